#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tentpole {

/// Finds nodes by their labels: in a table where labels lie close together, else by binary search.
class NodeIndex {
 public:
  explicit NodeIndex(std::span<const std::int64_t> labels);

  /// The index of the node with this label, or none.
  std::int32_t find(std::int64_t label) const;

  /// Two nodes with the same label, if there are any.
  std::optional<std::pair<std::int32_t, std::int32_t>> duplicate() const { return duplicate_; }

 private:
  void fill_table(std::span<const std::int64_t> labels);
  void fill_sorted(std::span<const std::int64_t> labels);

  std::int64_t lowest_ = 0;
  std::vector<std::int32_t> table_;                            ///< [label - lowest_]; empty: look into sorted_
  std::vector<std::pair<std::int64_t, std::int32_t>> sorted_;  ///< (label, index)
  std::optional<std::pair<std::int32_t, std::int32_t>> duplicate_;
};

}  // namespace tentpole
