#pragma once

#include <array>
#include <cstdint>

namespace tentpole {

/// What random numbers are drawn for: numbers of different purposes are independent for the same seed.
enum class RandomPurpose : std::uint64_t { defect_field = 1, defect_tests = 2 };

struct RandomKey {
  std::uint64_t seed;
  RandomPurpose purpose;
};

using RandomCounter = std::array<std::uint64_t, 4>;

/// Four numbers, independent and uniform in the open interval (0, 1), that depend on key and counter only: the same on
/// every machine and in every order. Philox4x64-10 (Salmon et al., SC 2011), 52 bits of each word.
std::array<double, 4> uniform_numbers(const RandomKey& key, const RandomCounter& counter);

/// The number of points of a Poisson process with this mean, at most largest_poisson_mean, by inversion of its
/// distribution at a uniform number in (0, 1).
std::int64_t poisson_number(double mean, double uniform);

inline constexpr double largest_poisson_mean = 30;

}  // namespace tentpole
