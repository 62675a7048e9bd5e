#include "host/mesh/planar_delaunay.hpp"

#include <algorithm>
#include <cmath>

namespace tentpole {

namespace {

/// Triangles with their neighbours: neighbor[t][i] lies across the edge opposite corner i.
class FlippableTriangulation {
 public:
  FlippableTriangulation(const std::vector<Point>& vertices, std::vector<CellVertices>& triangles)
      : vertices_(vertices), triangles_(triangles), neighbor_(triangles.size(), {none, none, none}) {
    match_edges();
  }

  void flip_all() {
    std::vector<std::int32_t> pending(triangles_.size());
    for (std::size_t i = 0; i < pending.size(); ++i) pending[i] = static_cast<std::int32_t>(pending.size() - 1 - i);
    while (!pending.empty()) {
      const std::int32_t triangle = pending.back();
      pending.pop_back();
      for (int corner = 0; corner < 3; ++corner) {
        if (!should_flip(triangle, corner)) continue;
        const std::int32_t other = neighbor_[triangle][corner];
        flip(triangle, corner);
        pending.push_back(other);
        pending.push_back(triangle);
        break;
      }
    }
  }

 private:
  struct Edge {
    std::int32_t low, high, triangle, corner;
    auto operator<=>(const Edge&) const = default;
  };

  void match_edges() {
    std::vector<Edge> edges;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(triangles_[t][(i + 1) % 3], triangles_[t][(i + 2) % 3]);
        edges.push_back({low, high, static_cast<std::int32_t>(t), i});
      }
    std::sort(edges.begin(), edges.end());
    for (std::size_t e = 1; e < edges.size(); ++e) {
      const Edge &a = edges[e - 1], &b = edges[e];
      if (a.low != b.low || a.high != b.high) continue;
      neighbor_[a.triangle][a.corner] = b.triangle;
      neighbor_[b.triangle][b.corner] = a.triangle;
    }
  }

  int corner_towards(std::int32_t triangle, std::int32_t neighbor) const {
    const auto& row = neighbor_[triangle];
    return static_cast<int>(std::find(row.begin(), row.end(), neighbor) - row.begin());
  }

  /// Whether the vertex across the edge lies inside the triangle's circle (the in-circle determinant, from that
  /// vertex).
  bool should_flip(std::int32_t triangle, int corner) const {
    const std::int32_t other = neighbor_[triangle][corner];
    if (other == none) return false;
    const Point& d = vertices_[triangles_[other][corner_towards(other, triangle)]];
    std::array<double, 3> x{}, y{}, square{};
    for (int i = 0; i < 3; ++i) {
      x[i] = vertices_[triangles_[triangle][i]][0] - d[0];
      y[i] = vertices_[triangles_[triangle][i]][1] - d[1];
      square[i] = x[i] * x[i] + y[i] * y[i];
    }
    const double determinant = square[0] * (x[1] * y[2] - x[2] * y[1]) + square[1] * (x[2] * y[0] - x[0] * y[2]) +
                               square[2] * (x[0] * y[1] - x[1] * y[0]);
    const double scale = std::max({square[0], square[1], square[2]});
    return determinant > 1e-10 * scale * scale;
  }

  void relink(std::int32_t triangle, std::int32_t from, std::int32_t to) {
    if (triangle != none) neighbor_[triangle][corner_towards(triangle, from)] = to;
  }

  /// Triangles (a, b, c) and (d, c, b) become (a, b, d) and (a, d, c).
  void flip(std::int32_t t, int corner) {
    const std::int32_t n = neighbor_[t][corner];
    const int opposite = corner_towards(n, t);
    const std::int32_t a = triangles_[t][corner], b = triangles_[t][(corner + 1) % 3],
                       c = triangles_[t][(corner + 2) % 3];
    const std::int32_t d = triangles_[n][opposite];
    const std::int32_t across_ca = neighbor_[t][(corner + 1) % 3], across_ab = neighbor_[t][(corner + 2) % 3];
    const std::int32_t across_bd = neighbor_[n][(opposite + 1) % 3], across_dc = neighbor_[n][(opposite + 2) % 3];
    triangles_[t] = {a, b, d, none};
    triangles_[n] = {a, d, c, none};
    neighbor_[t] = {across_bd, n, across_ab};
    neighbor_[n] = {across_dc, across_ca, t};
    relink(across_bd, n, t);
    relink(across_ca, t, n);
  }

  const std::vector<Point>& vertices_;
  std::vector<CellVertices>& triangles_;
  std::vector<std::array<std::int32_t, 3>> neighbor_;
};

}  // namespace

void flip_to_delaunay(const std::vector<Point>& vertices, std::vector<CellVertices>& triangles) {
  FlippableTriangulation(vertices, triangles).flip_all();
}

}  // namespace tentpole
