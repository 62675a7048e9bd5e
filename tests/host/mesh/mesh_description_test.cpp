#include "host/mesh/mesh_description.hpp"

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
