#include "host/problem/mesh_names.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/run/make_simulation.hpp"
#include "tests/test_folder.hpp"

// How the names of a mesh file and of a case meet.
namespace tentpole {
namespace {

/// A case with this mesh of tests/host/mesh (or elsewhere), and these tables.
Simulation simulation_with(const std::string& mesh, const std::vector<std::string>& materials,
                           const std::vector<std::string>& boundaries, const std::string& crack = "") {
  const std::filesystem::path path = test_folder("case") / "mesh_names.toml";
  std::ofstream stream(path);
  const std::filesystem::path folder = std::filesystem::path(TENTPOLE_TEST_DATA) / "../mesh";
  stream << "[domain]\ndimension = 2\nmesh = \"" << (folder / mesh).string() << "\"\n";
  for (const std::string& name : materials)
    stream << "[material." << name << "]\ndensity = 1\nyoungs_modulus = " << name.size() << "\npoisson_ratio = 0\n";
  for (const std::string& name : boundaries) stream << "[boundary." << name << "]\nabsorbing = true\n";
  stream << "[time]\nend = 1\n[discretization]\ndegree = 2\n";
  if (!crack.empty())
    stream << "[fracture]\nenabled = false\n[[fracture.crack]]\nside = \"" << crack << "\"\ndamage = 1\n";
  stream.close();
  return make_simulation(read_case(path));
}

std::string refusal(const std::string& mesh, const std::vector<std::string>& materials,
                    const std::vector<std::string>& boundaries, const std::string& crack = "") {
  try {
    simulation_with(mesh, materials, boundaries, crack);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeshNames, GroupsThatOverlapMayStayWithoutTables) {
  const Simulation simulation = simulation_with("square_groups_41.msh", {"plate"}, {"rim"});
  EXPECT_EQ(simulation.mesh.region_names, std::vector<std::string>{"plate"});
  EXPECT_EQ(simulation.mesh.boundary_names, std::vector<std::string>{"rim"});
}

TEST(MeshNames, AllIsEveryRegionWithoutATableOfItsOwn) {
  EXPECT_EQ(simulation_with("square_groups_41.msh", {"all"}, {"rim"}).materials.front().mu * 2, 3);
  EXPECT_EQ(simulation_with("square_groups_22.msh", {"all", "everything"}, {"rim"}).materials.front().mu * 2, 10);
  const Simulation two =
      simulation_with("two_regions_on_one_entity.msh", {"all", "inclusion"}, {"left", "right", "bottom", "top"});
  ASSERT_EQ(two.mesh.region_names, (std::vector<std::string>{"plate", "inclusion"}));
  EXPECT_EQ(two.materials[0].mu * 2, 3);
  EXPECT_EQ(two.materials[1].mu * 2, 9);
}

TEST(MeshNames, NamesWithoutATableAndTablesWithoutANameAreReportedTogether) {
  const std::string message = refusal("square_41.msh", {"steel"}, {"left", "right", "bottom", "lid"});
  for (const char* part :
       {"boundary.top: the mesh has this boundary and the case no condition for it. Add [boundary.top].",
        "boundary.lid: the mesh has no such boundary (it has: left, right, bottom, top). Remove the table or name one",
        "material.plate: the mesh has this region and the case no material for it. Add [material.plate].",
        "material.steel: the mesh has no such region (it has: plate). Remove the table or name one of these."})
    EXPECT_NE(message.find(part), std::string::npos) << part << "\nnot in\n" << message;
}

TEST(MeshNames, ASideInsideIsOfferedAsACrack) {
  EXPECT_NE(
      refusal("crack_inside.msh", {"all"}, {"outer", "notch"})
          .find("boundary.notch: this side lies inside the body, between cells, where no condition can be. Remove "
                "the table, or make the side a crack: [[fracture.crack]] with side = \"notch\"."),
      std::string::npos);
  EXPECT_EQ(refusal("crack_inside.msh", {"all"}, {"outer"}), "accepted");
}

TEST(MeshNames, ACrackIsASideInside) {
  for (const char* mesh : {"crack_inside.msh", "crack_doubled.msh"}) {
    EXPECT_EQ(refusal(mesh, {"all"}, {"outer"}, "notch"), "accepted");
    EXPECT_NE(refusal(mesh, {"all"}, {"outer", "notch"}, "notch")
                  .find("boundary.notch: this side is a crack, on which [fracture] says what the surfaces bear. Remove "
                        "the table."),
              std::string::npos);
  }
  EXPECT_NE(refusal("crack_inside.msh", {"all"}, {"outer"}, "outer")
                .find("belongs to the crack outer, but lies on the boundary of the body"),
            std::string::npos);
  const std::string misspelt = refusal("crack_inside.msh", {"all"}, {"outer"}, "nutch");
  EXPECT_NE(
      misspelt.find("mesh_names.toml:17: fracture.crack[1].side = \"nutch\": the mesh has no such side inside the "
                    "body. Did you mean \"notch\"?"),
      std::string::npos)
      << misspelt;
  const std::string nowhere = refusal("square_41.msh", {"all"}, {"left", "right", "bottom", "top"}, "nutch");
  EXPECT_NE(nowhere.find("the mesh has no such side, and none inside the body. Give points instead."),
            std::string::npos)
      << nowhere;
}

/// The square with its names replaced, in a temporary folder.
std::string square_named(const std::string& region, const std::string& side) {
  std::ifstream square(std::string(TENTPOLE_TEST_DATA) + "/../mesh/square_41.msh");
  std::string bytes(std::istreambuf_iterator<char>(square), {});
  for (const auto& [old_name, name] : {std::pair<std::string, std::string>{"\"plate\"", region}, {"\"left\"", side}})
    bytes.replace(bytes.find(old_name), old_name.size(), "\"" + name + "\"");
  const std::filesystem::path path = test_folder("mesh") / "square_named.msh";
  std::ofstream(path) << bytes;
  return path.string();
}

TEST(MeshNames, AdviceIsWhatACaseFileTakes) {
  for (const std::string name :
       {"Mechanically clamped", "freie Oberfläche", "3\" pipe", "C:\\mesh", "a.b", "=#]", "板"}) {
    const std::string mesh = square_named("solid " + name, name);
    const std::vector<std::string> others{"right", "bottom", "top"};
    const std::string message = refusal(mesh, {"missing"}, others);
    const auto advised = [&](const std::string& section) {
      const std::string start = "Add [" + section + ".";
      const std::size_t begin = message.find(start) + start.size(), end = message.find("].\n", begin);
      return message.substr(begin, (end == std::string::npos ? message.size() - 2 : end) - begin);
    };
    std::vector<std::string> sides = others;
    sides.push_back(advised("boundary"));
    EXPECT_EQ(refusal(mesh, {advised("material")}, sides), "accepted") << message;
  }
}

TEST(MeshNames, NamesInLatin1AreThoseLetters) {
  const std::string mesh = square_named("Stahl",
                                        "freie Oberfl\xe4"
                                        "che");
  EXPECT_EQ(refusal(mesh, {"Stahl"}, {"\"freie Oberfläche\"", "right", "bottom", "top"}), "accepted");
}

TEST(MeshNames, ControlCharactersInNamesAreRefused) {
  const std::string message = refusal(square_named("Stahl", "\x1b[31mred"), {"Stahl"}, {"right"});
  EXPECT_NE(message.find("line 6, $PhysicalNames: the name \"?[31mred\" of a physical group holds a control character"),
            std::string::npos)
      << message;
}

}  // namespace
}  // namespace tentpole
