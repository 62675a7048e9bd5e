#include "host/books/exact_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/binary_stream.hpp"
#include "common/simplex.hpp"

namespace tentpole {
namespace {

double jacobian_determinant(const SpacetimeElement& element) {
  const int d = element.dimension + 1;
  double matrix[4][4], determinant = 1;
  for (int l = 0; l < d; ++l)
    for (int j = 0; j < d; ++j) matrix[l][j] = element.corner[l + 1][j] - element.corner[0][j];
  for (int column = 0; column < d; ++column) {
    int pivot = column;
    for (int row = column + 1; row < d; ++row)
      if (std::fabs(matrix[row][column]) > std::fabs(matrix[pivot][column])) pivot = row;
    std::swap(matrix[pivot], matrix[column]);
    determinant *= matrix[column][column];
    for (int row = column + 1; row < d; ++row)
      for (int j = d - 1; j >= column; --j)
        matrix[row][j] -= matrix[row][column] / matrix[column][column] * matrix[column][j];
  }
  return std::fabs(determinant);
}

/// Spacetime point of reference coordinates xi [D + 1].
std::array<double, 4> spacetime_point(const SpacetimeElement& element, const double* xi) {
  const int d = element.dimension + 1;
  std::array<double, 4> point = element.corner[0];
  for (int j = 0; j < d; ++j)
    for (int l = 0; l < d; ++l) point[j] += xi[l] * (element.corner[l + 1][j] - element.corner[0][j]);
  return point;
}

}  // namespace

ExactErrors::ExactErrors(const std::optional<VectorExpression>& exact, int dimension, int degree)
    : exact_(exact), dimension_(dimension), basis_(dimension + 1, degree), finer_basis_(dimension + 1, degree + 2) {
  if (active()) make_tables();
}

void ExactErrors::make_tables() {
  const int d = dimension_ + 1;
  const std::size_t size = finer_basis_.size();
  rule_ = simplex_quadrature(d, 2 * finer_basis_.degree());
  num_derivatives_ = num_polynomials(d, finer_basis_.degree() - 1);
  values_.resize(rule_.num_points() * size);
  derivatives_.assign(d * num_derivatives_ * size, 0.0);
  std::vector<double> gradients(size * d);
  for (int q = 0; q < rule_.num_points(); ++q) {
    const std::span<const double> xi(&rule_.points[static_cast<std::size_t>(q) * d], d);
    double* value = &values_[q * size];
    finer_basis_.values(xi, {value, size});
    finer_basis_.gradients(xi, gradients);
    for (int l = 0; l < d; ++l)
      for (int b = 0; b < num_derivatives_; ++b)
        for (std::size_t a = 0; a < size; ++a)
          derivatives_[(l * num_derivatives_ + b) * size + a] += rule_.weights[q] * value[b] * gradients[a * d + l];
  }
}

/// Books the displacement errors of the element; returns the projection of u - u_h.
ExactErrors::Coefficients ExactErrors::project_difference(const SpacetimeElement& element, double determinant) {
  const int d = dimension_ + 1, num_basis = basis_.size(), size = finer_basis_.size();
  Coefficients difference(dimension_ * size, 0.0);
  double squared_error = 0, squared = 0;
  for (int q = 0; q < rule_.num_points(); ++q) {
    const std::array<double, 4> point = spacetime_point(element, &rule_.points[static_cast<std::size_t>(q) * d]);
    std::array<double, 3> place{};
    std::copy_n(point.begin(), dimension_, place.begin());
    const std::array<double, 3> exact = exact_->evaluate(place, point[dimension_]);
    const double* value = &values_[static_cast<std::size_t>(q) * size];
    for (int i = 0; i < dimension_; ++i) {
      double error = exact[i];
      for (int a = 0; a < num_basis; ++a) error -= element.coefficients[i * num_basis + a] * value[a];
      squared_error += rule_.weights[q] * error * error;
      squared += rule_.weights[q] * exact[i] * exact[i];
      for (int a = 0; a < size; ++a) difference[i * size + a] += rule_.weights[q] * error * value[a];
    }
  }
  displacement_error_ += determinant * squared_error;
  displacement_ += determinant * squared;
  return difference;
}

/// int rho |v|^2 + E:C:E of the polynomials `difference` over the element, per Jacobian determinant: by Parseval's
/// identity a sum over the coefficients of the derivatives.
double ExactErrors::energy_density(const SpacetimeElement& element, const ElementFields& fields,
                                   const Coefficients& difference) const {
  const int d = dimension_ + 1, size = finer_basis_.size();
  const auto& inverse = fields.inverse_jacobian();
  double sum = 0;
  for (int b = 0; b < num_derivatives_; ++b) {
    double slope[3][4] = {};  // coefficient b of du_i / dx_j
    for (int i = 0; i < dimension_; ++i)
      for (int l = 0; l < d; ++l) {
        const double* row = &derivatives_[static_cast<std::size_t>(l * num_derivatives_ + b) * size];
        double reference = 0;
        for (int a = 0; a < size; ++a) reference += row[a] * difference[i * size + a];
        for (int j = 0; j < d; ++j) slope[i][j] += reference * inverse[l][j];
      }
    double trace = 0;
    for (int i = 0; i < dimension_; ++i) {
      sum += element.material.density * slope[i][dimension_] * slope[i][dimension_];
      trace += slope[i][i];
      for (int j = 0; j < dimension_; ++j) {
        const double strain = 0.5 * (slope[i][j] + slope[j][i]);
        sum += 2 * element.material.mu * strain * strain;
      }
    }
    sum += element.material.lambda * trace * trace;
  }
  return sum;
}

void ExactErrors::add(const SpacetimeElement& element) {
  const ElementFields fields(basis_, element);
  const double determinant = jacobian_determinant(element);
  const Coefficients difference = project_difference(element, determinant);
  energy_error_ += determinant * energy_density(element, fields, difference);
}

std::optional<RunSummary::Errors> ExactErrors::result() const {
  if (!active()) return std::nullopt;
  RunSummary::Errors errors;
  errors.displacement_l2 = std::sqrt(displacement_error_.value());
  errors.displacement_l2_relative = errors.displacement_l2 / std::sqrt(displacement_.value());
  errors.energy_norm = std::sqrt(energy_error_.value());
  return errors;
}

void ExactErrors::save(std::ostream& stream) const {
  write_value(stream, displacement_error_);
  write_value(stream, displacement_);
  write_value(stream, energy_error_);
}

void ExactErrors::load(std::istream& stream) {
  displacement_error_ = read_value<ExactSum>(stream);
  displacement_ = read_value<ExactSum>(stream);
  energy_error_ = read_value<ExactSum>(stream);
}

}  // namespace tentpole
