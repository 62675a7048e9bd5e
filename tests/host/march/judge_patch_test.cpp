#include "host/march/judge_patch.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/batch/energy_balance.hpp"
#include "tests/host/march/planned_patch.hpp"
#include "tests/host/march/resting_front.hpp"

// Records written down by hand, and what becomes of the patch.
namespace tentpole {
namespace {

constexpr double tolerance = 1e-3;
/// Of the cells at a crack, and more than any cell of the mesh has [m].
constexpr double crack_size = 0.05, longest = 1;

/// A tent over the star of an inner vertex, solved, with balanced energies and nothing lost.
class JudgedTent : public ::testing::Test {
 protected:
  JudgedTent() : front_(4, crack_size, 0.1) {
    state().limits.tolerance = tolerance;
    plan_ = testing::planned_tent(state(), testing::busiest_vertex(state().front.mesh(), VertexKind::interior), 0.1);
    const std::size_t num_elements = plan_.below().size();
    batch_.patches = {{.first_element = 0, .num_elements = static_cast<std::int32_t>(num_elements)}};
    batch_.elements.resize(num_elements);
    for (const FootprintCell& cell : plan_.below()) batch_.cells.push_back(cell.cell);
    batch_.records.resize(num_elements);
    batch_.energies.resize(1);
  }

  AdaptiveState& state() { return front_.state; }
  PatchVerdict verdict(double energy_scale = 1) { return judge_patch(state(), plan_, batch_, 0, energy_scale); }

  void expect_refined(const PatchVerdict& verdict, const std::vector<std::size_t>& elements) {
    ASSERT_EQ(verdict.refine.size(), elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      EXPECT_EQ(verdict.refine[i].cell, plan_.below()[elements[i]].cell);
      EXPECT_EQ(verdict.refine[i].serial, plan_.below()[elements[i]].serial);
    }
  }
  std::vector<std::size_t> all_elements() const {
    std::vector<std::size_t> elements(plan_.below().size());
    for (std::size_t i = 0; i < elements.size(); ++i) elements[i] = i;
    return elements;
  }

  /// No cell may be refined.
  void forbid_refinement() { state().limits.min_size = longest / front_.unit(); }

  /// The patch takes the vertex out instead.
  void make_deletion() { plan_.exchange.between.resize(1); }

  /// A fracture facet on which damage grows by this part of what is allowed.
  void grow_damage(double part) {
    batch_.patches[0].num_fractures = 2;  // the other one rests
    batch_.fracture_records.resize(2);
    batch_.fracture_records[1].largest_damage_change = part * front_.simulation.settings.fracture.max_damage_step;
  }

  testing::RestingFront front_;
  PatchPlan plan_;
  HostBatch batch_;
};

TEST_F(JudgedTent, IsAcceptedUpToTheToleranceAndRefinedBelowTheElementsBeyondIt) {
  batch_.records[1].dissipation = tolerance;
  batch_.records[2].dissipation = 0.5 * tolerance;
  PatchVerdict found = verdict();
  EXPECT_TRUE(found.is_accepted);
  EXPECT_TRUE(found.refine.empty());
  EXPECT_EQ(found.dissipation_ratio, 1);
  batch_.records[1].dissipation = 1.5 * tolerance;
  batch_.records[3].dissipation = 3 * tolerance;
  found = verdict();
  EXPECT_FALSE(found.is_accepted);
  EXPECT_TRUE(found.is_solved);
  EXPECT_FALSE(found.shorten);
  EXPECT_EQ(found.dissipation_ratio, 3);
  expect_refined(found, {1, 3});
}

TEST_F(JudgedTent, IsAcceptedBeyondTheToleranceOverCellsOfTheLeastSizeAndTheyAreCounted) {
  batch_.records[0].dissipation = batch_.records[2].dissipation = 2 * tolerance;
  forbid_refinement();
  const PatchVerdict found = verdict();
  EXPECT_TRUE(found.is_accepted);
  EXPECT_EQ(found.min_size_hits, 2);
  EXPECT_TRUE(found.refine.empty());
}

TEST_F(JudgedTent, LooksOnlyAtItsOwnElements) {
  batch_.records.insert(batch_.records.begin(), ElementRecord{});
  batch_.records.front().dissipation = 2 * tolerance;
  batch_.records.front().status = static_cast<std::int32_t>(Status::not_causal);
  batch_.elements.emplace_back();
  batch_.patches.insert(batch_.patches.begin(), PatchDescriptor{.first_element = 0, .num_elements = 1});
  batch_.patches[1].first_element = 1;
  batch_.energies.resize(2);
  batch_.energies[0].change = 1;
  EXPECT_TRUE(judge_patch(state(), plan_, batch_, 1, 1).is_accepted);
}

TEST_F(JudgedTent, ThatCouldNotBeSolvedWantsSmallerCellsThenALowerPoleThenNothing) {
  batch_.records[0].status = static_cast<std::int32_t>(Status::damage_not_converged);
  PatchVerdict found = verdict();
  EXPECT_FALSE(found.is_accepted);
  EXPECT_FALSE(found.is_solved);
  EXPECT_FALSE(found.shorten) << "one of the two at a time";
  expect_refined(found, all_elements());
  forbid_refinement();
  state().memory[plan_.vertex].halvings = max_halvings - 1;
  found = verdict();
  EXPECT_FALSE(found.is_accepted);
  EXPECT_TRUE(found.refine.empty());
  EXPECT_TRUE(found.shorten);
  state().memory[plan_.vertex].halvings = max_halvings;
  EXPECT_FALSE(verdict().shorten);
}

TEST_F(JudgedTent, ThatGainsEnergyEndsTheRunAndADeletionThatDoesIsLeftUndone) {
  batch_.energies[0].change = 2 * balance_limit;
  EXPECT_THROW(verdict(), std::runtime_error);
  EXPECT_TRUE(verdict(3).is_accepted) << "little beside the energies of the run";
  make_deletion();
  const PatchVerdict found = verdict();
  EXPECT_FALSE(found.is_accepted);
  EXPECT_FALSE(found.is_solved);
  EXPECT_TRUE(found.refine.empty());
  EXPECT_FALSE(found.shorten);
}

TEST_F(JudgedTent, OfADeletionAboveToleranceIsLeftUndoneAndNothingIsRefined) {
  make_deletion();
  batch_.records[0].dissipation = 1.5 * tolerance;
  const PatchVerdict found = verdict();
  EXPECT_FALSE(found.is_accepted);
  EXPECT_TRUE(found.is_solved);
  EXPECT_TRUE(found.refine.empty());
  EXPECT_EQ(found.dissipation_ratio, VertexMemory{}.dissipation_ratio) << "that of the last tent is not known";
}

// Cells are large here: the crack was at rest so far.
TEST_F(JudgedTent, WhoseDamageGrowsIsSolvedAgainInSmallerCellsAndIfItGrowsFastWithALowerPole) {
  grow_damage(0.04);
  EXPECT_TRUE(verdict().is_accepted);
  grow_damage(0.06);
  PatchVerdict found = verdict();
  EXPECT_FALSE(found.is_accepted);
  EXPECT_FALSE(found.shorten);
  expect_refined(found, all_elements());
  state().limits.crack_size = longest / front_.unit();
  grow_damage(1);
  EXPECT_TRUE(verdict().is_accepted);
  grow_damage(1.01);
  found = verdict();
  EXPECT_FALSE(found.is_accepted);
  EXPECT_TRUE(found.shorten);
  EXPECT_TRUE(found.refine.empty());
  state().memory[plan_.vertex].halvings = max_halvings;
  EXPECT_TRUE(verdict().is_accepted) << "poles have an end";
}

}  // namespace
}  // namespace tentpole
