#pragma once

#include <cstdint>
#include <list>
#include <unordered_map>

namespace tentpole {

/// A fully associative cache of blocks with least-recently-used replacement.
///
/// A block is found if it and all other blocks that were touched since its last touch fit into the capacity. Streaming
/// over the same blocks again and again therefore finds all of them or none.
class RecencyCache {
 public:
  /// Capacity [B].
  explicit RecencyCache(double capacity) : capacity_(capacity) {}

  /// Reads or writes a block of `size` [B], always the same for one block; true if it was in the cache.
  bool touch(std::int64_t block, double size);

 private:
  struct Entry {
    std::int64_t block;
    double size;
  };

  double capacity_;
  double used_ = 0;
  std::list<Entry> by_recency_;  ///< most recent first
  std::unordered_map<std::int64_t, std::list<Entry>::iterator> entries_;
};

}  // namespace tentpole
