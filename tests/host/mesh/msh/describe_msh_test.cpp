#include "host/mesh/msh/describe_msh.hpp"

#include <string>

#include <gtest/gtest.h>

#include "host/mesh/msh/read_msh.hpp"

namespace tentpole {
namespace {

/// A curve of two edges in `num_groups` groups, "side 1" and so on, and a surface of two triangles in as many.
std::string in_many_groups(int num_groups) {
  std::string names = "$PhysicalNames\n" + std::to_string(2 * num_groups) + "\n", groups = std::to_string(num_groups);
  for (int group = 1; group <= num_groups; ++group) {
    const std::string number = std::to_string(group);
    names += "1 " + number + " \"side " + number + "\"\n2 " + number + " \"region " + number + "\"\n";
    groups += " " + number;
  }
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names + "$EndPhysicalNames\n$Entities\n0 1 1 0\n1 0 0 0 1 1 0 " +
         groups + " 0\n1 0 0 0 1 1 0 " + groups + " 0\n$EndEntities\n" +
         "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n" +
         "$Elements\n2 4 1 4\n1 1 1 2\n1 1 2\n2 2 3\n2 1 2 2\n3 1 2 3\n4 1 3 4\n$EndElements\n";
}

std::vector<std::string> facet_names(const MeshDescription& mesh) {
  std::vector<std::string> names;
  for (const NamedFacet& facet : mesh.named_facets) names.push_back(mesh.boundary_names[facet.boundary]);
  return names;
}

TEST(DescribeMsh, OfManyGroupsOnlyThoseThatCountAreKept) {
  const MshContents contents = read_msh("many", in_many_groups(20000));
  const MeshDescription used =
      describe_msh("many", contents, 2, NameUse{{"region 77"}, {"side 9999"}, {"side 20000", "side 5"}});
  EXPECT_EQ(used.region_names, std::vector<std::string>{"region 77"});
  EXPECT_EQ(facet_names(used),
            (std::vector<std::string>{"side 5", "side 5", "side 9999", "side 9999", "side 20000", "side 20000"}));
  const MeshDescription unused = describe_msh("many", contents, 2, NameUse{});
  EXPECT_EQ(unused.region_names, std::vector<std::string>{"region 1"});
  EXPECT_EQ(facet_names(unused), (std::vector<std::string>{"side 1", "side 1"}));
  EXPECT_EQ(unused.cells.size(), 2u);
  EXPECT_EQ(unused.cell_number, (std::vector<std::int64_t>{3, 4}));
}

TEST(DescribeMsh, ElementsBelowTheFacetsMayBeAnything) {
  const std::string mesh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n3\n1 15 2 1 1 1\n2 8 2 1 1 1 2 3\n3 4 2 5 1 1 2 3 4\n$EndElements\n";
  EXPECT_EQ(describe_msh("solid", read_msh("solid", mesh), 3, {}).cells.size(), 1u);
  EXPECT_THROW(describe_msh("plate", read_msh("plate", mesh), 2, {}), MeshError);
}

}  // namespace
}  // namespace tentpole
