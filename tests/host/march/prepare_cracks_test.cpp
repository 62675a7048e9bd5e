#include "host/march/prepare_cracks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "common/binary_stream.hpp"
#include "host/case_file/input_error.hpp"
#include "host/march/adaptive_march.hpp"
#include "host/mesh/simplex_geometry.hpp"
#include "tests/host/march/march_books.hpp"
#include "tests/host/run/case_text.hpp"
#include "tests/host/run/solved_run.hpp"

// The front that a run with prepared cracks starts from.
namespace tentpole {
namespace {

using Polyline = std::vector<Point>;

/// Part of the longest edge of a cell within which points are snapped.
constexpr double snap = 0.05;

Simulation cracked_box(int dimension, bool structured, const std::vector<Polyline>& lines, double damage = 1) {
  testing::CaseText text;
  text.dimension = dimension;
  text.cells = {8, 4};
  text.max = {1, 0.5};
  text.structured = structured;
  const char* const sides[] = {"left", "right", "bottom", "top"};
  for (int side = 0; side < 2 * dimension; ++side)
    text.rest += std::string("[boundary.") + sides[side] + "]\nabsorbing = true\n";
  text.rest += "[fracture]\nenabled = true\nthreshold = 1\nstrength = 2\nrelaxation_time = 1\n";
  Simulation simulation = testing::simulation_of(text.text());
  // Here, so that the reader of the case file does not refuse them first.
  for (const Polyline& line : lines)
    simulation.settings.fracture.cracks.push_back({line, damage, "", {"bar.toml", 7, 0, "fracture.crack", ""}});
  return simulation;
}

/// The front of a march and the state of its cracks before the first patch.
struct PreparedFront {
  AdaptiveFront front;
  std::vector<CrackEdgeState> state;
};

PreparedFront prepare(const Simulation& simulation) {
  testing::MarchBooks books(simulation);
  const AdaptiveMarch march(books.get(), books.folder());
  CheckpointContents contents;
  march.save(contents);
  std::istringstream stream(contents.march, std::ios::binary);
  const std::vector<double> speed{simulation.scaled_materials[0].dilatational_speed()};
  PreparedFront prepared{AdaptiveFront(simulation.mesh, speed, {.causality = simulation.settings.front.causality}), {}};
  prepared.front.load(stream);
  prepared.state = read_vector<CrackEdgeState>(stream);
  return prepared;
}

/// Marked edges in m; a box has the units of its case.
struct MarkedEdges {
  double length = 0;
  std::map<std::int32_t, int> edges_at;  ///< [vertex]
  std::vector<Point> position;           ///< of the marked vertices
};

MarkedEdges marked_edges(const PreparedFront& prepared, double unit) {
  MarkedEdges marked;
  const auto place = [&](std::int32_t vertex) {
    Point position = prepared.front.mesh().position(vertex);
    for (double& coordinate : position) coordinate *= unit;
    return position;
  };
  for (int edge = 0; edge < prepared.front.cracks().size(); ++edge) {
    if (prepared.front.cracks().is_retired(edge)) continue;
    const auto& ends = prepared.front.cracks().edge(edge);
    marked.length += distance(place(ends[0]), place(ends[1]));
    for (const std::int32_t vertex : ends) ++marked.edges_at[vertex];
  }
  for (const auto& [vertex, count] : marked.edges_at) marked.position.push_back(place(vertex));
  return marked;
}

double distance_to_segment(const Point& point, const Point& first, const Point& last) {
  const Point way = difference(last, first), to_point = difference(point, first);
  const double share = std::clamp(dot(way, to_point) / dot(way, way), 0.0, 1.0);
  return distance(point, {first[0] + share * way[0], first[1] + share * way[1], 0});
}

double distance_to_line(const Point& point, const Polyline& line) {
  double least = INFINITY;
  for (std::size_t corner = 1; corner < line.size(); ++corner)
    least = std::min(least, distance_to_segment(point, line[corner - 1], line[corner]));
  return least;
}

double length_of(const Polyline& line) {
  double length = 0;
  for (std::size_t corner = 1; corner < line.size(); ++corner) length += distance(line[corner - 1], line[corner]);
  return length;
}

class FittedLine : public ::testing::TestWithParam<std::tuple<bool, int>> {
 protected:
  static Polyline line() {
    const Polyline lines[] = {{{0.5, 0, 0}, {0.5, 0.5, 0}},
                              {{0.31, 0, 0}, {0.77, 0.5, 0}},
                              {{0.22, 0.13, 0}, {0.81, 0.37, 0}},
                              {{0.1, 0.4, 0}, {0.33, 0.11, 0}, {0.57, 0.13, 0}, {0.93, 0.44, 0}},
                              {{0, 0.21, 0}, {1, 0.23, 0}}};
    return lines[std::get<1>(GetParam())];
  }
};

TEST_P(FittedLine, RunAlongEdgesFromEndToEnd) {
  const Simulation simulation = cracked_box(2, std::get<0>(GetParam()), {line()}, 0.75);
  const PreparedFront prepared = prepare(simulation);
  prepared.front.check();
  const MarkedEdges marked = marked_edges(prepared, simulation.scaling.length);
  // The longest edge of the mesh; fitting only cuts.
  double longest = 0;
  for (int cell = 0; cell < simulation.mesh.num_cells(); ++cell)
    for (int corner = 0; corner < 3; ++corner)
      longest = std::max(longest,
                         simulation.scaling.length * distance(simulation.mesh.corner_position(cell, corner),
                                                              simulation.mesh.corner_position(cell, (corner + 1) % 3)));
  const double tolerance = snap * longest * 1.0001;
  EXPECT_NEAR(marked.length, length_of(line()), 2 * tolerance);
  for (const Point& corner : line()) {
    double nearest = INFINITY;
    for (const Point& vertex : marked.position) nearest = std::min(nearest, distance(vertex, corner));
    EXPECT_LE(nearest, tolerance) << "the corner (" << corner[0] << ", " << corner[1] << ") is not reached";
  }
  for (const Point& vertex : marked.position) EXPECT_LE(distance_to_line(vertex, line()), tolerance);
  int ends = 0;
  for (const auto& [vertex, count] : marked.edges_at) {
    EXPECT_LE(count, 2) << "a branch";
    ends += count == 1;
  }
  EXPECT_EQ(ends, 2) << "one chain of edges";
  for (int edge = 0; edge < prepared.front.cracks().size(); ++edge)
    if (!prepared.front.cracks().is_retired(edge)) {
      EXPECT_EQ(smallest_damage(prepared.state[edge]), 0.75);
      EXPECT_EQ(largest_damage(prepared.state[edge]), 0.75);
    }
}

INSTANTIATE_TEST_SUITE_P(, FittedLine, ::testing::Combine(::testing::Bool(), ::testing::Range(0, 5)),
                         [](const auto& variant) {
                           return std::string(std::get<0>(variant.param) ? "Structured" : "Unstructured") +
                                  std::to_string(std::get<1>(variant.param));
                         });

TEST(FittedLines, MayCross) {
  const Simulation simulation = cracked_box(2, false, {{{0.2, 0.1, 0}, {0.8, 0.4, 0}}, {{0.2, 0.4, 0}, {0.8, 0.1, 0}}});
  const PreparedFront prepared = prepare(simulation);
  prepared.front.check();
  const MarkedEdges marked = marked_edges(prepared, simulation.scaling.length);
  EXPECT_NEAR(marked.length, 2 * std::hypot(0.6, 0.3), 0.04);
  int crossings = 0, ends = 0;
  for (const auto& [vertex, count] : marked.edges_at) {
    crossings += count == 4;
    ends += count == 1;
  }
  EXPECT_EQ(crossings, 1);
  EXPECT_EQ(ends, 4);
}

TEST(FittedPoint, IsAVertex) {
  for (const double x : {0.5, 0.37, 0.13}) {
    const Simulation simulation = cracked_box(1, true, {{{x, 0, 0}}});
    const PreparedFront prepared = prepare(simulation);
    prepared.front.check();
    const MarkedEdges marked = marked_edges(prepared, simulation.scaling.length);
    ASSERT_EQ(marked.position.size(), 1u);
    EXPECT_NEAR(marked.position[0][0], x, snap / 8);
  }
}

/// A case with a mesh of tests/host/mesh and a crack on its side "notch", from (0.5, 1) to (1.5, 1).
Simulation notched_square(const std::string& mesh, const std::string& more) {
  return testing::simulation_of("[domain]\ndimension = 2\nmesh = \"" TENTPOLE_TEST_DATA "/../mesh/" + mesh +
                                "\"\n[material.all]\ndensity = 1\nyoungs_modulus = 1\npoisson_ratio = 0\n"
                                "[boundary.outer]\nabsorbing = true\n[time]\nend = 1\n[discretization]\ndegree = 2\n"
                                "[fracture]\nenabled = true\nthreshold = 1\nstrength = 2\nrelaxation_time = 1\n"
                                "[[fracture.crack]]\nside = \"notch\"\ndamage = 0.75\n" +
                                more);
}

TEST(CrackOnASide, ConsistsOfItsEdges) {
  for (const char* mesh : {"crack_inside.msh", "crack_doubled.msh"}) {
    const Simulation simulation = notched_square(mesh, "");
    const PreparedFront prepared = prepare(simulation);
    prepared.front.check();
    const MarkedEdges marked = marked_edges(prepared, simulation.scaling.length);
    EXPECT_EQ(prepared.front.mesh().num_cells(), simulation.mesh.num_cells()) << "nothing is cut";
    EXPECT_EQ(prepared.front.cracks().size(), 4);
    EXPECT_NEAR(marked.length, 1, 1e-12);
    for (const Point& vertex : marked.position) EXPECT_LE(distance_to_line(vertex, {{0.5, 1, 0}, {1.5, 1, 0}}), 1e-9);
    for (const CrackEdgeState& state : prepared.state) EXPECT_EQ(smallest_damage(state), 0.75);
  }
}

TEST(CrackOnASide, StaysMarkedWhereALineCrossesIt) {
  const Simulation simulation =
      notched_square("crack_inside.msh", "[[fracture.crack]]\npoints = [[0.8, 0.5], [0.9, 1.4]]\ndamage = 0.25\n");
  const PreparedFront prepared = prepare(simulation);
  prepared.front.check();
  const MarkedEdges marked = marked_edges(prepared, simulation.scaling.length);
  EXPECT_NEAR(marked.length, 1 + std::hypot(0.1, 0.9), 0.1);
  double on_the_side = 0;
  for (int edge = 0; edge < prepared.front.cracks().size(); ++edge)
    if (!prepared.front.cracks().is_retired(edge) && std::fabs(smallest_damage(prepared.state[edge]) - 0.75) < 1e-12) {
      const auto& ends = prepared.front.cracks().edge(edge);
      on_the_side += distance(prepared.front.mesh().position(ends[0]), prepared.front.mesh().position(ends[1])) *
                     simulation.scaling.length;
    }
  EXPECT_NEAR(on_the_side, 1, 1e-12);
}

TEST(CrackOnASide, OfABarIsAVertex) {
  Simulation simulation = cracked_box(1, true, {});
  simulation.mesh.inner_sides = {{"joint", {{3, none, none}}}};
  CrackSettings crack;
  crack.side = "joint";
  crack.damage = 1;
  simulation.settings.fracture.cracks = {crack};
  const PreparedFront prepared = prepare(simulation);
  const MarkedEdges marked = marked_edges(prepared, simulation.scaling.length);
  ASSERT_EQ(marked.position.size(), 1u);
  EXPECT_NEAR(marked.position[0][0], 0.375, 1e-12);
}

std::string refusal(const Simulation& simulation) {
  try {
    prepare(simulation);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FittedLines, OutsideTheDomainAreRefusedByNumberAndPoint) {
  const Polyline good{{0.2, 0.1, 0}, {0.8, 0.4, 0}};
  const std::string message = refusal(cracked_box(2, false, {good, {{0.5, 0.25, 0}, {1.25, 0.25, 0}}}));
  EXPECT_NE(message.find("crack 2 at (1.25, 0.25) m lies outside the domain"), std::string::npos) << message;
  EXPECT_NE(message.find("fracture.crack"), std::string::npos) << message;
  const std::string point = refusal(cracked_box(1, true, {{{-0.5, 0, 0}}}));
  EXPECT_NE(point.find("crack 1 at (-0.5, 0) m lies outside the domain"), std::string::npos) << point;
}

TEST(FittedLines, OnTheBoundaryAreRefusedByNumberAndPoint) {
  // Near enough to be snapped to the bottom.
  const std::string message = refusal(cracked_box(2, true, {{{0.25, 0.001, 0}, {0.75, 0.001, 0}}}));
  EXPECT_NE(message.find("crack 1 at (0.25, 0) m runs along the boundary"), std::string::npos) << message;
  const std::string point = refusal(cracked_box(1, true, {{{0.001, 0, 0}}}));
  EXPECT_NE(point.find("crack 1 at (0, 0) m lies on the boundary"), std::string::npos) << point;
}

}  // namespace
}  // namespace tentpole
