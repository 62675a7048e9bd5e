#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/mesh/msh/msh_contents.hpp"
#include "host/mesh/name_use.hpp"

namespace tentpole {

/// The names of the groups of elements, as far as they can count: an element may be in thousands of groups.
class GroupNames {
 public:
  /// Keeps references. Without `use` all names are used.
  GroupNames(const MshContents& contents, const std::optional<NameUse>& use) : contents_(contents), use_(use) {}

  /// For cells: the first two used names of regions, or else the first name.
  const std::vector<std::string>& of_cells(const MshBlock& block) { return of(block, true); }
  /// For facets: the first two used names of boundaries and all names of cracks, or else the first name.
  const std::vector<std::string>& of_facets(const MshBlock& block) { return of(block, false); }

 private:
  const std::vector<std::string>& of(const MshBlock& block, bool is_cell);
  std::vector<std::string> counting_names(const MshBlock& block, bool is_cell) const;
  bool is_used(const std::string& name, bool is_cell) const;

  const MshContents& contents_;
  const std::optional<NameUse>& use_;
  std::map<std::pair<int, MshTag>, std::vector<std::string>> known_;  ///< by dimension, and entity or group
};

}  // namespace tentpole
