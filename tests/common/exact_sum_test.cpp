#include "common/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

std::vector<double> terms_of_all_sizes(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 290);
  std::vector<double> terms;
  for (int i = 0; i < count; ++i) terms.push_back(std::ldexp(mantissa(random), exponent(random)));
  return terms;
}

double sum(const std::vector<double>& terms) {
  ExactSum total;
  for (const double term : terms) total += term;
  return total.value();
}

TEST(ExactSum, KeepsWhatOrdinarySumsLose) {
  ExactSum total;
  for (const double term : {1e100, 1.0, -1e100}) total += term;
  EXPECT_EQ(total.value(), 1.0);
}

TEST(ExactSum, DoesNotDependOnTheOrder) {
  std::vector<double> terms = terms_of_all_sizes(2000);
  const double first = sum(terms);
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(terms.begin(), terms.end(), random);
    EXPECT_EQ(sum(terms), first);
  }
}

TEST(ExactSum, GivesBackSingleNumbersAndTheirNegatives) {
  for (const double term : terms_of_all_sizes(200)) {
    EXPECT_EQ(sum({term}), term);
    EXPECT_EQ(sum({term, -term}), 0.0);
    EXPECT_EQ(sum({-term, -term}), -2 * term);
  }
  const double smallest = std::numeric_limits<double>::denorm_min(), largest = std::numeric_limits<double>::max();
  for (const double term : {smallest, -smallest, std::numeric_limits<double>::min(), largest, -largest})
    EXPECT_EQ(sum({term}), term);
}

TEST(ExactSum, AddsPartialSumsExactly) {
  const std::vector<double> terms = terms_of_all_sizes(100);
  ExactSum left, right;
  for (std::size_t i = 0; i < terms.size(); ++i) (i % 3 ? left : right) += terms[i];
  left += right;
  EXPECT_EQ(left.value(), sum(terms));
}

TEST(ExactSum, IsSoundAsSumsLeaveItAndNotWithAnyBytes) {
  ExactSum sound;
  for (const double term : terms_of_all_sizes(1000)) {
    sound += term;
    EXPECT_TRUE(sound.is_sound());
  }
  ExactSum twice = sound;
  twice += sound;
  EXPECT_TRUE(twice.is_sound());
  twice += std::nan("");
  EXPECT_TRUE(twice.is_sound());
  const std::int64_t number = std::int64_t{1} << 62;
  for (std::size_t place = 0; place + sizeof number <= sizeof(ExactSum); place += sizeof number) {
    ExactSum bad = sound;
    std::memcpy(reinterpret_cast<char*>(&bad) + place, &number, sizeof number);
    EXPECT_FALSE(bad.is_sound()) << "byte " << place;
  }
}

TEST(ExactSum, IsNotANumberOnceATermIsNotFinite) {
  EXPECT_TRUE(std::isnan(sum({1, std::numeric_limits<double>::infinity(), 2})));
  EXPECT_TRUE(std::isnan(sum({std::nan(""), 1})));
}

}  // namespace
}  // namespace tentpole
