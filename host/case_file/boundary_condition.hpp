#pragma once

#include <array>
#include <optional>
#include <string>

#include "host/case_file/expression.hpp"
#include "kernels/element/patch_batch.hpp"

namespace tentpole {

/// How a load rises from 0 to 1 with r = min(1, t / rise time): r^2 (3 - 2 r) or r^3 (6 r^2 - 15 r + 10).
enum class RampOrder { cubic, quintic };

/// Rise of a load from rest; no rise time means full load from t = 0 on.
struct Ramp {
  double rise_time = 0;  ///< [s]
  RampOrder order = RampOrder::cubic;

  /// Factor in [0, 1] at the time [s].
  double factor(double time) const;
};

/// What is prescribed on one side of the domain. The expressions are copied with it: give each thread its own copy.
class BoundaryCondition {
 public:
  /// Normal component (outward positive) and tangential components prescribed separately. `tangential` has one
  /// component for D = 2, along the tangent (-n_y, n_x); three global components for D = 3, whose tangential part is
  /// taken; none for D = 1, and where it is zero. Units [m/s] for velocity, [Pa] for traction (tension positive).
  static BoundaryCondition by_components(int dimension, BoundaryKind normal_kind, Expression normal,
                                         BoundaryKind tangential_kind, VectorExpression tangential, Ramp ramp);
  /// All components of one kind, velocity [m/s] or traction sigma n on the outward normal n [Pa], in global axes.
  static BoundaryCondition by_vector(BoundaryKind kind, VectorExpression value, Ramp ramp);
  /// Outgoing plane waves leave; beyond the side the initial state goes on as it is there.
  static BoundaryCondition absorbing();
  /// The same with a far field given by the case: its velocity [m/s] and its traction on the outward normal [Pa], in
  /// global axes.
  static BoundaryCondition absorbing(VectorExpression velocity, VectorExpression traction);
  /// The side is glued to the opposite side `partner`; it has no kind and no value.
  static BoundaryCondition periodic(std::string partner);

  BoundaryKind normal_kind() const { return normal_kind_; }
  BoundaryKind tangential_kind() const { return tangential_kind_; }
  bool is_periodic() const { return !partner_.empty(); }
  bool is_absorbing() const { return normal_kind_ == BoundaryKind::absorbing; }
  /// An absorbing side whose far field the case gives.
  bool has_far_field() const { return far_field_velocity_.has_value(); }
  const std::string& periodic_partner() const { return partner_; }
  const Ramp& ramp() const { return ramp_; }

  /// Vector in global axes as the boundary block of kernels/element/patch_batch.hpp takes it: its part along the normal
  /// is the prescribed normal velocity or traction, its tangential part the prescribed tangential one; both times the
  /// ramp. Of an absorbing side: the traction of a given far field. The outward normal has length 1. Throws InputError
  /// if an expression is not finite there.
  std::array<double, 3> value(const std::array<double, 3>& point, double time,
                              const std::array<double, 3>& outward_normal);
  /// Velocity of a given far field [m/s]; otherwise zero. Throws as value().
  std::array<double, 3> far_field_velocity(const std::array<double, 3>& point, double time);
  /// True if value() and far_field_velocity() are zero everywhere and always.
  bool is_zero() const;

 private:
  int dimension_ = 0;
  BoundaryKind normal_kind_ = BoundaryKind::traction;
  BoundaryKind tangential_kind_ = BoundaryKind::traction;
  std::optional<Expression> normal_;  ///< absent: vector_ holds all components
  VectorExpression vector_;           ///< all components, or the tangential ones
  std::optional<VectorExpression> far_field_velocity_;
  Ramp ramp_;
  std::string partner_;
};

}  // namespace tentpole
