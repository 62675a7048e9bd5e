#pragma once

#include <array>
#include <vector>

#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/element/patch_batch.hpp"
#include "kernels/element/quadrature.hpp"

/// Fields of an element at a point, straight from the definitions. Host only and never tuned: the reference kernels and
/// the tests are written in these terms.
namespace tentpole::reference {

using Row = std::vector<double>;  ///< a linear function of the unknowns of an element, or plain components
using Rows = std::vector<Row>;
using Vector = std::array<double, max_dimension + 1>;
using Matrix = std::array<Vector, max_dimension + 1>;

/// What all elements of a batch share: bases and quadrature exact to degree 2 k.
struct Discretization {
  Discretization(int dimension, int degree);
  int dimension;                        ///< D
  OrthonormalBasis basis;               ///< of degree k on the element
  OrthonormalBasis facet_basis;         ///< of degree k - 1 on a facet
  OrthonormalBasis linear_facet_basis;  ///< of degree 1 on a facet
  Quadrature volume_rule;               ///< weights sum to 1 / (D + 1)!
  Quadrature facet_rule;                ///< weights sum to 1: means over the facet
  int num_unknowns;                     ///< D num_basis
};

/// Affine map of an element: inverse[l][j] = d xi_l / d x_j, and |det d x / d xi|.
struct Geometry {
  Matrix inverse{};
  double determinant = 1;
};
Geometry element_geometry(const ElementDescriptor& element, int dimension);

/// Outward normal times area of the facet opposite `corner`, as a spacetime covector [D + 1].
Vector facet_covector(const Geometry& geometry, int dimension, int corner);

/// Corners of a facet as facet_table() numbers the listings: 0..D+1 without corner `table`, or for table > D + 1 the
/// corners 0..D with D + 1 in place of table - D - 2.
std::vector<int> facet_corners(int dimension, int table);

/// Barycentric coordinates [D + 1] of point q of the facet rule.
Row facet_barycentric(const Discretization& discretization, int q);
/// Reference coordinates in the element of the point with these coordinates on the facet with these corners.
Row element_point(const Row& barycentric, const std::vector<int>& corners);

/// Fields at a point: every component is a row over the unknowns, or a row of one number once evaluated.
struct PointState {
  Rows displacement, velocity;  ///< [D]
  Rows strain, stress;          ///< [D * D], full tensors
};
PointState point_state(const Discretization& discretization, const Matrix& inverse, const Material& material,
                       const Row& xi);
/// The same for given coefficients [num_unknowns]: rows of one number.
PointState evaluate(const PointState& state, const double* coefficients);

/// sigma = lambda tr(E) I + 2 mu E, of [D * D] rows.
Rows stress_of(const Rows& strain, const Material& material, int dimension);

/// rho v_t - div sigma as [D] rows: rho u_i,tt - (lambda + mu) u_j,ji - mu u_i,jj.
Rows momentum_operator(const Discretization& discretization, const Matrix& inverse, const Material& material,
                       const Row& xi);

/// Component i of data [components][modes] at a facet point, in the modes of `modes` scaled to squares of mean 1.
double facet_mode_sum(const OrthonormalBasis& modes, const Row& barycentric, const double* data, int i);

/// Fields (rows of one number) that the batch prescribes at a point of an inflow facet: those of the source element, or
/// the initial data.
PointState state_below(const Discretization& discretization, const PatchBatch& batch, const ElementDescriptor& element,
                       int facet, const Row& barycentric);

}  // namespace tentpole::reference
