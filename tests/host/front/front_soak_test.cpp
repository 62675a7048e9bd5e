#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/front/front.hpp"
#include "tests/host/front/random_meshes.hpp"
#include "tests/host/mesh/mesh_angles.hpp"

namespace tentpole {
namespace {

/// Seeds per family of meshes. scripts/soak_front sets TENTPOLE_SOAK_SEEDS to run many more than the default.
int num_seeds(int by_default) {
  const char* text = std::getenv("TENTPOLE_SOAK_SEEDS");
  return text == nullptr ? by_default : std::stoi(text);
}

struct Outcome {
  std::int64_t num_tents = 0;
  double height_sum = 0;  ///< of pole heights over altitude / c, before the end time cuts them
  double smallest_height = 1e300;
  double steepest = 0;
  testing::AngleRange angles;
};

/// Marches to 10 median altitudes / c with unit wave speed and gamma = 1; any lack of progress throws.
void march(const SpaceMesh& mesh, Outcome& outcome) {
  std::vector<double> altitude;
  for (int vertex = 0; vertex < mesh.num_vertices(); ++vertex)
    altitude.push_back(testing::smallest_altitude(mesh, vertex));
  std::vector<double> sorted = altitude;
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  const double end_time = 10 * sorted[sorted.size() / 2];
  Front front(mesh, std::vector<double>(mesh.num_cells(), 1.0), 1.0);
  for (auto minima = front.next_minima(256, end_time); !minima.empty(); minima = front.next_minima(256, end_time))
    for (const int vertex : minima) {
      const double bottom = front.time(vertex), top = front.pole_top_time(vertex, end_time);
      const double relative = (front.pole_top_time(vertex, 1e300) - bottom) / altitude[vertex];
      outcome.height_sum += relative;
      outcome.smallest_height = std::min(outcome.smallest_height, relative);
      front.raise(vertex, top);
      ++outcome.num_tents;
      outcome.steepest = std::max(outcome.steepest, front.steepness(vertex));
    }
  for (const double time : front.times()) ASSERT_EQ(time, end_time);
  const testing::AngleRange angles = testing::angle_range(mesh);
  outcome.angles = {std::min(outcome.angles.smallest, angles.smallest),
                    std::max(outcome.angles.largest, angles.largest)};
}

/// `smallest_height`: what the rule promises for one pole, in altitudes / c.
void soak(int by_default, double smallest_height, const std::function<SpaceMesh(std::uint64_t)>& make_mesh) {
  Outcome outcome;
  for (int seed = 1; seed <= num_seeds(by_default); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    march(make_mesh(static_cast<std::uint64_t>(seed)), outcome);
  }
  std::printf("  tents %lld, angles %.2f..%.2f, mean height %.3f, smallest %.3f, steepest 1%+.1e\n",
              static_cast<long long>(outcome.num_tents), outcome.angles.smallest, outcome.angles.largest,
              outcome.height_sum / static_cast<double>(outcome.num_tents), outcome.smallest_height,
              outcome.steepest - 1);
  EXPECT_LE(outcome.steepest, 1 + 1e-12);
  EXPECT_GE(outcome.smallest_height, smallest_height);
}

TEST(FrontSoak, NeverStuckOnTrianglesOf5To150Degrees) {
  soak(40, 0.3, [](std::uint64_t seed) { return testing::bad_triangle_mesh(seed, 8, 5, 150); });
}

TEST(FrontSoak, NeverStuckOnTrianglesOf2To170Degrees) {
  soak(60, 0.3, [](std::uint64_t seed) { return testing::bad_triangle_mesh(seed, 8, 2, 170); });
}

TEST(FrontSoak, NeverStuckOnDelaunayTetrahedra) {
  soak(50, 1e-6, [](std::uint64_t seed) { return testing::delaunay_tetrahedron_mesh(seed, 60); });
}

TEST(FrontSoak, NeverStuckOnSliverTetrahedra) {
  soak(50, 1e-3, [](std::uint64_t seed) { return testing::sliver_tetrahedron_mesh(seed, 3, 0.02); });
}

}  // namespace
}  // namespace tentpole
