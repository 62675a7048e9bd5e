#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tentpole {

/// Which names of a mesh a case uses. A cell or facet in several groups has the name that is used.
struct NameUse {
  std::vector<std::string> regions;     ///< with a material of their own
  std::vector<std::string> boundaries;  ///< with a condition
  std::vector<std::string> cracks;      ///< sides inside the body that are cracks

  bool has_region(const std::string& name) const;
  bool has_boundary(const std::string& name) const;
  bool has_crack(const std::string& name) const;
};

/// Which of several names of one place counts: the used one, else the first. `rival` is another that is used.
struct NameChoice {
  std::size_t chosen = 0;
  std::optional<std::size_t> rival;
};

/// `is_used` goes with `names`, which are not none.
NameChoice choose_name(const std::vector<bool>& is_used);

}  // namespace tentpole
