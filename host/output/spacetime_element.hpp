#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "common/material.hpp"
#include "kernels/element/orthonormal_basis.hpp"

namespace tentpole {

/// A solved spacetime element as everything that writes results sees it: the simplex with corners 0..D+1 in space x
/// time and its displacement polynomials. All SI; the solver scales back before it hands an element over.
struct SpacetimeElement {
  int dimension = 0;                              ///< D, number of space dimensions
  std::array<std::array<double, 4>, 5> corner{};  ///< rows 0..D+1; columns x.. [m], t [s] in column D
  int region = 0;                                 ///< region number of the mesh
  std::int64_t id = 0;                            ///< named in messages; need not be independent of the batch size
  Material material{};                            ///< [kg/m^3, Pa]
  double damage = 0;                              ///< largest damage of the fracture edges of its front cell
  /// Displacement [m]: dof (i, a) at i * num_basis + a in the orthonormal basis of degree k on the reference simplex of
  /// dimension D + 1, xi = J^-1 (x - corner_0), columns of J are corner_l - corner_0, l = 1..D+1. Not owned.
  std::span<const double> coefficients;

  double time_min() const;
  double time_max() const;
  /// Mean of the corners. Distinct for distinct elements, so it orders them whatever the order of their arrival.
  std::array<double, 4> centroid() const;
};

/// Fields of one element at one spacetime point. Components that the dimension lacks are 0, except the out-of-plane
/// normal stresses, which are those of plane or uniaxial strain (lambda tr E).
struct PointFields {
  std::array<double, 3> displacement{};             ///< u [m]
  std::array<double, 3> velocity{};                 ///< du/dt [m/s]
  std::array<std::array<double, 3>, 3> gradient{};  ///< gradient[i][j] = du_i/dx_j
  std::array<double, 6> stress{};                   ///< lambda tr(E) I + 2 mu E [Pa]; xx, yy, zz, xy, yz, xz
  double strain_energy_density = 0;                 ///< 1/2 sigma : E [J/m^3]
};

/// Evaluates the displacement polynomials of one element. Keeps references to the basis and to the coefficients.
class ElementFields {
 public:
  /// `basis` has dimension D + 1 and the degree of the element. Throws std::invalid_argument for another dimension,
  /// another number of coefficients, or an element without volume.
  ElementFields(const OrthonormalBasis& basis, const SpacetimeElement& element);

  /// Fields at (x.., t) [D + 1]; outside the element the polynomials are continued.
  PointFields at(std::span<const double> point) const;

  /// xi = J^-1 (point - corner_0), the barycentric coordinates of corners 1..D+1.
  std::array<double, 4> reference_point(std::span<const double> point) const;

  /// J^-1: entry [l][j] = d xi_l / d x_j, the time derivative in column D.
  const std::array<std::array<double, 4>, 4>& inverse_jacobian() const { return inverse_; }

 private:
  const OrthonormalBasis* basis_;
  SpacetimeElement element_;
  std::array<std::array<double, 4>, 4> inverse_{};  ///< J^-1: row l is the gradient of xi_l
};

}  // namespace tentpole
