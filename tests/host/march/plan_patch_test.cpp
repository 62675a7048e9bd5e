#include "host/march/plan_patch.hpp"

#include <gtest/gtest.h>

#include "tests/host/march/resting_front.hpp"

// How high the poles of planned tents are.
namespace tentpole {
namespace {

constexpr double end_time = 1e9;

class PoleHeight : public ::testing::Test {
 protected:
  PoleHeight() : front_(6, 1, 0.1) {
    const auto minima = front_.state.front.local_minima(end_time);
    for (const std::int32_t vertex : minima)
      if (front_.state.front.mesh().kind(vertex) == VertexKind::interior) vertex_ = vertex;
  }

  double height() const { return plan_patch(front_.state, vertex_).top.time - front_.state.front.time(vertex_); }
  double limit(Pitch pitch) const {
    const double end = front_.simulation.scaled_end_time();
    return front_.state.front.pole_top_time(vertex_, end, pitch) - front_.state.front.time(vertex_);
  }
  /// Puts an edge of a crack at the vertex, whose last patch was still; nothing is deleted.
  void crack_still_vertex() {
    front_.state.limits.max_size = 0;
    memory().dissipation_ratio = 0;
    front_.state.front.mark_crack(vertex_, front_.state.front.mesh().neighbors(vertex_).front());
    front_.state.follow_front();
  }

  VertexMemory& memory() { return front_.state.memory[vertex_]; }

  testing::RestingFront front_;
  std::int32_t vertex_ = none;
};

TEST_F(PoleHeight, IsGentleUntilTheDissipationIsKnown) {
  EXPECT_LT(limit(Pitch::gentle), limit(Pitch::full));
  EXPECT_EQ(height(), limit(Pitch::gentle));
}

TEST_F(PoleHeight, IsFullWhereThePatchBeforeWasStill) {
  const double coarsening = front_.simulation.settings.adaptivity.coarsening;
  front_.state.limits.max_size = 0;  // nothing is deleted
  memory().dissipation_ratio = static_cast<float>(0.9 * coarsening);
  EXPECT_EQ(height(), limit(Pitch::gentle));
  memory().dissipation_ratio = 0;
  EXPECT_EQ(height(), limit(Pitch::full));
}

TEST_F(PoleHeight, IsGentleAndCappedAtACrackWhoseDamageGrows) {
  crack_still_vertex();
  EXPECT_EQ(height(), limit(Pitch::gentle));
  front_.state.limits.max_pole_height = 0.25 * limit(Pitch::gentle);
  EXPECT_DOUBLE_EQ(height(), 0.25 * limit(Pitch::gentle));
  memory().halvings = 2;
  EXPECT_DOUBLE_EQ(height(), 0.0625 * limit(Pitch::gentle)) << "a halving must make a difference";
}

TEST_F(PoleHeight, IsFullAtACrackAtRest) {
  crack_still_vertex();
  front_.state.crack_state[0].effective_traction = 0;
  EXPECT_EQ(height(), limit(Pitch::full));
}

TEST_F(PoleHeight, ThatIsLostInTheRoundingOfTheTimeIsAFaultWithAPlace) {
  crack_still_vertex();
  front_.state.limits.max_pole_height = 0;
  try {
    plan_patch(front_.state, vertex_);
    FAIL() << "a tent without height";
  } catch (const std::runtime_error& error) {
    for (const char* part : {"tent at (", " m, t = ", "rounding", "fracture.relaxation_time"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tentpole
