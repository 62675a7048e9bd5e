#include "host/march/commit_round.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/march/planned_patch.hpp"
#include "tests/host/march/resting_front.hpp"

// What becomes of the front, of what lies below its cells and of the slots of the store. Verdicts are written by hand.
namespace tentpole {
namespace {

constexpr double pole_height = 0.01;

/// A patch that is not accepted and wants nothing; `is_solved`: but lost too much.
PatchVerdict rejection(bool is_solved = true) {
  PatchVerdict verdict;
  verdict.is_accepted = false;
  verdict.is_solved = is_solved;
  return verdict;
}

class CommittedRound : public ::testing::Test {
 protected:
  CommittedRound() : front_(4, 0.05, 0.1), writer_(state()), search_(state()) { state().limits.tolerance = 1; }

  AdaptiveState& state() { return front_.state; }
  const FrontMesh& mesh() const { return front_.state.front.mesh(); }
  /// A local minimum inside the domain.
  std::int32_t inner_minimum() const {
    for (const std::int32_t vertex : front_.state.front.local_minima(1e9))
      if (mesh().kind(vertex) == VertexKind::interior) return vertex;
    throw std::logic_error("all local minima are on the boundary");
  }

  /// A round of one patch on which nothing happens.
  AdaptiveRound round_of(const PatchPlan& plan, const PatchVerdict& verdict = {}) {
    AdaptiveRound round;
    round.batches.resize(1);
    round.patches = {{.plan = plan, .batch = 0, .patch = 0, .verdict = verdict}};
    HostBatch& batch = round.batches[0];
    writer_.write(plan, batch);
    batch.records.resize(batch.elements.size());
    batch.fracture_records.resize(batch.fractures.size());
    return round;
  }
  /// Whether its patch was accepted.
  bool commit(const AdaptiveRound& round) { return commit_round(state(), search_, round).at(0).at(0); }

  PatchPlan tent() { return testing::planned_tent(state(), inner_minimum(), pole_height); }

  /// Accepts a tent at the only crack edge, whose damage grows where the traction is large.
  PatchPlan commit_cracked_tent(double effective_traction) {
    const PatchPlan plan = tent();
    state().front.mark_crack(plan.vertex, mesh().neighbors(plan.vertex)[0]);
    state().follow_front();
    AdaptiveRound round = round_of(plan);
    FractureRecord& record = round.batches[0].fracture_records.at(0);
    std::copy_n(std::array{0.25, 0.5, 0.75}.begin(), 3, record.damage);
    std::copy_n(std::array{1, 3, 2}.begin(), 3, record.mode_points);
    record.gap[1] = -4;
    record.largest_effective_traction = effective_traction;
    EXPECT_TRUE(commit(round));
    return plan;
  }

  /// Every slot is below a cell or free.
  void expect_no_slot_lost() {
    std::set<std::int32_t> slots;
    for (int cell = 0; cell < mesh().num_cell_slots(); ++cell)
      if (mesh().is_alive_cell(cell) && state().sources.slot[cell] != none) slots.insert(state().sources.slot[cell]);
    ElementStore& store = state().books.store;
    const std::int32_t num_slots = store.num_slots(), num_free = num_slots - static_cast<std::int32_t>(slots.size());
    std::vector<std::int32_t> acquired;
    for (int free = 0; free < num_free; ++free) acquired.push_back(store.acquire());
    for (const std::int32_t slot : acquired) EXPECT_TRUE(slots.insert(slot).second) << "a slot below a cell is free";
    EXPECT_EQ(store.num_slots(), num_slots) << "a slot is lost";
    for (const std::int32_t slot : acquired) store.release(slot);
    store.end_batch();
  }

  /// The element below a cell: its corners but number `sources.facet` are those of the cell.
  void expect_stands_on(const ElementDescriptor& element, std::int32_t cell) {
    const FrontSimplex simplex = mesh().simplex(cell);
    std::set<std::array<double, 3>> expected, found;
    for (int corner = 0; corner < 3; ++corner)
      expected.insert({simplex.position[corner][0], simplex.position[corner][1], simplex.time[corner]});
    for (int corner = 0; corner < 4; ++corner)
      if (corner != state().sources.facet[cell] % 4)  // codes 4 to 6 are those of tents: the top for the pole
        found.insert({element.corner[corner][0], element.corner[corner][1], element.corner[corner][2]});
    EXPECT_EQ(found, expected);
  }

  testing::RestingFront front_;
  PatchWriter writer_;
  DefectSearch search_;
};

TEST_F(CommittedRound, OfAcceptedTentsRaisesThemAndPutsTheirElementsBelow) {
  const std::vector<double> before = mesh().times();
  AdaptiveRound round = solve_round(state(), writer_, 2);
  ASSERT_GT(round.batches.size(), 1u);
  round.patches[1].verdict.dissipation_ratio = 0.25;
  std::vector<double> expected = before;
  for (const RoundPatch& patch : round.patches) expected[patch.plan.vertex] = patch.plan.top.time;
  for (const std::vector<std::uint8_t>& batch : commit_round(state(), search_, round))
    for (const std::uint8_t is_accepted : batch) EXPECT_TRUE(is_accepted);
  EXPECT_EQ(mesh().times(), expected);
  int num_raised = 0;
  for (const RoundPatch& patch : round.patches)
    for (std::size_t e = 0; e < patch.plan.below().size(); ++e, ++num_raised) {
      const std::int32_t cell = patch.plan.below()[e].cell;
      const ElementDescriptor& element =
          round.batch_of(patch).elements[round.descriptor(patch).first_element + static_cast<std::int32_t>(e)];
      EXPECT_EQ(state().sources.slot[cell], element.result_slot);
      EXPECT_EQ(state().sources.facet[cell], 4 + mesh().corner_of(cell, patch.plan.vertex));
      expect_stands_on(element, cell);
    }
  EXPECT_EQ(std::ranges::count(state().sources.slot, none), mesh().num_cells() - num_raised);
  EXPECT_EQ(state().memory[round.patches[1].plan.vertex].dissipation_ratio, 0.25);
  EXPECT_EQ(state().counts.rejected, 0);
  expect_no_slot_lost();
}

TEST_F(CommittedRound, OfARejectedTentSplitsTheCellsThatItWantsOrLowersTheNextPole) {
  for (const bool shorten : {true, false}) {
    const PatchPlan plan = tent();
    const std::int64_t splits = state().counts.splits, rejected = state().counts.rejected;
    const int num_cells = mesh().num_cells();
    const double measure = mesh().domain_measure();
    PatchVerdict verdict = rejection();
    verdict.shorten = shorten;
    if (!shorten) verdict.refine = {plan.below()[0], plan.below()[2]};
    EXPECT_FALSE(commit(round_of(plan, verdict)));
    EXPECT_EQ(mesh().time(plan.vertex), 0);
    EXPECT_EQ(state().counts.rejected, rejected + 1);
    EXPECT_EQ(state().memory[plan.vertex].halvings, 1) << "by the first of the two only";
    EXPECT_EQ(state().front.is_unchanged(plan.below()), shorten);
    for (const FootprintCell& wanted : verdict.refine) EXPECT_FALSE(state().front.is_unchanged({wanted}));
    EXPECT_EQ(mesh().num_cells() - num_cells, state().counts.splits - splits);
    EXPECT_NEAR(mesh().domain_measure(), measure, 1e-12);
    EXPECT_TRUE(state().pending.empty());
  }
  expect_no_slot_lost();
}

TEST_F(CommittedRound, AcceptsATentAboveToleranceThatNeitherSplitsNorTwoHalvingsHelped) {
  const PatchPlan plan = tent();
  const PatchVerdict verdict = rejection();
  for (const int halvings : {1, 2}) {
    EXPECT_FALSE(commit(round_of(plan, verdict)));
    EXPECT_EQ(state().memory[plan.vertex].halvings, halvings);
    EXPECT_EQ(mesh().time(plan.vertex), 0);
  }
  EXPECT_TRUE(commit(round_of(plan, verdict)));
  EXPECT_EQ(mesh().time(plan.vertex), pole_height);
  EXPECT_EQ(state().counts.refused, 1);
  EXPECT_EQ(state().counts.rejected, 2);
  EXPECT_EQ(state().memory[plan.vertex].halvings, 0) << "the next pole is a full one";
  expect_no_slot_lost();
}

TEST_F(CommittedRound, EndsTheRunWhereATentCannotBeSolvedHoweverLow) {
  const PatchPlan plan = tent();
  AdaptiveRound round = round_of(plan, rejection(false));
  for (ElementRecord& record : round.batches[0].records)
    record.status = static_cast<std::int32_t>(Status::damage_not_converged);
  state().memory[plan.vertex].halvings = max_halvings;
  char place[80];
  const Point position = front_.place(plan.vertex);
  std::snprintf(place, sizeof place, "tent at (%.6g, %.6g) m, t = 0 s: damage not converged", position[0], position[1]);
  try {
    commit(round);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(place), std::string::npos) << error.what();
  }
}

TEST_F(CommittedRound, OfADeletionPutsEachNewCellOnTheElementBelowIt) {
  const PatchPlan plan = testing::planned_deletion(state(), inner_minimum());
  for (const FootprintCell& cell : plan.below()) state().sources.slot[cell.cell] = state().books.store.acquire();
  const AdaptiveRound round = round_of(plan);
  const std::int64_t first_new = mesh().next_serial();
  EXPECT_TRUE(commit(round));
  EXPECT_FALSE(mesh().is_alive_vertex(plan.vertex));
  EXPECT_EQ(state().counts.deletions, 1);
  int num_new = 0;
  for (int cell = 0; cell < mesh().num_cell_slots(); ++cell) {
    if (!mesh().is_alive_cell(cell) || mesh().cell(cell).serial < first_new) continue;
    ++num_new;
    const auto& elements = round.batches[0].elements;
    const auto element = std::ranges::find(elements, state().sources.slot[cell], &ElementDescriptor::result_slot);
    ASSERT_NE(element, elements.end());
    expect_stands_on(*element, cell);
  }
  EXPECT_EQ(num_new, static_cast<int>(plan.below().size()) - 2);
  expect_no_slot_lost();
}

TEST_F(CommittedRound, HandsTheDamageOn) {
  commit_cracked_tent(0);
  EXPECT_EQ(smallest_damage(state().crack_state[0]), 0.25);
  EXPECT_EQ(largest_damage(state().crack_state[0]), 0.75);
  EXPECT_EQ(state().crack_state[0].gap[1], -4);
  EXPECT_EQ(state().crack_mode[0], CrackMode::stick) << "at most of the points";
  EXPECT_EQ(state().counts.splits, 0) << "at rest";
}

TEST_F(CommittedRound, SplitsAllLargeCellsAtACrackWhoseDamageGrows) {
  const PatchPlan plan = commit_cracked_tent(1e9);
  for (const FootprintCell& cell : plan.below()) EXPECT_FALSE(state().front.is_unchanged({cell}));
  expect_no_slot_lost();
}

// Random verdicts on a front where all operations are allowed.
TEST_F(CommittedRound, LosesNeitherSlotsNorPartsOfTheDomain) {
  front_.simulation.settings.front.smoothing = true;
  std::mt19937 engine(11);
  const double measure = mesh().domain_measure();
  for (int number = 0; number < 60; ++number) {
    AdaptiveRound round = solve_round(state(), writer_, 3);
    for (RoundPatch& patch : round.patches) {
      patch.verdict.is_accepted = engine() % 3 > 0;
      if (!patch.verdict.is_accepted && patch.plan.is_tent() && mesh().num_cells() < 300)
        patch.verdict.refine.assign(1, patch.plan.below()[engine() % patch.plan.below().size()]);
      patch.verdict.shorten = engine() % 4 == 0;
    }
    commit_round(state(), search_, round);
    ASSERT_NO_THROW(state().front.check());
    EXPECT_NEAR(mesh().domain_measure(), measure, 1e-9 * measure);
    expect_no_slot_lost();
  }
  const AdaptiveCounts& counts = state().counts;
  std::printf("  %ld rejected, %ld splits, %ld deletions, %ld flips, %ld inclined, %ld refused\n",
              long(counts.rejected), long(counts.splits), long(counts.deletions), long(counts.flips),
              long(counts.inclined), long(counts.refused));
  for (const std::int64_t count : {counts.rejected, counts.splits, counts.deletions, counts.flips, counts.inclined})
    EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace tentpole
