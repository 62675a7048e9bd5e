#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/front/adaptive_front.hpp"
#include "host/mesh/box_mesh.hpp"
#include "tests/host/front/random_meshes.hpp"
#include "tests/host/front/random_operations.hpp"

namespace tentpole {
namespace {

/// Seeds per family. scripts/soak_front sets TENTPOLE_SOAK_SEEDS to run many more than the default.
int num_seeds(int by_default) {
  const char* text = std::getenv("TENTPOLE_SOAK_SEEDS");
  return text == nullptr ? by_default : std::stoi(text);
}

struct Family {
  std::function<SpaceMesh(std::uint64_t)> make_mesh;
  int num_operations;
  int operations_per_check;
  int crack_share;  ///< every n-th edge is a crack; 0: none
};

void add(testing::OperationCounts& sum, const testing::OperationCounts& counts) {
  sum.tents += counts.tents;
  sum.inclined += counts.inclined;
  sum.splits += counts.splits;
  sum.edge_splits += counts.edge_splits;
  sum.refused += counts.refused;
  sum.deletions += counts.deletions;
  sum.flips += counts.flips;
  sum.smallest_rise = std::min(sum.smallest_rise, counts.smallest_rise);
}

/// Random operations, all invariants in between; then only tents to a common end time.
void run(const SpaceMesh& mesh, std::uint64_t seed, const Family& family, testing::OperationCounts& sum) {
  const std::vector<double> speeds{1.0, 2.0};
  const AdaptiveFrontRules rules;
  AdaptiveFront front(mesh, std::span(speeds).first(mesh.region_names.size()), rules);
  std::mt19937_64 random(seed);
  if (family.crack_share > 0) testing::mark_random_cracks(front, random, family.crack_share);
  testing::OperationCounts counts;
  testing::OperationMix mix;
  mix.max_cells = 3 * mesh.num_cells();
  for (int operation = 1; operation <= family.num_operations; ++operation) {
    ASSERT_NO_THROW(testing::random_operation(front, random, rules.causality, mix, counts))
        << "operation " << operation;
    if (operation % family.operations_per_check > 0) continue;
    ASSERT_NO_THROW(front.check()) << "operation " << operation;
    ASSERT_LE(front.steepness(), 1 + 1e-9);
  }
  const std::vector<double>& times = front.mesh().times();
  const double end_time = *std::max_element(times.begin(), times.end()) + 0.1;
  for (auto minima = front.local_minima(end_time); !minima.empty(); minima = front.local_minima(end_time))
    for (const int vertex : minima) {
      front.raise(vertex, front.pole_top_time(vertex, end_time));
      ++counts.tents;
    }
  EXPECT_EQ(front.minimum_time(), end_time);
  ASSERT_NO_THROW(front.check());
  EXPECT_NEAR(front.mesh().domain_measure(), 1, 1e-12);
  const std::vector<double> sides = front.mesh().boundary_measures();
  EXPECT_NEAR(std::accumulate(sides.begin(), sides.end(), 0.0), mesh.dimension == 1 ? 2 : 4, 1e-12);
  add(sum, counts);
}

void soak(int seeds, const Family& family) {
  testing::OperationCounts sum;
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    run(family.make_mesh(static_cast<std::uint64_t>(seed)), static_cast<std::uint64_t>(seed), family, sum);
    if (::testing::Test::HasFatalFailure()) return;
  }
  std::printf(
      "  tents %lld, inclined %lld, bisected %lld, edges cut %lld, splits refused %lld, deletions %lld, flips %lld, "
      "smallest rise %.3f\n",
      static_cast<long long>(sum.tents), static_cast<long long>(sum.inclined), static_cast<long long>(sum.splits),
      static_cast<long long>(sum.edge_splits), static_cast<long long>(sum.refused),
      static_cast<long long>(sum.deletions), static_cast<long long>(sum.flips), sum.smallest_rise);
  EXPECT_GE(sum.smallest_rise, 0.15);
  EXPECT_GT(sum.deletions, 0);
  EXPECT_GT(sum.inclined, 0);
  EXPECT_GT(sum.splits, 0);
}

SpaceMesh two_region_mesh(SpaceMesh mesh) {
  testing::divide_into_regions(mesh, 0.5);
  return mesh;
}

SpaceMesh box(int dimension, int n, MeshPattern pattern, std::uint64_t seed) {
  BoxMesh box;
  box.dimension = dimension;
  box.cells = {n, n, 1};
  box.pattern = pattern;
  box.seed = seed;
  return make_box_mesh(box);
}

TEST(AdaptiveFrontSoak, InvariantsHoldAfterEveryOperation) {
  soak(2, {[](std::uint64_t seed) { return testing::bad_triangle_mesh(seed, 6, 5, 150); }, 2000, 1, 0});
  soak(2,
       {[](std::uint64_t seed) { return two_region_mesh(testing::bad_triangle_mesh(seed, 6, 5, 150)); }, 2000, 1, 9});
}

TEST(AdaptiveFrontSoak, NeverStuckOnTrianglesOf5To150Degrees) {
  soak(num_seeds(12), {[](std::uint64_t seed) { return testing::bad_triangle_mesh(seed, 8, 5, 150); }, 10000, 500, 0});
}

TEST(AdaptiveFrontSoak, NeverStuckOnTrianglesOf2To170DegreesWithCracks) {
  soak(num_seeds(12), {[](std::uint64_t seed) { return testing::bad_triangle_mesh(seed, 8, 2, 170); }, 10000, 500, 20});
}

TEST(AdaptiveFrontSoak, NeverStuckWithAStraightInterfaceAndTwoWaveSpeeds) {
  soak(num_seeds(12),
       {[](std::uint64_t) { return two_region_mesh(box(2, 8, MeshPattern::structured, 1)); }, 10000, 500, 0});
}

TEST(AdaptiveFrontSoak, NeverStuckOnALineWithTwoWaveSpeedsAndCracks) {
  soak(num_seeds(12), {[](std::uint64_t seed) { return two_region_mesh(box(1, 40, MeshPattern::unstructured, seed)); },
                       10000, 500, 15});
}

}  // namespace
}  // namespace tentpole
