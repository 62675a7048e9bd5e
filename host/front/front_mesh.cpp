#include "host/front/front_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {

namespace {

/// Sine of the angle below which two edges count as one straight line.
constexpr double straight_tolerance = 1e-9;

/// A protected edge at a vertex: where it leads and what it divides.
struct ProtectedEdge {
  std::int32_t vertex;
  std::int32_t boundary;                ///< or none: an interface
  std::array<std::int32_t, 2> regions;  ///< ascending; none outside
  auto operator<=>(const ProtectedEdge&) const = default;
};

std::vector<ProtectedEdge> protected_edges(const FrontMesh& mesh, int vertex) {
  std::vector<ProtectedEdge> edges;
  for (const auto& [id, corner] : mesh.star(vertex))
    for (const int step : {1, 2}) {
      const int facet = (corner + step) % 3;
      if (!mesh.is_protected(id, facet)) continue;
      const FrontCell& cell = mesh.cell(id);
      std::array<std::int32_t, 2> regions{none, cell.region};
      if (cell.neighbor[facet] != none) regions[0] = mesh.cell(cell.neighbor[facet]).region;
      insertion_sort(regions, 2);
      edges.push_back({cell.vertex[3 - corner - facet], cell.boundary[facet], regions});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

FrontMesh::FrontMesh(const SpaceMesh& mesh, double start_time)
    : dimension_(mesh.dimension),
      position_(mesh.vertices),
      time_(mesh.vertices.size(), start_time),
      kind_(mesh.vertices.size(), VertexKind::interior),
      star_(mesh.vertices.size()) {
  if (dimension_ != 1 && dimension_ != 2)
    throw std::invalid_argument("an adaptive front has one or two dimensions, the mesh has " +
                                std::to_string(dimension_));
  if (mesh.shifts.size() > 1) throw std::invalid_argument("an adaptive front cannot have periodic sides");
  for (int id = 0; id < mesh.num_cells(); ++id) {
    FrontCell cell{{none, none, none}, {none, none, none}, {none, none, none}, mesh.cell_region[id], 0, {}, 0, 0};
    for (int i = 0; i <= dimension_; ++i) {
      cell.vertex[i] = mesh.cells[id][i];
      cell.neighbor[i] = mesh.neighbor[id][i];
      cell.neighbor_facet[i] = mesh.neighbor_facet[id][i];
      cell.boundary[i] = mesh.facet_boundary[id][i];
    }
    cell.serial = next_serial_++;
    cell.refinement_corner = longest_edge_corner(cell.vertex);
    cells_.push_back(cell);
  }
  rebuild_stars();
  classify_vertices();
  input_measure_ = domain_measure();
  input_boundary_measures_ = boundary_measures();
}

void FrontMesh::rebuild_stars() {
  for (auto& star : star_) star.clear();
  for (int cell = 0; cell < num_cell_slots(); ++cell)
    if (is_alive_cell(cell))
      for (int corner = 0; corner < num_corners(); ++corner)
        star_[cells_[cell].vertex[corner]].push_back({cell, corner});
}

void FrontMesh::classify_vertices() {
  for (int vertex = 0; vertex < num_vertex_slots(); ++vertex) kind_[vertex] = classify(vertex);
}

VertexKind FrontMesh::classify(int vertex) const {
  if (dimension_ == 1) {
    const bool is_protected_end = std::any_of(star_[vertex].begin(), star_[vertex].end(), [&](const CellCorner& entry) {
      return is_protected(entry.cell, 1 - entry.corner);
    });
    return is_protected_end ? VertexKind::corner : VertexKind::interior;
  }
  const std::vector<ProtectedEdge> edges = protected_edges(*this, vertex);
  if (edges.empty()) return VertexKind::interior;
  if (edges.size() != 2 || edges[0].boundary != edges[1].boundary || edges[0].regions != edges[1].regions)
    return VertexKind::corner;
  const Point a = difference(position_[edges[0].vertex], position_[vertex]);
  const Point b = difference(position_[edges[1].vertex], position_[vertex]);
  const double lengths = std::sqrt(dot(a, a) * dot(b, b));
  const bool is_straight = std::abs(a[0] * b[1] - a[1] * b[0]) <= straight_tolerance * lengths && dot(a, b) < 0;
  return is_straight ? VertexKind::line : VertexKind::corner;
}

bool FrontMesh::fits_kind(int vertex) const {
  if (dimension_ == 1) return kind_[vertex] == classify(vertex);
  if (kind_[vertex] == VertexKind::corner) return true;
  const std::size_t num_edges = protected_edges(*this, vertex).size();
  return num_edges == (kind_[vertex] == VertexKind::line ? 2 : 0);
}

bool FrontMesh::is_protected(int cell, int facet) const {
  const std::int32_t other = cells_[cell].neighbor[facet];
  return other == none || cells_[other].region != cells_[cell].region;
}

std::vector<std::int32_t> FrontMesh::neighbors(int vertex) const {
  std::vector<std::int32_t> result;
  for (const auto& [cell, corner] : star_[vertex])
    for (const std::int32_t other : vertices(cell))
      if (other != vertex) result.push_back(other);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

EdgeCells FrontMesh::cells_with(int a, int b) const {
  EdgeCells result;
  for (const auto& [cell, corner] : star_[a]) {
    const auto corners = vertices(cell);
    if (std::find(corners.begin(), corners.end(), b) != corners.end() && result.size < 2)
      result.cell[result.size++] = cell;
  }
  return result;
}

int FrontMesh::corner_of(int cell, int vertex) const {
  const auto corners = vertices(cell);
  return static_cast<int>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}

FrontSimplex FrontMesh::simplex(const FrontVertices& vertices) const {
  FrontSimplex result;
  result.dimension = dimension_;
  for (int i = 0; i <= dimension_; ++i) {
    result.position[i] = position_[vertices[i]];
    result.time[i] = time_[vertices[i]];
  }
  return result;
}

std::uint8_t FrontMesh::longest_edge_corner(const FrontVertices& vertices) const {
  if (dimension_ == 1) return 0;
  using Key = std::tuple<double, std::int32_t, std::int32_t>;
  Key longest{-1.0, none, none};
  int result = 0;
  for (int corner = 0; corner < 3; ++corner) {
    const std::int32_t lower = vertices[corner == 0 ? 1 : 0], higher = vertices[corner == 2 ? 1 : 2];
    const Key key{distance(position_[lower], position_[higher]), lower, higher};
    if (key <= longest) continue;
    longest = key;
    result = corner;
  }
  return static_cast<std::uint8_t>(result);
}

std::optional<std::array<std::int32_t, 2>> line_neighbors(const FrontMesh& mesh, int vertex) {
  if (mesh.kind(vertex) != VertexKind::line) return std::nullopt;
  const std::vector<ProtectedEdge> edges = protected_edges(mesh, vertex);
  return std::array<std::int32_t, 2>{edges.front().vertex, edges.back().vertex};
}

}  // namespace tentpole
