#include <algorithm>
#include <cstdio>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/host/run/polynomial_field.hpp"
#include "tests/host/run/solved_run.hpp"

// Polynomials of the degree of the solution are solutions of the discrete equations: with their body force, initial and
// boundary data they come back up to rounding on any mesh (docs/formulation.md).
namespace tentpole {
namespace {

using testing::CaseText;
using testing::Polynomial;
using testing::SideKind;
using testing::Solid;

constexpr double tolerance = 1e-11;  // relative L2 error of the displacement over space and time
const Solid solid{1.3, 0.9, 0.8};

std::vector<Polynomial> random_displacement(int dimension, const std::vector<int>& variables, int degree) {
  std::mt19937 engine(17 * dimension + degree);
  std::vector<Polynomial> displacement;
  for (int i = 0; i < dimension; ++i) displacement.push_back(Polynomial::random(variables, degree, engine));
  return displacement;
}

std::vector<int> all_variables(int dimension) {
  std::vector<int> variables{3};
  for (int axis = 0; axis < dimension; ++axis) variables.push_back(axis);
  return variables;
}

CaseText small_case(int dimension, int degree) {
  CaseText text;
  text.dimension = dimension;
  text.degree = degree;
  const int cells[4] = {0, 5, 3, 2};
  text.cells.assign(3, cells[dimension]);
  if (dimension == 3 && degree > 2) text.cells = {2, 1, 1};  // expressions of many terms take most of the time
  text.end = dimension == 3 ? 0.1 : 0.3;
  text.solid = solid;
  return text;
}

/// Largest error over the devices.
double largest_error(const CaseText& text) {
  double largest = 0;
  for (const Device& device : testing::test_devices()) {
    const RunSummary summary = testing::solve(text.text(), device).summary;
    largest = std::max(largest, summary.errors.value().displacement_l2_relative);
    EXPECT_GT(summary.counts.patches, 10) << device.name;
  }
  return largest;
}

void expect_reproduced(int dimension, int degree, const std::vector<SideKind>& kinds, const char* description) {
  CaseText text = small_case(dimension, degree);
  text.rest =
      field_sections(polynomial_field(random_displacement(dimension, all_variables(dimension), degree), solid), kinds);
  const double error = largest_error(text);
  std::printf("  D = %d, k = %d, %s: %.1e\n", dimension, degree, description, error);
  EXPECT_LE(error, tolerance) << "D = " << dimension << ", k = " << degree << ", " << description;
}

void expect_reproduced_with_each_kind(int dimension, int degree) {
  const std::pair<SideKind, const char*> kinds[] = {{SideKind::velocity, "velocity"},
                                                    {SideKind::traction, "traction"},
                                                    {SideKind::roller, "roller"},
                                                    {SideKind::slider, "slider"}};
  for (const auto& [kind, description] : kinds)
    expect_reproduced(dimension, degree, std::vector<SideKind>(2 * dimension, kind), description);
}

void expect_reproduced_with_mixed_sides(int dimension, int degree) {
  expect_reproduced(dimension, degree,
                    {SideKind::velocity, SideKind::traction, SideKind::roller, SideKind::slider, SideKind::traction,
                     SideKind::velocity},
                    "mixed sides");
}

TEST(PatchTest, EachBoundaryKindKeepsPolynomialsInOneDimension) {
  for (const int degree : {1, 2, 3, 4}) expect_reproduced_with_each_kind(1, degree);
}

TEST(PatchTest, EachBoundaryKindKeepsPolynomialsInTwoDimensions) {
  for (const int degree : {1, 2, 3}) expect_reproduced_with_each_kind(2, degree);
}

TEST(PatchTest, EachBoundaryKindKeepsPolynomialsInThreeDimensions) {
  for (const int degree : {1, 2}) expect_reproduced_with_each_kind(3, degree);
}

TEST(PatchTest, EveryDegreeIsExactInOneDimension) {
  for (int degree = 1; degree <= 7; ++degree) expect_reproduced_with_mixed_sides(1, degree);
}

TEST(PatchTest, EveryDegreeIsExactInTwoDimensions) {
  for (int degree = 1; degree <= 5; ++degree) expect_reproduced_with_mixed_sides(2, degree);
}

TEST(PatchTest, EveryDegreeIsExactInThreeDimensions) {
  for (int degree = 1; degree <= 4; ++degree) expect_reproduced_with_mixed_sides(3, degree);
}

TEST(PatchTest, PeriodicSidesKeepPolynomialsThatDoNotVaryAcross) {
  for (const auto& [dimension, degree] : {std::tuple(1, 3), std::tuple(2, 2), std::tuple(2, 3), std::tuple(3, 2)}) {
    CaseText text = small_case(dimension, degree);
    std::vector<SideKind> kinds(6, SideKind::periodic);
    std::vector<int> variables{3};
    if (dimension > 1) {
      kinds[0] = SideKind::velocity;
      kinds[1] = SideKind::traction;
      variables.push_back(0);
    }
    text.cells = {dimension == 1 ? 5 : 2, 3, 3};
    text.rest = field_sections(polynomial_field(random_displacement(dimension, variables, degree), solid), kinds);
    const double error = largest_error(text);
    std::printf("  D = %d, k = %d, periodic: %.1e\n", dimension, degree, error);
    EXPECT_LE(error, tolerance) << "D = " << dimension << ", k = " << degree;
  }
}

/// A polynomial of x - c t, of the degree given.
Polynomial travelling(double speed, int degree, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  const Polynomial phase = Polynomial::monomial({1, 0, 0, 0}, 1) + Polynomial::monomial({0, 0, 0, 1}, -speed);
  Polynomial power = Polynomial::monomial({}, 1), result;
  for (int n = 0; n <= degree; ++n, power = power * phase) result = result + normal(engine) * power;
  return result;
}

// The far field of an absorbing side is at rest, so the solution must leave through it at a right angle: P and S waves
// in x.
TEST(PatchTest, AbsorbingSidesAreExactForWavesThatLeaveAtARightAngle) {
  for (const auto& [dimension, degree] :
       {std::tuple(1, 2), std::tuple(1, 4), std::tuple(2, 2), std::tuple(2, 3), std::tuple(3, 2)}) {
    std::mt19937 engine(degree);
    std::vector<Polynomial> displacement{travelling(solid.dilatational_speed(), degree, engine)};
    for (int i = 1; i < dimension; ++i) displacement.push_back(travelling(solid.shear_speed(), degree, engine));
    CaseText text = small_case(dimension, degree);
    text.rest = field_sections(polynomial_field(displacement, solid),
                               {SideKind::velocity, SideKind::absorbing, SideKind::traction, SideKind::velocity,
                                SideKind::velocity, SideKind::traction});
    const double error = largest_error(text);
    std::printf("  D = %d, k = %d, absorbing: %.1e\n", dimension, degree, error);
    EXPECT_LE(error, tolerance) << "D = " << dimension << ", k = " << degree;
  }
}

TEST(PatchTest, PolynomialsAreKeptInTheUnitsOfABarOfOneMillimetre) {
  const Solid ceramic{3690, 77.75e9, 107.4e9};
  const double length = 1e-3, time = length / ceramic.dilatational_speed();
  for (const int degree : {2, 3}) {
    std::vector<Polynomial> displacement;
    for (const Polynomial& polynomial : random_displacement(2, all_variables(2), degree))
      displacement.push_back(1e-6 * polynomial.in_units({length, length, length, time}));
    CaseText text = small_case(2, degree);
    text.max.assign(3, length);
    text.end = 0.3 * time;
    text.solid = ceramic;
    text.rest = field_sections(polynomial_field(displacement, ceramic),
                               {SideKind::velocity, SideKind::traction, SideKind::roller, SideKind::slider});
    const double error = largest_error(text);
    std::printf("  D = 2, k = %d, SI: %.1e\n", degree, error);
    EXPECT_LE(error, tolerance) << "k = " << degree;
  }
}

}  // namespace
}  // namespace tentpole
