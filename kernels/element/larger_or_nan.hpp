#pragma once

namespace tentpole {

/// The larger number; not a number if one of them is not (fmax would pass over it).
inline double larger_or_nan(double a, double b) {
  return b > a || b != b ? b : a;
}

}  // namespace tentpole
