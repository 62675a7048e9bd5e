#pragma once

#include <array>
#include <vector>

#include "host/problem/far_field.hpp"
#include "host/problem/initial_state.hpp"
#include "host/problem/simulation.hpp"
#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/element/patch_batch.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {

/// Turns the expressions of a case into the data blocks of kernels/element/patch_batch.hpp: scaled, projected on the
/// modes of a facet or element by quadrature. Blocks are appended to `prescribed`; every function returns the offset of
/// its block, or none where the data are identically zero and no block is needed. Strains of the initial displacement
/// are differences of the expression (initial_state.hpp) with a step of 0.4 % of the cell. Keeps copies of the
/// expressions, so it serves one thread. Throws InputError where an expression is not finite.
class PrescribedData {
 public:
  explicit PrescribedData(const Simulation& simulation);

  /// Initial data on inflow facet `facet` of an element that starts from the initial front.
  std::int32_t add_initial(const ElementDescriptor& element, int facet, std::vector<double>& prescribed);
  /// Boundary data on vertical facet `facet` of an element, condition number `boundary`. An absorbing side takes what
  /// its far field sends in (docs/formulation.md, Absorbing boundary).
  std::int32_t add_boundary(const ElementDescriptor& element, int facet, int boundary, std::vector<double>& prescribed);
  /// Body force rho b in the element.
  std::int32_t add_body_force(const ElementDescriptor& element, std::vector<double>& prescribed);

  /// At how many points of a facet an expression is evaluated.
  int num_facet_points() const { return facet_rule_.num_points(); }

 private:
  using Point = std::array<double, 3>;

  Point to_si(const Point& scaled) const;
  SidePoint side_point(const ElementDescriptor& element, int facet, const Point& normal) const;
  std::int32_t add_far_field(const ElementDescriptor& element, int facet, BoundaryCondition& condition,
                             std::vector<double>& prescribed);

  int dimension_;
  int num_facet_modes_;
  Scaling scaling_;
  std::vector<double> density_;  ///< [region], SI
  std::vector<BoundaryCondition> conditions_;
  FarField far_field_;
  InitialState initial_;
  VectorExpression body_force_;
  Quadrature facet_rule_;
  std::vector<double> facet_psi_;  ///< [point][mode], with the mean weights of the rule
  std::vector<double> facet_chi_;  ///< [point][D + 1]
  Quadrature volume_rule_;
  std::vector<double> volume_modes_;  ///< [point][mode]
  int num_volume_modes_;
};

}  // namespace tentpole
