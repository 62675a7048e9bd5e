#pragma once

#include <cstdio>
#include <string>

namespace tentpole {

/// A number for a message: six significant digits, also for tiny SI values (std::to_string would print 0.000000).
inline std::string printed(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace tentpole
