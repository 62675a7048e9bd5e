#include "host/march/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/element/quadrature.hpp"
#include "tests/host/march/planned_patch.hpp"
#include "tests/host/march/resting_front.hpp"

// Cutting cells changes no function: neither the solution below the front nor the damage on its edges.
namespace tentpole {
namespace {

using Event = std::array<double, 3>;  // x, y, t; scaled

/// A quadratic displacement, which elements of degree 2 hold exactly.
std::array<double, 2> displacement(const Event& event) {
  const auto [x, y, t] = event;
  return {1 + 2 * x - y + 0.5 * x * y + t * x, 3 * y - x * x + 2 * t};
}

/// Corners of an element below a cell of a flat front: the vertices of the cell in the order of the facet's code
/// (docs/formulation.md, General elements), and one place for all.
struct ElementBelow {
  std::array<Event, 4> corner;
  std::array<int, 3> listed;  ///< [vertex of the cell]: corner of the element
  int apex;
};

ElementBelow element_below(const FrontMesh& mesh, std::int32_t cell, int code) {
  ElementBelow element{{}, {}, code < 4 ? code : code - 4};
  for (int vertex = 0, corner = 0; vertex < 3; ++vertex, ++corner) {
    if (code < 4 && corner == element.apex) ++corner;
    element.listed[vertex] = code >= 4 && vertex == element.apex ? 3 : corner;
    const Point& position = mesh.position(mesh.vertices(cell)[vertex]);
    element.corner[element.listed[vertex]] = {position[0], position[1], 0};
  }
  element.corner[element.apex] = {1, 1.5, -1};
  return element;
}

/// The event with these reference coordinates.
Event event_at(const ElementBelow& element, const double* xi) {
  Event event = element.corner[0];
  for (int axis = 0; axis < 3; ++axis)
    for (int l = 0; l < 3; ++l) event[axis] += xi[l] * (element.corner[l + 1][axis] - element.corner[0][axis]);
  return event;
}

/// L2 projection of the displacement.
std::vector<double> project(const ElementBelow& element) {
  const OrthonormalBasis basis(3, 2);
  const Quadrature rule = simplex_quadrature(3, 4);
  std::vector<double> coefficients(2 * basis.size()), phi(basis.size());
  for (int point = 0; point < rule.num_points(); ++point) {
    const double* xi = &rule.points[3 * point];
    basis.values({xi, 3}, phi);
    const std::array<double, 2> u = displacement(event_at(element, xi));
    for (int i = 0; i < 2; ++i)
      for (int a = 0; a < basis.size(); ++a) coefficients[i * basis.size() + a] += rule.weights[point] * u[i] * phi[a];
  }
  return coefficients;
}

class RefinedFront : public ::testing::Test {
 protected:
  RefinedFront() : front_(3, 0.1, 0.1) {}

  AdaptiveState& state() { return front_.state; }
  const FrontMesh& mesh() const { return front_.state.front.mesh(); }

  FootprintCell cell(std::int32_t number) const { return {number, mesh().cell(number).serial}; }
  Footprint cells() const {
    Footprint all;
    for (int number = 0; number < mesh().num_cell_slots(); ++number)
      if (mesh().is_alive_cell(number)) all.push_back(cell(number));
    return all;
  }

  /// Gives every cell an element below, each code of a facet in turn.
  void solve_below() {
    for (const FootprintCell& below : cells()) {
      const std::int32_t slot = state().books.store.acquire();
      const int code = below.cell % 7;
      state().sources.slot[below.cell] = slot;
      state().sources.facet[below.cell] = code;
      state().books.runner.write_slots({&slot, 1}, project(element_below(mesh(), below.cell, code)),
                                       std::vector<double>(9, 0.0));
    }
  }

  void expect_displacement_below(std::int32_t cell) {
    const ElementBelow element = element_below(mesh(), cell, state().sources.facet[cell]);
    std::vector<double> found, inverse_jacobian;
    state().books.runner.read_slots({&state().sources.slot[cell], 1}, found, inverse_jacobian);
    const std::vector<double> expected = project(element);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << "cell " << cell;
  }

  testing::RestingFront front_;
};

// Closures cut cells again before anything is transplanted.
TEST_F(RefinedFront, HasTheSameSolutionBelowTheParts) {
  solve_below();
  const int num_cells = mesh().num_cells();
  Refinement refinement(state());
  EXPECT_NE(refinement.split_edge(mesh().vertices(0)[0], mesh().vertices(0)[1], 0.25), none);
  for (int sweep = 0; sweep < 3; ++sweep)
    for (const FootprintCell& wanted : cells()) EXPECT_TRUE(wanted.cell % 3 > 0 || refinement.split(wanted));
  refinement.flush();
  EXPECT_GT(mesh().num_cells(), 3 * num_cells);
  EXPECT_EQ(state().counts.splits, mesh().num_cells() - num_cells) << "each adds one cell";
  for (const FootprintCell& below : cells()) expect_displacement_below(below.cell);
}

TEST_F(RefinedFront, HoldsOneElementPerCellAndFreesTheOthers) {
  solve_below();
  Refinement refinement(state());
  for (const FootprintCell& wanted : cells()) refinement.split(wanted);
  refinement.flush();
  std::set<std::int32_t> held;
  for (const FootprintCell& below : cells()) held.insert(state().sources.slot[below.cell]);
  EXPECT_EQ(static_cast<int>(held.size()), mesh().num_cells());
  ElementStore& store = state().books.store;
  const std::int32_t num_slots = store.num_slots();
  for (int free = mesh().num_cells(); free < num_slots; ++free)
    EXPECT_TRUE(held.insert(store.acquire()).second) << "a slot below a cell is given out";
  EXPECT_EQ(store.num_slots(), num_slots) << "a slot is lost";
}

TEST_F(RefinedFront, TakesTheInitialDataWhereItsCellsDid) {
  Refinement refinement(state());
  for (const FootprintCell& wanted : cells()) refinement.split(wanted);
  refinement.flush();
  EXPECT_EQ(state().books.store.num_slots(), 0);
  for (const FootprintCell& below : cells()) EXPECT_EQ(state().sources.slot[below.cell], none);
}

// Gauss points of three on the unit interval.
TEST_F(RefinedFront, KeepsTheDamageAlongACutEdge) {
  const double gauss[3] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
  const std::int32_t vertex = testing::busiest_vertex(mesh(), VertexKind::interior);
  const std::int32_t other = mesh().neighbors(vertex).back();
  const std::int32_t edge = state().front.mark_crack(vertex, other);
  state().follow_front();
  const Point from = mesh().position(std::min(vertex, other)), to = mesh().position(std::max(vertex, other));
  // Linear along the edge, from its lower to its higher vertex.
  const auto damage = [](double s) { return 0.2 + 0.7 * s; };
  for (int point = 0; point < 3; ++point) state().crack_state[edge].damage[point] = damage(gauss[point]);
  state().crack_mode[edge] = CrackMode::slip;
  Refinement refinement(state());
  const std::int32_t middle = refinement.split_edge(vertex, other, 0.25);
  refinement.flush();
  ASSERT_NE(middle, none);
  EXPECT_NEAR(distance(mesh().position(middle), mesh().position(vertex)), 0.25 * distance(from, to), 1e-12);
  for (const std::int32_t end : {vertex, other}) {
    const std::int32_t half = state().front.crack_edge(end, middle);
    ASSERT_NE(half, none);
    EXPECT_EQ(state().crack_mode[half], CrackMode::slip);
    const auto [low, high] = state().front.cracks().edge(half);
    const double low_place = distance(mesh().position(low), from) / distance(from, to);
    const double high_place = distance(mesh().position(high), from) / distance(from, to);
    for (int point = 0; point < 3; ++point)
      EXPECT_NEAR(state().crack_state[half].damage[point], damage(low_place + gauss[point] * (high_place - low_place)),
                  1e-12);
  }
}

TEST_F(RefinedFront, StillHasExactlyTheCellsWhoseSplitIsRefused) {
  for (int round = 0; round < 8; ++round)
    for (const std::int32_t vertex : state().front.local_minima(1e9))
      state().front.raise(vertex, state().front.pole_top_time(vertex, 1e9, Pitch::full));
  Refinement refinement(state());
  int refused = 0;
  for (const FootprintCell& wanted : cells()) {
    const bool is_done = refinement.split(wanted);
    EXPECT_EQ(is_done, !state().front.is_unchanged({wanted}));
    EXPECT_EQ(refinement.split(wanted), is_done) << "a cell that is gone needs no split";
    refused += !is_done;
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(state().counts.splits, 0);
  state().front.check();
}

TEST_F(RefinedFront, HasSmallCellsWhereACrackAsksForThem) {
  const std::int32_t vertex = state().front.local_minima(1e9).front();
  const auto first_cell = [&] { return mesh().star(vertex).front().cell; };
  ASSERT_GT(longest_edge(mesh().simplex(first_cell())), 2 * state().limits.crack_size);
  Refinement refinement(state());
  const std::optional<std::int32_t> found = refinement.refine_for_crack(first_cell);
  refinement.flush();
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(*found, first_cell());
  EXPECT_LE(longest_edge(mesh().simplex(*found)), 1.0001 * state().limits.crack_size);
  EXPECT_EQ(refinement.refine_for_crack([] { return none; }), none);
}

}  // namespace
}  // namespace tentpole
