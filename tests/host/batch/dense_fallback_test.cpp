#include "host/batch/dense_fallback.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "host/batch/batch_runner.hpp"
#include "host/march/batch_builder.hpp"
#include "host/run/make_simulation.hpp"
#include "tests/host/run/sample_cases.hpp"
#include "tests/test_folder.hpp"

namespace tentpole {
namespace {

Simulation sample_simulation(int dimension) {
  const std::filesystem::path folder = test_folder("dense_fallback_" + std::to_string(dimension));
  std::ofstream(folder / "case.toml") << sample_case(dimension);
  return make_simulation(read_case(folder / "case.toml"));
}

/// Solves some batches and hands the last one to `inspect` together with the runner.
template <class Inspect>
void after_some_batches(const Simulation& simulation, const Inspect& inspect) {
  Front front(simulation.mesh, simulation.cell_wave_speed, simulation.settings.front.causality);
  CellSources sources{std::vector<std::int32_t>(simulation.mesh.num_cells(), none),
                      std::vector<std::int32_t>(simulation.mesh.num_cells(), 0)};
  ElementStore store;
  BatchBuilder builder(simulation, front, sources, store);
  StageTimer timer;
  TrafficCounters traffic;
  BatchRunner runner(simulation, host_device(), 1, timer, traffic);
  HostBatch batch;
  for (int i = 0; i < 6; ++i) {
    builder.build(batch, 16);
    ASSERT_FALSE(batch.patches.empty());
    runner.run(batch);
  }
  EXPECT_EQ(runner.num_fallbacks(), 0);
  inspect(batch, runner);
}

std::vector<std::int32_t> source_slots(const HostBatch& batch, const PatchDescriptor& patch, int dimension) {
  std::vector<std::int32_t> slots;
  for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e)
    for (int facet = 0; facet <= dimension + 1; ++facet)
      if (has_source(batch.elements[e], facet)) slots.push_back(batch.elements[e].source_slot[facet]);
  return slots;
}

class DenseFallbackTest : public testing::TestWithParam<int> {};

TEST_P(DenseFallbackTest, GivesWhatThePatchSolverGives) {
  const Simulation simulation = sample_simulation(GetParam());
  const ReferenceTables tables(simulation.dimension(), simulation.degree());
  after_some_batches(simulation, [&](HostBatch& batch, BatchRunner& runner) {
    const PatchDescriptor patch = batch.patches.front();
    std::vector<double> coefficients, inverse_jacobians, solved, solved_jacobians;
    const std::vector<std::int32_t> sources = source_slots(batch, patch, GetParam());
    runner.read_slots(sources, coefficients, inverse_jacobians);
    const std::vector<ElementRecord> before = batch.records;
    for (int e = 0; e < patch.num_elements; ++e)
      batch.records[patch.first_element + e].status = static_cast<int>(Status::residual_too_large);

    DenseFallback fallback(batch, patch, simulation, tables);
    fallback.solve(sources, coefficients, inverse_jacobians);
    runner.read_slots(fallback.result_slots(), solved, solved_jacobians);
    ASSERT_EQ(fallback.coefficients().size(), solved.size());
    double scale = 0, difference = 0;
    for (std::size_t i = 0; i < solved.size(); ++i) {
      scale = std::max(scale, std::fabs(solved[i]));
      difference = std::max(difference, std::fabs(solved[i] - fallback.coefficients()[i]));
    }
    EXPECT_LT(difference, 1e-10 * scale);
    EXPECT_TRUE(std::equal(solved_jacobians.begin(), solved_jacobians.end(), fallback.inverse_jacobians().begin()));
    double largest = 0;
    for (const ElementRecord& record : before) largest = std::max(largest, record.outflow_energy);
    for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e) {
      EXPECT_EQ(batch.records[e].status, static_cast<int>(Status::ok));
      EXPECT_NEAR(batch.records[e].outflow_energy, before[e].outflow_energy, 1e-10 * largest);
      EXPECT_NEAR(batch.records[e].dissipation, before[e].dissipation, 1e-10 * largest);
    }
  });
}

TEST_P(DenseFallbackTest, NamesThePlaceAndTheTimeOfAPatchThatCannotBeSolved) {
  const Simulation simulation = sample_simulation(GetParam());
  const ReferenceTables tables(simulation.dimension(), simulation.degree());
  after_some_batches(simulation, [&](HostBatch& batch, BatchRunner&) {
    const PatchDescriptor patch = batch.patches.front();
    batch.records[patch.first_element].status = static_cast<int>(Status::not_causal);
    DenseFallback fallback(batch, patch, simulation, tables);
    try {
      fallback.solve({}, {}, {});
      FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      for (const char* part : {"cell ", "tent at (", " m, t = ", "outflow facet not causal", "front.causality"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Dimensions, DenseFallbackTest, testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
