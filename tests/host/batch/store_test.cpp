#include <algorithm>

#include <gtest/gtest.h>

#include "host/march/batch_builder.hpp"
#include "tests/host/run/case_text.hpp"
#include "tests/host/run/solved_run.hpp"

// What a run keeps is proportional to the front: a slot per front cell and one batch, however long it runs; and a batch
// carries the same for every patch.
namespace tentpole {
namespace {

using testing::CaseText;

Simulation box(int dimension, double end) {
  CaseText text;
  text.dimension = dimension;
  const int cells[4] = {0, 64, 10, 4};
  text.cells.assign(3, cells[dimension]);
  text.end = end;
  const std::string free_side =
      "traction = " + testing::expression_list(std::vector<std::string>(dimension, "0")) + "\n";
  const char* const sides[6] = {"left", "right", "bottom", "top", "back", "front"};
  for (int side = 0; side < 2 * dimension; ++side)
    text.rest += std::string("[boundary.") + sides[side] + "]\n" + free_side;
  return testing::simulation_of(text.text());
}

/// Pitches all tents without solving them.
struct Pitched {
  int num_slots = 0;
  int largest_batch = 0;  ///< elements
  std::size_t num_patches = 0;
  std::size_t num_prescribed = 0;  ///< numbers in all batches
};

Pitched pitch(const Simulation& simulation, int max_patches) {
  Front front(simulation.mesh, simulation.cell_wave_speed, 0.95);
  CellSources sources{std::vector<std::int32_t>(simulation.mesh.num_cells(), none),
                      std::vector<std::int32_t>(simulation.mesh.num_cells(), 0)};
  ElementStore store;
  BatchBuilder builder(simulation, front, sources, store);
  Pitched pitched;
  HostBatch batch;
  for (builder.build(batch, max_patches); !batch.patches.empty(); builder.build(batch, max_patches)) {
    pitched.num_slots = batch.num_slots;
    pitched.largest_batch = std::max(pitched.largest_batch, static_cast<int>(batch.elements.size()));
    pitched.num_patches += batch.patches.size();
    pitched.num_prescribed += batch.prescribed.size();
  }
  return pitched;
}

class ElementStoreSize : public ::testing::TestWithParam<int> {};

TEST_P(ElementStoreSize, IsTheFrontAndOneBatchHoweverLongTheRun) {
  const int dimension = GetParam();
  const Simulation shorter = box(dimension, 1), longer = box(dimension, 8);
  for (const int max_patches : {1, 16, 100000}) {
    SCOPED_TRACE("batches of " + std::to_string(max_patches));
    const Pitched few = pitch(shorter, max_patches), many = pitch(longer, max_patches);
    ASSERT_GT(many.num_patches, 6 * few.num_patches);
    EXPECT_LE(many.num_slots, longer.mesh.num_cells() + many.largest_batch);
    EXPECT_LE(many.num_slots, few.num_slots + many.largest_batch - few.largest_batch);
    EXPECT_EQ(many.num_prescribed, few.num_prescribed) << "free sides need data only below the first elements";
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ElementStoreSize, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
