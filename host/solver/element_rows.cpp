#include "host/solver/element_rows.hpp"

#include <unordered_map>

#include "kernels/patch_batch.hpp"

namespace tentpole {

std::vector<std::int32_t> number_rows(std::span<const std::int32_t> cell_slot, std::vector<std::int32_t>& cell_row) {
  std::vector<std::int32_t> slots;
  std::unordered_map<std::int32_t, std::int32_t> row_of_slot;
  cell_row.assign(cell_slot.size(), none);
  for (std::size_t cell = 0; cell < cell_slot.size(); ++cell) {
    if (cell_slot[cell] == none) continue;
    const auto [place, is_new] = row_of_slot.emplace(cell_slot[cell], static_cast<std::int32_t>(slots.size()));
    if (is_new) slots.push_back(cell_slot[cell]);
    cell_row[cell] = place->second;
  }
  return slots;
}

}  // namespace tentpole
