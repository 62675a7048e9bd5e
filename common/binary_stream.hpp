#pragma once

#include <cmath>
#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace tentpole {

/// Raw bytes of one value in and out of a checkpoint stream (same machine type only). Reading takes any bytes: what is
/// read is a sound value or a std::runtime_error that names the byte.
template <class Value>
requires std::is_trivially_copyable_v<Value>
void write_value(std::ostream& stream, const Value& value) {
  stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Throws std::runtime_error with the place in the stream unless `holds`: call it after reading what is wrong.
inline void require_sound(std::istream& stream, bool holds, const std::string& fault) {
  if (!holds) throw std::runtime_error("before byte " + std::to_string(stream.tellg()) + ": " + fault);
}

inline std::int64_t bytes_left(std::istream& stream) {
  const auto here = stream.tellg();
  stream.seekg(0, std::ios::end);
  const auto end = stream.tellg();
  stream.seekg(here);
  return end - here;
}

/// Types with a member is_sound() are asked it.
template <class Value>
requires std::is_trivially_copyable_v<Value> Value read_value(std::istream& stream) {
  if (const std::int64_t left = bytes_left(stream); left < static_cast<std::int64_t>(sizeof(Value)))
    throw std::runtime_error("byte " + std::to_string(stream.tellg()) + ": " + std::to_string(sizeof(Value)) +
                             " bytes are needed and " + std::to_string(left) + " are left");
  Value value{};
  stream.read(reinterpret_cast<char*>(&value), sizeof value);
  if constexpr (requires { value.is_sound(); })
    require_sound(stream, value.is_sound(), "a number or code is out of its range");
  return value;
}

/// A number from 0 to `largest`.
template <class Number>
Number read_number(std::istream& stream, Number largest, const char* name) {
  const Number value = read_value<Number>(stream);
  require_sound(
      stream, value >= 0 && value <= largest,
      std::string(name) + " is " + std::to_string(value) + "; it must lie from 0 to " + std::to_string(largest));
  return value;
}

template <class Value>
void write_vector(std::ostream& stream, const std::vector<Value>& values) {
  write_value(stream, static_cast<std::int64_t>(values.size()));
  for (const Value& value : values) write_value(stream, value);
}

/// The length of a list whose entries take at least `entry_size` bytes each: no more than the stream can hold, so
/// memory may be reserved for it.
inline std::int64_t read_length(std::istream& stream, std::size_t entry_size) {
  const auto length = read_value<std::int64_t>(stream);
  const std::int64_t left = bytes_left(stream);
  require_sound(stream, length >= 0 && length <= left / static_cast<std::int64_t>(entry_size),
                "a list of " + std::to_string(length) + " entries of " + std::to_string(entry_size) + " bytes, where " +
                    std::to_string(left) + " bytes are left");
  return length;
}

template <class Value>
std::vector<Value> read_vector(std::istream& stream) {
  std::vector<Value> values(read_length(stream, sizeof(Value)));
  for (Value& value : values) stream.read(reinterpret_cast<char*>(&value), sizeof value);
  if constexpr (requires(const Value& value) { value.is_sound(); })
    for (const Value& value : values)
      require_sound(stream, value.is_sound(), "a number or code of a list is out of its range");
  return values;
}

/// Whether all numbers of an array are finite.
template <class Numbers>
bool all_finite(const Numbers& numbers) {
  for (const double number : numbers)
    if (!std::isfinite(number)) return false;
  return true;
}

}  // namespace tentpole
