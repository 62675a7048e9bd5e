#include "host/batch/energy_balance.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "host/output/checkpoint_file.hpp"
#include "host/run/make_simulation.hpp"
#include "host/run/run.hpp"
#include "tests/host/run/sample_cases.hpp"
#include "tests/test_folder.hpp"

// A run whose numbers double precision cannot resolve ends with place and time instead of results that mean nothing.
namespace tentpole {
namespace {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A batch of one patch of two elements, over elements of the store.
HostBatch solved_batch(const ElementRecord& first, const ElementRecord& second) {
  HostBatch batch;
  batch.patches = {{0, 2}};
  batch.elements.resize(2);
  for (ElementDescriptor& element : batch.elements) {
    for (FacetKind& kind : element.facet_kind) kind = FacetKind::outflow;
    element.pole = 0;
  }
  batch.cells = {4, 5};
  batch.records = {first, second};
  return batch;
}

Simulation unit_simulation() {
  Simulation simulation;
  simulation.mesh.dimension = 1;
  simulation.settings.degree = 2;
  simulation.scaling = {1, 1, 1, 1};
  return simulation;
}

ElementRecord record(double inflow_energy, double outflow_energy, double dissipation = 0, double external_work = 0) {
  ElementRecord record{};
  record.inflow_energy = inflow_energy;
  record.outflow_energy = outflow_energy;
  record.dissipation = dissipation;
  record.external_work = external_work;
  return record;
}

// E_out - E_in = (3 - 5) + (4 - 1) = 1, losses 0.5 + 0.25 + 2 + 1, work 4.75.
TEST(PatchEnergies, AddUpElementsAndFractureFacets) {
  HostBatch batch = solved_batch(record(5, 3, 0.5, -7), record(1, 4, 0.25, 11.75));
  batch.patches[0].num_fractures = 1;
  batch.fracture_records.resize(1);
  batch.fracture_records[0].fracture_work = 2;
  batch.fracture_records[0].friction_work = 1;
  const PatchEnergies energies = patch_energies(batch, batch.patches[0], unit_simulation());
  EXPECT_EQ(energies.change, 1);
  EXPECT_EQ(energies.loss, 3.75);
  EXPECT_EQ(energies.work, 4.75);
  EXPECT_EQ(energies.largest, 11.75);
  EXPECT_EQ(energies.imbalance(), 0);
}

bool balances(double outflow_energy, double scale, double unit = 1) {
  Simulation simulation = unit_simulation();
  simulation.scaling.density = unit;
  HostBatch batch = solved_batch(record(1, outflow_energy), record(0, 0));
  batch.energies = {patch_energies(batch, batch.patches[0], simulation)};
  return is_balanced(batch, 0, scale, simulation);
}

TEST(Balance, IsJudgedByTheLargestEnergySoFar) {
  EXPECT_TRUE(balances(1 + 0.99e-6, 1));
  EXPECT_FALSE(balances(1 + 1.01e-6, 1));
  EXPECT_FALSE(balances(1 - 1.01e-6, 1)) << "a loss that nothing explains";
  EXPECT_TRUE(balances(1 + 1.01e-4, 1000));
}

TEST(Balance, OfEnergiesThatAreNotFiniteOrOverflowInTheirUnitNeverCloses) {
  for (const double energy : {std::nan(""), infinity, -infinity}) {
    EXPECT_FALSE(balances(energy, 1));
    EXPECT_FALSE(balances(energy, infinity));
  }
  EXPECT_TRUE(balances(1, 1, 1e200));
  EXPECT_FALSE(balances(1, 1, 1e300)) << "sums of such energies in J overflow";
}

TEST(Balance, OfAWholeRunIsJudgedByItsLargestShare) {
  RunSummary::Energy energy;
  energy.external_work = 5;
  energy.kinetic = 2;
  energy.strain = 1;
  energy.numerical = 2;
  EXPECT_NO_THROW(require_balance(energy, 0));
  energy.strain = 1 + 4.9e-6;
  EXPECT_NO_THROW(require_balance(energy, 0));
  energy.strain = 1 + 5.1e-6;
  EXPECT_THROW(require_balance(energy, 0), std::runtime_error);
  EXPECT_NO_THROW(require_balance(energy, 6)) << "energies were larger in between";
  energy.strain = std::nan("");
  EXPECT_THROW(require_balance(energy, 6), std::runtime_error);
  energy = {};
  EXPECT_NO_THROW(require_balance(energy, 0)) << "a body at rest";
}

Simulation simulation_of(const std::string& text, const std::vector<std::string>& overrides) {
  const fs::path file = test_folder("balance_case") / "case.toml";
  std::ofstream(file) << text;
  return make_simulation(read_case(file, overrides));
}

/// The message with which a run in `folder` fails, or an empty one.
std::string failure(const Simulation& simulation, const fs::path& folder) {
  RunOptions options;
  options.folder = folder;
  options.threads = 1;
  try {
    run_simulation(simulation, options);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
}

// The equations are solved, but velocities of 1e200 wave speeds have no finite square.
TEST(EnergiesThatOverflow, EndTheRunWithPlaceTimeAndACheckpoint) {
  for (const int dimension : {1, 2, 3}) {
    const fs::path folder = test_folder("overflow");
    std::string zeros = "\"1e200\"";
    for (int i = 1; i < dimension; ++i) zeros += ",\"0\"";
    const Simulation simulation = simulation_of(sample_case(dimension), {"initial.velocity=[" + zeros + "]"});
    expect_parts(failure(simulation, folder), {"cell ", "tent at (",
                                               " m, t = 0 s: the energies of its solution are not "
                                               "finite",
                                               "check the units", (folder / "checkpoint.h5").string()});
    EXPECT_FALSE(fs::exists(folder / "summary.json"));
    EXPECT_NO_THROW(read_checkpoint_file(folder / "checkpoint.h5"));
  }
}

/// A bar of 12 cells that cracks, with defects everywhere. Sound with a density of 3690.
const char* const cracking_bar = R"toml(
[domain]
dimension = 2
min = [0.0, 0.0]
max = [1.2e-4, 3e-5]
cells = [12, 3]
pattern = "unstructured"
[material.all]
density = 3690.0
youngs_modulus = 260e9
poisson_ratio = 0.21
[boundary.left]
normal_velocity = "6.1"
tangential_velocity = "0"
ramp = 2e-9
[boundary.right]
normal_velocity = "6.1"
tangential_velocity = "0"
ramp = 2e-9
[boundary.bottom]
normal_velocity = "0"
tangential_traction = "0"
[boundary.top]
normal_velocity = "0"
tangential_traction = "0"
[time]
end = 2.4e-8
[discretization]
degree = 2
[adaptivity]
enabled = true
error_tolerance = 2e-6
min_size = 2e-6
max_size = 5e-5
[fracture]
enabled = true
threshold = 300e6
strength = 400e6
relaxation_time = 1e-9
process_zone_size = 12e-6
[fracture.nucleation]
model = "field"
mean = 2.0e9
minimum = 220e6
maximum = 4.0e9
tail_strength = 400e6
tail_probability = 2e-4
density = 5e12
[output]
snapshots = 2
)toml";

// Waves take 1e7 relaxation times through a cell, so poles are 1e-9 of it: rounding is as large as what happens there.
TEST(FlatTents, EndAnAdaptiveRunThatTheyMakeUnsoundWithPlaceTimeAndACheckpoint) {
  const fs::path folder = test_folder("flat");
  expect_parts(failure(simulation_of(cracking_bar, {"material.all.density=3.69e18"}), folder),
               {"cell ", "tent at (", " m, t = ", "the energy balance of its solution misses ", "1e-06 is the limit",
                "relaxation time", (folder / "checkpoint.h5").string()});
  EXPECT_FALSE(fs::exists(folder / "summary.json"));
  EXPECT_NO_THROW(read_checkpoint_file(folder / "checkpoint.h5"));
}

/// A body without loads.
std::string free_body(int dimension) {
  std::string min = "0.0", cells = "5", zeros = "\"0\"", sides;
  for (int i = 1; i < dimension; ++i) min += ", 0.0", cells += ", 3", zeros += ", \"0\"";
  const char* const names[] = {"left", "right", "bottom", "top", "back", "front"};
  for (int side = 0; side < 2 * dimension; ++side)
    sides += std::string("[boundary.") + names[side] + "]\ntraction = [" + zeros + "]\n";
  std::string max = min;
  for (char& digit : max) digit = digit == '.' ? '.' : digit == '0' ? '1' : digit;
  return "[domain]\ndimension = " + std::to_string(dimension) + "\nmin = [" + min + "]\nmax = [" + max +
         "]\ncells = [" + cells + "]\n[material.all]\ndensity = 1.0\nyoungs_modulus = 1.0\npoisson_ratio = 0.25\n" +
         sides + "[time]\nend = 0.2\n[discretization]\ndegree = 2\n[run]\nbatch_size = 3\n";
}

// Strains of a body that is far from where it was are rounding; their energies do not balance and mean no fault.
TEST(DisplacedBody, IsNoFault) {
  for (const int dimension : {1, 2, 3}) {
    std::string far = "\"1e5\"";
    for (int i = 1; i < dimension; ++i) far += ", \"-3\"";
    const std::string text = free_body(dimension) + "[initial]\ndisplacement = [" + far + "]\n";
    EXPECT_EQ(failure(simulation_of(text, {}), test_folder("displaced")), "") << dimension;
  }
}

}  // namespace
}  // namespace tentpole
