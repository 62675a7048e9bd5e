#include "host/front/crack_edges.hpp"

#include <algorithm>
#include <istream>
#include <ostream>
#include <stdexcept>

#include "host/output/binary_stream.hpp"
#include "kernels/patch_batch.hpp"

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
  for (const std::int32_t index : read_vector<std::int32_t>(stream)) {
    const bool is_known = index >= 0 && index < other.size();
    if (!is_known || other.edges_[index][0] < 0 || other.edges_[index][1] < other.edges_[index][0] ||
        other.edges_[index][1] >= num_vertices)
      throw std::runtime_error("the cracks in the checkpoint are damaged");
    other.insert(index);
  }
  *this = std::move(other);
}

}  // namespace tentpole
