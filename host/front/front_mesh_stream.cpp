#include <algorithm>
#include <istream>
#include <ostream>
#include <stdexcept>

#include "common/binary_stream.hpp"
#include "host/front/front_mesh.hpp"

namespace tentpole {

namespace {

bool all_below(const std::vector<std::int32_t>& values, int size) {
  return std::all_of(values.begin(), values.end(), [&](std::int32_t value) { return value >= 0 && value < size; });
}

/// No run makes as many cells.
constexpr std::int64_t largest_serial = std::int64_t{1} << 60;

/// Indices lie below these.
struct Counts {
  int vertices, cells, boundaries;
};

/// Whether every index of a cell leads somewhere, so that check() may follow them.
bool is_in_range(const FrontCell& cell, int dimension, const Counts& counts) {
  if (cell.serial == none) return true;
  for (int i = 0; i <= dimension; ++i)
    if (cell.vertex[i] < 0 || cell.vertex[i] >= counts.vertices || cell.neighbor[i] < none ||
        cell.neighbor[i] >= counts.cells || cell.boundary[i] < none || cell.boundary[i] >= counts.boundaries ||
        cell.neighbor_facet[i] > dimension)
      return false;
  return cell.serial >= 0 && cell.region >= 0 && cell.refinement_corner <= dimension;
}

/// Whether the free slots are those that nobody uses, each once.
template <class IsAlive>
bool are_free(std::vector<std::int32_t> slots, const IsAlive& is_alive) {
  std::sort(slots.begin(), slots.end());
  return std::adjacent_find(slots.begin(), slots.end()) == slots.end() &&
         std::none_of(slots.begin(), slots.end(), is_alive);
}

}  // namespace

void FrontMesh::save(std::ostream& stream) const {
  write_value(stream, static_cast<std::int32_t>(dimension_));
  write_vector(stream, position_);
  write_vector(stream, time_);
  write_vector(stream, kind_);
  write_vector(stream, free_vertices_);
  write_vector(stream, cells_);
  write_vector(stream, free_cells_);
  write_value(stream, next_serial_);
}

void FrontMesh::load(std::istream& stream) {
  if (read_value<std::int32_t>(stream) != dimension_)
    throw std::runtime_error("the front has another dimension than the mesh");
  FrontMesh other = *this;
  other.position_ = read_vector<Point>(stream);
  other.time_ = read_vector<double>(stream);
  other.kind_ = read_vector<VertexKind>(stream);
  other.free_vertices_ = read_vector<std::int32_t>(stream);
  other.cells_ = read_vector<FrontCell>(stream);
  other.free_cells_ = read_vector<std::int32_t>(stream);
  other.next_serial_ = read_value<std::int64_t>(stream);
  const int vertices = other.num_vertex_slots(), cells = other.num_cell_slots();
  const Counts counts{vertices, cells, static_cast<int>(input_boundary_measures_.size())};
  require_sound(stream, std::ssize(other.time_) == vertices && std::ssize(other.kind_) == vertices,
                "the vertices of the front have different numbers of positions, times and kinds");
  require_sound(stream, all_finite(other.time_) && std::ranges::all_of(other.position_, all_finite<Point>),
                "a position or a time of the front is not finite");
  require_sound(stream, std::ranges::all_of(other.kind_, [](VertexKind kind) { return kind <= VertexKind::corner; }),
                "the kind of a vertex is unknown");
  for (int cell = 0; cell < cells; ++cell)
    require_sound(stream, is_in_range(other.cells_[cell], dimension_, counts),
                  "cell " + std::to_string(cell) + " of the front has an index that leads nowhere");
  require_sound(stream, all_below(other.free_vertices_, vertices) && all_below(other.free_cells_, cells),
                "a free slot of the front does not exist");
  require_sound(stream, other.next_serial_ >= 0 && other.next_serial_ <= largest_serial,
                "the number of cells that the front ever had is " + std::to_string(other.next_serial_));
  other.star_.assign(vertices, {});
  other.rebuild_stars();
  require_sound(stream,
                are_free(other.free_vertices_, [&](int vertex) { return other.is_alive_vertex(vertex); }) &&
                    are_free(other.free_cells_, [&](int cell) { return other.is_alive_cell(cell); }),
                "a free slot of the front is in use or named twice");
  other.check();
  *this = std::move(other);
}

}  // namespace tentpole
