#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "host/front/front_simplex.hpp"
#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Corners of a front cell in ascending vertex id, or any other vertex triple; entries beyond the dimension are `none`.
using FrontVertices = std::array<std::int32_t, FrontSimplex::max_corners>;

/// What may be done with a vertex. line: inner vertex of a straight piece of boundary or of a straight interface of two
/// regions. corner: any other vertex of a boundary or interface (D = 1: every one).
enum class VertexKind : std::uint8_t { interior, line, corner };

/// Facet i is opposite corner i.
struct FrontCell {
  FrontVertices vertex;
  FrontVertices neighbor;   ///< cell across facet i, or none
  FrontVertices boundary;   ///< index into SpaceMesh::boundary_names where neighbor is none, else none
  std::int32_t region;      ///< index into SpaceMesh::region_names
  std::int32_t generation;  ///< bisections since the input mesh, less deletions
  std::array<std::uint8_t, 3> neighbor_facet;  ///< number of facet i seen from the neighbour
  std::uint8_t refinement_corner;              ///< newest vertex: the edge opposite to it is bisected next (D = 2)
  std::int64_t serial;                         ///< ascending, never reused; none: the slot is free
};
static_assert(std::has_unique_object_representations_v<FrontCell>, "checkpoints hold its bytes");

/// A cell to be made.
struct NewFrontCell {
  FrontVertices vertex;  ///< ascending
  std::int32_t region;
  std::int32_t generation;
  std::uint8_t refinement_corner;
};

/// A boundary facet that did not exist before: its D vertices in any order, the other entry `none`.
struct NewBoundaryFacet {
  std::array<std::int32_t, 2> vertex;
  std::int32_t boundary;
};

/// Cells that contain two given vertices: those at an edge (D = 2), the one between them (D = 1).
struct EdgeCells {
  int size = 0;
  std::array<std::int32_t, 2> cell{none, none};
};

/// A conforming simplicial mesh of D = 1 or 2 whose cells and vertices come and go, with a time at every vertex.
/// Ids of vertices and cells are slots that are reused, last freed first, so they are a function of the sequence of
/// changes; serials of cells are unique. Who changes it keeps it conforming (AdaptiveFront); check() verifies.
class FrontMesh {
 public:
  /// Copies a mesh without periodic sides, all times `start_time`; bisection starts at the longest edges. Throws
  /// std::invalid_argument for D = 3 and for periodic sides.
  FrontMesh(const SpaceMesh& mesh, double start_time);

  int dimension() const { return dimension_; }
  int num_corners() const { return dimension_ + 1; }
  int num_vertices() const { return num_vertex_slots() - static_cast<int>(free_vertices_.size()); }
  int num_cells() const { return num_cell_slots() - static_cast<int>(free_cells_.size()); }
  int num_vertex_slots() const { return static_cast<int>(position_.size()); }
  int num_cell_slots() const { return static_cast<int>(cells_.size()); }
  bool is_alive_vertex(int vertex) const { return !star_[vertex].empty(); }
  bool is_alive_cell(int cell) const { return cells_[cell].serial != none; }

  const Point& position(int vertex) const { return position_[vertex]; }
  double time(int vertex) const { return time_[vertex]; }
  const std::vector<double>& times() const { return time_; }
  VertexKind kind(int vertex) const { return kind_[vertex]; }
  const FrontCell& cell(int cell) const { return cells_[cell]; }

  /// Corners of a cell, ascending.
  std::span<const std::int32_t> vertices(int cell) const {
    return {cells_[cell].vertex.data(), static_cast<std::size_t>(num_corners())};
  }

  /// Cells round a vertex, ascending cell.
  std::span<const CellCorner> star(int vertex) const { return star_[vertex]; }

  /// Vertices that share a cell with this one, ascending.
  std::vector<std::int32_t> neighbors(int vertex) const;

  EdgeCells cells_with(int a, int b) const;

  /// Number of the corner that is this vertex of the cell.
  int corner_of(int cell, int vertex) const;

  /// Whether a facet lies on the boundary or between two regions. Such facets are kept whatever happens to the cells.
  bool is_protected(int cell, int facet) const;

  FrontSimplex simplex(int cell) const { return simplex(cells_[cell].vertex); }
  FrontSimplex simplex(const FrontVertices& vertices) const;

  /// Corner opposite the longest edge; equal lengths are decided by the vertex ids, so that neighbours agree.
  std::uint8_t longest_edge_corner(const FrontVertices& vertices) const;

  /// The serial that the next cell gets: changes with every change of cells.
  std::int64_t next_serial() const { return next_serial_; }

  // --- changes
  std::int32_t add_vertex(const Point& position, double time, VertexKind kind);
  void set_time(int vertex, double time) { time_[vertex] = time; }
  void set_position(int vertex, const Point& position) { position_[vertex] = position; }
  void set_refinement_corner(int cell, int corner) {
    cells_[cell].refinement_corner = static_cast<std::uint8_t>(corner);
  }

  /// Replaces some cells by others that fill the same place. Facets of their hull keep neighbour and boundary; boundary
  /// facets that are cut or merged are given in `boundary`. Vertices left without cells are freed. Returns the ids of
  /// the added cells in their order. Throws std::logic_error where the added cells do not fit the hull.
  std::vector<std::int32_t> replace(std::span<const std::int32_t> removed, std::span<const NewFrontCell> added,
                                    std::span<const NewBoundaryFacet> boundary = {});

  // --- whole mesh
  /// Throws std::runtime_error naming the first broken invariant: neighbours and stars agree, corners ascend, measures
  /// are positive, neighbours lie on two sides, line vertices are straight, the measure of the domain and of every
  /// boundary is that of the input mesh (to 1e-9).
  void check() const;

  double domain_measure() const;

  /// Length (D = 1: number of points) per boundary index.
  std::vector<double> boundary_measures() const;

  /// Checkpoint; load throws std::runtime_error where the bytes are no mesh of this dimension.
  void save(std::ostream& stream) const;
  void load(std::istream& stream);

 private:
  struct OpenFacet;

  void classify_vertices();
  VertexKind classify(int vertex) const;
  /// Whether a vertex that may move does so within, or along, what is kept.
  bool fits_kind(int vertex) const;
  void remove_cell(int cell);
  std::int32_t add_cell(const NewFrontCell& cell);
  void link(std::int32_t cell, std::vector<OpenFacet>& open);
  void rebuild_stars();
  void check_cell(int cell) const;
  void check_facet(int cell, int facet) const;
  void check_vertex(int vertex) const;

  int dimension_;
  std::vector<Point> position_;
  std::vector<double> time_;
  std::vector<VertexKind> kind_;
  std::vector<std::vector<CellCorner>> star_;
  std::vector<std::int32_t> free_vertices_;
  std::vector<FrontCell> cells_;
  std::vector<std::int32_t> free_cells_;
  std::int64_t next_serial_ = 0;
  double input_measure_ = 0;
  std::vector<double> input_boundary_measures_;
};

/// The two vertices next to a `line` vertex along its straight boundary or interface, ascending; nothing for other
/// kinds.
std::optional<std::array<std::int32_t, 2>> line_neighbors(const FrontMesh& mesh, int vertex);

}  // namespace tentpole
