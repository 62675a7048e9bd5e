#include "kernels/reference/point_state.reference.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace tentpole::reference {
namespace {

/// sum_i a_i b_i over the length of a.
double dot(const Row& a, const double* b) {
  return std::inner_product(a.begin(), a.end(), b, 0.0);
}

PointState initial_state(const Discretization& disc, const PatchBatch& batch, const ElementDescriptor& element,
                         int facet, const Row& barycentric) {
  const int D = disc.dimension;
  const double* velocity = batch.prescribed + element.facet_data[facet];
  const double* strain = velocity + D * disc.facet_basis.size();
  const double* displacement = strain + num_symmetric(D) * disc.facet_basis.size();
  PointState state;
  for (int i = 0; i < D; ++i) {
    state.velocity.push_back({facet_mode_sum(disc.facet_basis, barycentric, velocity, i)});
    state.displacement.push_back({facet_mode_sum(disc.linear_facet_basis, barycentric, displacement, i)});
    for (int j = 0; j < D; ++j)
      state.strain.push_back({facet_mode_sum(disc.facet_basis, barycentric, strain, symmetric_index(D, i, j))});
  }
  state.stress = stress_of(state.strain, batch.materials[element.material], D);
  return state;
}

PointState source_state(const Discretization& disc, const PatchBatch& batch, const ElementDescriptor& element,
                        int facet, const Row& barycentric) {
  const int d = disc.dimension + 1;
  const std::size_t slot = element.source_slot[facet];
  Matrix inverse{};
  for (int l = 0; l < d; ++l)
    for (int j = 0; j < d; ++j) inverse[l][j] = batch.inverse_jacobians[(slot * d + l) * d + j];
  const Row xi = element_point(barycentric, facet_corners(disc.dimension, element.source_facet[facet]));
  return evaluate(point_state(disc, inverse, batch.materials[element.material], xi),
                  batch.coefficients + slot * disc.num_unknowns);
}

}  // namespace

Discretization::Discretization(int the_dimension, int degree)
    : dimension(the_dimension),
      basis(dimension + 1, degree),
      facet_basis(dimension, degree - 1),
      linear_facet_basis(dimension, 1),
      volume_rule(simplex_quadrature(dimension + 1, 2 * degree)),
      facet_rule(simplex_quadrature(dimension, 2 * degree)),
      num_unknowns(dimension * basis.size()) {
  const double facet_volume = std::accumulate(facet_rule.weights.begin(), facet_rule.weights.end(), 0.0);
  for (double& weight : facet_rule.weights) weight /= facet_volume;
}

// Gauss-Jordan elimination with row pivoting of J[j][l] = corner_{l+1, j} - corner_{0, j}.
Geometry element_geometry(const ElementDescriptor& element, int dimension) {
  const int size = dimension + 1;
  Matrix jacobian{};
  Geometry geometry;
  for (int j = 0; j < size; ++j) {
    for (int l = 0; l < size; ++l) jacobian[j][l] = element.corner[l + 1][j] - element.corner[0][j];
    geometry.inverse[j][j] = 1;
  }
  for (int column = 0; column < size; ++column) {
    int pivot = column;
    for (int row = column + 1; row < size; ++row)
      if (std::abs(jacobian[row][column]) > std::abs(jacobian[pivot][column])) pivot = row;
    if (pivot != column) geometry.determinant = -geometry.determinant;
    std::swap(jacobian[column], jacobian[pivot]);
    std::swap(geometry.inverse[column], geometry.inverse[pivot]);
    const double diagonal = jacobian[column][column];
    geometry.determinant *= diagonal;
    for (int j = 0; j < size; ++j) {
      jacobian[column][j] /= diagonal;
      geometry.inverse[column][j] /= diagonal;
    }
    for (int row = 0; row < size; ++row) {
      if (row == column) continue;
      const double factor = jacobian[row][column];
      for (int j = 0; j < size; ++j) {
        jacobian[row][j] -= factor * jacobian[column][j];
        geometry.inverse[row][j] -= factor * geometry.inverse[column][j];
      }
    }
  }
  geometry.determinant = std::abs(geometry.determinant);
  return geometry;
}

// -|det J| / D! times the gradient of the barycentric coordinate of the corner.
Vector facet_covector(const Geometry& geometry, int dimension, int corner) {
  double factor = -geometry.determinant;
  for (int i = 2; i <= dimension; ++i) factor /= i;
  Vector covector{};
  for (int j = 0; j <= dimension; ++j) {
    if (corner > 0) {
      covector[j] = factor * geometry.inverse[corner - 1][j];
    } else {
      for (int l = 0; l <= dimension; ++l) covector[j] -= factor * geometry.inverse[l][j];
    }
  }
  return covector;
}

std::vector<int> facet_corners(int dimension, int table) {
  std::vector<int> corners;
  if (table > dimension + 1) {
    for (int c = 0; c <= dimension; ++c) corners.push_back(c == table - dimension - 2 ? dimension + 1 : c);
  } else {
    for (int c = 0; c <= dimension + 1; ++c)
      if (c != table) corners.push_back(c);
  }
  return corners;
}

Row facet_barycentric(const Discretization& disc, int q) {
  Row barycentric(disc.dimension + 1, 1.0);
  for (int j = 0; j < disc.dimension; ++j) {
    barycentric[j + 1] = disc.facet_rule.points[q * disc.dimension + j];
    barycentric[0] -= barycentric[j + 1];
  }
  return barycentric;
}

Row element_point(const Row& barycentric, const std::vector<int>& corners) {
  Row xi(corners.size(), 0.0);
  for (std::size_t c = 0; c < corners.size(); ++c)
    if (corners[c] > 0) xi[corners[c] - 1] = barycentric[c];
  return xi;
}

Rows stress_of(const Rows& strain, const Material& material, int dimension) {
  Rows stress = strain;
  for (std::size_t n = 0; n < strain[0].size(); ++n) {
    double trace = 0;
    for (int i = 0; i < dimension; ++i) trace += strain[i * dimension + i][n];
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j)
        stress[i * dimension + j][n] =
            2 * material.mu * strain[i * dimension + j][n] + (i == j ? material.lambda * trace : 0);
  }
  return stress;
}

PointState point_state(const Discretization& disc, const Matrix& inverse, const Material& material, const Row& xi) {
  const int D = disc.dimension, num_basis = disc.basis.size();
  Row value(num_basis), gradient(num_basis * (D + 1));
  disc.basis.values(xi, value);
  disc.basis.gradients(xi, gradient);
  PointState state;
  state.displacement = state.velocity = Rows(D, Row(disc.num_unknowns, 0.0));
  state.strain = Rows(D * D, Row(disc.num_unknowns, 0.0));
  for (int a = 0; a < num_basis; ++a) {
    Vector physical{};
    for (int j = 0; j <= D; ++j)
      for (int l = 0; l <= D; ++l) physical[j] += gradient[a * (D + 1) + l] * inverse[l][j];
    for (int i = 0; i < D; ++i) {
      const int unknown = i * num_basis + a;
      state.displacement[i][unknown] = value[a];
      state.velocity[i][unknown] = physical[D];
      for (int j = 0; j < D; ++j) {
        state.strain[i * D + j][unknown] += physical[j] / 2;
        state.strain[j * D + i][unknown] += physical[j] / 2;
      }
    }
  }
  state.stress = stress_of(state.strain, material, D);
  return state;
}

Rows momentum_operator(const Discretization& disc, const Matrix& inverse, const Material& material, const Row& xi) {
  const int D = disc.dimension, d = D + 1, num_basis = disc.basis.size();
  Row hessian(num_basis * d * d);
  disc.basis.hessians(xi, hessian);
  Rows momentum(D, Row(disc.num_unknowns, 0.0));
  for (int a = 0; a < num_basis; ++a) {
    Matrix physical{};
    for (int j = 0; j < d; ++j)
      for (int k = 0; k < d; ++k)
        for (int l = 0; l < d; ++l)
          for (int m = 0; m < d; ++m) physical[j][k] += hessian[(a * d + l) * d + m] * inverse[l][j] * inverse[m][k];
    double laplacian = 0;
    for (int j = 0; j < D; ++j) laplacian += physical[j][j];
    for (int i = 0; i < D; ++i) {
      momentum[i][i * num_basis + a] += material.density * physical[D][D] - material.mu * laplacian;
      for (int j = 0; j < D; ++j) momentum[i][j * num_basis + a] -= (material.lambda + material.mu) * physical[i][j];
    }
  }
  return momentum;
}

double facet_mode_sum(const OrthonormalBasis& modes, const Row& barycentric, const double* data, int i) {
  Row value(modes.size());
  modes.values({&barycentric[1], barycentric.size() - 1}, value);
  double factorial = 1;
  for (int n = 2; n <= modes.dimension(); ++n) factorial *= n;
  return dot(value, data + i * modes.size()) / std::sqrt(factorial);
}

PointState evaluate(const PointState& state, const double* coefficients) {
  PointState result = state;
  for (Rows* rows : {&result.displacement, &result.velocity, &result.strain, &result.stress})
    for (Row& row : *rows) row = {dot(row, coefficients)};
  return result;
}

PointState state_below(const Discretization& disc, const PatchBatch& batch, const ElementDescriptor& element, int facet,
                       const Row& barycentric) {
  return has_source(element, facet) ? source_state(disc, batch, element, facet, barycentric)
                                    : initial_state(disc, batch, element, facet, barycentric);
}

}  // namespace tentpole::reference
