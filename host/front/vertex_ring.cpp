#include "host/front/vertex_ring.hpp"

#include <algorithm>
#include <cassert>

namespace tentpole {

namespace {

/// A cell of the star as a step round the vertex.
struct Step {
  std::int32_t from, to;
  std::int32_t cell;
  bool starts_at_line;  ///< the edge (vertex, from) is protected
  bool ends_at_line;    ///< the edge (vertex, to) is protected
};

std::vector<Step> steps_round(const FrontMesh& mesh, int vertex) {
  std::vector<Step> steps;
  for (const auto& [id, corner] : mesh.star(vertex)) {
    const bool is_positive = signed_measure(mesh.simplex(id)) > 0;
    const int from = (corner + (is_positive ? 1 : 2)) % 3, to = (corner + (is_positive ? 2 : 1)) % 3;
    const FrontCell& cell = mesh.cell(id);
    steps.push_back({cell.vertex[from], cell.vertex[to], id, mesh.is_protected(id, to), mesh.is_protected(id, from)});
  }
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.from < b.from; });
  return steps;
}

}  // namespace

std::vector<RingPart> vertex_ring(const FrontMesh& mesh, int vertex) {
  assert(mesh.dimension() == 2 && mesh.kind(vertex) != VertexKind::corner && "corners have no simple ring");
  const std::vector<Step> steps = steps_round(mesh, vertex);
  const auto next = [&](const Step& step) {
    return std::find_if(steps.begin(), steps.end(), [&](const Step& other) { return other.from == step.to; });
  };
  std::vector<RingPart> parts;
  if (mesh.kind(vertex) == VertexKind::interior) {
    parts.push_back({{}, mesh.cell(steps.front().cell).region});
    auto step = steps.begin();
    do {
      parts.back().vertices.push_back(step->from);
      step = next(*step);
    } while (step != steps.begin());
    return parts;
  }
  for (auto first = steps.begin(); first != steps.end(); ++first) {
    if (!first->starts_at_line) continue;
    parts.push_back({{first->from}, mesh.cell(first->cell).region});
    auto step = first;
    parts.back().vertices.push_back(step->to);
    while (!step->ends_at_line) {
      step = next(*step);
      parts.back().vertices.push_back(step->to);
    }
  }
  return parts;
}

}  // namespace tentpole
