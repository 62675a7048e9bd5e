#include "bench/assembly/cell_tables.hpp"

#include <algorithm>
#include <numeric>

#include "common/simplex.hpp"
#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

/// Appends [l][a] to `table`.
void append_gradient(const OrthonormalBasis& basis, std::span<const double> xi, std::vector<double>& table) {
  const int d = basis.dimension();
  std::vector<double> gradient(basis.size() * d);
  basis.gradients(xi, gradient);
  for (int l = 0; l < d; ++l)
    for (int a = 0; a < basis.size(); ++a) table.push_back(gradient[a * d + l]);
}

/// Appends [l <= l'][a] to `table`.
void append_hessian(const OrthonormalBasis& basis, std::span<const double> xi, std::vector<double>& table) {
  const int d = basis.dimension();
  std::vector<double> hessian(basis.size() * d * d);
  basis.hessians(xi, hessian);
  for (int l = 0; l < d; ++l)
    for (int m = l; m < d; ++m)
      for (int a = 0; a < basis.size(); ++a) table.push_back(hessian[(a * d + l) * d + m]);
}

/// Reference coordinates in the element of facet point eta; the facet lies opposite a corner.
std::vector<double> element_point(int facet, std::span<const double> eta) {
  const int num_corners = static_cast<int>(eta.size()) + 1;
  std::vector<double> xi(num_corners, 0.0);
  for (int c = 0; c < num_corners; ++c) {
    const int corner = c < facet ? c : c + 1;
    const double barycentric = c == 0 ? 1 - std::accumulate(eta.begin(), eta.end(), 0.0) : eta[c - 1];
    if (corner > 0) xi[corner - 1] = barycentric;
  }
  return xi;
}

}  // namespace

CellTables::CellTables(int space_dimension, int the_degree)
    : dimension(space_dimension),
      degree(the_degree),
      num_basis(num_polynomials(dimension + 1, degree)),
      num_unknowns(dimension * num_basis) {
  const int d = dimension + 1;
  const OrthonormalBasis basis(d, degree);
  const Quadrature volume = simplex_quadrature(d, std::max(0, 2 * degree - 3));
  volume_weight = volume.weights;
  for (int q = 0; q < volume.num_points(); ++q) {
    const std::span<const double> xi(&volume.points[q * d], d);
    append_gradient(basis, xi, volume_gradient);
    append_hessian(basis, xi, volume_hessian);
  }
  const Quadrature face = simplex_quadrature(dimension, 2 * degree - 2);
  const double area = std::accumulate(face.weights.begin(), face.weights.end(), 0.0);
  for (const double weight : face.weights) facet_weight.push_back(weight / area);
  for (int facet = 0; facet <= d; ++facet)
    for (int q = 0; q < face.num_points(); ++q)
      append_gradient(basis, element_point(facet, {&face.points[q * dimension], std::size_t(dimension)}),
                      facet_gradient);
}

}  // namespace tentpole
