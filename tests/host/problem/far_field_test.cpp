#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/host/run/exact_field.hpp"
#include "tests/host/run/solved_run.hpp"

// Absorbing sides let in what their far field sends (docs/formulation.md, Absorbing boundary): the initial state at the
// side, unless the case gives another.
namespace tentpole {
namespace {

using testing::CaseText;
using testing::SolvedRun;
using testing::Table;

const char* const sides[6] = {"left", "right", "bottom", "top", "back", "front"};

/// The first components of a vector, as expressions.
std::string first(int dimension, const std::vector<std::string>& components) {
  return testing::expression_list({components.begin(), components.begin() + dimension});
}

std::string probe(int dimension) {
  return "[[output.probe]]\nname = \"p\"\npoint = " +
         testing::number_list(std::vector<double>(static_cast<std::size_t>(dimension), 0.3)) + "\n";
}

/// A unit box whose sides all absorb.
CaseText absorbing_box(int dimension, int degree) {
  CaseText text;
  text.dimension = dimension;
  text.degree = degree;
  const int cells[4] = {0, 12, 5, 3};
  text.cells.assign(3, cells[dimension]);
  text.end = 1.2;
  text.history_rows = 10;
  for (int side = 0; side < 2 * dimension; ++side)
    text.rest += std::string("[boundary.") + sides[side] + "]\nabsorbing = true\n";
  text.rest += probe(dimension);
  return text;
}

const std::string adaptivity = "[adaptivity]\nenabled = true\nerror_tolerance = 1e-6\nmin_size = 0.02\n";

/// Homogeneous stress of all kinds.
std::string strained(int dimension) {
  return "[initial]\ndisplacement = " + first(dimension, {"0.3*x + 0.4*y", "-y/3 + 0.2*z", "0.1*x"}) + "\n";
}

Table probe_of(const SolvedRun& run) {
  return testing::read_table(run.files.at("probe_p.csv"));
}

/// Largest change of a column since the first row.
double drift(const std::vector<double>& column) {
  double largest = 0;
  for (const double value : column) largest = std::max(largest, std::fabs(value - column[0]));
  return largest;
}

/// `bound`: of velocities, in parts of the wave speed sqrt(3), and of stresses, in parts of the modulus 3.
void expect_rest(const CaseText& text, const std::string& description, double bound) {
  SCOPED_TRACE(description);
  const SolvedRun run = testing::solve(text.text());
  const Table table = probe_of(run);
  double velocity = 0, stress = 0;
  for (const auto& [name, column] : table) {
    if (name[0] == 'v') velocity = std::max(velocity, drift(column));
    if (name[0] == 's') stress = std::max(stress, drift(column));
  }
  const RunSummary::Energy& energy = run.summary.energy;
  std::printf("  %-34s velocity %.1e, stress %.1e, kinetic %.1e, lost %.1e, balance %.1e\n", description.c_str(),
              velocity, stress, energy.kinetic, energy.numerical, energy.balance_error());
  EXPECT_GT(energy.initial, 0.01);
  EXPECT_LE(velocity, std::sqrt(3.0) * bound);
  EXPECT_LE(stress, 3 * bound);
  EXPECT_LE(energy.kinetic, bound * bound);
  EXPECT_LE(energy.numerical, bound * bound);
  EXPECT_NEAR(energy.strain, energy.initial, bound);
  EXPECT_LE(std::fabs(energy.balance_error()), 1e-12 * energy.initial);
}

TEST(FarField, PrestressedBodyStaysAtRest) {
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (int degree = 1; degree <= 3; ++degree) {
      if (dimension == 3 && degree == 3) continue;  // takes seconds
      CaseText text = absorbing_box(dimension, degree);
      text.rest += strained(dimension);
      const std::string name = "D = " + std::to_string(dimension) + ", k = " + std::to_string(degree);
      expect_rest(text, name, 1e-12);
      if (dimension == 3 || (dimension == 2 && degree != 2)) continue;
      text.rest += adaptivity;
      expect_rest(text, name + ", adaptive", 1e-12);
    }
}

TEST(FarField, PrestressedBodyBetweenPeriodicSidesStaysAtRest) {
  for (int dimension = 2; dimension <= 3; ++dimension) {
    CaseText text = absorbing_box(dimension, 2);
    const std::string absorbing = "absorbing = true\n";
    for (int side = 0; side < 2 * (dimension - 1); side += 2) {
      const std::string first_header = std::string("[boundary.") + sides[side] + "]\n",
                        second = std::string("[boundary.") + sides[side + 1] + "]\n" + absorbing;
      text.rest.erase(text.rest.find(second), second.size());
      text.rest.replace(text.rest.find(first_header + absorbing), (first_header + absorbing).size(),
                        first_header + "periodic = \"" + sides[side + 1] + "\"\n");
    }
    const std::string last = dimension == 2 ? "y" : "z";
    text.rest += "[initial]\ndisplacement = " + first(dimension, {"0.4*" + last, "0.3*" + last, "-0.2*" + last}) + "\n";
    expect_rest(text, "D = " + std::to_string(dimension) + ", periodic", 1e-12);
  }
}

TEST(FarField, PrestressedBodyOfTwoMaterialsStaysAtRest) {
  // sigma_xx = 1 on both sides of x = 1/2; the solid of the case has lambda + 2 mu = 3, the other one 1.5
  CaseText text = absorbing_box(1, 2);
  text.rest += "[initial]\ndisplacement = [\"x < 0.5 ? x/3 : 1/6 + (x - 0.5)/1.5\"]\n";
  Simulation simulation = testing::simulation_of(text.text());
  testing::give_second_material(simulation, 0.5, {2, 0.5, 0.5});
  const Table table = probe_of(testing::solve(simulation));
  EXPECT_LE(drift(table.at("vx")), 1e-12);
  EXPECT_LE(drift(table.at("sxx")), 1e-12);
}

TEST(FarField, WeightThatTheStressCarriesStaysAtRest) {
  // rho b = -2 along y, carried by sigma_yy = 2 y, so E_yy = 2 y / 3, between walls without friction
  CaseText text = absorbing_box(2, 2);
  for (const char* side : {"left", "right"}) {
    const std::string header = std::string("[boundary.") + side + "]\n";
    const std::size_t at = text.rest.find(header + "absorbing = true");
    text.rest.replace(at, (header + "absorbing = true").size(),
                      header + "normal_velocity = \"0\"\ntangential_traction = \"0\"");
  }
  text.rest += "[initial]\ndisplacement = [\"0\", \"y^2/3\"]\n[body_force]\nacceleration = [\"0\", \"-2\"]\n";
  expect_rest(text, "weight", 1e-11);
}

TEST(FarField, BodyInUniformMotionGoesOn) {
  CaseText text = absorbing_box(2, 2);
  text.rest += "[initial]\nvelocity = [\"0.5\", \"-0.25\"]\n";
  const Table table = probe_of(testing::solve(text.text()));
  EXPECT_LE(drift(table.at("vx")), 1e-12);
  EXPECT_NEAR(table.at("ux").back(), 0.5 * 1.2, 1e-12);
  EXPECT_NEAR(table.at("uy").back(), -0.25 * 1.2, 1e-12);
}

TEST(FarField, NothingOutsideOfTheBodyIsLookedAt) {
  CaseText text = absorbing_box(1, 2);
  text.rest += "[initial]\ndisplacement = [\"x >= 0 && x <= 1 ? 0.3*x : 1/0\"]\n";
  const Table table = probe_of(testing::solve(text.text()));
  EXPECT_LE(drift(table.at("sxx")), 1e-12);
}

/// A bar that is pulled at its left end by a pulse, which leaves at the right one.
CaseText pulled_bar(int dimension) {
  CaseText text;
  text.dimension = dimension;
  text.degree = 3;
  text.cells = {10, 2};
  text.max = {1, 0.2};
  text.end = 1.4;
  text.rest = "[boundary.right]\nabsorbing = true\n[boundary.left]\nvelocity = " +
              first(dimension, {"t < 0.5 ? sin(2*pi*t)^4 : 0", "0"}) + "\n";
  for (int side = 2; side < 2 * dimension; ++side)
    text.rest += std::string("[boundary.") + sides[side] + "]\nnormal_velocity = \"0\"\ntangential_traction = \"0\"\n";
  text.rest += "[[output.probe]]\nname = \"p\"\npoint = " +
               testing::number_list(dimension == 1 ? std::vector{0.7} : std::vector{0.7, 0.1}) + "\n";
  return text;
}

TEST(FarField, WaveLeavesAPrestressedBodyAsItLeavesAnother) {
  for (int dimension = 1; dimension <= 2; ++dimension) {
    SCOPED_TRACE(dimension);
    CaseText text = pulled_bar(dimension);
    const SolvedRun plain = testing::solve(text.text());
    text.rest += "[initial]\ndisplacement = " + first(dimension, {"0.25*x", "0"}) + "\n";
    const SolvedRun strained = testing::solve(text.text());
    const Table without = probe_of(plain), with = probe_of(strained);
    double largest = 0, difference = 0;
    for (std::size_t row = 0; row < without.at("time").size(); ++row) {
      largest = std::max(largest, std::fabs(without.at("vx")[row]));
      difference = std::max(difference, std::fabs(with.at("vx")[row] - without.at("vx")[row]));
      difference = std::max(difference, std::fabs(with.at("sxx")[row] - without.at("sxx")[row] - 0.75));
    }
    std::printf("  D = %d: largest velocity %.3f, difference with prestress %.1e\n", dimension, largest, difference);
    EXPECT_GT(largest, 0.5);
    EXPECT_LE(difference, 1e-11);
    for (const SolvedRun* run : {&plain, &strained}) {
      const RunSummary::Energy& energy = run->summary.energy;
      EXPECT_LE(std::fabs(energy.balance_error()), 1e-12 * (energy.initial + energy.external_work + 1));
      EXPECT_LE(energy.kinetic, 1e-4);  // the pulse has left
    }
  }
}

TEST(FarField, GivenOneSendsItsWaveIn) {
  // rho = 1, lambda + 2 mu = 3: a wave to the left with velocity f has the stress sqrt(3) f
  CaseText text = absorbing_box(1, 4);
  text.cells = {20};
  const std::size_t right = text.rest.find("[boundary.right]\nabsorbing = true\n");
  text.rest.insert(right + 17 + 17,
                   "far_field_velocity = [\"sin(5*t)^3\"]\nfar_field_traction = [\"sqrt(3)*sin(5*t)^3\"]\n");
  const SolvedRun run = testing::solve(text.text());
  const Table table = probe_of(run);
  for (std::size_t row = 0; row < table.at("time").size(); ++row) {
    const double arrived = table.at("time")[row] - 0.7 / std::sqrt(3.0);
    const double expected = arrived > 0 ? std::pow(std::sin(5 * arrived), 3) : 0;
    EXPECT_NEAR(table.at("vx")[row], expected, 1e-3) << "t = " << table.at("time")[row];
    EXPECT_NEAR(table.at("sxx")[row], std::sqrt(3.0) * expected, 2e-3) << "t = " << table.at("time")[row];
  }
  const RunSummary::Energy& energy = run.summary.energy;
  EXPECT_GT(energy.external_work, 0.1);
  EXPECT_LE(std::fabs(energy.balance_error()), 1e-12 * energy.external_work);
}

TEST(FarField, InitialStateThatIsZeroAtTheSidesChangesNoByte) {
  for (int dimension = 1; dimension <= 2; ++dimension) {
    CaseText text = absorbing_box(dimension, 2);
    const std::string lump = "(x > 0.3 && x < 0.7 ? sin(pi*(x - 0.3)/0.4)^4 : 0)";
    const std::string inside = dimension == 1 ? "" : "*(y > 0.3 && y < 0.7 ? sin(pi*(y - 0.3)/0.4)^4 : 0)";
    text.rest += "[initial]\ndisplacement = " + first(dimension, {lump + inside, "0"}) + "\n";
    const SolvedRun unsaid = testing::solve(text.text());
    for (int side = 0; side < 2 * dimension; ++side) {
      const std::string header = std::string("[boundary.") + sides[side] + "]\nabsorbing = true\n";
      text.rest.insert(text.rest.find(header) + header.size(),
                       "far_field_traction = " + first(dimension, {"0", "0"}) + "\n");
    }
    EXPECT_EQ(unsaid.files, testing::solve(text.text()).files);
  }
}

}  // namespace
}  // namespace tentpole
