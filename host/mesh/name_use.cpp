#include "host/mesh/name_use.hpp"

#include <algorithm>

namespace tentpole {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool NameUse::has_region(const std::string& name) const {
  return contains(regions, name);
}

bool NameUse::has_boundary(const std::string& name) const {
  return contains(boundaries, name);
}

bool NameUse::has_crack(const std::string& name) const {
  return contains(cracks, name);
}

NameChoice choose_name(const std::vector<bool>& is_used) {
  NameChoice choice;
  bool has_used = false;
  for (std::size_t name = 0; name < is_used.size(); ++name) {
    if (!is_used[name]) continue;
    if (!has_used)
      choice.chosen = name;
    else if (!choice.rival)
      choice.rival = name;
    has_used = true;
  }
  return choice;
}

}  // namespace tentpole
