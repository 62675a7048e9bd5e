#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/output/checkpoint_file.hpp"

namespace tentpole {

/// Numbers the slots in use 0, 1, .. in the order of the cells that refer to them first: cell_row [cell] is the row, or
/// none where the cell has no element. Returns the slot of every row.
std::vector<std::int32_t> number_rows(std::span<const std::int32_t> cell_slot, std::vector<std::int32_t>& cell_row);

/// Number of rows that the cells of a checkpoint refer to, of a front with this many cell slots. Throws
/// std::runtime_error unless rows are numbered as number_rows does, and facets have codes of the dimension.
std::int32_t num_element_rows(const CheckpointContents& contents, std::size_t num_cells, int dimension);

}  // namespace tentpole
