#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tentpole {

/// Numbers the slots in use 0, 1, .. in the order of the cells that refer to them first: cell_row [cell] is the row, or
/// none where the cell has no element. Returns the slot of every row.
std::vector<std::int32_t> number_rows(std::span<const std::int32_t> cell_slot, std::vector<std::int32_t>& cell_row);

}  // namespace tentpole
