#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tentpole {

/// Sum of doubles without any rounding until it is read, so the result does not depend on the order of the terms.
/// A fixed-point number of 2176 bits in signed 32-bit digits kept in 64-bit words (Kulisch's long accumulator);
/// carries are resolved every 2^30 additions at most. Energies accumulated in it are bitwise equal for any batch size.
/// Not finite terms make the result NaN.
class ExactSum {
 public:
  ExactSum& operator+=(double term) {
    if (term == 0) return *this;
    if (!std::isfinite(term)) {
      is_not_finite_ = 1;
      return *this;
    }
    const auto bits = std::bit_cast<std::uint64_t>(term);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t mantissa = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
    const int position = biased == 0 ? 0 : biased - 1;  // term = mantissa * 2^(position - 1074)
    const int digit = position / 32, shift = position % 32;
    const std::uint64_t low = mantissa << shift;
    const std::uint64_t high = shift == 0 ? 0 : mantissa >> (64 - shift);
    const std::int64_t sign = term < 0 ? -1 : 1;
    digits_[digit] += sign * static_cast<std::int64_t>(low & 0xffffffffu);
    digits_[digit + 1] += sign * static_cast<std::int64_t>(low >> 32);
    digits_[digit + 2] += sign * static_cast<std::int64_t>(high);
    if (++pending_ >= max_pending) normalize();
    return *this;
  }

  ExactSum& operator+=(const ExactSum& other) {
    ExactSum right = other;
    right.normalize();
    normalize();
    for (int i = 0; i < num_digits; ++i) digits_[i] += right.digits_[i];
    pending_ += 1;
    is_not_finite_ |= right.is_not_finite_;
    return *this;
  }

  /// The sum rounded to double; the same for every order of the same terms.
  double value() const {
    if (is_not_finite_ != 0) return std::nan("");
    ExactSum copy = *this;
    copy.normalize();
    const bool negative = copy.digits_[num_digits - 1] < 0;
    if (negative) {
      for (auto& digit : copy.digits_) digit = -digit;
      copy.normalize();
    }
    double result = 0;
    for (int i = num_digits - 1; i >= 0; --i) result += std::ldexp(static_cast<double>(copy.digits_[i]), 32 * i - 1074);
    return negative ? -result : result;
  }

  /// Whether the members are such as sums leave them: bytes of a file may hold any others, with which sums overflow.
  bool is_sound() const {
    if (pending_ < 0 || pending_ >= max_pending || (is_not_finite_ != 0 && is_not_finite_ != 1)) return false;
    const std::int64_t largest = (pending_ + 2) << 32;  // every term adds less than 2^32 to a digit
    for (int i = 0; i < num_digits - 1; ++i)
      if (digits_[i] < -largest || digits_[i] > largest) return false;
    const std::int64_t last = digits_[num_digits - 1];  // of carries alone
    return last > -(std::int64_t{1} << 32) && last < std::int64_t{1} << 32;
  }

 private:
  static constexpr int num_digits = 68;
  static constexpr std::int64_t max_pending = std::int64_t{1} << 30;

  /// Carry so that every digit but the last lies in [0, 2^32).
  void normalize() {
    std::int64_t carry = 0;
    for (int i = 0; i < num_digits - 1; ++i) {
      const std::int64_t total = digits_[i] + carry;
      carry = total >> 32;
      digits_[i] = total - carry * (std::int64_t{1} << 32);
    }
    digits_[num_digits - 1] += carry;
    pending_ = 0;
  }

  std::array<std::int64_t, num_digits> digits_{};
  std::int64_t pending_ = 0;
  std::int64_t is_not_finite_ = 0;  ///< 1 once a term was not
};

}  // namespace tentpole
