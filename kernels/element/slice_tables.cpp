#include "kernels/element/slice_tables.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "common/simplex.hpp"
#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

/// Barycentric coordinates of point q: the first corner is the origin of the unit simplex.
std::vector<double> barycentric(const Quadrature& rule, int q) {
  std::vector<double> coordinates(rule.dimension + 1, 1.0);
  for (int l = 0; l < rule.dimension; ++l) {
    coordinates[l + 1] = rule.points[q * rule.dimension + l];
    coordinates[0] -= coordinates[l + 1];
  }
  return coordinates;
}

/// Points of the product of the simplices with `slow` and `fast` corners, in the layout of SliceTablesView.
std::vector<double> product_points(int slow, int fast, int degree, int& num_blocks) {
  constexpr int block = SliceTablesView::block;
  const Quadrature slow_rule = simplex_quadrature(slow - 1, degree + fast - 1);
  const Quadrature fast_rule = simplex_quadrature(fast - 1, degree + slow - 1);
  const int num_points = slow_rule.num_points() * fast_rule.num_points(), num_entries = slow + fast + 1;
  num_blocks = (num_points + block - 1) / block;
  std::vector<double> points(num_blocks * num_entries * block, 0.0);
  const auto put = [&](int point, int entry, double value) {
    points[(point / block * num_entries + entry) * block + point % block] = value;
  };
  for (int point = 0; point < num_blocks * block; ++point) {
    const int actual = std::min(point, num_points - 1), p = actual / fast_rule.num_points(),
              q = actual % fast_rule.num_points();
    const std::vector<double> r = barycentric(slow_rule, p), f = barycentric(fast_rule, q);
    for (int i = 0; i < slow; ++i) put(point, i, r[i]);
    for (int j = 0; j < fast; ++j) put(point, slow + j, f[j]);
    put(point, slow + fast, point < num_points ? slow_rule.weights[p] * fast_rule.weights[q] : 0.0);
  }
  return points;
}

}  // namespace

SliceTables::SliceTables(int dimension, int degree) : degree_(degree), num_blocks_{} {
  if (dimension < 1 || dimension > max_dimension || degree < 1 || degree > max_degree)
    throw std::invalid_argument("slice tables: dimension " + std::to_string(dimension) + ", degree " +
                                std::to_string(degree) + ": dimension must be 1..3 and degree 1..7");
  for (int slow = 1; slow <= 2; ++slow) {
    offset_[slow - 1] = block_.size();
    const std::vector<double> points =
        product_points(slow, dimension + 2 - slow, 2 * degree - 2, num_blocks_[slow - 1]);
    block_.insert(block_.end(), points.begin(), points.end());
  }
  offset_[2] = block_.size();
  const OrthonormalBasis basis(dimension + 1, degree - 1);
  block_.insert(block_.end(), basis.recurrence_rows().begin(), basis.recurrence_rows().end());
}

SliceTablesView SliceTables::view(const double* base) const {
  return {{num_blocks_[0], num_blocks_[1]}, {base + offset_[0], base + offset_[1]}, {degree_ - 1, base + offset_[2]}};
}

}  // namespace tentpole
