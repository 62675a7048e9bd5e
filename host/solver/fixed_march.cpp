#include "host/solver/fixed_march.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/solver/advance_front.hpp"
#include "host/solver/element_rows.hpp"

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
  bool fits = contents.front_times.size() == mesh.vertices.size() && contents.cell_element.size() == num_cells &&
              contents.cell_facet.size() == num_cells;
  std::int32_t num_rows = 0;
  for (std::size_t cell = 0; fits && cell < num_cells; ++cell) {
    const std::int32_t row = contents.cell_element[cell], facet = contents.cell_facet[cell];
    if (row != none) fits = row == num_rows++;
    fits = fits && facet >= 0 && facet < num_facet_tables(mesh.dimension);
  }
  if (!fits) throw std::runtime_error("its arrays do not fit together");
  front_.set_times(contents.front_times);
  std::vector<std::int32_t> slots(num_rows);
  for (std::int32_t& slot : slots) slot = books_.store.acquire();
  sources_.facet = contents.cell_facet;
  for (std::size_t cell = 0; cell < num_cells; ++cell)
    sources_.slot[cell] = contents.cell_element[cell] == none ? none : slots[contents.cell_element[cell]];
  return slots;
}

}  // namespace tentpole
