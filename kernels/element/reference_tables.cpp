#include "kernels/element/reference_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

using Corners = std::vector<int>;

int round_up(int n, int multiple) {
  return (n + multiple - 1) / multiple * multiple;
}

double factorial(int n) {
  return n < 2 ? 1.0 : n * factorial(n - 1);
}

/// Corners of the facet with this code in their listed order (patch_batch.hpp); the simplex has corners 0..D+1.
Corners facet_corners(int dimension, int code) {
  const bool tent_top = code > dimension + 1;
  Corners corners;
  for (int corner = 0; corner <= dimension + 1; ++corner)
    if (tent_top ? corner <= dimension : corner != code) corners.push_back(corner);
  if (tent_top) corners[code - dimension - 2] = dimension + 1;
  return corners;
}

/// Everything evaluated at the quadrature points of one facet; mean weights sum to 1.
struct FacetSamples {
  int num_points = 0;
  std::vector<double> weight;      ///< [point]
  std::vector<double> value;       ///< [point][a]
  std::vector<double> derivative;  ///< [point][a][l]
  std::vector<double> psi;         ///< [point][m]
  std::vector<double> chi;         ///< [point][m']
};

class TableBuilder {
 public:
  TableBuilder(const ReferenceTablesView& sizes)
      : size_(sizes),
        basis_(sizes.dimension + 1, sizes.degree),
        psi_(sizes.dimension, sizes.degree - 1),
        chi_(sizes.dimension, 1),
        facet_rule_(simplex_quadrature(sizes.dimension, 2 * sizes.degree)) {}

  FacetSamples sample(const Corners& corners) const {
    const int dimension = size_.dimension, d = dimension + 1, num_basis = size_.num_basis;
    const double normalization = std::sqrt(factorial(dimension));
    FacetSamples samples;
    samples.num_points = facet_rule_.num_points();
    samples.value.resize(samples.num_points * num_basis);
    samples.derivative.resize(samples.num_points * num_basis * d);
    samples.psi.resize(samples.num_points * psi_.size());
    samples.chi.resize(samples.num_points * chi_.size());
    for (int point = 0; point < samples.num_points; ++point) {
      const std::span<const double> eta(&facet_rule_.points[point * dimension], dimension);
      samples.weight.push_back(facet_rule_.weights[point] * factorial(dimension));
      const std::array<double, 4> xi = element_point(corners, eta);
      const std::span<const double> element_xi(xi.data(), d);
      basis_.values(element_xi, {&samples.value[point * num_basis], std::size_t(num_basis)});
      basis_.gradients(element_xi, {&samples.derivative[point * num_basis * d], std::size_t(num_basis * d)});
      evaluate_modes(psi_, eta, normalization, &samples.psi[point * psi_.size()]);
      evaluate_modes(chi_, eta, normalization, &samples.chi[point * chi_.size()]);
    }
    return samples;
  }

  /// out[l][a][m] = <d_l phi_a psi_m>.
  void derivative_modes(const FacetSamples& samples, double* out) const {
    const int d = size_.dimension + 1, num_basis = size_.num_basis, num_modes = size_.num_facet_modes;
    for (int point = 0; point < samples.num_points; ++point)
      for (int l = 0; l < d; ++l)
        for (int a = 0; a < num_basis; ++a)
          for (int m = 0; m < num_modes; ++m)
            out[(l * num_basis + a) * size_.facet_stride + m] += samples.weight[point] *
                                                                 samples.derivative[(point * num_basis + a) * d + l] *
                                                                 samples.psi[point * num_modes + m];
  }

  /// out[a][m'] = <phi_a chi_m'>.
  void value_modes(const FacetSamples& samples, double* out) const {
    const int num_modes = size_.dimension + 1, num_basis = size_.num_basis;
    for (int point = 0; point < samples.num_points; ++point)
      for (int a = 0; a < num_basis; ++a)
        for (int m = 0; m < num_modes; ++m)
          out[a * num_modes + m] +=
              samples.weight[point] * samples.value[point * num_basis + a] * samples.chi[point * num_modes + m];
  }

  /// out[a][l, l'][b] = sum_m <d_l phi_a psi_m> <d_l' phi_b psi_m>, exact because psi spans the traces of derivatives.
  void gram(const double* derivative, double* out) const {
    const int d = size_.dimension + 1, num_basis = size_.num_basis, stride = size_.facet_stride;
    for (int a = 0; a < num_basis; ++a)
      for (int l = 0; l < d; ++l)
        for (int k = 0; k < d; ++k)
          for (int b = 0; b < num_basis; ++b) {
            double sum = 0;
            for (int m = 0; m < size_.num_facet_modes; ++m)
              sum += derivative[(l * num_basis + a) * stride + m] * derivative[(k * num_basis + b) * stride + m];
            out[(a * d * d + l * d + k) * size_.basis_stride + b] = sum;
          }
  }

  void corner_tables(double* corner_modes, double* corner_psi) const {
    const int dimension = size_.dimension;
    for (int corner = 0; corner <= dimension; ++corner) {
      // Barycentric coordinate of this corner in the chi modes: its means against chi over the facet.
      for (int point = 0; point < facet_rule_.num_points(); ++point) {
        const std::span<const double> eta(&facet_rule_.points[point * dimension], dimension);
        std::array<double, 4> chi{};
        evaluate_modes(chi_, eta, std::sqrt(factorial(dimension)), chi.data());
        double barycentric = corner == 0 ? 1.0 : eta[corner - 1];
        if (corner == 0)
          for (double coordinate : eta) barycentric -= coordinate;
        for (int m = 0; m <= dimension; ++m)
          corner_modes[corner * (dimension + 1) + m] +=
              facet_rule_.weights[point] * factorial(dimension) * barycentric * chi[m];
      }
      std::array<double, 3> eta{};
      if (corner > 0) eta[corner - 1] = 1;
      evaluate_modes(psi_, {eta.data(), std::size_t(dimension)}, std::sqrt(factorial(dimension)),
                     corner_psi + corner * size_.facet_stride);
    }
  }

  void volume_tables(double* volume_derivative, double* curvature) const {
    const int d = size_.dimension + 1, num_basis = size_.num_basis;
    const Quadrature rule = simplex_quadrature(d, 2 * size_.degree - 2);
    std::vector<double> value(num_basis), gradient(num_basis * d), hessian(num_basis * d * d);
    for (int point = 0; point < rule.num_points(); ++point) {
      const std::span<const double> xi(&rule.points[point * d], d);
      basis_.values(xi, value);
      basis_.gradients(xi, gradient);
      basis_.hessians(xi, hessian);
      for (int l = 0; l < d; ++l)
        for (int a = 0; a < num_basis; ++a)
          for (int q = 0; q < size_.num_volume_modes; ++q)
            volume_derivative[(l * num_basis + a) * size_.num_volume_modes + q] +=
                rule.weights[point] * gradient[a * d + l] * value[q];
      int pair = 0;
      for (int l = 0; l < d; ++l)
        for (int k = l; k < d; ++k, ++pair)
          for (int q = 0; q < size_.num_curvature_modes; ++q)
            for (int b = 0; b < num_basis; ++b)
              curvature[(pair * size_.num_curvature_modes + q) * size_.basis_stride + b] +=
                  rule.weights[point] * value[q] * hessian[(b * d + l) * d + k];
    }
  }

 private:
  static void evaluate_modes(const OrthonormalBasis& modes, std::span<const double> eta, double normalization,
                             double* out) {
    modes.values(eta, {out, std::size_t(modes.size())});
    for (int m = 0; m < modes.size(); ++m) out[m] /= normalization;
  }

  /// Reference coordinates in the element of the facet point eta: corner 0 is the origin, corner l the l-th unit point.
  std::array<double, 4> element_point(const Corners& corners, std::span<const double> eta) const {
    std::array<double, 4> xi{};
    double first = 1;
    for (double coordinate : eta) first -= coordinate;
    for (int i = 0; i <= size_.dimension; ++i) {
      const double barycentric = i == 0 ? first : eta[i - 1];
      if (corners[i] > 0) xi[corners[i] - 1] += barycentric;
    }
    return xi;
  }

  ReferenceTablesView size_;
  OrthonormalBasis basis_;
  OrthonormalBasis psi_;
  OrthonormalBasis chi_;
  Quadrature facet_rule_;
};

ReferenceTablesView table_sizes(int dimension, int degree) {
  ReferenceTablesView size{};
  size.dimension = dimension;
  size.degree = degree;
  size.num_basis = num_polynomials(dimension + 1, degree);
  size.num_unknowns = dimension * size.num_basis;
  size.num_facet_modes = num_polynomials(dimension, degree - 1);
  size.num_volume_modes = num_polynomials(dimension + 1, degree - 1);
  size.num_curvature_modes = num_polynomials(dimension + 1, degree - 2);
  size.num_lines = dimension == 1 ? 1 : degree + 1;
  size.num_panel_points = std::max(3, degree);
  size.basis_stride = round_up(size.num_basis, 4);
  size.facet_stride = round_up(size.num_facet_modes, 4);
  return size;
}

}  // namespace

ReferenceTables::ReferenceTables(int dimension, int degree) {
  if (dimension < 1 || dimension > max_dimension || degree < 1 || degree > max_degree)
    throw std::invalid_argument("reference tables: dimension " + std::to_string(dimension) + ", degree " +
                                std::to_string(degree) + ": dimension must be 1..3 and degree 1..7");
  offsets_ = table_sizes(dimension, degree);
  const ReferenceTablesView& size = offsets_;
  const OrthonormalBasis facet_basis(dimension, degree - 1);
  const std::size_t d = dimension + 1, facets = dimension + 2, codes = 2 * dimension + 3;
  const std::size_t derivative = d * size.num_basis * size.facet_stride;
  const std::size_t value = size.num_basis * d;
  const std::size_t gram = size.num_basis * d * d * size.basis_stride;
  const std::size_t lengths[] = {codes * derivative,
                                 codes * value,
                                 facets * gram,
                                 d * d,
                                 d * size.facet_stride,
                                 d * size.num_basis * size.num_volume_modes,
                                 d * (d + 1) / 2 * size.num_curvature_modes * size.basis_stride,
                                 std::size_t(size.num_lines),
                                 std::size_t(size.num_lines),
                                 std::size_t(size.num_panel_points),
                                 std::size_t(size.num_panel_points),
                                 facet_basis.recurrence_rows().size()};
  std::size_t total = 0;
  for (std::size_t length : lengths) {
    offset_.push_back(total);
    total += (length + 7) / 8 * 8;  // tables start on cache lines
  }
  block_.assign(total, 0.0);
  const auto table = [&](int index) { return block_.data() + offset_[index]; };

  const TableBuilder builder(size);
  for (std::size_t code = 0; code < codes; ++code) {
    const FacetSamples samples = builder.sample(facet_corners(dimension, static_cast<int>(code)));
    builder.derivative_modes(samples, table(0) + code * derivative);
    builder.value_modes(samples, table(1) + code * value);
    if (code < facets) builder.gram(table(0) + code * derivative, table(2) + code * gram);
  }
  builder.corner_tables(table(3), table(4));
  builder.volume_tables(table(5), table(6));
  const Quadrature lines = gauss_jacobi(size.num_lines, 0), panel = gauss_jacobi(size.num_panel_points, 0);
  std::ranges::copy(lines.points, table(7));
  std::ranges::copy(lines.weights, table(8));
  std::ranges::copy(panel.points, table(9));
  std::ranges::copy(panel.weights, table(10));
  std::ranges::copy(facet_basis.recurrence_rows(), table(11));
}

ReferenceTablesView ReferenceTables::view(const double* base) const {
  ReferenceTablesView view = offsets_;
  view.derivative = base + offset_[0];
  view.value = base + offset_[1];
  view.gram = base + offset_[2];
  view.corner_modes = base + offset_[3];
  view.corner_psi = base + offset_[4];
  view.volume_derivative = base + offset_[5];
  view.curvature = base + offset_[6];
  view.line_point = base + offset_[7];
  view.line_weight = base + offset_[8];
  view.panel_point = base + offset_[9];
  view.panel_weight = base + offset_[10];
  view.facet_recurrence = base + offset_[11];
  return view;
}

}  // namespace tentpole
