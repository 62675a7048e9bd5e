#include "host/output/crack_strip.hpp"

#include <algorithm>
#include <cmath>

#include "host/output/time_coverage.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

double between(const std::array<double, 2>& ends, double fraction) {
  return (1 - fraction) * ends[0] + fraction * ends[1];
}

/// Cuts [begin, end] down to where time is above the line through `ends`, or (sign -1) not above it.
void cut(StripPart& part, const std::array<double, 2>& ends, double time, double sign) {
  const double first = sign * (time - ends[0]), last = sign * (time - ends[1]);
  if (first <= 0 && last <= 0 && !(sign < 0 && first == 0 && last == 0)) part.end = part.begin;
  if ((first > 0) == (last > 0)) return;
  const double crossing = first / (first - last);
  if (first > 0)
    part.end = std::min(part.end, crossing);
  else
    part.begin = std::max(part.begin, crossing);
}

}  // namespace

double CrackStrip::time_min() const {
  return std::min(old_time[0], old_time[1]);
}
double CrackStrip::time_max() const {
  return std::max(new_time[0], new_time[1]);
}

std::array<double, 3> CrackStrip::position(double fraction) const {
  std::array<double, 3> point;
  for (int axis = 0; axis < 3; ++axis) point[axis] = (1 - fraction) * end[0][axis] + fraction * end[1][axis];
  return point;
}

double CrackStrip::measure() const {
  if (dimension == 1) return 1;
  double square = 0;
  for (int axis = 0; axis < 3; ++axis) square += (end[1][axis] - end[0][axis]) * (end[1][axis] - end[0][axis]);
  return std::sqrt(square);
}

std::optional<StripPart> part_at(const CrackStrip& strip, double time) {
  constexpr double a_point = 1e-9;
  if (strip.dimension == 1) {
    if (!covers(strip.old_time[0], strip.new_time[0], time)) return std::nullopt;
    return StripPart{0, 1};
  }
  StripPart part{0, 1};
  if (time == 0) {
    if (strip.old_time[0] == 0 && strip.old_time[1] == 0) return part;
    return std::nullopt;
  }
  cut(part, strip.old_time, time, 1);
  cut(part, strip.new_time, time, -1);
  if (part.end - part.begin <= a_point) return std::nullopt;
  return part;
}

CrackEdgeState damage_at(const CrackStrip& strip, const StripPart& part, double time) {
  CrackEdgeState state = restrict_to_part(strip.below, part.begin, part.end);
  const CrackEdgeState above = restrict_to_part(strip.above, part.begin, part.end);
  const Quadrature rule = gauss_jacobi(state.num_points, 0);
  for (int point = 0; point < state.num_points; ++point) {
    const double fraction = strip.dimension == 1 ? 0 : part.begin + (part.end - part.begin) * rule.points[point];
    const double low = between(strip.old_time, fraction), high = between(strip.new_time, fraction);
    const double risen = high > low ? std::clamp((time - low) / (high - low), 0.0, 1.0) : 1;
    state.damage[point] = (1 - risen) * state.damage[point] + risen * above.damage[point];
  }
  return state;
}

}  // namespace tentpole
