#include "host/command_line/quantity.hpp"

#include <cmath>
#include <cstdio>

namespace tentpole {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[64];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::string short_number(double value) {
  return formatted("%.4g", value);
}

std::string count_text(std::int64_t count) {
  std::string text = std::to_string(count);
  const int first_digit = count < 0 ? 1 : 0;
  for (int place = static_cast<int>(text.size()) - 3; place > first_digit; place -= 3) text.insert(place, ",");
  return text;
}

std::string estimate_text(double count) {
  constexpr double largest_exact = 1e15;
  return std::abs(count) < largest_exact ? count_text(static_cast<std::int64_t>(std::llround(count)))
                                         : short_number(count);
}

std::string bytes_text(double num_bytes) {
  const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
  int unit = 0;
  while (num_bytes >= 999.5 && unit < 4) {
    num_bytes /= 1000;
    ++unit;
  }
  return formatted(unit == 0 || num_bytes >= 99.95 ? "%.0f %s" : "%.1f %s", num_bytes, units[unit]);
}

std::string duration_text(double seconds) {
  if (seconds < 9.9995) return formatted("%.3f s", seconds);
  if (seconds < 59.95) return formatted("%.1f s", seconds);
  if (!(seconds < 1e11)) return short_number(seconds / (365.25 * 86400)) + " years";
  const auto whole = std::llround(seconds);
  if (whole < 3600) return formatted("%lld min %02lld s", whole / 60, whole % 60);
  return formatted("%lld h %02lld min", whole / 3600, whole % 3600 / 60);
}

}  // namespace tentpole
