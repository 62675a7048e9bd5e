#include "host/case_file/input_error.hpp"

#include "host/mesh/printable.hpp"

namespace tentpole {
namespace {

std::string join(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += (text.empty() ? "" : "\n") + to_string(problem);
  return text;
}

}  // namespace

std::string to_string(const SourceLocation& location) {
  const std::string value = printable(location.value);
  if (location.is_override()) return "--set " + printable(location.key) + (value.empty() ? "" : "=" + value);
  std::string text = printable(location.file);
  if (location.line > 0) text += ":" + std::to_string(location.line);
  if (location.column > 0) text += ":" + std::to_string(location.column);
  if (!location.key.empty()) text += (text.empty() ? "" : ": ") + printable(location.key);
  if (!value.empty()) text += " = " + value;
  return text;
}

std::string to_string(const Problem& problem) {
  const std::string place = to_string(problem.location);
  return place.empty() ? problem.reason : place + ": " + problem.reason;
}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(join(problems)), problems_(std::move(problems)) {}

InputError::InputError(const std::string& message) : InputError(std::vector<Problem>{{{}, message}}) {}

}  // namespace tentpole
