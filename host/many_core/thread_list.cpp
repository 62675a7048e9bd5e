#include "host/many_core/thread_list.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "host/case_file/input_error.hpp"

namespace tentpole {
namespace {

[[noreturn]] void refuse(const std::string& list, const std::string& part, const std::string& reason) {
  throw InputError("--threads " + list + ": \"" + part + "\" " + reason +
                   ". Give numbers and ranges, e.g. 1-120 or 1,2,4-8.");
}

int count_in(const std::string& list, const std::string& part, const std::string& digits) {
  int count = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, count);
  if (error == std::errc::result_out_of_range || (error == std::errc{} && stop == end && count > max_model_threads))
    refuse(list, part, "is more than " + std::to_string(max_model_threads) + " threads");
  if (error != std::errc{} || stop != end) refuse(list, part, "is neither a number nor a range");
  if (count < 1) refuse(list, part, "is no number of threads");
  return count;
}

}  // namespace

std::vector<int> parse_thread_list(const std::string& text) {
  std::set<int> counts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    const std::string part = text.substr(start, comma - start);
    const std::size_t dash = part.find('-');
    const int first = count_in(text, part, part.substr(0, dash));
    const int last = dash == std::string::npos ? first : count_in(text, part, part.substr(dash + 1));
    if (last < first) refuse(text, part, "runs backwards");
    for (int count = first; count <= last; ++count) counts.insert(count);
    start = comma + 1;
  }
  return {counts.begin(), counts.end()};
}

}  // namespace tentpole
