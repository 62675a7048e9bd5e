#pragma once

#include <string>
#include <vector>

namespace tentpole {

/// The largest thread count and the largest matrix that the model takes.
constexpr int max_model_threads = 4096, max_model_rows = 100000;

/// Thread counts of a list such as "1-120" or "1,2,4-8", ascending and each once. Throws InputError, with the part that
/// is wrong, for anything else and for counts outside 1..max_model_threads.
std::vector<int> parse_thread_list(const std::string& text);

}  // namespace tentpole
