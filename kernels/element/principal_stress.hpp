#pragma once

#include <cmath>

namespace tentpole {

/// Largest eigenvalue of a symmetric D x D tensor (closed forms; D = 3 by the trigonometric solution of the cubic).
template <int D>
inline double largest_principal(const double (&s)[D][D]) {
  if constexpr (D == 1) {
    return s[0][0];
  } else if constexpr (D == 2) {
    const double mean = 0.5 * (s[0][0] + s[1][1]), half = 0.5 * (s[0][0] - s[1][1]);
    return mean + sqrt(half * half + s[0][1] * s[0][1]);
  } else {
    const double mean = (s[0][0] + s[1][1] + s[2][2]) / 3;
    double deviator = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double value = s[i][j] - (i == j ? mean : 0);
        deviator += value * value;
      }
    const double p = sqrt(deviator / 6);
    if (!(p > 0)) return mean;
    const double a = (s[0][0] - mean) / p, b = (s[1][1] - mean) / p, c = (s[2][2] - mean) / p;
    const double x = s[0][1] / p, y = s[1][2] / p, z = s[0][2] / p;
    const double half_determinant = 0.5 * (a * (b * c - y * y) - x * (x * c - y * z) + z * (x * y - b * z));
    const double angle = acos(fmin(1.0, fmax(-1.0, half_determinant))) / 3;
    return mean + 2 * p * cos(angle);
  }
}

}  // namespace tentpole
