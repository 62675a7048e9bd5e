#include "tests/host/output/sample_fields.hpp"

#include <algorithm>
#include <cmath>

namespace tentpole {

DisplacementField quadratic_field(int dimension) {
  return [dimension](std::span<const double> event) {
    std::array<double, 3> s{};
    for (int i = 0; i < dimension; ++i) s[i] = event[i] / 1e-3;
    const double time = event[dimension] / 1e-7;
    return std::array<double, 3>{1e-9 * (1 + s[0] * s[1] + time * time), 1e-9 * (s[0] * s[0] - 2 * s[1] * time),
                                 1e-9 * (s[2] * s[0] + s[1] * s[1])};
  };
}

DisplacementField wave_field(double length, double speed, double velocity, double ramp) {
  // int_0^s r^2 (3 - 2 r) ds with r = min(1, s / ramp).
  const auto distance = [ramp](double s) {
    const double r = std::clamp(s / ramp, 0.0, 1.0);
    return ramp * (r * r * r - r * r * r * r / 2) + std::max(0.0, s - ramp);
  };
  return [=](std::span<const double> event) {
    const double x = event[0], time = event.back();
    return std::array<double, 3>{velocity * (distance(time - (length - x) / speed) - distance(time - x / speed)), 0, 0};
  };
}

}  // namespace tentpole
