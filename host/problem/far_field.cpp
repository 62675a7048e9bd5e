#include "host/problem/far_field.hpp"

namespace tentpole {
namespace {

using Vector = std::array<double, 3>;

Vector divided(const Vector& vector, double unit) {
  return {vector[0] / unit, vector[1] / unit, vector[2] / unit};
}

/// sigma n of the strain.
Vector traction_of(const Material& material, int dimension, const std::array<double, 6>& strain, const Vector& normal) {
  double trace = 0;
  for (int i = 0; i < dimension; ++i) trace += strain[i];
  Vector traction{};
  for (int i = 0; i < dimension; ++i) {
    traction[i] = material.lambda * trace * normal[i];
    for (int j = 0; j < dimension; ++j)
      traction[i] += 2 * material.mu * strain[symmetric_index(dimension, i, j)] * normal[j];
  }
  return traction;
}

}  // namespace

FarField::State FarField::given(BoundaryCondition& condition, const SidePoint& side, double time) const {
  return {divided(condition.far_field_velocity(side.position, time), scaling_.speed),
          divided(condition.value(side.position, time, side.normal), scaling_.stress())};
}

FarField::State FarField::initial(const Material& material, const SidePoint& side) {
  const InitialPoint state = initial_.on_side(side);
  return {divided(state.velocity, scaling_.speed),
          traction_of(material, scaling_.dimension, state.strain, side.normal)};
}

Vector FarField::incoming_amplitude(BoundaryCondition& condition, int material, const SidePoint& side, double time) {
  const Material& solid = materials_[material];
  const State state = condition.has_far_field() ? given(condition, side, time) : initial(solid, side);
  const double along_normal = solid.density * solid.dilatational_speed(), across = solid.density * solid.shear_speed();
  double normal_velocity = 0;
  for (int i = 0; i < scaling_.dimension; ++i) normal_velocity += state.velocity[i] * side.normal[i];
  Vector amplitude{};
  for (int i = 0; i < scaling_.dimension; ++i)
    amplitude[i] =
        state.traction[i] + across * state.velocity[i] + (along_normal - across) * normal_velocity * side.normal[i];
  return amplitude;
}

}  // namespace tentpole
