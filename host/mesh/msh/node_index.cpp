#include "host/mesh/msh/node_index.hpp"

#include <algorithm>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

NodeIndex::NodeIndex(std::span<const std::int64_t> labels) {
  if (labels.empty()) return;
  const auto [lowest, highest] = std::minmax_element(labels.begin(), labels.end());
  lowest_ = *lowest;
  // Unsigned, because the difference of two labels may not fit 63 bits. The bound keeps the table as small as the list.
  const std::uint64_t range = static_cast<std::uint64_t>(*highest) - static_cast<std::uint64_t>(lowest_);
  if (range < 4 * labels.size()) {
    table_.assign(range + 1, none);
    fill_table(labels);
  } else {
    fill_sorted(labels);
  }
}

void NodeIndex::fill_table(std::span<const std::int64_t> labels) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::int32_t& entry = table_[labels[i] - lowest_];
    if (entry != none && !duplicate_) duplicate_ = {entry, static_cast<std::int32_t>(i)};
    entry = static_cast<std::int32_t>(i);
  }
}

void NodeIndex::fill_sorted(std::span<const std::int64_t> labels) {
  sorted_.reserve(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) sorted_.emplace_back(labels[i], static_cast<std::int32_t>(i));
  std::sort(sorted_.begin(), sorted_.end());
  const auto same = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                       [](const auto& a, const auto& b) { return a.first == b.first; });
  if (same != sorted_.end()) duplicate_ = {same->second, (same + 1)->second};
}

std::int32_t NodeIndex::find(std::int64_t label) const {
  if (!table_.empty()) {
    const std::uint64_t offset = static_cast<std::uint64_t>(label) - static_cast<std::uint64_t>(lowest_);
    return offset < table_.size() ? table_[offset] : none;
  }
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{label, std::int32_t{0}});
  return found != sorted_.end() && found->first == label ? found->second : none;
}

}  // namespace tentpole
