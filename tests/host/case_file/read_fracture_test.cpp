#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "host/case_file/sections.hpp"
#include "tests/test_folder.hpp"

namespace tentpole {
namespace {

const std::string valid = TENTPOLE_TEST_DATA "/valid/";

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What the readers and checks make of a valid case whether or not this version can solve it.
struct AdaptiveCase {
  Case settings;
  std::vector<std::string> warnings, problems;

  AdaptiveCase(const std::string& file, const std::vector<std::string>& overrides) {
    std::vector<Problem> faults;
    const Node root = read_document(valid + file, overrides, faults);
    SectionContext context{root, faults, warnings};
    settings.domain = context.domain = read_domain(context, valid);
    settings.materials = read_materials(context);
    settings.boundaries = read_boundaries(context);
    settings.adaptivity = read_adaptivity(context);
    settings.fracture = read_fracture(context);
    check_adaptive_run(context, settings);
    for (const Problem& fault : faults) problems.push_back(to_string(fault));
  }

  bool warns(const std::string& part) const { return mentions(warnings, part); }
  bool reports(const std::string& part) const { return mentions(problems, part); }

 private:
  static bool mentions(const std::vector<std::string>& texts, const std::string& part) {
    for (const std::string& text : texts)
      if (text.find(part) != std::string::npos) return true;
    return false;
  }
};

const std::vector<std::string> law{"fracture.enabled=true", "fracture.threshold=3", "fracture.strength=4",
                                   "fracture.relaxation_time=2"};

std::vector<std::string> law_and(std::vector<std::string> more) {
  more.insert(more.begin(), law.begin(), law.end());
  return more;
}

TEST(ReadAdaptivity, FullExampleHasEveryValue) {
  const AdaptivitySettings adaptivity = read_case(valid + "full_example.toml").adaptivity;
  EXPECT_FALSE(adaptivity.enabled);
  EXPECT_EQ(adaptivity.error_tolerance, 1e-6);
  EXPECT_EQ(adaptivity.min_size, 5e-7);
  EXPECT_EQ(adaptivity.max_size, 5e-5);
  EXPECT_EQ(adaptivity.coarsening, 0.1);
  EXPECT_EQ(adaptivity.reference_energy, 2e-5);
}

TEST(ReadAdaptivity, AbsentSectionIsSwitchedOff) {
  const Case bar = read_case(valid + "one_dimension.toml");
  EXPECT_FALSE(bar.adaptivity.enabled);
  EXPECT_FALSE(bar.fracture.enabled);
  EXPECT_EQ(bar.fracture.nucleation.model, NucleationModel::nowhere);
}

TEST(ReadAdaptivity, DefaultsCoarsenWithoutBoundAndEstimateTheEnergy) {
  const AdaptiveCase bar("one_dimension.toml",
                         {"adaptivity.enabled=true", "adaptivity.error_tolerance=1e-3", "adaptivity.min_size=0.125"});
  ASSERT_TRUE(bar.problems.empty()) << bar.problems[0];
  EXPECT_TRUE(bar.settings.adaptivity.enabled);
  EXPECT_EQ(bar.settings.adaptivity.max_size, infinity);
  EXPECT_EQ(bar.settings.adaptivity.coarsening, 0.05);
  EXPECT_FALSE(bar.settings.adaptivity.reference_energy.has_value());
}

TEST(ReadFracture, FullExampleHasEveryValue) {
  const FractureSettings fracture = read_case(valid + "full_example.toml").fracture;
  EXPECT_FALSE(fracture.enabled);
  EXPECT_EQ(fracture.threshold, 300e6);
  EXPECT_EQ(fracture.strength, 400e6);
  EXPECT_EQ(fracture.relaxation_time, 1e-9);
  EXPECT_EQ(fracture.delay_exponent, 11);
  EXPECT_EQ(fracture.shear_factor, 0.9);
  EXPECT_EQ(fracture.friction, 0.3);
  EXPECT_EQ(fracture.max_damage_step, 0.1);
  EXPECT_EQ(fracture.process_zone_size, 9e-6);
  EXPECT_EQ(fracture.growth_length, 3e-6);
  ASSERT_EQ(fracture.cracks.size(), 1u);
  EXPECT_EQ(fracture.cracks[0].damage, 0.25);
  ASSERT_EQ(fracture.cracks[0].points.size(), 2u);
  EXPECT_EQ(fracture.cracks[0].points[1], (std::array<double, 3>{5e-4, 2e-4, 0}));
}

TEST(ReadFracture, FullExampleHasEveryValueOfItsDefects) {
  const NucleationSettings nucleation = read_case(valid + "full_example.toml").fracture.nucleation;
  EXPECT_EQ(nucleation.model, NucleationModel::field);
  EXPECT_EQ(nucleation.distribution, StrengthLaw::normal);
  EXPECT_EQ(nucleation.mean, 2e9);
  EXPECT_EQ(nucleation.minimum, 220e6);
  EXPECT_EQ(nucleation.maximum, 4e9);
  EXPECT_EQ(nucleation.tail_strength, 400e6);
  EXPECT_EQ(nucleation.tail_probability, 2e-4);
  EXPECT_EQ(nucleation.density, 1e13);
  EXPECT_EQ(nucleation.seed, 7u);
}

TEST(ReadFracture, LawHasUsualDefaults) {
  const AdaptiveCase bar("one_dimension.toml", law);
  ASSERT_TRUE(bar.problems.empty()) << bar.problems[0];
  const FractureSettings& fracture = bar.settings.fracture;
  EXPECT_EQ(fracture.delay_exponent, 10);
  EXPECT_EQ(fracture.shear_factor, 1);
  EXPECT_EQ(fracture.friction, 0);
  EXPECT_EQ(fracture.max_damage_step, 0.2);
  EXPECT_FALSE(fracture.process_zone_size.has_value());
  EXPECT_FALSE(fracture.growth_length.has_value());
}

TEST(ReadFracture, ProcessZoneIsThatOfTheFastestMaterialUnlessGiven) {
  Case settings = AdaptiveCase("one_dimension.toml", law).settings;
  const Material material = elastic_material(settings.materials.begin()->second, 1);
  EXPECT_DOUBLE_EQ(settings.process_zone_size(), 2 * material.dilatational_speed());
  settings.materials["stiff"] = settings.materials.begin()->second;
  settings.materials["stiff"].density /= 4;
  EXPECT_DOUBLE_EQ(settings.process_zone_size(), 4 * material.dilatational_speed());
  settings.fracture.process_zone_size = 0.25;
  EXPECT_EQ(settings.process_zone_size(), 0.25);
}

TEST(ReadFracture, WeibullDefectsHaveALocationAndNoUpperBound) {
  const std::string section = "fracture.nucleation.";
  const AdaptiveCase bar("one_dimension.toml",
                         law_and({section + "model=sampled", section + "distribution=weibull", section + "minimum=0",
                                  section + "weibull_modulus=8", section + "weibull_scale=5", section + "density=10"}));
  ASSERT_TRUE(bar.problems.empty()) << bar.problems[0];
  const NucleationSettings& nucleation = bar.settings.fracture.nucleation;
  EXPECT_EQ(nucleation.model, NucleationModel::sampled);
  EXPECT_EQ(nucleation.distribution, StrengthLaw::weibull);
  EXPECT_EQ(nucleation.minimum, 0);
  EXPECT_EQ(nucleation.maximum, infinity);
  EXPECT_EQ(nucleation.weibull_modulus, 8);
  EXPECT_EQ(nucleation.weibull_scale, 5);
  EXPECT_EQ(nucleation.seed, 1u);
}

TEST(ReadFracture, NoNucleationNeedsNoDistribution) {
  const AdaptiveCase bar("one_dimension.toml", law_and({"fracture.nucleation.model=none"}));
  EXPECT_TRUE(bar.problems.empty()) << bar.problems[0];
  EXPECT_EQ(bar.settings.fracture.nucleation.model, NucleationModel::nowhere);
}

TEST(ReadFracture, CrackMayBeASideOfAMeshFile) {
  const std::filesystem::path folder = test_folder("case"), temporary = folder / "crack_side.toml";
  std::ifstream mesh_file(valid + "mesh_file.toml");
  std::ofstream(temporary) << mesh_file.rdbuf()
                           << "[fracture]\nenabled = false\n[[fracture.crack]]\nside = \"joint\"\ndamage = 0.5\n";
  std::filesystem::copy_file(valid + "two_triangles.msh", folder / "two_triangles.msh");
  const FractureSettings fracture = read_case(temporary).fracture;
  ASSERT_EQ(fracture.cracks.size(), 1u);
  EXPECT_EQ(fracture.cracks[0].side, "joint");
  EXPECT_EQ(fracture.cracks[0].damage, 0.5);
  EXPECT_TRUE(fracture.cracks[0].points.empty());
  EXPECT_EQ(fracture.cracks[0].location.key, "fracture.crack[1].side");
}

TEST(ReadFracture, CrackOfABarIsAPoint) {
  const std::string path = test_folder("case") / "crack_of_a_bar.toml";
  const auto points_of = [&](const std::string& points) {
    std::ifstream bar(valid + "one_dimension.toml");
    std::ofstream(path) << bar.rdbuf() << "[fracture]\nenabled = false\n[[fracture.crack]]\npoints = " << points
                        << "\ndamage = 0\n";
    return read_case(path).fracture.cracks.at(0).points;
  };
  EXPECT_EQ(points_of("[[0.5]]"), (std::vector<std::array<double, 3>>{{0.5, 0, 0}}));
  EXPECT_THROW(points_of("[[0.5], [1.0]]"), InputError);
  EXPECT_THROW(points_of("[0.5]"), InputError);
  EXPECT_THROW(points_of("[[2.0]]"), InputError);  // the end of the bar
}

TEST(CheckAdaptiveRun, ThreeDimensionsAreRefused) {
  const AdaptiveCase box("three_dimensions.toml",
                         law_and({"adaptivity.enabled=true", "adaptivity.error_tolerance=1", "adaptivity.min_size=0.1",
                                  "boundary.back={absorbing=true}", "boundary.front={absorbing=true}"}));
  EXPECT_TRUE(box.reports("--set adaptivity.enabled=true: needs domain.dimension 1 or 2, which is 3. Set enabled"));
  EXPECT_TRUE(box.reports("--set fracture.enabled=true: needs domain.dimension 1 or 2, which is 3. Set enabled"));
}

TEST(CheckAdaptiveRun, PeriodicSidesAreRefusedOncePerPair) {
  const AdaptiveCase square("periodic.toml", law);
  EXPECT_TRUE(
      square.reports("fracture.enabled=true: cannot be combined with periodic sides, which left and right are."));
  EXPECT_TRUE(square.reports("which bottom and top are. Give them other conditions, or set enabled = false."));
  EXPECT_EQ(square.problems.size(), 2u);
}

TEST(CheckAdaptiveRun, UnresolvedProcessZoneGivesAWarning) {
  // c_p = 2 m/s and tau = 0.1 s: a zone of 0.2 m, cells of 0.25 m
  EXPECT_TRUE(AdaptiveCase("one_dimension.toml", law_and({"fracture.relaxation_time=0.1"}))
                  .warns("the cells of [domain] are up to 0.25 m long. Damage needs cells of a quarter of the process "
                         "zone, which is 0.05 m. Switch on [adaptivity]"));
  const std::vector<std::string> adaptive =
      law_and({"fracture.process_zone_size=0.2", "adaptivity.enabled=true", "adaptivity.error_tolerance=1e-3"});
  const auto with_min_size = [&](const std::string& size) {
    std::vector<std::string> overrides = adaptive;
    overrides.push_back("adaptivity.min_size=" + size);
    return AdaptiveCase("one_dimension.toml", overrides);
  };
  EXPECT_TRUE(with_min_size("0.1").warns("adaptivity.min_size=0.1: is too coarse for the cracks."));
  EXPECT_TRUE(with_min_size("0.05").warnings.empty());
}

TEST(CheckAdaptiveRun, WarnsOfFrictionAndOfStrongDefectsAndOfIdleSmoothing) {
  EXPECT_TRUE(AdaptiveCase("one_dimension.toml", law_and({"fracture.friction=0.7"})).warns("more friction than 0.6"));
  const std::string section = "fracture.nucleation.";
  EXPECT_TRUE(AdaptiveCase("one_dimension.toml",
                           law_and({section + "model=field", section + "distribution=weibull", section + "minimum=3",
                                    section + "weibull_modulus=8", section + "weibull_scale=5", section + "density=1"}))
                  .warns("nucleation.minimum=3: no defect is weaker than fracture.threshold = 3"));
  const std::vector<std::string> warnings = read_case(valid + "full_example.toml").warnings;
  ASSERT_EQ(warnings.size(), 2u);  // damage is among the fields, too
  EXPECT_NE(warnings[1].find("front.smoothing = true: has no effect on a fixed mesh."), std::string::npos);
}

}  // namespace
}  // namespace tentpole
