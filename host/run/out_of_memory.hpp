#pragma once

#include <cstddef>
#include <new>
#include <string>

namespace tentpole {

/// What the operator new of the program throws: std::bad_alloc with the size that could not be had.
class OutOfMemory : public std::bad_alloc {
 public:
  explicit OutOfMemory(std::size_t num_bytes) : num_bytes_(num_bytes) {}
  const char* what() const noexcept override { return "out of memory"; }
  std::size_t num_bytes() const { return num_bytes_; }

 private:
  std::size_t num_bytes_;
};

/// Memory that nobody uses, so that there is some when there is no more: the first allocation that fails gives it back
/// before it throws, and the program can clear up and write a checkpoint. Untouched pages take addresses but no memory.
/// There is one reserve at a time.
class MemoryReserve {
 public:
  MemoryReserve() = default;
  ~MemoryReserve();
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

  /// Holds at least this much; keeps what it has where there is no more. Nothing once the reserve was given back.
  void hold(std::size_t num_bytes);

 private:
  std::size_t num_bytes_ = 0;
};

/// One sentence for the user: what was asked for, what was there, the way out.
std::string out_of_memory_text(const std::bad_alloc& error);

}  // namespace tentpole
