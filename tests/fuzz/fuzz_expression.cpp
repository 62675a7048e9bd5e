#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "host/case_file/expression.hpp"

// The way of an expression, from its text to values. Whatever the text is, it makes an expression whose copies agree
// and whose values are finite, or an InputError; anything else ends the program.
namespace tentpole {
namespace {

void require(bool holds, const char* invariant) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", invariant);
  std::abort();
}

/// The value, or NaN where it is refused.
double value_at(Expression& expression, const std::array<double, 3>& point, double time) {
  try {
    const double value = expression.evaluate(point, time);
    require(std::isfinite(value), "a value is finite");
    return value;
  } catch (const InputError& error) {
    require(error.problems().size() == 1, "a refusal has one reason");
    return std::nan("");
  }
}

void check_copies(const Expression& expression) {
  Expression first = expression, second;
  second = first;
  Expression third = std::move(first);
  for (const double time : {0.0, 0.5}) {
    const double value = value_at(second, {0.3, -1, 2}, time), other = value_at(third, {0.3, -1, 2}, time);
    require(value == other || (std::isnan(value) && std::isnan(other)), "copies have the same values");
    if (expression.is_zero()) require(value == 0, "zero is zero");
  }
}

}  // namespace
}  // namespace tentpole

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tentpole;
  const std::string text(reinterpret_cast<const char*>(data), size);
  static const Constants constants{{"V", 6.1}, {"px", -0.25}, {"e_1", 1e300}};
  try {
    check_copies(Expression(text, constants, {"input", 1, 0, "key", ""}));
  } catch (const InputError& error) {
    require(error.what()[0] != '\0', "a refusal has a message");
  }
  return 0;
}
