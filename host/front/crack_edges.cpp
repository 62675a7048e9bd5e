#include "host/front/crack_edges.hpp"

#include <algorithm>
#include <istream>
#include <ostream>
#include <string>

#include "common/binary_stream.hpp"
#include "common/index.hpp"

namespace tentpole {

std::int32_t CrackEdges::find(std::int32_t a, std::int32_t b) const {
  for (const std::int32_t index : at(a))
    if (edges_[index] == Edge{std::min(a, b), std::max(a, b)}) return index;
  return none;
}

void CrackEdges::insert(std::int32_t index) {
  const Edge& edge = edges_[index];
  if (edge[1] >= static_cast<int>(at_vertex_.size())) at_vertex_.resize(edge[1] + 1);
  at_vertex_[edge[0]].push_back(index);
  if (edge[0] != edge[1]) at_vertex_[edge[1]].push_back(index);
}

std::int32_t CrackEdges::mark(std::int32_t a, std::int32_t b) {
  if (const std::int32_t known = find(a, b); known != none) return known;
  edges_.push_back({std::min(a, b), std::max(a, b)});
  insert(size() - 1);
  return size() - 1;
}

std::array<std::int32_t, 2> CrackEdges::split(std::int32_t index, std::int32_t middle) {
  const Edge whole = edges_[index];
  for (const std::int32_t vertex : whole) std::erase(at_vertex_[vertex], index);
  return {mark(whole[0], middle), mark(whole[1], middle)};
}

std::span<const std::int32_t> CrackEdges::at(std::int32_t vertex) const {
  if (vertex >= static_cast<int>(at_vertex_.size())) return {};
  return at_vertex_[vertex];
}

void CrackEdges::save(std::ostream& stream) const {
  write_vector(stream, edges_);
  std::vector<std::int32_t> in_use;
  for (int index = 0; index < size(); ++index)
    if (!is_retired(index)) in_use.push_back(index);
  write_vector(stream, in_use);
}

void CrackEdges::load(std::istream& stream, int num_vertices) {
  CrackEdges other;
  other.edges_ = read_vector<Edge>(stream);
  for (const Edge& edge : other.edges_)
    require_sound(stream, edge[0] >= 0 && edge[0] <= edge[1] && edge[1] < num_vertices,
                  "a crack edge runs from vertex " + std::to_string(edge[0]) + " to vertex " + std::to_string(edge[1]) +
                      "; the front has " + std::to_string(num_vertices));
  std::int32_t last = none;
  for (const std::int32_t index : read_vector<std::int32_t>(stream)) {
    require_sound(stream, index > last && index < other.size(), "the crack edges in use do not ascend or do not exist");
    const Edge& edge = other.edges_[index];
    require_sound(stream, other.find(edge[0], edge[1]) == none, "two crack edges in use are the same");
    other.insert(index);
    last = index;
  }
  *this = std::move(other);
}

}  // namespace tentpole
