#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

namespace tentpole {

/// Hands out slots of the element store and takes them back when the last front cell that refers to them lets go. A
/// slot let go while a batch is built may still be read by that batch; it becomes free when `end_batch` is called,
/// because later batches run after it. So the store holds the elements that a front cell refers to, plus one batch:
/// memory is proportional to the front.
class ElementStore {
 public:
  /// A free slot with one reference.
  std::int32_t acquire() {
    if (free_.empty()) {
      references_.push_back(1);
      return num_slots() - 1;
    }
    const std::int32_t slot = free_.back();
    free_.pop_back();
    references_[slot] = 1;
    return slot;
  }
  /// One more cell refers to the slot.
  void share(std::int32_t slot) { ++references_[slot]; }
  void release(std::int32_t slot) {
    assert(references_[slot] > 0 && "every reference is released once");
    if (--references_[slot] == 0) released_.push_back(slot);
  }
  void end_batch() {
    free_.insert(free_.end(), released_.rbegin(), released_.rend());
    released_.clear();
  }
  /// Slots in use or free: what the device must hold.
  std::int32_t num_slots() const { return static_cast<std::int32_t>(references_.size()); }

 private:
  std::vector<std::int32_t> references_;  ///< [slot]
  std::vector<std::int32_t> free_;
  std::vector<std::int32_t> released_;
};

}  // namespace tentpole
