#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/host/run/exact_field.hpp"
#include "tests/host/run/solved_run.hpp"

// Every patch satisfies E_out - E_in + dissipation = external work with dissipation >= 0 (docs/formulation.md): without
// loads the energy on the front never grows, whatever the boundary and the materials.
namespace tentpole {
namespace {

using testing::CaseText;
using testing::ExactField;
using testing::SideKind;

constexpr double rounding = 1e-12;  // of the energy balance of one patch, relative to the largest energy of a cell

/// A medium with slower waves than Solid's default.
const Material soft_and_heavy{2.0, 1.0, 0.7};

ExactField rest(int dimension) {
  const std::vector<std::string> zero(dimension, "0");
  return {dimension, zero, zero, std::vector<std::vector<std::string>>(dimension, zero), {}};
}

/// Everything at rest on the boundary, a pulse in the middle.
CaseText pulse_case(int dimension, int degree, const std::vector<SideKind>& kinds) {
  CaseText text;
  text.dimension = dimension;
  text.degree = degree;
  const int cells[4] = {0, 12, 4, 3};
  text.cells.assign(3, cells[dimension]);
  text.end = dimension == 3 ? 0.3 : 0.6;
  std::string sections = field_sections(rest(dimension), kinds);
  // The pulse reaches the sides, and a far field in its initial state would feed it.
  const std::string absorbing = "absorbing = true\n", zero = "far_field_traction = ";
  for (std::size_t at = 0; (at = sections.find(absorbing, at)) != std::string::npos;)
    sections.insert(at += absorbing.size(), zero + testing::expression_list(rest(dimension).displacement) + "\n");
  const std::vector<std::string> displacement{"exp(-30*((x-0.45)^2+(y-0.45)^2*Y+(z-0.5)^2*Z))", "0.4*sin(3*x)*y",
                                              "0.2*cos(2*x+z)"};
  const std::vector<std::string> velocity{"2*cos(5*x)", "sin(4*y)", "x*y"};
  text.rest = sections.substr(0, sections.find("[initial]")) + "[constants]\nY = " + std::to_string(dimension > 1) +
              "\nZ = " + std::to_string(dimension > 2) + "\n[initial]\ndisplacement = " +
              testing::expression_list({displacement.begin(), displacement.begin() + dimension}) +
              "\nvelocity = " + testing::expression_list({velocity.begin(), velocity.begin() + dimension}) + "\n";
  return text;
}

RunSummary::Energy energy_of(const CaseText& text, bool two_materials) {
  Simulation simulation = testing::simulation_of(text.text());
  if (two_materials) testing::give_second_material(simulation, 0.5, soft_and_heavy);
  return testing::solve(simulation).summary.energy;
}

void expect_energy_falls(const CaseText& text, bool two_materials, const std::string& description) {
  SCOPED_TRACE(description);
  const RunSummary::Energy energy = energy_of(text, two_materials);
  std::printf("  %-32s initial %.4f, at the end %.4f, largest increase %8.1e, imbalance %.1e, balance error %8.1e\n",
              description.c_str(), energy.initial, energy.kinetic + energy.strain, energy.largest_patch_increase,
              energy.largest_patch_imbalance, energy.balance_error() / energy.initial);
  EXPECT_GT(energy.initial, 0.1);
  EXPECT_LE(energy.external_work, rounding * energy.initial);  // absorbing sides take energy away
  EXPECT_LE(energy.largest_patch_increase, rounding);
  EXPECT_LE(energy.largest_patch_imbalance, rounding);
  EXPECT_LE(std::fabs(energy.balance_error()), 1e-10 * energy.initial);
  EXPECT_LT(energy.kinetic + energy.strain, energy.initial);
}

void expect_energy_falls_with_each_kind(int dimension, int degree) {
  const std::pair<SideKind, const char*> kinds[] = {
      {SideKind::velocity, "clamped"}, {SideKind::traction, "free"},       {SideKind::roller, "roller"},
      {SideKind::slider, "slider"},    {SideKind::absorbing, "absorbing"}, {SideKind::periodic, "periodic"}};
  for (const auto& [kind, name] : kinds)
    for (const bool two_materials : {false, true})
      expect_energy_falls(pulse_case(dimension, degree, std::vector<SideKind>(6, kind)), two_materials,
                          "D = " + std::to_string(dimension) + ", k = " + std::to_string(degree) + ", " + name +
                              (two_materials ? ", two materials" : ""));
}

TEST(Energy, NeverGrowsWithoutLoadInOneDimension) {
  for (const int degree : {1, 3}) expect_energy_falls_with_each_kind(1, degree);
}

TEST(Energy, NeverGrowsWithoutLoadInTwoDimensions) {
  for (const int degree : {1, 2}) expect_energy_falls_with_each_kind(2, degree);
}

TEST(Energy, NeverGrowsWithoutLoadInThreeDimensions) {
  expect_energy_falls_with_each_kind(3, 2);
}

/// A body force, tractions on the lower sides and velocities on the upper sides, both rising from zero; at rest before.
CaseText loaded_case(int dimension) {
  CaseText text = pulse_case(dimension, 2, std::vector<SideKind>(6, SideKind::velocity));
  const auto first = [&](const std::vector<std::string>& all) {
    return testing::expression_list({all.begin(), all.begin() + dimension}) + "\n";
  };
  const std::string loads[2] = {
      "traction = " + first({"sin(3*t)", "1+x", "0.3"}) + "ramp = 0.2\n",
      "velocity = " + first({"0.5", "x", "cos(t)"}) + "ramp = 0.3\nramp_order = \"quintic\"\n"};
  const char* const sides[6] = {"left", "right", "bottom", "top", "back", "front"};
  text.rest = "[body_force]\nacceleration = " + first({"1+t", "-9.81", "x*t"});
  for (int side = 0; side < 2 * dimension; ++side)
    text.rest += std::string("[boundary.") + sides[side] + "]\n" + loads[side % 2];
  return text;
}

TEST(Energy, BalancesTheWorkOfLoadsThatRise) {
  for (const int dimension : {1, 2, 3})
    for (const bool two_materials : {false, true}) {
      const RunSummary::Energy energy = energy_of(loaded_case(dimension), two_materials);
      std::printf("  D = %d, loads: work %.4f, at the end %.4f, lost %.4f, imbalance %.1e, balance error %8.1e\n",
                  dimension, energy.external_work, energy.kinetic + energy.strain, energy.numerical,
                  energy.largest_patch_imbalance, energy.balance_error() / energy.external_work);
      EXPECT_EQ(energy.initial, 0);
      EXPECT_GT(energy.external_work, 0.01);
      EXPECT_GT(energy.numerical, 0);
      EXPECT_LE(energy.largest_patch_imbalance, rounding);
      EXPECT_LE(std::fabs(energy.balance_error()), 1e-10 * energy.external_work);
    }
}

// u = 0, v = sin(pi x): int 1/2 rho v^2 = rho / 4, and half a period later the same energy is strain.
TEST(Energy, OfAStandingWaveIsKnown) {
  CaseText text;
  text.degree = 4;
  text.cells = {12};
  text.solid = {1, 0, 0.5};
  text.end = 0.5;
  text.rest =
      "[boundary.left]\nvelocity = [\"0\"]\n[boundary.right]\nvelocity = [\"0\"]\n[initial]\nvelocity = "
      "[\"sin(pi*x)\"]\n";
  const RunSummary::Energy energy = testing::solve(text.text()).summary.energy;
  EXPECT_NEAR(energy.initial, 0.25, 1e-9);
  EXPECT_NEAR(energy.strain, 0.25, 1e-7);
  EXPECT_NEAR(energy.kinetic, 0, 1e-9);
  EXPECT_GE(energy.numerical, 0);
}

}  // namespace
}  // namespace tentpole
