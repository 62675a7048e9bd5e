#include "host/output/spacetime_element.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/simplex.hpp"

namespace tentpole {
namespace {

constexpr int max_basis = num_polynomials(max_dimension + 1, max_degree);
using Matrix = std::array<std::array<double, 4>, 4>;

/// Gauss-Jordan inverse of the leading size x size block; false where it is singular. Rows are scaled to their largest
/// entry first, because they carry different units (m and s).
bool invert(Matrix matrix, int size, Matrix& inverse) {
  inverse = {};
  for (int row = 0; row < size; ++row) {
    double largest = 0;
    for (int column = 0; column < size; ++column) largest = std::max(largest, std::abs(matrix[row][column]));
    if (!(largest > 0)) return false;
    for (int column = 0; column < size; ++column) matrix[row][column] /= largest;
    inverse[row][row] = 1 / largest;
  }
  for (int step = 0; step < size; ++step) {
    int pivot = step;
    for (int row = step + 1; row < size; ++row)
      if (std::abs(matrix[row][step]) > std::abs(matrix[pivot][step])) pivot = row;
    std::swap(matrix[step], matrix[pivot]);
    std::swap(inverse[step], inverse[pivot]);
    if (!(std::abs(matrix[step][step]) > 0)) return false;
    const double scale = 1 / matrix[step][step];
    for (int column = 0; column < size; ++column) matrix[step][column] *= scale, inverse[step][column] *= scale;
    for (int row = 0; row < size; ++row) {
      if (row == step) continue;
      const double factor = matrix[row][step];
      for (int column = 0; column < size; ++column) {
        matrix[row][column] -= factor * matrix[step][column];
        inverse[row][column] -= factor * inverse[step][column];
      }
    }
  }
  return true;
}

/// Stress and strain energy density of a displacement gradient.
void add_stress(const Material& material, int dimension, PointFields& fields) {
  double trace = 0;
  for (int i = 0; i < dimension; ++i) trace += fields.gradient[i][i];
  for (int i = 0; i < 3; ++i) fields.stress[i] = material.lambda * trace;
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j) {
      const double strain = 0.5 * (fields.gradient[i][j] + fields.gradient[j][i]);
      double& stress = fields.stress[symmetric_index(3, i, j)];
      stress += 2 * material.mu * strain;
      fields.strain_energy_density += (i == j ? 0.5 : 1.0) * stress * strain;
    }
}

}  // namespace

double SpacetimeElement::time_min() const {
  double result = corner[0][dimension];
  for (int i = 1; i < dimension + 2; ++i) result = std::min(result, corner[i][dimension]);
  return result;
}

double SpacetimeElement::time_max() const {
  double result = corner[0][dimension];
  for (int i = 1; i < dimension + 2; ++i) result = std::max(result, corner[i][dimension]);
  return result;
}

std::array<double, 4> SpacetimeElement::centroid() const {
  std::array<double, 4> sum{};
  for (int i = 0; i < dimension + 2; ++i)
    for (int c = 0; c <= dimension; ++c) sum[c] += corner[i][c] / (dimension + 2);
  return sum;
}

ElementFields::ElementFields(const OrthonormalBasis& basis, const SpacetimeElement& element)
    : basis_(&basis), element_(element) {
  const int size = element.dimension + 1;
  const std::string name = "element " + std::to_string(element.id);
  if (basis.dimension() != size)
    throw std::invalid_argument(name + ": the basis has dimension " + std::to_string(basis.dimension()) +
                                " and should have " + std::to_string(size));
  if (basis.size() > max_basis)
    throw std::invalid_argument(name + ": degree " + std::to_string(basis.degree()) + " is above the largest, " +
                                std::to_string(max_degree));
  const auto num_unknowns = static_cast<std::size_t>(element.dimension * basis.size());
  if (element.coefficients.size() != num_unknowns)
    throw std::invalid_argument(name + ": " + std::to_string(element.coefficients.size()) +
                                " coefficients where the basis needs " + std::to_string(num_unknowns));
  Matrix jacobian{};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      jacobian[row][column] = element.corner[column + 1][row] - element.corner[0][row];
  if (!invert(jacobian, size, inverse_)) throw std::invalid_argument(name + ": the spacetime volume is 0");
}

std::array<double, 4> ElementFields::reference_point(std::span<const double> point) const {
  std::array<double, 4> xi{};
  for (int l = 0; l <= element_.dimension; ++l)
    for (int c = 0; c <= element_.dimension; ++c) xi[l] += inverse_[l][c] * (point[c] - element_.corner[0][c]);
  return xi;
}

PointFields ElementFields::at(std::span<const double> point) const {
  const int dimension = element_.dimension, size = dimension + 1, num_basis = basis_->size();
  std::array<double, max_basis> value;
  std::array<double, 4 * max_basis> derivative;
  const std::array<double, 4> xi = reference_point(point);
  basis_->values(std::span(xi).first(size), std::span(value).first(num_basis));
  basis_->gradients(std::span(xi).first(size), std::span(derivative).first(num_basis * size));

  PointFields fields;
  for (int i = 0; i < dimension; ++i) {
    const auto coefficients = element_.coefficients.subspan(i * num_basis, num_basis);
    std::array<double, 4> reference_gradient{};
    for (int a = 0; a < num_basis; ++a) {
      fields.displacement[i] += coefficients[a] * value[a];
      for (int l = 0; l < size; ++l) reference_gradient[l] += coefficients[a] * derivative[a * size + l];
    }
    for (int l = 0; l < size; ++l) {
      for (int j = 0; j < dimension; ++j) fields.gradient[i][j] += reference_gradient[l] * inverse_[l][j];
      fields.velocity[i] += reference_gradient[l] * inverse_[l][dimension];
    }
  }
  add_stress(element_.material, dimension, fields);
  return fields;
}

}  // namespace tentpole
