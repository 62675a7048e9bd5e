#pragma once

#include <functional>
#include <vector>

#include "bench/assembly/element_updates.hpp"
#include "device/device.hpp"
#include "device/traffic_counters.hpp"

namespace tentpole {

/// A row-major matrix of which an element's updates change blocks of n x n.
struct MatrixView {
  double* entries;
  long stride;

  double* row(long index) const { return entries + index * stride; }
  MatrixView block(long row_block, long column_block, long size) const {
    return {entries + row_block * size * stride + column_block * size, stride};
  }
};

/// Adds one update to a block: the double loop over rows and columns, which each rung of the thesis writes its own way.
/// The block holds num_unknowns rows and columns.
using AddUpdate = std::function<void(const UpdateRows& update, MatrixView block)>;

/// The ladder of the thesis (section 3.3); a file each, named like the function without `add_`.
void add_with_library_operators(const UpdateRows& update, MatrixView block);
void add_sequential(const UpdateRows& update, MatrixView block);
void add_vectorized(const UpdateRows& update, MatrixView block);
void add_threaded_rows(const UpdateRows& update, MatrixView block, int num_threads);

/// All updates of an element, one after the other, into the blocks of the patch matrix that starts at `patch_matrix`;
/// first_element is the patch's. The blocks are zeroed by the caller.
void assemble_updates(const ElementUpdates& updates, int element, int first_element, MatrixView patch_matrix,
                      const AddUpdate& add);

/// Points in parallel: every thread forms the rows of its points, and adds them in a critical section.
void assemble_threaded_quadrature(const ElementUpdates& updates, int element, int first_element,
                                  MatrixView patch_matrix, int num_threads);

/// The double loop on a device; block and rows cross the border for every update.
void assemble_offload_transfer(const ElementUpdates& updates, int element, int first_element, MatrixView patch_matrix,
                               const Device& device, int num_threads, TrafficCounters& traffic);
/// The same with the element's matrix blocks kept on the device; they come down once, at the end.
void assemble_offload_persistent(const ElementUpdates& updates, int element, int first_element, MatrixView patch_matrix,
                                 const Device& device, int num_threads, TrafficCounters& traffic);

}  // namespace tentpole
