#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "host/front/front_mesh.hpp"
#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/printed_number.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

constexpr double conserved_tolerance = 1e-9;
/// Sine of the largest bend of a line vertex: rounding of positions, divided by the size of small cells.
constexpr double bend_tolerance = 1e-6;

[[noreturn]] void fail(const char* entity, int id, const std::string& what) {
  throw std::runtime_error("front mesh, " + std::string(entity) + " " + std::to_string(id) + ": " + what);
}

}  // namespace

void FrontMesh::check_facet(int id, int facet) const {
  const FrontCell& cell = cells_[id];
  const std::int32_t other_id = cell.neighbor[facet];
  if (other_id == none) {
    if (cell.boundary[facet] == none) fail("cell", id, "a boundary facet has no name");
    return;
  }
  if (cell.boundary[facet] != none) fail("cell", id, "a facet inside the domain has a boundary name");
  if (!is_alive_cell(other_id)) fail("cell", id, "its neighbour " + std::to_string(other_id) + " does not exist");
  const FrontCell& other = cells_[other_id];
  const int other_facet = cell.neighbor_facet[facet];
  if (!(other.neighbor[other_facet] == id && other.neighbor_facet[other_facet] == facet))
    fail("cell", id, "its neighbour " + std::to_string(other_id) + " has another neighbour");
  FrontVertices crossed = cell.vertex;  // the neighbour, its corners in the order of this cell's facet
  crossed[facet] = other.vertex[other_facet];
  FrontVertices sorted = crossed;
  insertion_sort(sorted, num_corners());
  if (sorted != other.vertex) fail("cell", id, "shares no whole facet with its neighbour " + std::to_string(other_id));
  if (!(signed_measure(simplex(cell.vertex)) * signed_measure(simplex(crossed)) < 0))
    fail("cell", id, "lies on the same side of a facet as its neighbour " + std::to_string(other_id));
}

void FrontMesh::check_cell(int id) const {
  const FrontCell& cell = cells_[id];
  if (cell.serial >= next_serial_) fail("cell", id, "its serial has not been given out");
  for (int i = 0; i < num_corners(); ++i) {
    if (i > 0 && cell.vertex[i - 1] >= cell.vertex[i]) fail("cell", id, "its corners do not ascend");
    const auto& star = star_[cell.vertex[i]];
    if (!(std::count_if(star.begin(), star.end(),
                        [&](const CellCorner& entry) { return entry.cell == id && entry.corner == i; }) == 1))
      fail("cell", id, "is missing in the star of vertex " + std::to_string(cell.vertex[i]));
    check_facet(id, i);
  }
  if (!(std::abs(signed_measure(simplex(id))) > 0)) fail("cell", id, "has no measure");
}

void FrontMesh::check_vertex(int vertex) const {
  for (const auto& [cell, corner] : star_[vertex])
    if (!(is_alive_cell(cell) && cells_[cell].vertex[corner] == vertex))
      fail("vertex", vertex, "its star holds cell " + std::to_string(cell) + " that does not contain it");
  if (!fits_kind(vertex)) fail("vertex", vertex, "its kind does not fit the boundary and interfaces there");
  const auto ends = line_neighbors(*this, vertex);
  if (!ends) return;
  const Point a = difference(position_[(*ends)[0]], position_[vertex]);
  const Point b = difference(position_[(*ends)[1]], position_[vertex]);
  const double bend = std::abs(a[0] * b[1] - a[1] * b[0]) / std::sqrt(dot(a, a) * dot(b, b));
  if (!(bend <= bend_tolerance && dot(a, b) < 0))
    fail("vertex", vertex, "left its straight line, sine " + printed(bend));
}

void FrontMesh::check() const {
  int num_found = 0;
  for (int cell = 0; cell < num_cell_slots(); ++cell)
    if (is_alive_cell(cell)) {
      check_cell(cell);
      ++num_found;
    }
  if (num_found != num_cells()) fail("cell", num_cells(), "the number of free slots is wrong");
  num_found = 0;
  for (int vertex = 0; vertex < num_vertex_slots(); ++vertex)
    if (is_alive_vertex(vertex)) {
      check_vertex(vertex);
      ++num_found;
    }
  if (num_found != num_vertices()) fail("vertex", num_vertices(), "the number of free slots is wrong");
  if (const double measure = domain_measure(); std::abs(measure / input_measure_ - 1) > conserved_tolerance)
    throw std::runtime_error("front mesh: the domain has measure " + printed(measure) + " instead of " +
                             printed(input_measure_));
  const std::vector<double> measures = boundary_measures();
  for (std::size_t i = 0; i < std::max(measures.size(), input_boundary_measures_.size()); ++i)
    if (!(i < measures.size() && i < input_boundary_measures_.size() &&
          std::abs(measures[i] - input_boundary_measures_[i]) <= conserved_tolerance * input_boundary_measures_[i]))
      fail("boundary", static_cast<int>(i), "its measure has changed");
}

double FrontMesh::domain_measure() const {
  double measure = 0;
  for (int cell = 0; cell < num_cell_slots(); ++cell)
    if (is_alive_cell(cell)) measure += std::abs(signed_measure(simplex(cell)));
  return measure;
}

std::vector<double> FrontMesh::boundary_measures() const {
  std::vector<double> measures;
  for (int id = 0; id < num_cell_slots(); ++id)
    for (int facet = 0; is_alive_cell(id) && facet < num_corners(); ++facet) {
      const FrontCell& cell = cells_[id];
      if (cell.boundary[facet] == none) continue;
      if (cell.boundary[facet] >= static_cast<int>(measures.size())) measures.resize(cell.boundary[facet] + 1, 0.0);
      measures[cell.boundary[facet]] +=
          dimension_ == 1 ? 1
                          : distance(position_[cell.vertex[(facet + 1) % 3]], position_[cell.vertex[(facet + 2) % 3]]);
    }
  return measures;
}

}  // namespace tentpole
