#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>

#include "host/mesh/msh/byte_source.hpp"

namespace tentpole::testing {

/// Writes numbers as a .msh file of some encoding has them: the counterpart of ByteSource, and independent of it.
class MshWriter {
 public:
  explicit MshWriter(const MshEncoding& encoding) : encoding_(encoding) {}

  /// $MeshFormat of version "2.2" or "4.1".
  MshWriter& format(const std::string& version) {
    const int size = version == "2.2" ? 8 : encoding_.label_bytes;
    line("$MeshFormat").line(version + (encoding_.is_binary ? " 1 " : " 0 ") + std::to_string(size));
    if (encoding_.is_binary) integer(1).line("");
    return line("$EndMeshFormat");
  }
  MshWriter& line(const std::string& text) {
    bytes_ += text + "\n";
    return *this;
  }
  MshWriter& integer(std::int32_t value) { return put(value); }
  MshWriter& label(std::int64_t value) {
    if (encoding_.label_bytes == 4) return put(static_cast<std::int32_t>(value));
    return put(value);
  }
  MshWriter& number(double value) { return put(value); }
  MshWriter& integers(std::initializer_list<std::int32_t> values) {
    for (const std::int32_t value : values) integer(value);
    return *this;
  }
  MshWriter& labels(std::initializer_list<std::int64_t> values) {
    for (const std::int64_t value : values) label(value);
    return *this;
  }
  MshWriter& numbers(std::initializer_list<double> values) {
    for (const double value : values) number(value);
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  template <class Value>
  MshWriter& put(Value value) {
    if (!encoding_.is_binary) {
      std::ostringstream text;
      text.precision(17);
      text << value;
      bytes_ += text.str() + (++num_words_ % 7 == 0 ? "\n" : " ");  // the format does not care for lines
      return *this;
    }
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (encoding_.swaps_bytes) std::reverse(raw, raw + sizeof value);
    bytes_.append(raw, sizeof value);
    return *this;
  }

  MshEncoding encoding_;
  std::string bytes_;
  int num_words_ = 0;
};

}  // namespace tentpole::testing
