#include "host/run/out_of_memory.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "device/free_memory.hpp"

namespace tentpole {
namespace {

/// Seen by operator new, whoever calls it.
std::atomic<void*> reserve = nullptr;
std::atomic<bool> is_given_back = false;

void give_back_reserve() {
  is_given_back = true;
  std::free(reserve.exchange(nullptr));
}

std::string mebibytes(double num_bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g MiB", num_bytes / (1 << 20));
  return text;
}

}  // namespace

MemoryReserve::~MemoryReserve() {
  std::free(reserve.exchange(nullptr));
  is_given_back = false;
}

void MemoryReserve::hold(std::size_t num_bytes) {
  if (num_bytes <= num_bytes_ || is_given_back) return;
  void* larger = std::malloc(num_bytes);
  if (larger == nullptr) return;
  std::free(reserve.exchange(larger));
  num_bytes_ = num_bytes;
}

std::string out_of_memory_text(const std::bad_alloc& error) {
  std::string text = "out of memory: ";
  if (const auto* sized = dynamic_cast<const OutOfMemory*>(&error))
    text += mebibytes(static_cast<double>(sized->num_bytes())) + " were asked for";
  else
    text += "an allocation failed";
  if (const auto free = free_host_memory()) text += ", " + mebibytes(static_cast<double>(*free)) + " are free";
  return text +
         ". `tentpole check` says what a case needs; give fewer cells, a lower degree or fewer snapshots, or more "
         "memory.";
}

}  // namespace tentpole

// Those of the standard library say neither how much was wanted nor give a reserve back. Arrays, and forms without
// exceptions, come here too.
void* operator new(std::size_t num_bytes) {
  if (void* memory = std::malloc(num_bytes > 0 ? num_bytes : 1)) return memory;
  tentpole::give_back_reserve();
  throw tentpole::OutOfMemory(num_bytes);
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
