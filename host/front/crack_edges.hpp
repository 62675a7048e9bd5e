#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <vector>

namespace tentpole {

/// The front edges (D = 1: vertices) that are fracture surfaces, numbered 0, 1, .. in the order they were made. A split
/// retires a number and makes two, so numbers are never reused; at most half of them are retired.
class CrackEdges {
 public:
  using Edge = std::array<std::int32_t, 2>;  ///< vertices, ascending; D = 1: twice the same

  /// Number of the edge, new or known already. Vertices in any order.
  std::int32_t mark(std::int32_t a, std::int32_t b);

  /// Number of the edge, or none.
  std::int32_t find(std::int32_t a, std::int32_t b) const;

  /// Cuts an edge at vertex `middle`: the numbers of (lower, middle) and (higher, middle).
  std::array<std::int32_t, 2> split(std::int32_t index, std::int32_t middle);

  /// Numbers given out so far, retired ones included.
  int size() const { return static_cast<int>(edges_.size()); }
  const Edge& edge(int index) const { return edges_[index]; }
  bool is_retired(int index) const { return find(edges_[index][0], edges_[index][1]) != index; }

  /// Crack edges that end at a vertex, in the order they came.
  std::span<const std::int32_t> at(std::int32_t vertex) const;

  /// Checkpoint; load throws std::runtime_error where the bytes name no vertices of a mesh with this many.
  void save(std::ostream& stream) const;
  void load(std::istream& stream, int num_vertices);

 private:
  void insert(std::int32_t index);

  std::vector<Edge> edges_;
  std::vector<std::vector<std::int32_t>> at_vertex_;  ///< [vertex]: edges in use
};

}  // namespace tentpole
