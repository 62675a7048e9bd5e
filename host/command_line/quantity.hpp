#pragma once

#include <cstdint>
#include <string>

namespace tentpole {

/// Numbers as the terminal shows them: short, for people. Files use number_text (host/case_file) instead.

/// Four significant digits, e.g. "2.5e-05".
std::string short_number(double value);

/// "12,345".
std::string count_text(std::int64_t count);

/// "812 B", "4.2 MB": powers of 1000.
std::string bytes_text(double num_bytes);

/// "0.123 s", "45.1 s", "3 min 20 s", "2 h 05 min".
std::string duration_text(double seconds);

}  // namespace tentpole
