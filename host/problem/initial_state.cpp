#include "host/problem/initial_state.hpp"

#include <cmath>

#include "common/simplex.hpp"
#include "host/problem/differences.hpp"

namespace tentpole {
namespace {

using Vector = std::array<double, 3>;

Vector moved(Vector point, const Vector& direction, double offset) {
  for (int axis = 0; axis < 3; ++axis) point[axis] += offset * direction[axis];
  return point;
}

Vector unit(int axis) {
  Vector direction{};
  direction[axis] = 1;
  return direction;
}

/// Adds the share of a derivative along a direction: sym(derivative (x) direction).
void add_strain(int dimension, const Vector& derivative, const Vector& direction, std::array<double, 6>& strain) {
  for (int axis = 0; axis < dimension; ++axis)
    for (int i = 0; i < dimension; ++i)
      strain[symmetric_index(dimension, i, axis)] += (i == axis ? 1.0 : 0.5) * derivative[i] * direction[axis];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Orthonormal directions along a side, dimension - 1 of them.
std::array<Vector, 2> tangents(int dimension, const Vector& normal) {
  if (dimension < 3) return {Vector{-normal[1], normal[0], 0}, Vector{}};
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (std::abs(normal[other]) < std::abs(normal[axis])) axis = other;
  Vector first = cross(normal, unit(axis));
  const double length = std::hypot(first[0], first[1], first[2]);
  for (double& component : first) component /= length;
  return {first, cross(normal, first)};
}

}  // namespace

InitialPoint InitialState::without_strain(const Vector& point) {
  return {velocity_.evaluate(point, 0), displacement_.evaluate(point, 0), {}};
}

InitialPoint InitialState::inside(const Vector& point, double step) {
  InitialPoint state = without_strain(point);
  for (int axis = 0; axis < dimension_; ++axis) {
    const auto along = [&](double offset) { return displacement_.evaluate(moved(point, unit(axis), offset), 0); };
    add_strain(dimension_, central_difference(along, step), unit(axis), state.strain);
  }
  return state;
}

InitialPoint InitialState::on_side(const SidePoint& side) {
  constexpr double depth_step = 0.02, width_step = 4e-3;
  InitialPoint state = without_strain(side.position);
  if (displacement_.is_zero()) return state;
  const auto outward = [&](double offset) {
    return displacement_.evaluate(moved(side.position, side.normal, offset), 0);
  };
  add_strain(dimension_, backward_difference(outward, depth_step * side.depth), side.normal, state.strain);
  const std::array<Vector, 2> directions = tangents(dimension_, side.normal);
  for (int number = 0; number + 1 < dimension_; ++number) {
    const auto along = [&](double offset) {
      return displacement_.evaluate(moved(side.position, directions[number], offset), 0);
    };
    add_strain(dimension_, central_difference(along, width_step * side.width), directions[number], state.strain);
  }
  return state;
}

}  // namespace tentpole
