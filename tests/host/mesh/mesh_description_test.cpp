#include "host/mesh/mesh_description.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

/// The unit square with vertex 4 in its centre, one side all round.
MeshDescription square() {
  MeshDescription mesh;
  mesh.source = "square";
  mesh.dimension = 2;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  mesh.cells = {{0, 1, 4, none}, {2, 1, 4, none}, {2, 3, 4, none}, {3, 4, 0, none}};
  mesh.cell_region = {0, 0, 1, 0};
  mesh.named_facets = {{{0, 1, none}, 1}, {{1, 2, none}, 1}, {{2, 3, none}, 1}, {{3, 0, none}, 1}};
  mesh.region_names = {"matrix", "grain"};
  mesh.boundary_names = {"nowhere", "side"};
  return mesh;
}

TEST(BuildSpaceMesh, KeepsRegionsAndNamesAndForgetsBoundariesWithoutFacets) {
  const SpaceMesh mesh = build_space_mesh(square());
  EXPECT_EQ(mesh.cell_region, (std::vector<std::int32_t>{0, 0, 1, 0}));
  EXPECT_EQ(mesh.boundary_names, std::vector<std::string>{"side"});
  EXPECT_EQ(mesh.cells[3], (CellVertices{0, 3, 4, none}));
  EXPECT_EQ(mesh.facet_boundary[3], (CellVertices{none, none, 0, none}));
  EXPECT_EQ(mesh.neighbor[3], (CellVertices{2, 0, none, none}));
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(BuildSpaceMesh, DropsUnusedVerticesWithAWarning) {
  MeshDescription description = square();
  description.vertices.insert(description.vertices.begin() + 1, {7, 7, 0});
  for (auto& cell : description.cells)
    for (auto& vertex : cell) vertex += vertex >= 1;
  for (auto& facet : description.named_facets)
    for (auto& vertex : facet.vertices) vertex += vertex >= 1;
  const SpaceMesh mesh = build_space_mesh(description);
  EXPECT_EQ(mesh.cells, build_space_mesh(square()).cells);
  EXPECT_EQ(mesh.vertices, build_space_mesh(square()).vertices);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].find("vertex 1"), std::string::npos);
}

TEST(BuildSpaceMesh, WarnsOfNamedFacetsInside) {
  MeshDescription description = square();
  description.named_facets.push_back({{1, 4, none}, 0});
  const SpaceMesh mesh = build_space_mesh(description);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].find("edge (1, 4) of nowhere"), std::string::npos);
}

TEST(BuildSpaceMesh, KeepsNamedFacetsInsideByName) {
  MeshDescription description = square();
  description.boundary_names = {"joint", "side", "seam"};
  description.named_facets.push_back({{4, 1, none}, 0});
  description.named_facets.push_back({{1, 4, none}, 0});  // once more
  description.named_facets.push_back({{4, 0, none}, 0});
  description.named_facets.push_back({{1, 4, none}, 2});
  const SpaceMesh mesh = build_space_mesh(description);
  ASSERT_EQ(mesh.inner_sides.size(), 2u);
  EXPECT_EQ(mesh.inner_sides[0].name, "joint");
  EXPECT_EQ(mesh.inner_sides[0].facets, (std::vector<FacetVertices>{{0, 4, none}, {1, 4, none}}));
  EXPECT_EQ(mesh.inner_sides[1].name, "seam");
  EXPECT_EQ(mesh.inner_sides[1].facets, (std::vector<FacetVertices>{{1, 4, none}}));
  EXPECT_EQ(mesh.boundary_names, std::vector<std::string>{"side"});
}

/// The square with a crack of these facets, all else used.
MeshDescription cracked_square(const std::vector<FacetVertices>& facets) {
  MeshDescription description = square();
  for (const FacetVertices& facet : facets) description.named_facets.push_back({facet, 0});
  description.boundary_names[0] = "crack";
  description.use = NameUse{{"matrix", "grain"}, {"side"}, {"crack"}};
  return description;
}

std::string refusal(const MeshDescription& description) {
  try {
    build_space_mesh(description);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BuildSpaceMesh, WarnsOfNoCrack) {
  const SpaceMesh mesh = build_space_mesh(cracked_square({{1, 4, none}}));
  EXPECT_TRUE(mesh.warnings.empty()) << mesh.warnings[0];
  EXPECT_EQ(mesh.inner_sides[0].facets, (std::vector<FacetVertices>{{1, 4, none}}));
}

TEST(BuildSpaceMesh, RefusesACrackOnTheBoundary) {
  for (const auto& facets : {std::vector<FacetVertices>{{0, 1, none}}, {{1, 4, none}, {1, 0, none}}}) {
    const std::string message = refusal(cracked_square(facets));
    EXPECT_NE(
        message.find("square, edge (0, 1): belongs to the crack crack, but lies on the boundary of the body, where "
                     "there is nothing to separate from. Name a side inside the body in [[fracture.crack]], "
                     "or give points."),
        std::string::npos)
        << message;
  }
}

TEST(BuildSpaceMesh, RefusesACrackThatTheMeshIsNotFittedTo) {
  const std::string across = refusal(cracked_square({{1, 4, none}, {0, 2, none}}));
  EXPECT_NE(across.find("square, edge (0, 2): belongs to the crack crack, but to no cell. Fit the mesh"),
            std::string::npos)
      << across;
  MeshDescription description = cracked_square({{1, 4, none}, {4, 5, none}});
  description.vertices.push_back({0.7, 0.6, 0});
  const std::string beside = refusal(description);
  EXPECT_NE(
      beside.find("square, edge (4, 5): belongs to the crack crack, but to no cell, because vertex 5 belongs to none"),
      std::string::npos)
      << beside;
}

TEST(BuildSpaceMesh, RefusesLengthsWhoseCubesAreNoNumbers) {
  for (const double length : {1e200, -1e308, 1e-200}) {
    MeshDescription description = square();
    for (Point& vertex : description.vertices)
      for (double& coordinate : vertex) coordinate *= length;
    const std::string message = refusal(description);
    EXPECT_NE(message.find(std::abs(length) > 1 ? "Coordinates must be finite, and at most 1e100 m."
                                                : "is too small: its longest edge is "),
              std::string::npos)
        << message;
  }
}

/// The square cut open from vertex 0 to 4 and on to 1, where it stays whole: vertices 5 and 6 lie where 0 and 4 do.
MeshDescription open_square() {
  MeshDescription description = square();
  description.vertices.push_back({0, 0, 0});
  description.vertices.push_back({0.5, 0.5, 0});
  description.cells = {{0, 1, 4, none}, {2, 1, 4, none}, {2, 3, 6, none}, {3, 6, 5, none}};
  description.cells[1][2] = 6;
  description.named_facets = {{{0, 1, none}, 1}, {{1, 2, none}, 1}, {{2, 3, none}, 1}, {{3, 5, none}, 1}};
  description.named_facets.push_back({{4, 0, none}, 0});
  description.named_facets.push_back({{1, 4, none}, 0});
  description.boundary_names = {"cut", "side"};
  return description;
}

TEST(DoubledSide, IsMergedWhereItIsACrack) {
  MeshDescription description = open_square();
  description.use = NameUse{{"matrix", "grain"}, {"side"}, {"cut"}};
  const SpaceMesh mesh = build_space_mesh(description), whole = build_space_mesh(square());
  EXPECT_EQ(mesh.vertices, whole.vertices);
  EXPECT_EQ(mesh.cells, whole.cells);
  EXPECT_EQ(mesh.neighbor, whole.neighbor);
  ASSERT_EQ(mesh.inner_sides.size(), 1u);
  EXPECT_EQ(mesh.inner_sides[0].facets, (std::vector<FacetVertices>{{0, 4, none}, {1, 4, none}}));
  EXPECT_TRUE(mesh.warnings.empty()) << mesh.warnings[0];
}

TEST(DoubledSide, IsOfferedAsACrackElsewhere) {
  MeshDescription description = open_square();
  description.boundary_names[0] = "the cut";
  const std::string message = refusal(description);
  EXPECT_NE(message.find("square, vertex 0 and vertex 5: both lie at (0, 0, 0). The side the cut is doubled there, as "
                         "Gmsh's plugin Crack does: make it a crack ([[fracture.crack]] with side = \"the cut\"), or "
                         "merge duplicate vertices (in Gmsh: Coherence Mesh)."),
            std::string::npos)
      << message;
}

TEST(DoubledSide, OtherVerticesAtOnePlaceStayAFault) {
  MeshDescription description = open_square();
  description.named_facets.resize(4);
  EXPECT_NE(refusal(description).find("both lie at (0, 0, 0). Merge duplicate vertices"), std::string::npos);
  description.named_facets.push_back({{2, 1, none}, 0});
  description.use = NameUse{{"matrix", "grain"}, {"side"}, {"cut"}};
  EXPECT_NE(refusal(description).find("both lie at (0, 0, 0). Merge duplicate vertices"), std::string::npos);
}

TEST(DoubledSide, OfABarIsAVertex) {
  MeshDescription bar;
  bar.source = "bar";
  bar.dimension = 1;
  bar.vertices = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {1, 0, 0}};
  bar.cells = {{0, 3, none, none}, {1, 2, none, none}};
  bar.cell_region = {0, 0};
  bar.region_names = {"all"};
  bar.boundary_names = {"end", "joint"};
  bar.named_facets = {{{0, none, none}, 0}, {{2, none, none}, 0}, {{3, none, none}, 1}};
  EXPECT_NE(refusal(bar).find("The side joint is doubled there"), std::string::npos);
  bar.use = NameUse{{}, {"end"}, {"joint"}};
  const SpaceMesh mesh = build_space_mesh(bar);
  EXPECT_EQ(mesh.num_vertices(), 3);
  EXPECT_EQ(mesh.neighbor[0], (CellVertices{1, none, none, none}));
  EXPECT_EQ(mesh.inner_sides[0].facets, (std::vector<FacetVertices>{{1, none, none}}));
}

TEST(BuildSpaceMesh, FindsAHangingNodeOnATetrahedronsFacet) {
  // Two tetrahedra below a triangle that is split by vertex 4 on its edge, one tetrahedron above that is not.
  MeshDescription mesh;
  mesh.source = "stack";
  mesh.dimension = 3;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}, {0.5, 0.5, 0}, {0.2, 0.2, -1}};
  mesh.cells = {{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 4, 2, 5}};
  mesh.cell_region = {0, 0, 0};
  mesh.region_names = {"all"};
  try {
    build_space_mesh(mesh);
    FAIL() << "no exception";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("stack, vertex 4: is a hanging node"), std::string::npos) << error.what();
  }
}

TEST(BuildSpaceMesh, JoinsPeriodicSidesThatAreNotAlignedWithAnAxis) {
  // A sheared strip: the right side is the left one moved by (3, 1).
  MeshDescription mesh;
  mesh.source = "strip";
  mesh.dimension = 2;
  for (int column = 0; column <= 3; ++column)
    for (int row = 0; row <= 1; ++row) mesh.vertices.push_back({1.0 * column, row + column / 3.0, 0});
  for (int column = 0; column < 3; ++column) {
    const int a = 2 * column, b = a + 1, c = a + 2, d = a + 3;
    mesh.cells.push_back({a, c, d, none});
    mesh.cells.push_back({a, d, b, none});
    mesh.named_facets.push_back({{a, c, none}, 2});
    mesh.named_facets.push_back({{b, d, none}, 2});
  }
  mesh.named_facets.push_back({{0, 1, none}, 0});
  mesh.named_facets.push_back({{6, 7, none}, 1});
  mesh.cell_region.assign(6, 0);
  mesh.region_names = {"all"};
  mesh.boundary_names = {"inlet", "outlet", "wall"};
  const SpaceMesh joined = build_space_mesh(mesh, {{"inlet", "outlet"}});
  EXPECT_EQ(joined.num_vertices(), 6);
  EXPECT_EQ(joined.boundary_names, std::vector<std::string>{"wall"});
  ASSERT_EQ(joined.shifts.size(), 2u);
  EXPECT_DOUBLE_EQ(joined.shifts[1][0], 3);
  EXPECT_DOUBLE_EQ(joined.shifts[1][1], 1);
  for (int vertex = 0; vertex < 6; ++vertex) EXPECT_EQ(joined.star(vertex).size(), 3u);
  double measure = 0;
  for (int cell = 0; cell < 6; ++cell) measure += joined.cell_measure(cell);
  EXPECT_DOUBLE_EQ(measure, 3);
}

}  // namespace
}  // namespace tentpole
