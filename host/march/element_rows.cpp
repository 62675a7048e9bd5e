#include "host/march/element_rows.hpp"

#include <stdexcept>
#include <string>
#include <unordered_map>

#include "kernels/element/patch_batch.hpp"

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

std::int32_t num_element_rows(const CheckpointContents& contents, std::size_t num_cells, int dimension) {
  const auto require = [](bool holds, const std::string& fault) {
    if (!holds) throw std::runtime_error(fault);
  };
  require(contents.cell_element.size() == num_cells && contents.cell_facet.size() == num_cells,
          "the front has " + std::to_string(num_cells) + " cells, \"cell_element\" " +
              std::to_string(contents.cell_element.size()) + " and \"cell_facet\" " +
              std::to_string(contents.cell_facet.size()));
  std::int32_t num_rows = 0;
  for (std::size_t cell = 0; cell < num_cells; ++cell) {
    const std::int32_t row = contents.cell_element[cell], facet = contents.cell_facet[cell];
    require(row >= none && row <= num_rows, "cell " + std::to_string(cell) + " lies on element " + std::to_string(row) +
                                                ", the next new one is " + std::to_string(num_rows));
    require(facet >= 0 && facet < num_facet_tables(dimension),
            "cell " + std::to_string(cell) + " is facet " + std::to_string(facet) + " of its element");
    num_rows += row == num_rows;
  }
  return num_rows;
}

}  // namespace tentpole
