#pragma once

#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace tentpole {

/// Raw bytes of one value in and out of a checkpoint stream (same machine type only).
template <class Value>
requires std::is_trivially_copyable_v<Value>
void write_value(std::ostream& stream, const Value& value) {
  stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Throws std::runtime_error where the stream ends early.
template <class Value>
requires std::is_trivially_copyable_v<Value> Value read_value(std::istream& stream) {
  Value value{};
  if (!stream.read(reinterpret_cast<char*>(&value), sizeof value))
    throw std::runtime_error("the output section of the checkpoint ends early; the checkpoint is damaged");
  return value;
}

template <class Value>
void write_vector(std::ostream& stream, const std::vector<Value>& values) {
  write_value(stream, static_cast<std::int64_t>(values.size()));
  for (const Value& value : values) write_value(stream, value);
}

template <class Value>
std::vector<Value> read_vector(std::istream& stream) {
  // Grown one by one, so a damaged length meets the end of the stream before it exhausts the memory.
  std::vector<Value> values;
  for (auto left = read_value<std::int64_t>(stream); left > 0; --left) values.push_back(read_value<Value>(stream));
  return values;
}

}  // namespace tentpole
