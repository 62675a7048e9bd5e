#include "device/target_runtime.hpp"

#include <stdexcept>

namespace tentpole::target_runtime {

namespace {

[[noreturn]] void refuse() {
  throw std::logic_error("a build without device images has no target devices");
}

}  // namespace

bool has_device_images() {
  return false;
}

int image_architecture() {
  return 0;
}

int num_devices() {
  return 0;
}

Probe probe(int) {
  refuse();
}

void* allocate(int, std::size_t) {
  refuse();
}

void release(int, void*) {
  refuse();
}

void copy_to(int, void*, const void*, std::size_t) {
  refuse();
}

void copy_from(int, void*, const void*, std::size_t) {
  refuse();
}

void launch_empty(int) {
  refuse();
}

void copy_words(int, std::uint64_t*, const std::uint64_t*, std::int64_t) {
  refuse();
}

void pack_rows(int, SlotRows) {
  refuse();
}

void unpack_rows(int, SlotRows) {
  refuse();
}

}  // namespace tentpole::target_runtime
