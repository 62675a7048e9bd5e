#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace tentpole {

/// Smallest of n values under single changes: a complete binary tree of pairwise minima. A change costs O(log n) at
/// most and mostly O(1), since it stops where a parent keeps its value.
class MinimumTree {
 public:
  explicit MinimumTree(std::span<const double> values) : size_(values.size()), node_(2 * values.size()) {
    std::copy(values.begin(), values.end(), node_.begin() + size_);
    for (std::size_t i = size_; i-- > 1;) node_[i] = std::min(node_[2 * i], node_[2 * i + 1]);
  }

  double value() const { return node_[1]; }

  void change(int index, double value) {
    std::size_t i = size_ + static_cast<std::size_t>(index);
    node_[i] = value;
    while (i > 1) {
      i /= 2;
      const double smaller = std::min(node_[2 * i], node_[2 * i + 1]);
      if (smaller == node_[i]) return;
      node_[i] = smaller;
    }
  }

 private:
  std::size_t size_;
  std::vector<double> node_;  ///< node 1 is the root, leaves are size_ .. 2 size_ - 1
};

}  // namespace tentpole
