#include "host/mesh/gmsh_file.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

std::string file(const std::string& name) {
  return std::string(TENTPOLE_TEST_DATA) + "/" + name;
}

TEST(GmshFile, AllFormatsGiveTheSameMesh) {
  const SpaceMesh expected = read_gmsh_file(file("square_22.msh"), 2);
  EXPECT_EQ(expected.num_vertices(), 5);
  EXPECT_EQ(expected.num_cells(), 4);
  EXPECT_EQ(expected.region_names, std::vector<std::string>{"plate"});
  EXPECT_EQ(expected.boundary_names.size(), 4u);
  for (const char* name : {"square_22_binary.msh", "square_41.msh", "square_41_binary.msh"}) {
    const SpaceMesh mesh = read_gmsh_file(file(name), 2);
    EXPECT_EQ(mesh.vertices, expected.vertices) << name;
    EXPECT_EQ(mesh.cells, expected.cells) << name;
    EXPECT_EQ(mesh.neighbor, expected.neighbor) << name;
    for (int cell = 0; cell < mesh.num_cells(); ++cell)
      for (int facet = 0; facet <= 2; ++facet) {
        const std::int32_t own = mesh.facet_boundary[cell][facet], reference = expected.facet_boundary[cell][facet];
        ASSERT_EQ(own == none, reference == none) << name;
        if (own != none) {
          EXPECT_EQ(mesh.boundary_names[own], expected.boundary_names[reference]) << name;
        }
      }
  }
}

TEST(GmshFile, PeriodicSidesMayBeNamed) {
  // One cell between the sides would meet itself: only the message of that check proves the names were understood.
  EXPECT_THROW(read_gmsh_file(file("square_22.msh"), 2, {{"left", "right"}}), MeshError);
}

TEST(GmshFile, ManyFilesCanBeReadInOneProcess) {
  for (int time = 0; time < 5; ++time) EXPECT_EQ(read_gmsh_file(file("square_41.msh"), 2).num_cells(), 4);
}

struct BrokenFile {
  std::string name;
  int dimension;
  PeriodicPairs periodic;
  std::vector<std::string> fragments;  ///< entity, values and remedy that the message must hold
};

class BrokenGmshFile : public ::testing::TestWithParam<BrokenFile> {};

TEST_P(BrokenGmshFile, IsRefusedWithEntityAndRemedy) {
  const BrokenFile& broken = GetParam();
  const std::string path = file("broken/" + broken.name);
  try {
    read_gmsh_file(path, broken.dimension, broken.periodic);
    FAIL() << path << " was accepted";
  } catch (const MeshError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(path, 0), 0u) << message;
    for (const std::string& fragment : broken.fragments)
      EXPECT_NE(message.find(fragment), std::string::npos) << "expected \"" << fragment << "\" in\n" << message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, BrokenGmshFile,
    ::testing::Values(
        BrokenFile{"missing.msh", 2, {}, {"cannot be opened"}},
        BrokenFile{"not_a_mesh.msh", 2, {}, {"line 1", "solid plate", "$MeshFormat"}},
        BrokenFile{"truncated.msh", 2, {}, {"is not readable"}},
        BrokenFile{"unknown_vertex.msh", 2, {}, {"is not readable", "17"}},
        BrokenFile{"no_cells.msh", 2, {}, {"no triangle", "\"dimension\" is 2"}},
        BrokenFile{"no_cells.msh", 3, {}, {"no tetrahedron"}},
        BrokenFile{"quadrilateral.msh", 2, {}, {"element 5", "Quadrilateral 4", "Recombine"}},
        BrokenFile{"second_order.msh", 2, {}, {"element 4", "Triangle 6", "ElementOrder"}},
        BrokenFile{"tetrahedron_in_plane_case.msh", 2, {}, {"element 5", "Tetrahedron 4", "dimension"}},
        BrokenFile{"not_finite.msh", 2, {}, {"vertex 5", "nan", "finite"}},
        BrokenFile{"out_of_plane.msh", 2, {}, {"vertex 5", "(0.5, 0.5, 0.25)", "z = 0"}},
        BrokenFile{"duplicate_vertices.msh", 2, {}, {"vertex 5 and vertex 6", "(0.5, 0.5, 0)", "Coherence"}},
        BrokenFile{"degenerate_cell.msh", 2, {}, {"triangle 9", "degenerate", "measure is 0"}},
        BrokenFile{"inverted_cell.msh", 2, {}, {"triangle 5 and triangle 6", "inverted", "edge (2, 5)"}},
        BrokenFile{"non_manifold_edge.msh", 2, {}, {"edge (1, 5)", "3 cells", "triangle 9"}},
        BrokenFile{"hanging_node.msh", 2, {}, {"vertex 6", "hanging node", "edge (1, 3)"}},
        BrokenFile{"boundary_without_group.msh", 2, {}, {"edge (1, 4)", "no name", "physical group"}},
        BrokenFile{"cell_without_region.msh", 2, {}, {"triangle 8", "no region", "physical group"}},
        BrokenFile{"facet_in_two_groups.msh", 2, {}, {"edge (1, 2)", "bottom and right", "Keep one"}},
        BrokenFile{"cell_in_two_groups.msh", 2, {}, {"element 5", "plate and inclusion", "Keep one"}},
        BrokenFile{"periodic_sides_differ.msh", 2, {{"left", "right"}}, {"no partner on right", "Periodic Curve"}}),
    [](const auto& test) {
      std::string name = test.param.name.substr(0, test.param.name.find('.'));
      return name + "_" + std::to_string(test.index);
    });

}  // namespace
}  // namespace tentpole
