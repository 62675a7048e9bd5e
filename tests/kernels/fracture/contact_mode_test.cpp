#include "kernels/fracture/contact_mode.hpp"

#include <gtest/gtest.h>

namespace tentpole {
namespace {

constexpr FractureLaw law{300, 400, 2, 10, 0.5, 0.3};
constexpr ContactTolerance tolerance{1e-3, 4};

ContactMode mode(double gap, double normal, double tangential) {
  return contact_state(law, tolerance, gap, normal, tangential).mode;
}

TEST(ContactMode, IsOpenWhereTheSidesAreApartOrPulled) {
  EXPECT_EQ(mode(0.1, -50, 0), ContactMode::open);
  EXPECT_EQ(mode(0, 50, 0), ContactMode::open);
}

TEST(ContactMode, StaysClosedWithinTheTolerances) {
  EXPECT_EQ(mode(5e-4, -50, 0), ContactMode::stick);
  EXPECT_EQ(mode(0, 3, 0), ContactMode::stick);
}

TEST(ContactMode, SlidesBeyondTheFrictionThatPressureAllows) {
  EXPECT_EQ(mode(0, -100, 29), ContactMode::stick);
  EXPECT_EQ(mode(0, -100, 31), ContactMode::slip);
  EXPECT_EQ(contact_state(law, tolerance, 0, -100, -31).direction, -1);
}

TEST(ContactMode, SlidesFreelyWhereNothingPresses) {
  const ContactState state = contact_state(law, tolerance, 0, 2, 10);
  EXPECT_EQ(state.mode, ContactMode::slip);
  EXPECT_EQ(state.direction, 0);
}

TEST(TractionMap, SplitsBetweenTheBondedAndTheDebondedPart) {
  const TractionMap open = traction_map(law, {ContactMode::open, 0}, 0.25, 1);
  EXPECT_DOUBLE_EQ(open.normal, 0.75);
  EXPECT_DOUBLE_EQ(open.tangential, 0.75);
  const TractionMap stick = traction_map(law, {ContactMode::stick, 0}, 0.25, 1);
  EXPECT_DOUBLE_EQ(stick.normal, 1);
  EXPECT_DOUBLE_EQ(stick.tangential, 1);
}

/// Pressure 100 and shear 50: the bonded three quarters carry theirs, the debonded quarter k_f times the pressure,
/// whichever way the normal of the frame points.
TEST(TractionMap, SlidingCarriesTheBondedShareAndFriction) {
  for (const double sign : {1.0, -1.0}) {
    const TractionMap slip = traction_map(law, {ContactMode::slip, 1}, 0.25, sign);
    EXPECT_DOUBLE_EQ(slip.tangential * 50 + slip.friction * sign * -100, 0.75 * 50 + 0.25 * 0.3 * 100);
    EXPECT_DOUBLE_EQ(slip.normal, 1);
  }
}

}  // namespace
}  // namespace tentpole
