#include "host/march/grow_cracks.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/host/march/resting_front.hpp"

// What triggers make of a front at rest, whatever its cells.
namespace tentpole {
namespace {

constexpr double growth_length = 0.1;
constexpr Point up{0, 1, 0}, right{1, 0, 0};

/// A front of the unit square at rest, in metres, whose cells at cracks have edges of at most `crack_size`.
class CrackedFront {
 public:
  explicit CrackedFront(double crack_size) : front_(4, crack_size, growth_length) {}

  /// A defect gives way at a place [m]; the surface is to have this normal.
  void trigger(Point position, const Point& normal) {
    for (double& coordinate : position) coordinate /= front_.unit();
    state().triggers.push_back({position, {{{normal[0], normal[1]}, {}}}, 1, {}});
    follow();
  }

  /// Goes on with what waits.
  void follow() {
    Refinement refinement(state());
    grow_cracks(state(), refinement);
    refinement.flush();
    state().front.check();
  }

  /// Raises all local minima. With the full pitch the front becomes steep.
  void raise(Pitch pitch) {
    for (const std::int32_t vertex : state().front.local_minima(no_end))
      state().front.raise(vertex, state().front.pole_top_time(vertex, no_end, pitch));
  }

  /// Length of all surfaces [m].
  double surface_length() const {
    double length = 0;
    for (int edge = 0; edge < cracks().size(); ++edge)
      if (!cracks().is_retired(edge))
        length += distance(front_.place(cracks().edge(edge)[0]), front_.place(cracks().edge(edge)[1]));
    return length;
  }

  /// Vertices where exactly n edges of cracks end.
  std::vector<Point> vertices_with_edges(std::size_t n) const {
    std::vector<Point> places;
    const FrontMesh& mesh = front_.state.front.mesh();
    for (int vertex = 0; vertex < mesh.num_vertex_slots(); ++vertex)
      if (mesh.is_alive_vertex(vertex) && cracks().at(vertex).size() == n) places.push_back(front_.place(vertex));
    return places;
  }

  const AdaptiveCounts& counts() const { return front_.state.counts; }
  bool is_done() const { return front_.state.triggers.empty() && front_.state.growths.empty(); }
  std::size_t num_growths() const { return front_.state.growths.size(); }

 private:
  static constexpr double no_end = 1e9;

  AdaptiveState& state() { return front_.state; }
  const CrackEdges& cracks() const { return front_.state.front.cracks(); }

  testing::RestingFront front_;
};

/// Tips of a crack along x: the left and the right one.
std::array<Point, 2> tips_along_x(const CrackedFront& front) {
  const std::vector<Point> tips = front.vertices_with_edges(1);
  EXPECT_EQ(tips.size(), 2u);
  if (tips.size() != 2) return {};
  return tips[0][0] < tips[1][0] ? std::array{tips[0], tips[1]} : std::array{tips[1], tips[0]};
}

/// An arm may miss half of its last edge or have that much too much: over many defects this averages out.
TEST(Nucleation, MakesSurfacesOfTheSameLengthInCellsOfAnySize) {
  for (const double crack_size : {1.0, 0.5, 0.25}) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> place(0.3, 0.7), angle(0, std::numbers::pi);
    double length = 0;
    constexpr int defects = 40;
    for (int defect = 0; defect < defects; ++defect) {
      CrackedFront front(crack_size * growth_length);
      const double direction = angle(generator);
      front.trigger({place(generator), place(generator), 0}, {std::cos(direction), std::sin(direction), 0});
      EXPECT_TRUE(front.is_done());
      EXPECT_EQ(front.counts().nucleations, 1);
      EXPECT_NEAR(front.surface_length(), 2 * growth_length, 1.5 * crack_size * growth_length);
      length += front.surface_length() / defects;
    }
    EXPECT_NEAR(length, 2 * growth_length, 0.1 * 2 * growth_length) << "cells of " << crack_size << " growth lengths";
  }
}

TEST(Nucleation, PutsItsArmsOnBothSidesAlongTheSurface) {
  CrackedFront front(0.25 * growth_length);
  front.trigger({0.52, 0.48, 0}, up);
  const auto [left, right_tip] = tips_along_x(front);
  EXPECT_NEAR(left[0], 0.52 - growth_length, 0.03);
  EXPECT_NEAR(right_tip[0], 0.52 + growth_length, 0.03);
  EXPECT_NEAR(left[1], 0.48, 0.04);
  EXPECT_NEAR(right_tip[1], 0.48, 0.04);
}

TEST(Extension, OfANearTipIsOneGrowthLength) {
  CrackedFront front(0.25 * growth_length);
  front.trigger({0.5, 0.5, 0}, up);
  const double before = front.surface_length();
  const Point tip = tips_along_x(front)[1];
  front.trigger({tip[0] + 0.8 * growth_length, tip[1], 0}, up);
  EXPECT_EQ(front.counts().extensions, 1);
  EXPECT_EQ(front.counts().nucleations, 1);
  EXPECT_NEAR(front.surface_length() - before, growth_length, 0.25 * growth_length);
  EXPECT_NEAR(tips_along_x(front)[1][0], tip[0] + growth_length, 0.03);
}

TEST(Extension, IsNotForTipsFartherThanAGrowthLength) {
  CrackedFront front(0.25 * growth_length);
  front.trigger({0.3, 0.5, 0}, up);
  const Point tip = tips_along_x(front)[1];
  front.trigger({tip[0] + 1.3 * growth_length, tip[1], 0}, up);
  EXPECT_EQ(front.counts().extensions, 0);
  EXPECT_EQ(front.counts().nucleations, 2);
}

TEST(Branch, LeavesTheMiddleOfACrackAtALargeAngleOnly) {
  CrackedFront front(0.25 * growth_length);
  front.trigger({0.5, 0.5, 0}, up);
  front.trigger(tips_along_x(front)[1], up);
  front.trigger(tips_along_x(front)[0], up);
  const double before = front.surface_length();
  front.trigger({0.5, 0.55, 0}, up);
  EXPECT_TRUE(front.is_done());
  EXPECT_EQ(front.surface_length(), before) << "a surface along the crack needs none of its own";
  front.trigger({0.5, 0.55, 0}, right);
  EXPECT_EQ(front.counts().branches, 1);
  EXPECT_NEAR(front.surface_length() - before, growth_length, 0.25 * growth_length);
  EXPECT_EQ(front.vertices_with_edges(3).size(), 1u);
}

TEST(Coalescence, EndsASurfaceAtTheBoundary) {
  CrackedFront front(0.25 * growth_length);
  front.trigger({0.93, 0.5, 0}, up);
  EXPECT_TRUE(front.is_done());
  EXPECT_EQ(front.counts().coalescences, 1);
  EXPECT_NEAR(front.surface_length(), growth_length + 0.07, 0.04);
}

TEST(Coalescence, EndsASurfaceAtAnotherCrack) {
  CrackedFront front(0.25 * growth_length);
  front.trigger({0.5, 0.5, 0}, right);
  const double before = front.surface_length();
  front.trigger({0.35, 0.5, 0}, up);
  ASSERT_EQ(front.counts().nucleations, 2);
  const Point tip = front.vertices_with_edges(1).back();
  EXPECT_EQ(front.counts().coalescences, 0) << "the second crack ends at (" << tip[0] << ", " << tip[1] << ")";
  front.trigger({0.44, 0.5, 0}, up);
  EXPECT_EQ(front.counts().extensions, 1);
  EXPECT_EQ(front.counts().coalescences, 1);
  EXPECT_LT(front.surface_length() - before, 3 * growth_length - 0.03) << "it does not go on beyond the first";
}

TEST(Nucleation, AtTheBoundaryHasOneArm) {
  for (const double sign : {1.0, -1.0}) {
    CrackedFront front(0.25 * growth_length);
    front.trigger({0.5, 0.001, 0}, {sign, 0, 0});
    EXPECT_TRUE(front.is_done());
    EXPECT_EQ(front.counts().nucleations, 1);
    EXPECT_NEAR(front.surface_length(), growth_length, 0.25 * growth_length);
  }
}

/// On a steep front splits are refused: triggers wait, or what is missing of their surfaces does, and nothing is lost.
TEST(Triggers, WaitForAdmissibleSplits) {
  int waited = 0, begun = 0;
  for (int rounds = 1; rounds <= 60; ++rounds) {
    CrackedFront front(0.25 * growth_length);
    for (int round = 0; round < rounds; ++round) front.raise(Pitch::full);
    front.trigger({0.3 + 0.007 * rounds, 0.48, 0}, up);
    waited += !front.is_done();
    for (int round = 0; round < 500 && !front.is_done(); ++round) {
      begun += front.num_growths() > 0;
      front.raise(Pitch::gentle);
      front.follow();
    }
    ASSERT_TRUE(front.is_done());
    EXPECT_EQ(front.counts().nucleations, 1);
    EXPECT_NEAR(front.surface_length(), 2 * growth_length, 1.5 * 0.25 * growth_length);
  }
  EXPECT_GT(waited, 0);
  EXPECT_GT(begun, 0);
}

TEST(Triggers, OutsideTheDomainAreDropped) {
  CrackedFront front(0.5 * growth_length);
  front.trigger({1.5, 0.5, 0}, up);
  EXPECT_TRUE(front.is_done());
  EXPECT_EQ(front.counts().nucleations, 0);
}

}  // namespace
}  // namespace tentpole
