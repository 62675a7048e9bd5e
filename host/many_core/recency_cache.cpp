#include "host/many_core/recency_cache.hpp"

namespace tentpole {

bool RecencyCache::touch(std::int64_t block, double size) {
  const auto found = entries_.find(block);
  if (found != entries_.end()) {
    by_recency_.splice(by_recency_.begin(), by_recency_, found->second);
    return true;
  }
  by_recency_.push_front({block, size});
  entries_[block] = by_recency_.begin();
  used_ += size;
  while (used_ > capacity_ && !by_recency_.empty()) {
    used_ -= by_recency_.back().size;
    entries_.erase(by_recency_.back().block);
    by_recency_.pop_back();
  }
  return false;
}

}  // namespace tentpole
