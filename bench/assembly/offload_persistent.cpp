// The thesis's second step: the matrix stays on the device; only the rows of each point go up, and the blocks come down
// when the element is done.
#include <map>

#include "bench/assembly/device_rows.hpp"
#include "bench/assembly/matrix_blocks.hpp"
#include "bench/assembly/rungs.hpp"

namespace tentpole {

void assemble_offload_persistent(const ElementUpdates& updates, int element, int first_element, MatrixView patch_matrix,
                                 const Device& device, int num_threads, TrafficCounters& traffic) {
  const int n = updates.tables().num_unknowns;
  DeviceRows device_rows(updates, device, traffic);
  std::map<int, DeviceBuffer<double>> blocks;  // of each column element
  std::vector<double> scratch(updates.scratch_size()), entries(static_cast<std::size_t>(n) * n, 0.0);
  for (int update = 0; update < updates.size(); ++update) {
    const int column_element = updates.column_element(update);
    auto block = blocks.find(column_element);
    if (block == blocks.end()) {
      block = blocks.emplace(column_element, DeviceBuffer<double>(device, traffic, std::ssize(entries))).first;
      block->second.upload(entries);
    }
    DeviceUpdate on_device = device_rows.upload(updates.form(update, scratch.data()));
    on_device.block = block->second.pointer();
    add_on_device(on_device, device, num_threads);
    traffic.count_launch(sizeof on_device);
  }
  for (const auto& [column_element, block] : blocks) {
    block.download(entries);
    unpack_block(entries, n, patch_matrix.block(element - first_element, column_element - first_element, n));
  }
}

}  // namespace tentpole
