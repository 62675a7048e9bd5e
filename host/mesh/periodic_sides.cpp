#include "host/mesh/periodic_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/point_finder.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

struct FacetOfSide {
  std::int32_t cell;
  std::int32_t facet;
};

/// One side of a pair: its facets by their sorted vertices, and its vertices.
struct Side {
  std::string name;
  std::map<FacetVertices, FacetOfSide> facets;
  std::vector<std::int32_t> vertices;
  std::vector<Point> positions;
};

Side collect_side(const MeshDescription& description, const FacetTable& facets, const std::string& name) {
  const auto& names = description.boundary_names;
  const auto found = std::find(names.begin(), names.end(), name);
  const auto boundary = static_cast<std::int32_t>(found - names.begin());
  Side side;
  side.name = name;
  for (std::size_t cell = 0; found != names.end() && cell < description.cells.size(); ++cell)
    for (int facet = 0; facet <= description.dimension; ++facet) {
      if (facets.boundary[cell][facet] != boundary) continue;
      FacetVertices vertices = facet_vertices(description.dimension, description.cells[cell], facet);
      side.facets[vertices] = {static_cast<std::int32_t>(cell), facet};
      side.vertices.insert(side.vertices.end(), vertices.begin(), vertices.begin() + description.dimension);
    }
  if (side.facets.empty())
    throw MeshError(description.source, "boundary " + name,
                    "is to be periodic but has no facets left. Name two different boundaries of the mesh, each once.");
  std::sort(side.vertices.begin(), side.vertices.end());
  side.vertices.erase(std::unique(side.vertices.begin(), side.vertices.end()), side.vertices.end());
  for (const std::int32_t vertex : side.vertices) side.positions.push_back(description.vertices[vertex]);
  return side;
}

/// Within which partners are found: 1e-9 of the domain's longest side, and more where numbers of the size of its
/// coordinates lie farther apart.
double matching_tolerance(const MeshDescription& description) {
  double largest = 0;
  for (const Point& vertex : description.vertices)
    for (const double coordinate : vertex) largest = std::max(largest, std::abs(coordinate));
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const double usual = PointFinder::default_tolerance(description.vertices);
  // No more than the finder's slots can bear; a domain that needs more has lost its shape to rounding.
  return usual + std::min(rounding * largest, 1e4 * usual);
}

Point mean_position(const std::vector<Point>& positions) {
  Point mean{};
  for (const Point& position : positions)
    for (int axis = 0; axis < max_dimension; ++axis)
      mean[axis] += position[axis] / static_cast<double>(positions.size());
  return mean;
}

[[noreturn]] void throw_mismatch(const MeshDescription& description, const Side& from, const Side& to,
                                 const std::string& entity) {
  throw MeshError(description.source, entity,
                  "on the periodic boundary " + from.name + " has no partner on " + to.name + " (" +
                      std::to_string(from.facets.size()) + " and " + std::to_string(to.facets.size()) + " facets). " +
                      description.way_out("Give both sides the same mesh (in Gmsh: Periodic Curve or Surface)."));
}

/// The vertex of `to` that each vertex of `from` meets under the translation, by vertex of `from`.
std::map<std::int32_t, std::int32_t> match_vertices(const MeshDescription& description, const Side& from,
                                                    const Side& to, const Point& translation) {
  const PointFinder finder(to.positions, matching_tolerance(description));
  std::map<std::int32_t, std::int32_t> partner;
  for (std::size_t i = 0; i < from.vertices.size(); ++i) {
    Point target = from.positions[i];
    for (int axis = 0; axis < max_dimension; ++axis) target[axis] += translation[axis];
    const std::int32_t found = finder.find(target);
    if (found == none) throw_mismatch(description, from, to, description.vertex_label(from.vertices[i]));
    partner[from.vertices[i]] = to.vertices[found];
  }
  return partner;
}

void join_facets(const MeshDescription& description, const Side& from, const Side& to,
                 const std::map<std::int32_t, std::int32_t>& partner, FacetTable& facets) {
  if (from.facets.size() != to.facets.size())
    throw_mismatch(description, from, to, description.facet_label(from.facets.begin()->first));
  for (const auto& [vertices, own] : from.facets) {
    FacetVertices image{none, none, none};
    for (int i = 0; i < description.dimension; ++i) image[i] = partner.at(vertices[i]);
    insertion_sort(image, description.dimension);
    const auto found = to.facets.find(image);
    if (found == to.facets.end()) throw_mismatch(description, from, to, description.facet_label(vertices));
    const FacetOfSide other = found->second;
    facets.neighbor[own.cell][own.facet] = other.cell;
    facets.neighbor[other.cell][other.facet] = own.cell;
    facets.neighbor_facet[own.cell][own.facet] = static_cast<std::uint8_t>(other.facet);
    facets.neighbor_facet[other.cell][other.facet] = static_cast<std::uint8_t>(own.facet);
    facets.boundary[own.cell][own.facet] = none;
    facets.boundary[other.cell][other.facet] = none;
  }
}

std::int32_t root(std::vector<std::int32_t>& parent, std::int32_t vertex) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

/// Index of a translation in the list, which at most 3^D different ones enter.
std::uint8_t shift_index(std::vector<Point>& shifts, const Point& shift, double tolerance) {
  std::size_t index = 0;
  while (index < shifts.size() && distance(shifts[index], shift) > tolerance) ++index;
  if (index == shifts.size()) shifts.push_back(shift);
  return static_cast<std::uint8_t>(index);
}

void check_no_cell_meets_itself(const MeshDescription& description, const PeriodicVertices& periodic) {
  for (int cell = 0; cell < static_cast<int>(description.cells.size()); ++cell)
    for (int i = 0; i <= description.dimension; ++i)
      for (int j = 0; j < i; ++j)
        if (periodic.representative[description.cells[cell][i]] == periodic.representative[description.cells[cell][j]])
          throw MeshError(description.source, description.cell_label(cell),
                          "meets itself across the periodic boundary. Use at least two cells between the sides.");
}

}  // namespace

PeriodicVertices identify_periodic_sides(const MeshDescription& description, const PeriodicPairs& pairs,
                                         FacetTable& facets) {
  const std::size_t num_vertices = description.vertices.size();
  PeriodicVertices result;
  result.representative.resize(num_vertices);
  result.shift.assign(num_vertices, 0);
  result.shifts = {Point{}};
  std::iota(result.representative.begin(), result.representative.end(), 0);
  for (const auto& [first, second] : pairs) {
    const Side from = collect_side(description, facets, first), to = collect_side(description, facets, second);
    const Point translation = difference(mean_position(to.positions), mean_position(from.positions));
    const auto partner = match_vertices(description, from, to, translation);
    join_facets(description, from, to, partner, facets);
    for (const auto& [a, b] : partner) {
      const std::int32_t root_a = root(result.representative, a), root_b = root(result.representative, b);
      result.representative[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }
  }
  const double tolerance = 4 * matching_tolerance(description);
  for (std::size_t vertex = 0; vertex < num_vertices; ++vertex) {
    const std::int32_t representative = root(result.representative, static_cast<std::int32_t>(vertex));
    result.representative[vertex] = representative;
    const Point shift = difference(description.vertices[vertex], description.vertices[representative]);
    result.shift[vertex] = shift_index(result.shifts, shift, tolerance);
  }
  check_no_cell_meets_itself(description, result);
  return result;
}

}  // namespace tentpole
