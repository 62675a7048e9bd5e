#pragma once

#include "host/problem/initial_state.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// What an absorbing side lets in: the wave of the far field beyond it. Unless the case gives the far field it is the
/// initial state of the body at the side, for all times, so that a prestressed body stays as it is
/// (docs/formulation.md, Absorbing boundary). Keeps copies of the expressions, so it serves one thread.
class FarField {
 public:
  explicit FarField(const Simulation& simulation)
      : scaling_(simulation.scaling), materials_(simulation.scaled_materials), initial_(simulation.settings) {}

  /// True if nothing ever comes in through a side with this condition.
  bool is_zero(const BoundaryCondition& condition) const {
    return condition.has_far_field() ? condition.is_zero() : initial_.is_zero();
  }

  /// s + Z v of the far field, scaled, in global axes, at a point of the side and a time [s]; `material` is that of the
  /// body there. Throws InputError where an expression is not finite.
  std::array<double, 3> incoming_amplitude(BoundaryCondition& condition, int material, const SidePoint& side,
                                           double time);

 private:
  using Vector = std::array<double, 3>;

  struct State {
    Vector velocity, traction;  ///< scaled
  };
  State given(BoundaryCondition& condition, const SidePoint& side, double time) const;
  State initial(const Material& material, const SidePoint& side);

  Scaling scaling_;
  std::vector<Material> materials_;  ///< [region], scaled
  InitialState initial_;
};

}  // namespace tentpole
