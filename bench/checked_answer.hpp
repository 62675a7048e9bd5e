#pragma once

#include <span>
#include <string>

namespace tentpole {

/// max |computed - expected| / max |expected|; infinity where an entry is not finite or the sizes differ.
double relative_difference(std::span<const double> computed, std::span<const double> expected);

/// Returns `error` if it is at most `limit`. Otherwise (NaN included) says on stderr what was wrong and ends the
/// program with exit code 1, so that no rate of a wrong answer is ever printed. what: driver, variant and sizes, as in
/// "bench_assembly: sequential, d = 4, k = 7".
double require_answer(const std::string& what, double error, double limit);

}  // namespace tentpole
