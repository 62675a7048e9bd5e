#include <string>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "kernels/patch/solve_patch.hpp"
#include "tests/kernels/solved_together.hpp"

namespace tentpole {
namespace {

/// A team of one lane that counts how often it meets itself. The number of meetings does not depend on that of lanes.
struct CountingLanes {
  static constexpr bool cooperative = true;
  long* num_meetings;

  int first() const { return 0; }
  int count() const { return 1; }
  void synchronize() const { ++*num_meetings; }
};

struct Meetings {
  double elements;  ///< mean of a patch
  double barriers;  ///< mean of a patch
};

/// The patches that bench_patch makes its batches of; the first eight.
template <int D>
Meetings count_meetings(int degree) {
  TentOptions options;
  options.num_patches = 8;
  options.boundary_fraction = 0.1;
  options.data.source_fraction = 1;
  TentBatch batch = random_tents(D, degree, options, 1);
  const ReferenceTables tables(D, degree);
  std::vector<double> scratch = team_scratch(tables, batch, 1);
  long num_meetings = 0;
  StageCycles cycles;
  for (int patch = 0; patch < 8; ++patch)
    solve_patch<D>(batch.view(), tables.view(), patch, scratch.data(), cycles, CountingLanes{&num_meetings});
  for (const ElementRecord& record : batch.records) EXPECT_EQ(record.status, int(Status::ok));
  return {static_cast<double>(batch.elements.size()) / 8, static_cast<double>(num_meetings) / 8};
}

/// On a GPU a patch takes as long as its meetings, not as its operations. Before the elements of a patch were worked on
/// side by side the counts were 798, 1575, 5551 and 11 415. A limit that must rise needs a reason in the commit.
TEST(Barriers, ArePerPatchAndNotPerElement) {
  const Meetings plane_2 = count_meetings<2>(2), plane_3 = count_meetings<2>(3), space_2 = count_meetings<3>(2),
                 space_3 = count_meetings<3>(3);
  EXPECT_NEAR(plane_2.elements, 4.6, 0.05);
  EXPECT_NEAR(plane_3.elements, 6.0, 0.05);
  EXPECT_NEAR(space_2.elements, 22.5, 0.05);
  EXPECT_NEAR(space_3.elements, 24.0, 0.05);
  EXPECT_LE(plane_2.barriers, 143);
  EXPECT_LE(plane_3.barriers, 195);
  EXPECT_LE(space_2.barriers, 204);
  EXPECT_LE(space_3.barriers, 275);
  RecordProperty("barriers", std::to_string(plane_2.barriers) + " " + std::to_string(plane_3.barriers) + " " +
                                 std::to_string(space_2.barriers) + " " + std::to_string(space_3.barriers));
}

}  // namespace
}  // namespace tentpole
