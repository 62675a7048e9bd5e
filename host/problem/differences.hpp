#pragma once

#include <array>

namespace tentpole {

/// Derivative of a vector function at offset 0 by the central difference of order 6,
/// (45 (f1 - f-1) - 9 (f2 - f-2) + (f3 - f-3)) / (60 step); exact up to degree 6.
template <class Function>
std::array<double, 3> central_difference(const Function& function, double step) {
  constexpr double weight[3] = {45.0 / 60, -9.0 / 60, 1.0 / 60};
  std::array<double, 3> derivative{};
  for (int k = 1; k <= 3; ++k) {
    const std::array<double, 3> ahead = function(k * step), behind = function(-k * step);
    for (int i = 0; i < 3; ++i) derivative[i] += weight[k - 1] * (ahead[i] - behind[i]) / step;
  }
  return derivative;
}

/// Derivative of a vector function at offset 0 from values at 0, -step, .., -6 step only; exact up to degree 6.
template <class Function>
std::array<double, 3> backward_difference(const Function& function, double step) {
  constexpr double weight[7] = {49.0 / 20, -6, 15.0 / 2, -20.0 / 3, 15.0 / 4, -6.0 / 5, 1.0 / 6};
  std::array<double, 3> derivative{};
  for (int k = 0; k < 7; ++k) {
    const std::array<double, 3> value = function(-k * step);
    for (int i = 0; i < 3; ++i) derivative[i] += weight[k] * value[i] / step;
  }
  return derivative;
}

}  // namespace tentpole
