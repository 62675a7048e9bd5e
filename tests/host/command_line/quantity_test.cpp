#include "host/command_line/quantity.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(Quantity, CountsHaveACommaEveryThreeDigits) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1000), "1,000");
  EXPECT_EQ(count_text(12345678), "12,345,678");
  EXPECT_EQ(count_text(-100), "-100");
  EXPECT_EQ(count_text(-1234), "-1,234");
}

TEST(Quantity, CountsBeyondAllIntegersHaveAnExponent) {
  EXPECT_EQ(estimate_text(12345.0), "12,345");
  EXPECT_EQ(estimate_text(999999999999999.0), "999,999,999,999,999");
  EXPECT_EQ(estimate_text(1.25e300), "1.25e+300");
  EXPECT_EQ(estimate_text(HUGE_VAL), "inf");
}

TEST(Quantity, BytesNeverShowAThousandOfAUnit) {
  EXPECT_EQ(bytes_text(0), "0 B");
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(999.6), "1.0 kB");
  EXPECT_EQ(bytes_text(4.24e6), "4.2 MB");
  EXPECT_EQ(bytes_text(123.4e9), "123 GB");
  EXPECT_EQ(bytes_text(5e15), "5000 TB");
}

TEST(Quantity, DurationsNeverShowSixtySecondsOrMinutes) {
  EXPECT_EQ(duration_text(0), "0.000 s");
  EXPECT_EQ(duration_text(0.1234), "0.123 s");
  EXPECT_EQ(duration_text(9.9996), "10.0 s");
  EXPECT_EQ(duration_text(59.94), "59.9 s");
  EXPECT_EQ(duration_text(59.96), "1 min 00 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(3599.6), "1 h 00 min");
  EXPECT_EQ(duration_text(7500), "2 h 05 min");
  EXPECT_EQ(duration_text(3.15576e300), "1e+293 years");
}

}  // namespace
}  // namespace tentpole
