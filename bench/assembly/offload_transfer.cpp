// The thesis's first step to the coprocessor: every double loop is offloaded by itself, and its data, the matrix
// included, go up before and come down after. A block of a larger matrix is packed on the host for its journeys.
#include "bench/assembly/device_rows.hpp"
#include "bench/assembly/matrix_blocks.hpp"
#include "bench/assembly/rungs.hpp"

namespace tentpole {

void assemble_offload_transfer(const ElementUpdates& updates, int element, int first_element, MatrixView patch_matrix,
                               const Device& device, int num_threads, TrafficCounters& traffic) {
  const int n = updates.tables().num_unknowns;
  DeviceRows device_rows(updates, device, traffic);
  DeviceBuffer<double> device_block(device, traffic, static_cast<long>(n) * n);
  std::vector<double> scratch(updates.scratch_size()), packed(patch_matrix.stride == n ? 0 : device_block.size());
  for (int update = 0; update < updates.size(); ++update) {
    const MatrixView block =
        patch_matrix.block(element - first_element, updates.column_element(update) - first_element, n);
    DeviceUpdate on_device = device_rows.upload(updates.form(update, scratch.data()));
    const std::span<double> entries = packed.empty() ? std::span(block.entries, device_block.size()) : packed;
    if (!packed.empty()) pack_block(block, n, entries);
    device_block.upload(entries);
    on_device.block = device_block.pointer();
    add_on_device(on_device, device, num_threads);
    traffic.count_launch(sizeof on_device);
    device_block.download(entries);
    if (!packed.empty()) unpack_block(entries, n, block);
  }
}

}  // namespace tentpole
