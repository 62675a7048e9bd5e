#include "host/mesh/gmsh_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/test_folder.hpp"

namespace tentpole {
namespace {

std::string file(const std::string& name) {
  return std::string(TENTPOLE_TEST_DATA) + "/" + name;
}

/// Positions of the corners of a cell or facet, and its name.
using NamedPlace = std::pair<std::set<Point>, std::string>;

/// A mesh whatever the order of its cells and vertices.
struct AnyOrder {
  std::multiset<NamedPlace> cells, sides;

  explicit AnyOrder(const SpaceMesh& mesh) {
    for (int cell = 0; cell < mesh.num_cells(); ++cell) {
      std::set<Point> corners;
      for (int corner = 0; corner <= mesh.dimension; ++corner) corners.insert(mesh.corner_position(cell, corner));
      cells.emplace(corners, mesh.region_names[mesh.cell_region[cell]]);
      for (int facet = 0; facet <= mesh.dimension; ++facet) {
        if (mesh.facet_boundary[cell][facet] == none) continue;
        std::set<Point> ends = corners;
        ends.erase(mesh.corner_position(cell, facet));
        sides.emplace(ends, mesh.boundary_names[mesh.facet_boundary[cell][facet]]);
      }
    }
  }
};

// The later ones were written by Gmsh 4.15 for the same square: with parametric nodes, in two partitions with ghost
// cells and their topology, and with periodic sides.
TEST(GmshFile, AllFormatsGiveTheSameMesh) {
  const AnyOrder expected(read_gmsh_file(file("square_22.msh"), 2));
  EXPECT_EQ(expected.cells.size(), 4u);
  EXPECT_EQ(expected.sides.size(), 4u);
  EXPECT_TRUE(expected.sides.contains({{{0, 0, 0}, {1, 0, 0}}, "bottom"}));
  for (const char* name :
       {"square_22_binary.msh", "square_41.msh", "square_41_binary.msh", "square_entities_on_several_lines.msh",
        "square_parametric_22.msh", "square_parametric_22_binary.msh", "square_parametric_41.msh",
        "square_partitioned_22.msh", "square_partitioned_41.msh", "square_partitioned_41_binary.msh",
        "square_periodic_22_binary.msh", "square_periodic_41.msh"}) {
    const SpaceMesh mesh = read_gmsh_file(file(name), 2);
    EXPECT_EQ(AnyOrder(mesh).cells, expected.cells) << name;
    EXPECT_EQ(AnyOrder(mesh).sides, expected.sides) << name;
    EXPECT_EQ(mesh.num_vertices(), 5) << name;
    EXPECT_TRUE(mesh.warnings.empty()) << name << ": " << mesh.warnings[0];
  }
}

TEST(GmshFile, RegionsOfVersion2AreThoseOfTheElementsWhateverTheirEntity) {
  const SpaceMesh mesh = read_gmsh_file(file("two_regions_on_one_entity.msh"), 2);
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"plate", "inclusion"}));
  EXPECT_EQ(mesh.cell_region, (std::vector<std::int32_t>{0, 0, 0, 1}));
}

// The square with two more groups: "everything" holds its cells, "rim" its sides. Version 2.2 lists each of them twice.
const char* const overlapping[] = {"square_groups_22.msh", "square_groups_22_binary.msh", "square_groups_41.msh"};

TEST(GmshFile, OfOverlappingGroupsTheUsedOneCounts) {
  const AnyOrder expected(read_gmsh_file(file("square_22.msh"), 2));
  for (const char* name : overlapping) {
    const SpaceMesh fine =
        read_gmsh_file(file(name), 2, {}, NameUse{{"plate"}, {"left", "right", "bottom", "top"}, {}});
    EXPECT_EQ(AnyOrder(fine).cells, expected.cells) << name;
    EXPECT_EQ(AnyOrder(fine).sides, expected.sides) << name;
    EXPECT_EQ(fine.region_names, std::vector<std::string>{"plate"}) << name;
    const SpaceMesh coarse = read_gmsh_file(file(name), 2, {}, NameUse{{"everything"}, {"rim"}, {}});
    EXPECT_EQ(coarse.num_cells(), 4) << name;
    EXPECT_EQ(coarse.region_names, std::vector<std::string>{"everything"}) << name;
    EXPECT_EQ(coarse.boundary_names, std::vector<std::string>{"rim"}) << name;
  }
}

TEST(GmshFile, OfOverlappingGroupsThatAreNotUsedTheFirstCounts) {
  const AnyOrder expected(read_gmsh_file(file("square_22.msh"), 2));
  for (const char* name : overlapping)
    EXPECT_EQ(AnyOrder(read_gmsh_file(file(name), 2, {}, NameUse{})).cells, expected.cells) << name;
}

TEST(GmshFile, TwoUsedGroupsOfOnePlaceAreRefusedWithBothTables) {
  const auto refusal = [](const char* name, const NameUse& use) -> std::string {
    try {
      read_gmsh_file(file(name), 2, {}, use);
    } catch (const MeshError& error) {
      return error.what();
    }
    return "accepted";
  };
  for (const char* name : overlapping) {
    const std::string cells = refusal(name, {{"plate", "everything"}, {"rim"}, {}});
    EXPECT_NE(cells.find("belongs to two physical groups, plate and everything, and both have a material. Keep one of "
                         "[material.plate] and [material.everything], or make the groups disjoint."),
              std::string::npos)
        << cells;
    EXPECT_NE(cells.find(", triangle "), std::string::npos) << cells;
    const std::string sides = refusal(name, {{"plate"}, {"rim", "left", "right", "bottom", "top"}, {}});
    EXPECT_NE(
        sides.find("edge (1, 2): belongs to two boundaries, bottom and rim, and both have a condition. Keep one of "
                   "[boundary.bottom] and [boundary.rim], or make the groups disjoint."),
        std::string::npos)
        << sides;
  }
}

// Written by Gmsh 4.15: a square with an embedded curve, and the same after its plugin Crack has doubled the nodes
// there.
TEST(GmshFile, ACrackIsTheSameWhetherItsNodesAreDoubledOrNot) {
  const NameUse use{{"glass"}, {"outer"}, {"notch"}};
  const SpaceMesh inside = read_gmsh_file(file("crack_inside.msh"), 2, {}, use);
  const SpaceMesh doubled = read_gmsh_file(file("crack_doubled.msh"), 2, {}, use);
  EXPECT_EQ(AnyOrder(doubled).cells, AnyOrder(inside).cells);
  EXPECT_EQ(AnyOrder(doubled).sides, AnyOrder(inside).sides);
  for (const SpaceMesh* mesh : {&inside, &doubled}) {
    ASSERT_EQ(mesh->inner_sides.size(), 1u);
    EXPECT_EQ(mesh->inner_sides[0].name, "notch");
    double length = 0;
    for (const auto& facet : mesh->inner_sides[0].facets)
      length += std::abs(mesh->vertices[facet[0]][0] - mesh->vertices[facet[1]][0]);
    EXPECT_EQ(mesh->inner_sides[0].facets.size(), 4u);
    EXPECT_NEAR(length, 1, 1e-12);
  }
}

TEST(GmshFile, NothingBesideTheMeshIsRead) {
  const std::filesystem::path folder = test_folder("mesh");
  std::filesystem::copy_file(file("square_41.msh"), folder / "square.msh");
  std::ofstream(folder / "square.msh.opt") << "SystemCall \"touch " << (folder / "ran").string() << "\";\n";
  EXPECT_EQ(read_gmsh_file((folder / "square.msh").string(), 2).num_cells(), 4);
  EXPECT_FALSE(std::filesystem::exists(folder / "ran"));
}

TEST(GmshFile, PeriodicSidesMayBeNamed) {
  // One cell between the sides would meet itself: only the message of that check proves the names were understood.
  EXPECT_THROW(read_gmsh_file(file("square_22.msh"), 2, {{"left", "right"}}), MeshError);
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
        BrokenFile{"truncated.msh", 2, {}, {"line 13, $Nodes", "number of nodes is given as 5", "cut short"}},
        BrokenFile{"unknown_vertex.msh", 2, {}, {"line 29, element 8", "node 17", "anew"}},
        BrokenFile{
            "fewer_nodes_announced.msh", 2, {}, {"line 10, $Nodes", "\"5\" stands where $EndNodes must", "anew"}},
        BrokenFile{"more_elements_announced.msh", 2, {}, {"line 11, $Elements", "given as 9", "room for 5"}},
        BrokenFile{"nodes_not_closed.msh", 2, {}, {"line 10, $Nodes", "\"$Elements\" stands where $EndNodes must"}},
        BrokenFile{"nodes_beyond_the_file.msh", 2, {}, {"line 10, $Nodes", "given as 99999999999", "room for 4"}},
        BrokenFile{"format_not_closed.msh", 2, {}, {"line 3, $MeshFormat", "$EndMeshFormat must be"}},
        BrokenFile{"section_not_closed.msh", 2, {}, {"line 4, $Physi?alNames", "not closed by", "Close the section"}},
        BrokenFile{"name_without_quotes.msh", 2, {}, {"line 6, $PhysicalNames", "name of a physical group"}},
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
        BrokenFile{"cell_in_two_groups.msh", 2, {}, {"triangle 5", "plate and inclusion", "Keep one"}},
        BrokenFile{"periodic_sides_differ.msh", 2, {{"left", "right"}}, {"no partner on right", "Periodic Curve"}}),
    [](const auto& test) {
      std::string name = test.param.name.substr(0, test.param.name.find('.'));
      return name + "_" + std::to_string(test.index);
    });

}  // namespace
}  // namespace tentpole
