#include "host/march/patch_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/host/march/planned_patch.hpp"
#include "tests/host/march/resting_front.hpp"

// Whether the elements of a patch fill the place between the fronts and know each other, told by their corners alone.
namespace tentpole {
namespace {

using Event = std::array<double, 3>;  // x, y, t; scaled

/// Corners of a facet, in no order.
std::set<Event> facet_corners(const ElementDescriptor& element, int facet) {
  std::set<Event> corners;
  for (int corner = 0; corner < 4; ++corner)
    if (corner != facet)
      corners.insert({element.corner[corner][0], element.corner[corner][1], element.corner[corner][2]});
  return corners;
}

double volume(const ElementDescriptor& element) {
  std::array<Point, SpaceMesh::max_corners> corners{};
  for (int corner = 0; corner < 4; ++corner) std::copy_n(element.corner[corner], 3, corners[corner].begin());
  return std::fabs(signed_simplex_measure(3, corners));
}

/// int tau dA over a cell of a front.
double volume_below(const FrontSimplex& cell) {
  return std::fabs(signed_measure(cell)) * (cell.time[0] + cell.time[1] + cell.time[2]) / 3;
}

class WrittenPatch : public ::testing::Test {
 protected:
  WrittenPatch() : front_(4, 0.05, 0.1) {
    const auto vector = [](double value) { return VectorExpression({Expression(value), Expression(value)}); };
    // left, right, bottom; the top goes on absorbing.
    conditions()[0] = BoundaryCondition::by_vector(BoundaryKind::velocity, vector(2), {});
    conditions()[1] = BoundaryCondition::by_vector(BoundaryKind::traction, vector(3), {});
    conditions()[2] = BoundaryCondition::by_components(2, BoundaryKind::velocity, Expression(5), BoundaryKind::traction,
                                                       VectorExpression({Expression(0.0)}), {});
  }

  std::vector<BoundaryCondition>& conditions() { return front_.simulation.conditions; }
  AdaptiveState& state() { return front_.state; }
  const FrontMesh& mesh() const { return front_.state.front.mesh(); }

  std::int32_t inner_vertex() const { return testing::busiest_vertex(mesh(), VertexKind::interior); }
  PatchPlan tent(std::int32_t vertex, double height = 0.1) { return testing::planned_tent(state(), vertex, height); }

  /// Number of facets of each kind of the last patch, whose elements must agree on those that they share.
  std::map<FacetKind, int> facets_of(const HostBatch& batch) {
    std::map<FacetKind, int> number;
    const PatchDescriptor& patch = batch.patches.back();
    for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e)
      for (int facet = 0; facet < 4; ++facet) {
        const ElementDescriptor& element = batch.elements[e];
        ++number[element.facet_kind[facet]];
        if (!is_shared(element.facet_kind[facet])) continue;
        const ElementDescriptor& other = batch.elements.at(element.neighbor[facet]);
        const int across = element.neighbor_facet[facet];
        EXPECT_EQ(other.neighbor[across], e);
        EXPECT_EQ(other.neighbor_facet[across], facet);
        EXPECT_EQ(other.facet_kind[across], element.facet_kind[facet]);
        EXPECT_EQ(facet_corners(other, across), facet_corners(element, facet));
      }
    return number;
  }
  /// Number of boundary facets on the left, right, bottom and top, which must have the condition of that side.
  std::array<int, 4> facets_on_sides(const HostBatch& batch) {
    const Scaling& scaling = front_.simulation.scaling;
    const double first_component[4] = {2 / scaling.speed, 3 / scaling.stress(), 0, 0}, size = 1 / front_.unit();
    std::array<int, 4> number{};
    for (const ElementDescriptor& element : batch.elements)
      for (int facet = 0; facet < 4; ++facet) {
        if (element.facet_kind[facet] != FacetKind::boundary) continue;
        double x = 0, y = 0;
        for (const Event& corner : facet_corners(element, facet)) x += corner[0] / size / 3, y += corner[1] / size / 3;
        const int side = x < 1e-9 ? 0 : x > 1 - 1e-9 ? 1 : y < 1e-9 ? 2 : 3;
        SCOPED_TRACE(side);
        ++number[side];
        EXPECT_EQ(element.normal_kind[facet], conditions()[side].normal_kind());
        EXPECT_EQ(element.tangential_kind[facet], conditions()[side].tangential_kind());
        const std::int32_t data = element.facet_data[facet];
        EXPECT_EQ(data == none, side == 3);
        EXPECT_NEAR(data == none ? 0 : batch.prescribed[data], first_component[side], 1e-14);
      }
    return number;
  }
  static double volume_of(const HostBatch& batch) {
    const PatchDescriptor& patch = batch.patches.back();
    double sum = 0;
    for (int e = 0; e < patch.num_elements; ++e) sum += volume(batch.elements[patch.first_element + e]);
    return sum;
  }

  testing::RestingFront front_;
};

TEST_F(WrittenPatch, OfATentIsAPyramidOfElementsThatKnowEachOther) {
  PatchWriter writer(state());
  HostBatch batch;
  writer.write(tent(0), batch);  // another patch before
  const PatchPlan plan = tent(inner_vertex(), 0.3);
  writer.write(plan, batch);
  const int num_cells = static_cast<int>(plan.below().size());
  EXPECT_EQ(facets_of(batch), (std::map<FacetKind, int>{{FacetKind::inflow, num_cells},
                                                        {FacetKind::outflow, num_cells},
                                                        {FacetKind::interior, 2 * num_cells}}));
  double area = 0;
  for (const FootprintCell& cell : plan.below()) area += std::fabs(signed_measure(mesh().simplex(cell.cell)));
  EXPECT_NEAR(volume_of(batch), area * 0.3 / 3, 1e-14);
  EXPECT_FALSE(batch.patches.back().is_general);
  std::set<std::int32_t> slots;
  for (const ElementDescriptor& element : batch.elements) EXPECT_TRUE(slots.insert(element.result_slot).second);
}

TEST_F(WrittenPatch, OfADeletionFillsThePlaceBetweenOldAndNewFront) {
  for (const VertexKind kind : {VertexKind::interior, VertexKind::line}) {
    const PatchPlan plan = testing::planned_deletion(state(), testing::busiest_vertex(mesh(), kind));
    PatchWriter writer(state());
    HostBatch batch;
    writer.write(plan, batch);
    double expected = 0;
    for (const NewFrontCell& cell : plan.exchange.above) expected += volume_below(mesh().simplex(cell.vertex));
    for (const FootprintCell& cell : plan.below()) expected -= volume_below(mesh().simplex(cell.cell));
    EXPECT_NEAR(volume_of(batch), expected, 1e-12);
    EXPECT_GT(expected, 1e-3);
    // A cone over a polygon of `above` triangles; at a side one of its facets is on the boundary.
    const int above = static_cast<int>(plan.exchange.above.size()), below = static_cast<int>(plan.below().size());
    ASSERT_GT(above, 1);
    const std::map<FacetKind, int> facets{{FacetKind::inflow, below},
                                          {FacetKind::outflow, above},
                                          {FacetKind::interior, 2 * (above - 1)},
                                          {FacetKind::boundary, kind == VertexKind::line ? 1 : 0}};
    for (const auto& [facet_kind, number] : facets) EXPECT_EQ(facets_of(batch)[facet_kind], number);
    facets_on_sides(batch);
    EXPECT_TRUE(batch.patches.back().is_general);
    for (const ElementDescriptor& element : batch.elements) EXPECT_EQ(element.pole, none);
  }
}

TEST_F(WrittenPatch, StandsOnTheElementsBelowOrOnInitialData) {
  const PatchPlan plan = tent(inner_vertex());
  for (std::size_t i = 1; i < plan.below().size(); ++i) {
    state().sources.slot[plan.below()[i].cell] = static_cast<std::int32_t>(100 + i);
    state().sources.facet[plan.below()[i].cell] = static_cast<std::int32_t>(i % 7);
  }
  PatchWriter writer(state());
  HostBatch batch;
  writer.write(plan, batch);
  for (std::size_t i = 0; i < plan.below().size(); ++i) {
    const ElementDescriptor& element = batch.elements[i];
    EXPECT_EQ(batch.cells[i], plan.below()[i].cell);
    std::set<Event> cell;
    for (const std::int32_t vertex : mesh().vertices(plan.below()[i].cell))
      cell.insert({mesh().position(vertex)[0], mesh().position(vertex)[1], mesh().time(vertex)});
    EXPECT_EQ(facet_corners(element, 3), cell);
    EXPECT_EQ(element.source_slot[3], i == 0 ? none : static_cast<std::int32_t>(100 + i));
    EXPECT_EQ(element.facet_data[3] == none, i > 0);
    EXPECT_EQ(element.source_facet[3], i % 7);
  }
}

TEST_F(WrittenPatch, TakesTheConditionOfTheSideThatItTouches) {
  PatchWriter writer(state());
  HostBatch batch;
  for (int vertex = 0; vertex < mesh().num_vertices(); ++vertex)
    if (mesh().kind(vertex) != VertexKind::interior) writer.write(tent(vertex), batch);
  // Each of the four edges of a side is touched by the tents at both of its ends.
  EXPECT_EQ(facets_on_sides(batch), (std::array<int, 4>{8, 8, 8, 8}));
}

TEST_F(WrittenPatch, HasAFractureFacetAboveEveryCrackEdgeAtItsVertex) {
  const std::int32_t vertex = inner_vertex();
  const std::vector<std::int32_t> neighbors = mesh().neighbors(vertex);
  const std::int32_t ends[2] = {neighbors[0], neighbors[neighbors.size() - 2]};
  for (const std::int32_t end : ends) state().front.mark_crack(vertex, end);
  state().follow_front();
  for (int edge = 0; edge < 2; ++edge) {
    state().crack_state[edge] = uniform_crack_edge(3, 0.25 * (edge + 1));
    state().crack_state[edge].gap = {1, 2, 3};
  }
  PatchWriter writer(state());
  HostBatch batch;
  const std::int32_t rising[3] = {ends[0], vertex, vertex};  // of each fracture facet
  for (const std::int32_t pole : {ends[0], vertex}) writer.write(tent(pole), batch);
  ASSERT_EQ(batch.fractures.size(), 3u);
  EXPECT_EQ(batch.patches[0].num_fractures, 1);
  EXPECT_EQ(batch.patches[1].first_fracture, 1);
  EXPECT_EQ(batch.patches[1].num_fractures, 2);
  EXPECT_EQ(facets_of(batch)[FacetKind::fracture], 4) << "both sides of each";
  for (std::size_t f = 0; f < 3; ++f) {
    const FractureFacet& fracture = batch.fractures[f];
    const std::int32_t edge = batch.crack_edges[f];
    const ElementDescriptor& side = batch.elements[fracture.element[0]];
    EXPECT_EQ(side.neighbor[fracture.facet[0]], fracture.element[1]);
    EXPECT_EQ(side.neighbor_facet[fracture.facet[0]], fracture.facet[1]);
    EXPECT_EQ(side.facet_kind[fracture.facet[0]], FacetKind::fracture);
    for (const std::int32_t end : {vertex, ends[edge]})
      EXPECT_TRUE(
          facet_corners(side, fracture.facet[0]).contains({mesh().position(end)[0], mesh().position(end)[1], 0}));
    EXPECT_EQ(fracture.rising_end, rising[f] == std::max(vertex, ends[edge]) ? 1 : 0);
    EXPECT_EQ(fracture.damage[2], 0.25 * (edge + 1));
    EXPECT_EQ(fracture.gap[1], 2);
    for (const std::int32_t element : fracture.element) EXPECT_EQ(batch.damage[element], 0.25 * (edge + 1));
  }
}

}  // namespace
}  // namespace tentpole
