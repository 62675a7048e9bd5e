#include "host/run/tent_estimate.hpp"

#include <gtest/gtest.h>

#include "host/run/make_simulation.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

Simulation square(const TemporaryFolder& folder) {
  return make_simulation(read_case(folder.write("square.toml", R"(
[domain]
dimension = 2
min = [0, 0]
max = [1, 1]
cells = [10, 10]
pattern = "unstructured"
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.0
[boundary.left]
absorbing = true
[boundary.right]
absorbing = true
[boundary.bottom]
absorbing = true
[boundary.top]
absorbing = true
[time]
end = 2.0
[discretization]
degree = 2
)")));
}

TEST(TentEstimate, ExtrapolatesToWithinTenPercentFromATenthOfTheTents) {
  const TemporaryFolder folder;
  const Simulation simulation = square(folder);
  const TentEstimate all = estimate_tents(simulation, 1'000'000);
  ASSERT_TRUE(all.is_exact);
  const TentEstimate estimate = estimate_tents(simulation, static_cast<std::int64_t>(all.patches / 10));
  EXPECT_FALSE(estimate.is_exact);
  EXPECT_NEAR(estimate.patches, all.patches, 0.1 * all.patches);
  EXPECT_NEAR(estimate.elements, all.elements, 0.1 * all.elements);
}

TEST(TentEstimate, LargestPatchIsTheLargestStar) {
  const TemporaryFolder folder;
  const Simulation simulation = square(folder);
  std::size_t largest = 0;
  for (int vertex = 0; vertex < simulation.mesh.num_vertices(); ++vertex)
    largest = std::max(largest, simulation.mesh.star(vertex).size());
  EXPECT_EQ(estimate_tents(simulation, 1'000'000).largest_patch, static_cast<int>(largest));
}

}  // namespace
}  // namespace tentpole
