#include "host/fracture/random_numbers.hpp"

#include <cassert>
#include <cmath>

#include <Random123/philox.h>

namespace tentpole {

std::array<double, 4> uniform_numbers(const RandomKey& key, const RandomCounter& counter) {
  r123::Philox4x64 philox;
  const r123::Philox4x64::key_type words{{key.seed, static_cast<std::uint64_t>(key.purpose)}};
  const auto bits = philox({{counter[0], counter[1], counter[2], counter[3]}}, words);
  std::array<double, 4> numbers;
  for (int i = 0; i < 4; ++i) numbers[i] = std::ldexp(static_cast<double>(bits[i] >> 12) + 0.5, -52);
  return numbers;
}

std::int64_t poisson_number(double mean, double uniform) {
  assert(mean >= 0 && mean <= largest_poisson_mean && "the probability of no point must not underflow");
  double term = std::exp(-mean), sum = term;
  std::int64_t number = 0;
  while (sum < uniform && term > 0) {
    ++number;
    term *= mean / static_cast<double>(number);
    sum += term;
  }
  return number;
}

}  // namespace tentpole
