#include "host/front/polygon_triangulation.hpp"

#include <algorithm>
#include <limits>

namespace tentpole {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The polygon cut off by diagonal (i, j): its best worst cost and the apex over the diagonal.
struct Piece {
  double cost = 0;
  int apex = -1;
};

void collect(const std::vector<std::vector<Piece>>& best, int i, int j, std::vector<PolygonTriangle>& triangles) {
  if (j - i < 2) return;
  const int apex = best[i][j].apex;
  triangles.push_back({i, apex, j});
  collect(best, i, apex, triangles);
  collect(best, apex, j, triangles);
}

}  // namespace

std::vector<PolygonTriangle> best_triangulation(int num_corners,
                                                const std::function<double(const PolygonTriangle&)>& cost) {
  std::vector<std::vector<Piece>> best(num_corners, std::vector<Piece>(num_corners));
  for (int width = 2; width < num_corners; ++width)
    for (int i = 0; i + width < num_corners; ++i) {
      const int j = i + width;
      Piece& piece = best[i][j];
      piece.cost = infinity;
      for (int apex = i + 1; apex < j; ++apex) {
        const double rest = std::max(best[i][apex].cost, best[apex][j].cost);
        if (!(rest < piece.cost)) continue;
        const double whole = std::max(rest, cost({i, apex, j}));
        if (whole < piece.cost) piece = {whole, apex};
      }
    }
  std::vector<PolygonTriangle> triangles;
  if (num_corners >= 3 && best[0][num_corners - 1].cost < infinity) collect(best, 0, num_corners - 1, triangles);
  return triangles;
}

}  // namespace tentpole
