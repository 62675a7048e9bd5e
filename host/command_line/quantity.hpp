#pragma once

#include <cstdint>
#include <string>

namespace tentpole {

/// Numbers as the terminal shows them: short, for people. Files use number_text (host/case_file) instead.

/// Four significant digits, e.g. "2.5e-05".
std::string short_number(double value);

/// "12,345".
std::string count_text(std::int64_t count);

/// The same for a whole number that may be beyond all integers: "12,345", "1.2e+300".
std::string estimate_text(double count);

/// "812 B", "4.2 MB": powers of 1000.
std::string bytes_text(double num_bytes);

/// "0.123 s", "45.1 s", "3 min 20 s", "2 h 05 min", "1.2e+09 years".
std::string duration_text(double seconds);

}  // namespace tentpole
