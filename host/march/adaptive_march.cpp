#include "host/march/adaptive_march.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "common/binary_stream.hpp"
#include "host/march/element_rows.hpp"
#include "host/march/front_report.hpp"
#include "host/march/prepare_cracks.hpp"
#include "host/march/reference_energy.hpp"
#include "host/march/require_sound_state.hpp"

namespace tentpole {
namespace {

std::vector<double> region_wave_speeds(const Simulation& simulation) {
  std::vector<double> speeds;
  for (const Material& material : simulation.scaled_materials) speeds.push_back(material.dilatational_speed());
  return speeds;
}

AdaptiveFrontRules front_rules(const Simulation& simulation) {
  AdaptiveFrontRules rules;
  rules.causality = simulation.settings.front.causality;
  return rules;
}

AdaptiveLimits make_limits(const Simulation& simulation) {
  const Case& settings = simulation.settings;
  const Scaling& scaling = simulation.scaling;
  AdaptiveLimits limits;
  limits.crack_size = limits.max_pole_height = std::numeric_limits<double>::infinity();
  if (settings.adaptivity.enabled) {
    limits.tolerance = settings.adaptivity.error_tolerance * reference_energy(simulation);
    limits.min_size = settings.adaptivity.min_size / scaling.length;
    limits.max_size = settings.adaptivity.max_size / scaling.length;
  }
  if (settings.fracture.enabled) {
    const double zone = settings.process_zone_size();
    limits.crack_size = std::max(zone / 4 / scaling.length, limits.min_size);
    limits.growth_length = settings.fracture.growth_length.value_or(zone / 4) / scaling.length;
    limits.law = scaled_fracture_law(simulation);
    limits.max_pole_height = settings.fracture.max_damage_step * settings.fracture.relaxation_time / scaling.time();
  }
  return limits;
}

/// Field by field: std::optional has no bytes that may be read back unseen.
void write_triggers(std::ostream& stream, const std::vector<DefectTrigger>& triggers) {
  write_value(stream, static_cast<std::int64_t>(triggers.size()));
  for (const DefectTrigger& trigger : triggers) {
    write_value(stream, trigger.position);
    write_value(stream, trigger.normal);
    write_value(stream, trigger.num_normals);
    write_value(stream, static_cast<std::int32_t>(trigger.defect.has_value()));
    write_value(stream, trigger.defect.value_or(DefectId{}));
  }
}

std::vector<DefectTrigger> read_triggers(std::istream& stream) {
  std::vector<DefectTrigger> triggers;
  for (auto left = read_length(stream, sizeof(Point) + sizeof(DefectId)); left > 0; --left) {
    DefectTrigger trigger{};
    trigger.position = read_value<Point>(stream);
    trigger.normal = read_value<std::array<PlaneNormal, 2>>(stream);
    trigger.num_normals = read_value<int>(stream);
    const bool has_defect = read_number(stream, std::int32_t{1}, "whether a defect has a name") == 1;
    const DefectId defect = read_value<DefectId>(stream);
    if (has_defect) trigger.defect = defect;
    triggers.push_back(trigger);
  }
  return triggers;
}

}  // namespace

AdaptiveMarch::AdaptiveMarch(RunBooks& books, const OutputFolder& folder)
    : state_{.books = books,
             .front = AdaptiveFront(books.simulation.mesh, region_wave_speeds(books.simulation),
                                    front_rules(books.simulation)),
             .limits = make_limits(books.simulation)},
      writer_(state_),
      search_(state_),
      cracks_({.dimension = books.simulation.dimension(),
               .folder = folder,
               .times = books.simulation.settings.output.snapshot_times}),
      loop_{state_, writer_, search_, cracks_} {
  state_.follow_front();
  prepare_cracks(state_);
  state_.counts.cells_min = state_.counts.cells_max = num_cells();
  for (int cell = 0; cell < state_.front.mesh().num_cell_slots(); ++cell)
    if (state_.front.mesh().is_alive_cell(cell)) state_.measure(cell);
}

bool AdaptiveMarch::advance(const AdvanceOptions& options) {
  return advance_adaptive_front(loop_, options);
}

void AdaptiveMarch::fill(RunSummary& summary) {
  const AdaptiveCounts& counts = state_.counts;
  summary.counts.rejected = counts.rejected;
  summary.counts.min_size_hits = counts.min_size_hits;
  summary.counts.splits = counts.splits;
  summary.counts.deletions = counts.deletions;
  summary.counts.flips = counts.flips;
  summary.counts.inclined = counts.inclined;
  summary.counts.cells_min = counts.cells_min;
  summary.counts.cells_max = counts.cells_max;
  summary.counts.smallest_cell = state_.edges.shortest * state_.books.simulation.scaling.length;
  summary.counts.largest_cell = state_.edges.longest * state_.books.simulation.scaling.length;
  const SurfaceState surfaces = surface_state(state_);
  summary.fracture.nucleations = counts.nucleations;
  summary.fracture.extensions = counts.extensions;
  summary.fracture.branches = counts.branches;
  summary.fracture.coalescences = counts.coalescences;
  summary.fracture.crack_length = surfaces.crack_length;
  summary.fracture.surface_length = surfaces.surface_length;
  if (counts.nucleations > 0) {
    const Scaling& scaling = state_.books.simulation.scaling;
    RunSummary::FirstNucleation first{.time = state_.first_nucleation.time * scaling.time()};
    for (int i = 0; i < state_.front.mesh().dimension(); ++i)
      first.position[i] = state_.first_nucleation.position[i] * scaling.length;
    summary.fracture.first_nucleation = first;
  }
  summary.fracture.damage_mean = surfaces.damage_mean;
  summary.fracture.damage_max = surfaces.damage_max;
  if (state_.has_fracture()) summary.fracture.fragments = fragments_in_motion(state_);
  if (counts.refused > 0)
    summary.warnings.push_back(
        std::to_string(counts.refused) +
        " patches were accepted above the error tolerance because no split was admissible there.");
  if (counts.min_size_hits > 0)
    summary.warnings.push_back(std::to_string(counts.min_size_hits) +
                               " elements stayed above the error tolerance in cells of adaptivity.min_size.");
}

std::vector<std::int32_t> AdaptiveMarch::save(CheckpointContents& contents) const {
  std::ostringstream stream(std::ios::binary);
  state_.front.save(stream);
  write_vector(stream, state_.crack_state);
  write_vector(stream, state_.crack_mode);
  write_vector(stream, state_.memory);
  write_vector(stream, state_.pending);
  write_triggers(stream, state_.triggers);
  write_vector(stream, state_.growths);
  write_vector(stream, std::vector<DefectId>(state_.spent.begin(), state_.spent.end()));
  write_value(stream, state_.first_nucleation);
  write_value(stream, state_.num_tested);
  write_value(stream, state_.counts);
  write_value(stream, state_.edges);
  cracks_.save(stream);
  contents.march = std::move(stream).str();
  contents.cell_facet = state_.sources.facet;
  std::vector<std::int32_t> slot = state_.sources.slot;
  for (int cell = 0; cell < state_.front.mesh().num_cell_slots(); ++cell)
    if (!state_.front.mesh().is_alive_cell(cell)) slot[cell] = none;
  return number_rows(slot, contents.cell_element);
}

std::vector<std::int32_t> AdaptiveMarch::load(const CheckpointContents& contents) {
  std::istringstream stream(contents.march, std::ios::binary);
  state_.front.load(stream);
  state_.crack_state = read_vector<CrackEdgeState>(stream);
  state_.crack_mode = read_vector<CrackMode>(stream);
  state_.memory = read_vector<VertexMemory>(stream);
  state_.pending = read_vector<PendingSplit>(stream);
  state_.triggers = read_triggers(stream);
  state_.growths = read_vector<CrackGrowth>(stream);
  const std::vector<DefectId> spent = read_vector<DefectId>(stream);
  state_.spent = {spent.begin(), spent.end()};
  state_.first_nucleation = read_value<FirstNucleation>(stream);
  state_.num_tested = read_value<std::int64_t>(stream);
  state_.counts = read_value<AdaptiveCounts>(stream);
  state_.edges = read_value<EdgeRange>(stream);
  cracks_.load(stream);
  require_sound(stream, bytes_left(stream) == 0, "bytes are left over");
  require_sound_state(state_);
  const std::size_t num_slots = state_.front.mesh().num_cell_slots();
  std::vector<std::int32_t> slots(num_element_rows(contents, num_slots, state_.front.mesh().dimension()), none);
  state_.sources.facet = contents.cell_facet;
  state_.sources.slot.assign(num_slots, none);
  for (std::size_t cell = 0; cell < num_slots; ++cell) {
    const std::int32_t row = contents.cell_element[cell];
    if (row == none) continue;
    if (slots[row] == none) {
      slots[row] = state_.books.store.acquire();
    } else {
      state_.books.store.share(slots[row]);
    }
    state_.sources.slot[cell] = slots[row];
  }
  state_.follow_front();
  return slots;
}

}  // namespace tentpole
