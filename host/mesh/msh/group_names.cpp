#include "host/mesh/msh/group_names.hpp"

#include <algorithm>
#include <span>

namespace tentpole {

bool GroupNames::is_used(const std::string& name, bool is_cell) const {
  return !use_ || (is_cell ? use_->has_region(name) : use_->has_boundary(name));
}

std::vector<std::string> GroupNames::counting_names(const MshBlock& block, bool is_cell) const {
  std::span<const std::int64_t> groups(&block.group, block.group != 0 ? 1 : 0);
  if (contents_.has_entities) {
    const auto found = contents_.groups.find(block.entity);
    groups = found == contents_.groups.end() ? std::span<const std::int64_t>() : std::span(found->second);
  }
  std::vector<std::string> names;
  int num_used = 0;
  for (const std::int64_t group : groups) {
    const std::string name = contents_.name_of(block.type->dimension, group);
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const bool counts = num_used < 2 && is_used(name, is_cell);
    num_used += counts;
    if (counts || (!is_cell && use_ && use_->has_crack(name))) names.push_back(name);
  }
  if (names.empty() && !groups.empty()) names.push_back(contents_.name_of(block.type->dimension, groups[0]));
  return names;
}

const std::vector<std::string>& GroupNames::of(const MshBlock& block, bool is_cell) {
  const MshTag source = contents_.has_entities ? block.entity : MshTag{0, block.group};
  const auto [found, is_new] = known_.try_emplace({block.type->dimension, source});
  if (is_new) found->second = counting_names(block, is_cell);
  return found->second;
}

}  // namespace tentpole
