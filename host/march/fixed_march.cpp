#include "host/march/fixed_march.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/march/advance_front.hpp"
#include "host/march/element_rows.hpp"

namespace tentpole {

FixedMarch::FixedMarch(RunBooks& books)
    : books_(books),
      front_(books.simulation.mesh, books.simulation.cell_wave_speed, books.simulation.settings.front.causality),
      sources_{std::vector<std::int32_t>(books.simulation.mesh.num_cells(), none),
               std::vector<std::int32_t>(books.simulation.mesh.num_cells(), 0)},
      builder_(books.simulation, front_, sources_, books.store),
      state_{books, front_, sources_, builder_} {}

bool FixedMarch::advance(const AdvanceOptions& options) {
  return advance_front(state_, options);
}

void FixedMarch::fill(RunSummary& summary) {
  summary.counts.cells_min = summary.counts.cells_max = num_cells();
  summary.counts.smallest_cell = books_.simulation.smallest_edge;
  summary.counts.largest_cell = books_.simulation.largest_edge;
}

std::vector<std::int32_t> FixedMarch::save(CheckpointContents& contents) const {
  contents.front_times.assign(front_.times().begin(), front_.times().end());
  contents.cell_facet = sources_.facet;
  return number_rows(sources_.slot, contents.cell_element);
}

std::vector<std::int32_t> FixedMarch::load(const CheckpointContents& contents) {
  const SpaceMesh& mesh = books_.simulation.mesh;
  const std::size_t num_cells = mesh.cells.size();
  std::vector<std::int32_t> slots(num_element_rows(contents, num_cells, mesh.dimension));
  const auto num_sources = std::ranges::count_if(contents.cell_element, [](std::int32_t row) { return row != none; });
  if (num_sources != std::ssize(slots)) throw std::runtime_error("two cells lie on one element");
  front_.set_times(contents.front_times);
  for (std::int32_t& slot : slots) slot = books_.store.acquire();
  sources_.facet = contents.cell_facet;
  for (std::size_t cell = 0; cell < num_cells; ++cell)
    sources_.slot[cell] = contents.cell_element[cell] == none ? none : slots[contents.cell_element[cell]];
  return slots;
}

}  // namespace tentpole
