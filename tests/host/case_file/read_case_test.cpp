#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "host/case_file/case.hpp"
#include "tests/test_folder.hpp"

namespace tentpole {
namespace {

const std::string valid = TENTPOLE_TEST_DATA "/valid/";

/// The message with which a case is refused; empty if it is accepted.
std::string refusal(const std::string& file, const std::vector<std::string>& overrides) {
  try {
    read_case(valid + file, overrides);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << part << "\" is not in \"" << text << "\"";
}

TEST(ReadCase, FullExampleHasEveryValue) {
  Case thesis_bar = read_case(valid + "full_example.toml");
  EXPECT_EQ(thesis_bar.title, "spall of an elastic bar (thesis 2.4.1)");
  EXPECT_EQ(thesis_bar.constants.at("V"), 6.1);
  EXPECT_EQ(thesis_bar.domain.dimension, 2);
  EXPECT_EQ(thesis_bar.domain.max, (std::array<double, 3>{1e-3, 2e-4, 0}));
  EXPECT_EQ(thesis_bar.domain.cells, (std::array<int, 3>{40, 8, 0}));
  EXPECT_EQ(thesis_bar.domain.pattern, MeshPattern::unstructured);
  EXPECT_EQ(thesis_bar.domain.seed, 1u);
  EXPECT_EQ(thesis_bar.materials.at("all").plane, Plane::strain);
  EXPECT_EQ(thesis_bar.material("all").density, 3690);
  EXPECT_EQ(thesis_bar.boundaries.size(), 4u);
  EXPECT_TRUE(thesis_bar.initial_displacement.is_zero());
  EXPECT_EQ(thesis_bar.initial_velocity.components().size(), 2u);
  EXPECT_TRUE(thesis_bar.body_force.is_zero());
  ASSERT_TRUE(thesis_bar.exact_displacement.has_value());
  EXPECT_DOUBLE_EQ(thesis_bar.exact_displacement->evaluate({5e-4, 0, 0}, 1e-7)[0], 6.1e-7 / 2);
  EXPECT_EQ(thesis_bar.end_time, 2e-7);
  EXPECT_EQ(thesis_bar.degree, 2);
  EXPECT_EQ(thesis_bar.front.causality, 0.95);
  EXPECT_TRUE(thesis_bar.front.smoothing);
  EXPECT_EQ(thesis_bar.checkpoint_minutes, 10.0);
}

TEST(ReadCase, FullExampleHasEveryOutput) {
  const OutputSettings output = read_case(valid + "full_example.toml").output;
  ASSERT_EQ(output.snapshot_times.size(), 20u);
  EXPECT_DOUBLE_EQ(output.snapshot_times.front(), 1e-8);
  EXPECT_EQ(output.snapshot_times.back(), 2e-7);
  EXPECT_EQ(output.fields.size(), 5u);
  EXPECT_EQ(output.fields[3], "strain_energy_density");
  ASSERT_EQ(output.probes.size(), 1u);
  EXPECT_EQ(output.probes[0].name, "mid");
  EXPECT_EQ(output.probes[0].point, (std::array<double, 3>{5e-4, 1e-4, 0}));
  EXPECT_EQ(output.probes[0].interval, 1e-10);
  EXPECT_DOUBLE_EQ(output.history_interval, 1e-9);
}

TEST(ReadCase, LoadOfTheFullExampleRises) {
  BoundaryCondition left = read_case(valid + "full_example.toml").boundaries.at("left");
  EXPECT_EQ(left.normal_kind(), BoundaryKind::velocity);
  EXPECT_DOUBLE_EQ(left.value({}, 1e-9, {-1, 0, 0})[0], -6.1 / 2);
  EXPECT_DOUBLE_EQ(left.value({}, 3e-9, {-1, 0, 0})[0], -6.1);
}

TEST(SetSeed, ReachesTheMeshAndTheDefects) {
  Case bar = read_case(valid + "full_example.toml");
  set_seed(bar, 12345678901234567890u);
  EXPECT_EQ(bar.domain.seed, 12345678901234567890u);
  EXPECT_EQ(bar.fracture.nucleation.seed, 12345678901234567890u);
}

TEST(SetSeed, IsRefusedWhereNothingIsRandom) {
  Case plate = read_case(valid + "mesh_file.toml");
  EXPECT_THROW(set_seed(plate, 2), InputError);
  plate.fracture.nucleation.model = NucleationModel::field;
  set_seed(plate, 2);
  EXPECT_EQ(plate.fracture.nucleation.seed, 2u);
}

TEST(ReadCase, OneDimensionTakesPlainNumbersAndDefaults) {
  Case bar = read_case(valid + "one_dimension.toml");
  EXPECT_EQ(bar.title, "one_dimension");
  EXPECT_TRUE(bar.boundaries.at("left").is_zero());
  EXPECT_EQ(bar.boundaries.at("left").normal_kind(), BoundaryKind::velocity);
  EXPECT_EQ(bar.boundaries.at("right").ramp().order, RampOrder::quintic);
  EXPECT_DOUBLE_EQ(bar.boundaries.at("right").value({2}, 0.25, {1, 0, 0})[0], 0.75);
  EXPECT_EQ(bar.material("all").dilatational_speed(), 2);
  EXPECT_EQ(bar.output.snapshot_times.size(), 20u);
  EXPECT_DOUBLE_EQ(bar.output.history_interval, 0.05);
  EXPECT_EQ(bar.batch_size, 0);
  EXPECT_FALSE(bar.checkpoint_minutes.has_value());
  EXPECT_FALSE(bar.exact_displacement.has_value());
}

TEST(ReadCase, DegreeOneIsAllowedWithAWarning) {
  const Case bar = read_case(valid + "one_dimension.toml");
  ASSERT_EQ(bar.warnings.size(), 1u);
  EXPECT_TRUE(
      contains(bar.warnings[0], "one_dimension.toml:20: discretization.degree = 1: degree 1 converges with order 1"));
  EXPECT_TRUE(read_case(valid + "one_dimension.toml", {"discretization.degree=2"}).warnings.empty());
}

TEST(ReadCase, ThreeDimensionsHaveEveryKindOfCondition) {
  Case box = read_case(valid + "three_dimensions.toml");
  EXPECT_DOUBLE_EQ(box.constants.at("c"), 2000);
  BoundaryCondition left = box.boundaries.at("left");
  EXPECT_EQ(left.normal_kind(), BoundaryKind::traction);
  EXPECT_EQ(left.tangential_kind(), BoundaryKind::velocity);
  EXPECT_EQ(left.value({}, 0.5, {-1, 0, 0}), (std::array<double, 3>{-2000, 0, 0.5}));
  EXPECT_EQ(box.boundaries.at("right").normal_kind(), BoundaryKind::absorbing);
  EXPECT_TRUE(box.boundaries.at("bottom").is_zero());
  EXPECT_EQ(box.boundaries.at("top").tangential_kind(), BoundaryKind::velocity);
  EXPECT_EQ(box.boundaries.at("back").periodic_partner(), "front");
  EXPECT_EQ(box.initial_velocity.evaluate({0.5, 0, 3}, 0), (std::array<double, 3>{1, 0, 3}));
  EXPECT_EQ(box.body_force.evaluate({}, 0)[1], -9.81);
  EXPECT_EQ(box.output.snapshot_times, (std::vector<double>{2.5e-4, 1e-3}));
  EXPECT_EQ(box.batch_size, 64);
}

TEST(ReadCase, FarFieldOfAnAbsorbingSideIsTheInitialStateUnlessGiven) {
  const std::string file = valid + "three_dimensions.toml";
  EXPECT_FALSE(read_case(file).boundaries.at("right").has_far_field());
  BoundaryCondition right =
      read_case(file, {"boundary.right.far_field_velocity=['y', '0', '2*t']"}).boundaries.at("right");
  EXPECT_TRUE(right.has_far_field());
  EXPECT_EQ(right.far_field_velocity({1, 3, 0}, 4), (std::array<double, 3>{3, 0, 8}));
  EXPECT_EQ(right.value({1, 3, 0}, 4, {1, 0, 0}), (std::array<double, 3>{0, 0, 0}));
  right = read_case(file, {"boundary.right.far_field_traction=['0', '0', '0']"}).boundaries.at("right");
  EXPECT_TRUE(right.has_far_field());
  EXPECT_TRUE(right.is_zero());
}

TEST(ReadCase, PeriodicSideStandsForItsPartner) {
  const Case square = read_case(valid + "periodic.toml");
  EXPECT_EQ(square.boundaries.size(), 4u);
  EXPECT_EQ(square.boundaries.at("right").periodic_partner(), "left");
  EXPECT_EQ(square.boundaries.at("top").periodic_partner(), "bottom");
  EXPECT_TRUE(square.output.snapshot_times.empty());
  EXPECT_EQ(square.materials.at("all").plane, Plane::stress);
}

TEST(ReadCase, MeshFileIsFoundBesideTheCaseFile) {
  const Case plate = read_case(valid + "mesh_file.toml");
  EXPECT_FALSE(plate.domain.is_box());
  EXPECT_TRUE(std::filesystem::is_regular_file(plate.domain.mesh_file));
  EXPECT_EQ(plate.material("glass").density, 2500);
  EXPECT_TRUE(plate.boundaries.contains("rim"));
  try {
    plate.material("wood");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(),
                         "region \"wood\" of the mesh has no material. Give [material.wood]; given: glass, steel."));
  }
}

TEST(ReadCase, SingleMaterialAllServesEveryRegion) {
  EXPECT_EQ(read_case(valid + "one_dimension.toml").material("plate").density, 2);
}

TEST(Overrides, ReplaceValuesBeforeValidation) {
  const Case bar = read_case(valid + "one_dimension.toml",
                             {"time.end=4.0", "domain.cells=[16]", "title=\"longer\"",
                              "boundary.right.traction=[\"2*t\"]", "constants.A=3", "front.causality=0.5"});
  EXPECT_EQ(bar.end_time, 4);
  EXPECT_EQ(bar.domain.cells[0], 16);
  EXPECT_EQ(bar.title, "longer");
  EXPECT_EQ(bar.constants.at("A"), 3);
  EXPECT_EQ(bar.front.causality, 0.5);
}

TEST(Overrides, TextThatIsNotTomlIsAString) {
  Case bar = read_case(valid + "one_dimension.toml", {"boundary.left.normal_velocity=2*t", "title=two words"});
  EXPECT_EQ(bar.boundaries.at("left").value({}, 3, {1, 0, 0})[0], 6);
  EXPECT_EQ(bar.title, "two words");
}

TEST(Overrides, KeysAreQuotedAsInTheFileAndInMessages) {
  const std::vector<std::string> clamped{"boundary.\"Mechanically clamped = 1.0\".traction=[\"1\", \"0\"]"};
  EXPECT_TRUE(read_case(valid + "mesh_file.toml", clamped).boundaries.contains("Mechanically clamped = 1.0"));
  const std::string unknown = refusal("mesh_file.toml", {"boundary.\"a \\\"b\\\"\".tracton=3"});
  EXPECT_TRUE(contains(unknown, "--set boundary.\"a \\\"b\\\"\".tracton=3: unknown key. Did you mean \"traction\"?"))
      << unknown;
  EXPECT_TRUE(contains(refusal("mesh_file.toml", {"boundary.\"a.traction=3"}), "is no override"));
  EXPECT_TRUE(contains(refusal("mesh_file.toml", {"boundary.\"a\"traction=3"}), "is no override"));
}

TEST(ReadCase, MessagesQuoteKeysWhereTheFileMust) {
  const std::string path = test_folder("case") / "quoted_key.toml";
  std::ifstream mesh_file(valid + "mesh_file.toml");
  std::ofstream(path) << mesh_file.rdbuf() << "[material.\"Probekörper Nº1\"]\ndensity = -1\n";
  try {
    read_case(path);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(), "material.\"Probekörper Nº1\".density = -1: must be positive")) << error.what();
  }
}

TEST(Overrides, CureAFaultOfTheFile) {
  const std::string broken = TENTPOLE_TEST_DATA "/broken/poisson_ratio_too_large.toml";
  EXPECT_THROW(read_case(broken), InputError);
  EXPECT_EQ(read_case(broken, {"material.all.poisson_ratio=0.25"}).materials.at("all").poisson_ratio, 0.25);
}

TEST(Overrides, FaultsNameTheOption) {
  EXPECT_TRUE(contains(refusal("one_dimension.toml", {"material.all.poisson_ratio=0.7"}),
                       "--set material.all.poisson_ratio=0.7: must lie in (-1, 0.5). Give a ratio below 0.5"));
  EXPECT_TRUE(contains(refusal("one_dimension.toml", {"time.ende=3"}),
                       "--set time.ende=3: unknown key. Did you mean \"end\"?"));
  EXPECT_TRUE(
      contains(refusal("one_dimension.toml", {"boundary.left.normal_velocity=2*q"}), "unknown name or symbol \"q\""));
  EXPECT_TRUE(contains(refusal("one_dimension.toml", {"time.end"}),
                       "--set time.end: is no override. Write --set section.key=value"));
  EXPECT_TRUE(contains(refusal("one_dimension.toml", {"time.end.hours=3"}), "time.end is an integer, not a table"));
}

TEST(Overrides, FaultsAreReportedTogetherWithThoseOfTheFile) {
  try {
    read_case(TENTPOLE_TEST_DATA "/broken/many_problems_at_once.toml", {"front.causality=2", "nonsense"});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 6u) << error.what();
    EXPECT_TRUE(error.problems().back().location.is_override());
  }
}

// Each constant needs the next one, so in the order of the file nearly all of them wait for the last.
TEST(Constants, AChainOfThousandsIsResolvedFromItsEnd) {
  constexpr int length = 5000;
  std::vector<std::string> overrides{"constants.c" + std::to_string(length) + "=1"};
  for (int i = 0; i < length; ++i)
    overrides.push_back("constants.c" + std::to_string(i) + "=\"c" + std::to_string(i + 1) + " + 1\"");
  const Case bar = read_case(TENTPOLE_TEST_DATA "/valid/one_dimension.toml", overrides);
  EXPECT_EQ(bar.constants.at("c0"), length + 1);
  EXPECT_EQ(bar.constants.at("c4000"), 1001);
}

TEST(Constants, ThoseThatGoRoundInACircleDoNotHideTheOthers) {
  const std::string message = refusal(
      "one_dimension.toml", {"constants.a=\"b+1\"", "constants.b=\"a+1\"", "constants.c=\"2*d\"", "constants.d=3"});
  EXPECT_TRUE(contains(message, "character 1: unknown name or symbol \"b\"")) << message;
  EXPECT_TRUE(contains(message, "character 1: unknown name or symbol \"a\"")) << message;
  EXPECT_FALSE(contains(message, "constants.c")) << message;
}

}  // namespace
}  // namespace tentpole
