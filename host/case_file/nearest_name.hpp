#pragma once

#include <string>
#include <vector>

namespace tentpole {

/// What to say about an unknown name: "Did you mean "density"?" if a known name is near by edit distance (Levenshtein;
/// up to a third of the letters, at least two), else "Known: density, ...".
std::string suggestion(const std::string& name, const std::vector<std::string>& known);

}  // namespace tentpole
