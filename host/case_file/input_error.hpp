#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace tentpole {

/// Where a value of the case was written.
struct SourceLocation {
  std::string file;   ///< path as the user gave it, or "--set" for an override from the command line
  int line = 0;       ///< from 1; 0 where there is none
  int column = 0;     ///< from 1; of syntax errors only, else 0
  std::string key;    ///< full key, e.g. "material.all.poisson_ratio"
  std::string value;  ///< as written, e.g. "0.7"; empty where the key is missing or a table

  bool is_override() const { return file == "--set"; }
};

/// "case.toml:14: material.all.poisson_ratio = 0.7" or "--set material.all.poisson_ratio=0.7".
std::string to_string(const SourceLocation& location);

/// One fault of the input: where it is, and what is wrong together with the way out.
struct Problem {
  SourceLocation location;
  std::string reason;
};

/// "case.toml:14: material.all.poisson_ratio = 0.7: must lie in (-1, 0.5). Give a ratio below 0.5."
std::string to_string(const Problem& problem);

/// Everything that is wrong with the user's input, all problems at once; what() has one line per problem.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  /// A fault without a place in a case file, e.g. of a mesh; `message` names the place itself.
  explicit InputError(const std::string& message);

  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace tentpole
