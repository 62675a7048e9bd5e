#include "host/march/prepare_cracks.hpp"

#include <cmath>
#include <cstdio>

#include "host/front/point_location.hpp"
#include "host/mesh/simplex_geometry.hpp"

namespace tentpole {
namespace {

/// Part of an edge within which its end is taken.
constexpr double snap = 0.05;

class CrackFitter {
 public:
  CrackFitter(AdaptiveState& state, Refinement& refinement, int number)
      : state_(state), refinement_(refinement), number_(number) {}

  /// The edges of a side, as long as nothing has cut them.
  void mark_side(const CrackSettings& crack) {
    for (const InnerSide& side : state_.books.simulation.mesh.inner_sides)
      for (std::size_t facet = 0; side.name == crack.side && facet < side.facets.size(); ++facet)
        mark(side.facets[facet][0], side.facets[facet][mesh().dimension() - 1], crack.damage);
  }

  void fit(const CrackSettings& crack) {
    std::vector<Point> corners;
    for (Point point : crack.points) {
      for (double& coordinate : point) coordinate /= state_.books.simulation.scaling.length;
      corners.push_back(point);
    }
    std::int32_t vertex = vertex_at(corners[0]);
    if (mesh().dimension() == 1) mark(vertex, vertex, crack.damage);
    for (std::size_t corner = 1; corner < corners.size(); ++corner)
      vertex = follow(vertex, corners[corner], crack.damage);
  }

 private:
  const FrontMesh& mesh() const { return state_.front.mesh(); }

  [[noreturn]] void refuse(const Point& point, const char* reason) const {
    const double unit = state_.books.simulation.scaling.length;
    char text[300];
    std::snprintf(text, sizeof text,
                  "crack %d at (%.6g, %.6g) m %s. Keep its points inside the domain and its lines off the boundary.",
                  number_, point[0] * unit, point[1] * unit, reason);
    throw InputError({{state_.books.simulation.settings.fracture.cracks[number_ - 1].location, text}});
  }

  void mark(std::int32_t a, std::int32_t b, double damage) {
    const Point& place = mesh().position(a);
    if (mesh().dimension() == 2 && mesh().cells_with(a, b).size != 2) refuse(place, "runs along the boundary");
    if (mesh().dimension() == 1 && mesh().star(a).size() != 2) refuse(place, "lies on the boundary");
    const std::int32_t edge = state_.front.mark_crack(a, b);
    state_.follow_front();
    state_.crack_state[edge] = uniform_crack_edge(state_.num_points(), damage);
  }

  std::int32_t cut(std::int32_t a, std::int32_t b, double fraction) {
    if (fraction < snap) return a;
    if (fraction > 1 - snap) return b;
    return refinement_.split_edge(a, b, fraction);
  }

  /// A vertex at the point, made by cuts: of the edge that holds it, or first of an edge in line with it.
  std::int32_t vertex_at(const Point& point) {
    const std::int32_t cell = locate(mesh(), point);
    if (cell == none) refuse(point, "lies outside the domain");
    const auto vertices = mesh().vertices(cell);
    for (const std::int32_t vertex : vertices)
      if (distance(mesh().position(vertex), point) <= snap * longest_edge(mesh().simplex(cell))) return vertex;
    if (mesh().dimension() == 1) {
      const double a = mesh().position(vertices[0])[0], b = mesh().position(vertices[1])[0];
      return cut(vertices[0], vertices[1], (point[0] - a) / (b - a));
    }
    const std::int32_t from = vertices[0], first = vertices[1], second = vertices[2];
    const double share = exit_fraction(from, first, second, difference(point, mesh().position(from)));
    const std::int32_t opposite = cut(first, second, share);
    const Point whole = difference(mesh().position(opposite), mesh().position(from));
    const Point part = difference(point, mesh().position(from));
    return cut(from, opposite, std::sqrt(dot(part, part) / dot(whole, whole)));
  }

  /// Where the ray from a corner meets the opposite edge, from first to second; negative where it points elsewhere.
  double exit_fraction(std::int32_t from, std::int32_t first, std::int32_t second, const Point& way) const {
    const Point a = difference(mesh().position(first), mesh().position(from));
    const Point b = difference(mesh().position(second), mesh().position(from));
    const double determinant = a[0] * b[1] - a[1] * b[0];
    const double alpha = (way[0] * b[1] - way[1] * b[0]) / determinant,
                 beta = (a[0] * way[1] - a[1] * way[0]) / determinant;
    constexpr double rounding = 1e-9;
    const double scale = std::fabs(alpha) + std::fabs(beta);
    if (alpha < -rounding * scale || beta < -rounding * scale) return -1;
    return beta / (alpha + beta);
  }

  /// Marks edges from a vertex to the point; the vertex there.
  std::int32_t follow(std::int32_t vertex, const Point& target, double damage) {
    const std::int32_t end = vertex_at(target);
    for (int guard = 0; vertex != end; ++guard) {
      if (guard > 1000000) refuse(target, "is never reached");
      const std::int32_t next = step(vertex, end);
      if (next == none || next == vertex) refuse(mesh().position(vertex), "leaves the domain");
      mark(vertex, next, damage);
      vertex = next;
    }
    return end;
  }

  /// The next vertex on the straight way to `end`, cutting the edge that is crossed.
  std::int32_t step(std::int32_t vertex, std::int32_t end) {
    const Point way = difference(mesh().position(end), mesh().position(vertex));
    for (const CellCorner& entry : mesh().star(vertex)) {
      const auto vertices = mesh().vertices(entry.cell);
      const std::int32_t first = vertices[entry.corner == 0 ? 1 : 0], second = vertices[entry.corner == 2 ? 1 : 2];
      if (first == end || second == end) return end;
      const double fraction = exit_fraction(vertex, first, second, way);
      if (fraction >= -snap) return cut(first, second, fraction);
    }
    return none;
  }

  AdaptiveState& state_;
  Refinement& refinement_;
  int number_;
};

}  // namespace

void prepare_cracks(AdaptiveState& state) {
  const std::vector<CrackSettings>& cracks = state.books.simulation.settings.fracture.cracks;
  Refinement refinement(state);
  // Sides first: the cuts for lines may halve their edges, which then stay marked.
  for (const bool is_side : {true, false})
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      CrackFitter fitter(state, refinement, static_cast<int>(i) + 1);
      if (cracks[i].side.empty() == is_side) continue;
      if (is_side)
        fitter.mark_side(cracks[i]);
      else
        fitter.fit(cracks[i]);
    }
  refinement.flush();
  state.counts.splits = 0;
}

}  // namespace tentpole
