#include "host/front/adaptive_front.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <stdexcept>
#include <string>

#include "host/front/progress_rule.hpp"
#include "host/mesh/printed_number.hpp"

namespace tentpole {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Poles lower than this part of an altitude / c are pitched with the whole causality.
constexpr double smallest_gentle_height = 0.2;

void check_rules(const AdaptiveFrontRules& rules) {
  if (!(rules.causality > 0 && rules.causality <= 1))
    throw std::invalid_argument("causality is " + printed(rules.causality) + "; it must lie in (0, 1].");
  if (!(rules.pitch_factor > 0 && rules.pitch_factor <= 1))
    throw std::invalid_argument("the pitch factor is " + printed(rules.pitch_factor) + "; it must lie in (0, 1].");
  if (!(rules.max_pole_speed >= 0 && rules.max_pole_speed < 1))
    throw std::invalid_argument("the largest pole speed is " + printed(rules.max_pole_speed) +
                                " of the wave speed; it must lie in [0, 1).");
}

}  // namespace

AdaptiveFront::AdaptiveFront(const SpaceMesh& mesh, std::span<const double> region_wave_speed,
                             const AdaptiveFrontRules& rules)
    : rules_(rules), mesh_(mesh, rules.start_time) {
  check_rules(rules);
  if (region_wave_speed.size() != mesh.region_names.size())
    throw std::invalid_argument("wave speeds of " + std::to_string(region_wave_speed.size()) +
                                " regions for a mesh of " + std::to_string(mesh.region_names.size()));
  for (std::size_t region = 0; region < region_wave_speed.size(); ++region) {
    if (!(region_wave_speed[region] > 0 && region_wave_speed[region] < infinity))
      throw std::invalid_argument("region \"" + mesh.region_names[region] + "\": wave speed is " +
                                  printed(region_wave_speed[region]) + "; it must be positive and finite.");
    slope_limit_.push_back(rules.causality / region_wave_speed[region]);
  }
  find_all_minima();
}

void AdaptiveFront::find_all_minima() {
  minima_ = {};
  for (int cell = 0; cell < mesh_.num_cell_slots(); ++cell)
    if (mesh_.is_alive_cell(cell)) minima_.add_cell(mesh_.vertices(cell), mesh_.times());
  minima_.settle();
}

std::vector<std::int32_t> AdaptiveFront::local_minima(double end_time) const {
  std::vector<std::int32_t> result;
  for (const std::int32_t vertex : minima_.all())
    if (time(vertex) < end_time) result.push_back(vertex);
  std::sort(result.begin(), result.end());
  return result;
}

double AdaptiveFront::minimum_time() const {
  double earliest = infinity;
  for (const std::int32_t vertex : minima_.all()) earliest = std::min(earliest, time(vertex));
  return earliest;
}

double AdaptiveFront::latest_time(int vertex, double factor) const {
  double latest = infinity;
  for (const auto& [cell, corner] : mesh_.star(vertex))
    latest = std::min(latest, latest_corner_time(mesh_.simplex(cell), corner, factor * slope_limit_of(cell)));
  return latest;
}

double AdaptiveFront::latest_gentle_time(int vertex) const {
  double travel_time = infinity;
  for (const auto& [cell, corner] : mesh_.star(vertex))
    travel_time =
        std::min(travel_time, slope_limit_of(cell) / rules_.causality * altitude(mesh_.simplex(cell), corner));
  const double gentle = latest_time(vertex, rules_.pitch_factor);
  return gentle - time(vertex) >= smallest_gentle_height * travel_time ? gentle : latest_time(vertex, 1);
}

double AdaptiveFront::pole_top_time(int vertex, double end_time, Pitch pitch) const {
  const double bottom = time(vertex);
  const double latest = pitch == Pitch::gentle ? latest_gentle_time(vertex) : latest_time(vertex, 1);
  double top = latest;
  if (latest >= end_time)
    top = end_time;
  else if (2 * (latest - bottom) > end_time - bottom)
    top = bottom + (end_time - bottom) / 2;
  if (!(top > bottom))
    throw std::runtime_error("vertex " + std::to_string(vertex) + ": the front cannot rise from " + printed(bottom) +
                             " (latest time " + printed(latest) + ", end time " + printed(end_time) +
                             "). The cells there are too small for the precision of the times.");
  return top;
}

void AdaptiveFront::raise(int vertex, double new_time) {
  assert(is_local_minimum(vertex) && new_time > time(vertex) && "only a local minimum rises");
  const double old_time = time(vertex);
  for (const auto& [cell, corner] : mesh_.star(vertex))
    minima_.raise_in_cell(mesh_.vertices(cell), vertex, old_time, new_time, mesh_.times());
  mesh_.set_time(vertex, new_time);
  minima_.settle();
}

std::vector<std::int32_t> AdaptiveFront::replace(std::span<const std::int32_t> removed,
                                                 std::span<const NewFrontCell> added,
                                                 std::span<const NewBoundaryFacet> boundary) {
  for (const std::int32_t cell : removed) minima_.remove_cell(mesh_.vertices(cell), mesh_.times());
  const std::vector<std::int32_t> ids = mesh_.replace(removed, added, boundary);
  for (const std::int32_t cell : ids) minima_.add_cell(mesh_.vertices(cell), mesh_.times());
  minima_.settle();
  return ids;
}

Footprint AdaptiveFront::footprint_of(std::span<const std::int32_t> cells) const {
  Footprint footprint;
  for (const std::int32_t cell : cells) footprint.push_back({cell, mesh_.cell(cell).serial});
  std::sort(footprint.begin(), footprint.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
  return footprint;
}

bool AdaptiveFront::is_unchanged(const Footprint& footprint) const {
  return std::all_of(footprint.begin(), footprint.end(), [&](const FootprintCell& entry) {
    return entry.cell < mesh_.num_cell_slots() && mesh_.cell(entry.cell).serial == entry.serial;
  });
}

std::vector<std::int32_t> AdaptiveFront::commit(const CellExchange& exchange) {
  if (!is_unchanged(exchange.below)) throw std::logic_error("an operation is committed to cells that have changed");
  std::vector<std::int32_t> removed;
  for (const FootprintCell& entry : exchange.below) removed.push_back(entry.cell);
  return replace(removed, exchange.above, exchange.boundary);
}

std::int32_t AdaptiveFront::mark_crack(int a, int b) {
  const bool is_vertex = mesh_.dimension() == 1 && a == b && mesh_.star(a).size() == 2;
  const bool is_edge = mesh_.dimension() == 2 && a != b && mesh_.cells_with(a, b).size == 2;
  if (!is_vertex && !is_edge)
    throw std::invalid_argument("no crack can run from vertex " + std::to_string(a) + " to vertex " +
                                std::to_string(b) + ": they do not bound a facet inside the domain.");
  return cracks_.mark(a, b);
}

}  // namespace tentpole
