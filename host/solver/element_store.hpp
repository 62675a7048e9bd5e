#pragma once

#include <cstdint>
#include <vector>

namespace tentpole {

/// Hands out slots of the element store and takes them back. A slot released while a batch is built may still be read
/// by that batch; it becomes free when `end_batch` is called, because later batches run after it. So the store holds
/// the elements that a front cell refers to, plus one batch: memory is proportional to the front.
class ElementStore {
 public:
  std::int32_t acquire() {
    if (free_.empty()) return num_slots_++;
    const std::int32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  void release(std::int32_t slot) { released_.push_back(slot); }
  void end_batch() {
    free_.insert(free_.end(), released_.rbegin(), released_.rend());
    released_.clear();
  }
  /// Slots in use or free: what the device must hold.
  std::int32_t num_slots() const { return num_slots_; }

 private:
  std::int32_t num_slots_ = 0;
  std::vector<std::int32_t> free_;
  std::vector<std::int32_t> released_;
};

}  // namespace tentpole
