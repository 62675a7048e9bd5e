#include "host/case_file/boundary_condition.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tentpole {
namespace {

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Tangential vector from the scalar along (-n_y, n_x) for D = 2, from three global components for D = 3.
std::array<double, 3> tangential_vector(int dimension, const std::array<double, 3>& given,
                                        const std::array<double, 3>& normal) {
  if (dimension == 1) return {};
  if (dimension == 2) return {-normal[1] * given[0], normal[0] * given[0], 0};
  const double along = dot(given, normal);
  return {given[0] - along * normal[0], given[1] - along * normal[1], given[2] - along * normal[2]};
}

}  // namespace

double Ramp::factor(double time) const {
  if (rise_time <= 0) return 1;
  const double r = std::clamp(time / rise_time, 0.0, 1.0);
  return order == RampOrder::cubic ? r * r * (3 - 2 * r) : r * r * r * (r * (6 * r - 15) + 10);
}

BoundaryCondition BoundaryCondition::by_components(int dimension, BoundaryKind normal_kind, Expression normal,
                                                   BoundaryKind tangential_kind, VectorExpression tangential,
                                                   Ramp ramp) {
  BoundaryCondition condition;
  condition.dimension_ = dimension;
  condition.normal_kind_ = normal_kind;
  condition.tangential_kind_ = tangential_kind;
  condition.normal_ = std::move(normal);
  condition.vector_ = std::move(tangential);
  condition.ramp_ = ramp;
  return condition;
}

BoundaryCondition BoundaryCondition::by_vector(BoundaryKind kind, VectorExpression value, Ramp ramp) {
  BoundaryCondition condition;
  condition.normal_kind_ = condition.tangential_kind_ = kind;
  condition.vector_ = std::move(value);
  condition.ramp_ = ramp;
  return condition;
}

BoundaryCondition BoundaryCondition::absorbing() {
  return by_vector(BoundaryKind::absorbing, {}, {});
}

BoundaryCondition BoundaryCondition::absorbing(VectorExpression velocity, VectorExpression traction) {
  BoundaryCondition condition = by_vector(BoundaryKind::absorbing, std::move(traction), {});
  condition.far_field_velocity_ = std::move(velocity);
  return condition;
}

BoundaryCondition BoundaryCondition::periodic(std::string partner) {
  BoundaryCondition condition;
  condition.partner_ = std::move(partner);
  return condition;
}

std::array<double, 3> BoundaryCondition::value(const std::array<double, 3>& point, double time,
                                               const std::array<double, 3>& outward_normal) {
  assert(!is_periodic() && "a periodic side has no boundary value");
  std::array<double, 3> result = vector_.evaluate(point, time);
  if (normal_) {
    result = tangential_vector(dimension_, result, outward_normal);
    const double normal_component = normal_->evaluate(point, time);
    for (int i = 0; i < 3; ++i) result[i] += normal_component * outward_normal[i];
  }
  const double factor = ramp_.factor(time);
  for (double& component : result) component *= factor;
  return result;
}

std::array<double, 3> BoundaryCondition::far_field_velocity(const std::array<double, 3>& point, double time) {
  return far_field_velocity_ ? far_field_velocity_->evaluate(point, time) : std::array<double, 3>{};
}

bool BoundaryCondition::is_zero() const {
  return vector_.is_zero() && (!normal_ || normal_->is_zero()) &&
         (!far_field_velocity_ || far_field_velocity_->is_zero());
}

}  // namespace tentpole
