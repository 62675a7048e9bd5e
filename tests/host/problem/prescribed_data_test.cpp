#include "host/problem/prescribed_data.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/host/run/case_text.hpp"
#include "tests/host/run/solved_run.hpp"

// Data blocks are polynomials: those of low degree come back at the corners of the element.
namespace tentpole {
namespace {

/// c_p = 4, c_s = 2, so that no unit of the scaling is one.
const testing::Solid solid{2, 16, 8};
constexpr int degree = 3;

/// A box with absorbing sides. `rest`: further sections, or sides instead of those.
Simulation box(int dimension, const std::string& rest, const std::vector<std::string>& other_sides = {}) {
  testing::CaseText text;
  text.dimension = dimension;
  text.degree = degree;
  text.cells = {2, 2, 2};
  text.max = {3, 3, 3};
  text.solid = solid;
  text.rest = rest;
  const char* const sides[6] = {"left", "right", "bottom", "top", "back", "front"};
  for (int side = 0; side < 2 * dimension; ++side)
    if (std::ranges::find(other_sides, sides[side]) == other_sides.end())
      text.rest += std::string("[boundary.") + sides[side] + "]\nabsorbing = true\n";
  return testing::simulation_of(text.text());
}

/// The first components of a vector, as expressions.
std::string first(int dimension, const std::vector<std::string>& components) {
  return testing::expression_list({components.begin(), components.begin() + dimension});
}

int index_of(const Simulation& simulation, const std::string& boundary) {
  const std::vector<std::string>& names = simulation.mesh.boundary_names;
  return static_cast<int>(std::ranges::find(names, boundary) - names.begin());
}

/// A tent element over the cell (0, 0, 0), (0.5, 0, 0), (0, 0.25, 0), (0, 0, 0.75), with its pole on corner 0. Facet 1
/// is at x = 0.
ElementDescriptor tent(int dimension) {
  ElementDescriptor element{};
  const double edge[3] = {0.5, 0.25, 0.75};
  for (int axis = 0; axis < dimension; ++axis) element.corner[axis + 1][axis] = edge[axis];
  for (int corner = 0; corner <= dimension; ++corner) element.corner[corner][dimension] = 0.125 * corner;
  element.corner[dimension + 1][dimension] = 0.5;
  return element;
}

/// Corner of an element, the coordinates in m and the time in s.
struct Place {
  std::array<double, 3> position{};
  double time = 0;
};

Place corner_place(const Simulation& simulation, const ElementDescriptor& element, int corner) {
  Place place;
  const int dimension = simulation.dimension();
  for (int axis = 0; axis < dimension; ++axis)
    place.position[axis] = element.corner[corner][axis] * simulation.scaling.length;
  place.time = element.corner[corner][dimension] * simulation.scaling.time();
  return place;
}

/// Value at a corner of the reference simplex of the polynomial with these coefficients. `norm`: mean square of its
/// modes over the simplex times the volume.
double value_at(int dimension, int polynomial_degree, const double* coefficients, int corner, double norm) {
  const OrthonormalBasis basis(dimension, polynomial_degree);
  std::vector<double> xi(dimension, 0.0), phi(basis.size());
  if (corner > 0) xi[corner - 1] = 1;
  basis.values(xi, phi);
  double value = 0;
  for (int mode = 0; mode < basis.size(); ++mode) value += coefficients[mode] * phi[mode] * norm;
  return value;
}

/// The modes on a facet have mean square 1; the reference simplex has the volume 1 / D!.
double facet_value(int dimension, int polynomial_degree, const double* coefficients, int corner) {
  return value_at(dimension, polynomial_degree, coefficients, corner, std::sqrt(1 / std::tgamma(dimension + 1)));
}

class DataBlocks : public ::testing::TestWithParam<int> {
 protected:
  int dimension() const { return GetParam(); }
  int num_facet_modes() const { return num_polynomials(dimension(), degree - 1); }
  /// Corner number `corner` of a facet, in the order of its modes.
  static int listed(int facet, int corner) { return corner < facet ? corner : corner + 1; }
};

TEST_P(DataBlocks, OfASideHoldThePolynomialThatIsPrescribedThere) {
  const char* const load[3] = {"1 + 2*y - z*t + 9*t^2", "3*t + y^2", "5 - y*z"};
  const Simulation simulation = box(
      dimension(), "[boundary.left]\ntraction = " + first(dimension(), {load[0], load[1], load[2]}) + "\n", {"left"});
  const ElementDescriptor element = tent(dimension());
  std::vector<double> prescribed(7);  // of others
  PrescribedData data(simulation);
  const std::int32_t offset = data.add_boundary(element, 1, index_of(simulation, "left"), prescribed);
  ASSERT_EQ(offset, 7);
  ASSERT_EQ(static_cast<int>(prescribed.size()), 7 + dimension() * num_facet_modes());
  for (int corner = 0; corner <= dimension(); ++corner) {
    const auto [position, t] = corner_place(simulation, element, listed(1, corner));
    const double y = position[1], z = position[2];
    const double expected[3] = {1 + 2 * y - z * t + 9 * t * t, 3 * t + y * y, 5 - y * z};
    for (int i = 0; i < dimension(); ++i)
      EXPECT_NEAR(facet_value(dimension(), degree - 1, &prescribed[7 + i * num_facet_modes()], corner) *
                      simulation.scaling.stress(),
                  expected[i], 1e-12);
  }
}

TEST_P(DataBlocks, OfTheInitialFrontHoldVelocityStrainAndDisplacement) {
  const Simulation simulation =
      box(dimension(),
          "[initial]\nvelocity = " + first(dimension(), {"1 + x^2", "2 - x", "3 + x*z"}) +
              "\ndisplacement = " + first(dimension(), {"0.1 + 0.5*x + 0.3*y", "0.2*y - 0.7*x", "z + 0.4*y"}) + "\n");
  const int inflow = dimension() + 1, num_modes = num_facet_modes();
  const ElementDescriptor element = tent(dimension());
  std::vector<double> prescribed;
  PrescribedData data(simulation);
  ASSERT_EQ(data.add_initial(element, inflow, prescribed), 0);
  const double strain[4][6] = {{}, {0.5}, {0.5, 0.2, -0.2}, {0.5, 0.2, 1, -0.2, 0.2, 0}};
  const int num_strains = num_symmetric(dimension());
  for (int corner = 0; corner <= dimension(); ++corner) {
    const auto [x, y, z] = corner_place(simulation, element, corner).position;
    const double velocity[3] = {1 + x * x, 2 - x, 3 + x * z};
    const double displacement[3] = {0.1 + 0.5 * x + 0.3 * y, 0.2 * y - 0.7 * x, z + 0.4 * y};
    const double* block = prescribed.data();
    for (int i = 0; i < dimension(); ++i, block += num_modes)
      EXPECT_NEAR(facet_value(dimension(), degree - 1, block, corner) * simulation.scaling.speed, velocity[i], 1e-12);
    for (int s = 0; s < num_strains; ++s, block += num_modes)
      EXPECT_NEAR(facet_value(dimension(), degree - 1, block, corner), strain[dimension()][s], 1e-11);
    for (int i = 0; i < dimension(); ++i, block += dimension() + 1)
      EXPECT_NEAR(facet_value(dimension(), 1, block, corner) * simulation.scaling.length, displacement[i], 1e-12);
    EXPECT_EQ(block, prescribed.data() + prescribed.size());
  }
}

TEST_P(DataBlocks, OfTheBodyForceHoldTheWeightOfTheElementsOwnMaterial) {
  Simulation simulation =
      box(dimension(), "[body_force]\nacceleration = " + first(dimension(), {"1 + x*t", "-9.81", "t^2 - y"}) + "\n");
  const double density = 5;
  testing::give_second_material(simulation, 1.5, {density, solid.lambda, solid.mu});
  ElementDescriptor element = tent(dimension());
  element.material = 1;
  std::vector<double> prescribed;
  ASSERT_EQ(PrescribedData(simulation).add_body_force(element, prescribed), 0);
  for (int corner = 0; corner <= dimension() + 1; ++corner) {
    const auto [position, t] = corner_place(simulation, element, corner);
    const double acceleration[3] = {1 + position[0] * t, -9.81, t * t - position[1]};
    for (int i = 0; i < dimension(); ++i)
      EXPECT_NEAR(value_at(dimension() + 1, degree - 1, &prescribed[i * num_polynomials(dimension() + 1, degree - 1)],
                           corner, 1) *
                      simulation.scaling.force_density(),
                  density * acceleration[i], 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, DataBlocks, ::testing::Values(1, 2, 3));

// A side along (-4, 3), whose outward normal is (3, 4) / 5 or its opposite, after where the third corner lies.
TEST(PrescribedComponents, FollowTheOutwardNormalEachInItsUnit) {
  const Simulation simulation = box(2, "[boundary.left]\nnormal_velocity = 5\ntangential_traction = 10\n", {"left"});
  PrescribedData data(simulation);
  const Scaling& scaling = simulation.scaling;
  for (const double sign : {1.0, -1.0}) {
    ElementDescriptor element{};
    element.corner[1][0] = -0.4;
    element.corner[1][1] = 0.3;
    element.corner[2][0] = -sign;
    element.corner[3][2] = 1;
    std::vector<double> prescribed;
    ASSERT_EQ(data.add_boundary(element, 2, index_of(simulation, "left"), prescribed), 0);
    const double normal[2] = {sign * 0.6, sign * 0.8}, tangent[2] = {-normal[1], normal[0]};
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(prescribed[i * num_polynomials(2, degree - 1)],
                  normal[i] * 5 / scaling.speed + tangent[i] * 10 / scaling.stress(), 1e-13);
  }
}

// s + Z v with Z = 8 along the normal and 4 across it, at x = 0 where the outward normal is -x.
TEST(AbsorbingSide, LetsInTractionPlusImpedanceTimesVelocity) {
  const Simulation simulation =
      box(2, "[boundary.left]\nabsorbing = true\nfar_field_velocity = [2, 3]\nfar_field_traction = [5, 7]\n", {"left"});
  std::vector<double> prescribed;
  const int left = index_of(simulation, "left");
  ASSERT_EQ(PrescribedData(simulation).add_boundary(tent(2), 1, left, prescribed), 0);
  EXPECT_NEAR(prescribed[0] * simulation.scaling.stress(), 5 + 8 * 2, 1e-12);
  EXPECT_NEAR(prescribed[num_polynomials(2, degree - 1)] * simulation.scaling.stress(), 7 + 4 * 3, 1e-12);
}

TEST(DataThatAreZero, NeedNoBlock) {
  for (const int dimension : {1, 2, 3}) {
    const Simulation simulation =
        box(dimension, "[boundary.left]\ntraction = " + first(dimension, {"0", "0", "0"}) + "\n", {"left"});
    std::vector<double> prescribed;
    PrescribedData data(simulation);
    for (const char* side : {"left", "right"})
      EXPECT_EQ(data.add_boundary(tent(dimension), 1, index_of(simulation, side), prescribed), none) << side;
    EXPECT_EQ(data.add_body_force(tent(dimension), prescribed), none);
    EXPECT_TRUE(prescribed.empty());
  }
}

}  // namespace
}  // namespace tentpole
