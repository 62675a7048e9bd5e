#include <algorithm>
#include <istream>
#include <ostream>
#include <stdexcept>

#include "host/front/front_mesh.hpp"
#include "host/output/binary_stream.hpp"

namespace tentpole {

namespace {

bool all_below(const std::vector<std::int32_t>& values, int size) {
  return std::all_of(values.begin(), values.end(), [&](std::int32_t value) { return value >= 0 && value < size; });
}

/// Whether every index of a cell leads somewhere, so that check() may follow them.
bool is_in_range(const FrontCell& cell, int dimension, int num_vertices, int num_cells) {
  if (cell.serial == none) return true;
  for (int i = 0; i <= dimension; ++i)
    if (cell.vertex[i] < 0 || cell.vertex[i] >= num_vertices || cell.neighbor[i] < none ||
        cell.neighbor[i] >= num_cells || cell.boundary[i] < none || cell.neighbor_facet[i] > dimension)
      return false;
  return cell.serial >= 0 && cell.region >= 0 && cell.refinement_corner <= dimension;
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
    throw std::runtime_error("the front in the checkpoint has another dimension than the mesh");
  FrontMesh other = *this;
  other.position_ = read_vector<Point>(stream);
  other.time_ = read_vector<double>(stream);
  other.kind_ = read_vector<VertexKind>(stream);
  other.free_vertices_ = read_vector<std::int32_t>(stream);
  other.cells_ = read_vector<FrontCell>(stream);
  other.free_cells_ = read_vector<std::int32_t>(stream);
  other.next_serial_ = read_value<std::int64_t>(stream);
  const int vertices = other.num_vertex_slots(), cells = other.num_cell_slots();
  const bool fits = static_cast<int>(other.time_.size()) == vertices &&
                    static_cast<int>(other.kind_.size()) == vertices && all_below(other.free_vertices_, vertices) &&
                    all_below(other.free_cells_, cells) &&
                    std::all_of(other.cells_.begin(), other.cells_.end(),
                                [&](const FrontCell& cell) { return is_in_range(cell, dimension_, vertices, cells); });
  if (!fits) throw std::runtime_error("the front in the checkpoint is damaged");
  other.star_.assign(vertices, {});
  other.rebuild_stars();
  other.check();
  *this = std::move(other);
}

}  // namespace tentpole
