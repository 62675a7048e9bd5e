#include "host/batch/patch_scratch.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

Device gpu_of(int num_multiprocessors) {
  return {0, false, DeviceKind::gpu, "GPU", 1, num_multiprocessors};
}

TEST(DeviceShape, OfACpuIsThreads) {
  Device device = host_device();
  device.num_threads = 5;
  EXPECT_EQ(device_shape(device, 3).workers, 3);
  EXPECT_EQ(device_shape(device, 0).workers, 5);
  EXPECT_EQ(device_shape(device, 0).lanes, 1);
}

/// 65536 registers of a multiprocessor at 128 a lane: 16 warps.
TEST(DeviceShape, OfAGpuIsWhatItsRegistersKeepResident) {
  const LaunchShape shape = device_shape(gpu_of(132), 7);
  EXPECT_EQ(shape.lanes, 32);
  EXPECT_EQ(shape.workers, 2112);
  EXPECT_EQ(device_shape(gpu_of(78), 0).workers, 1248);
  EXPECT_EQ(device_shape(gpu_of(0), 0).workers, 2112);
}

TEST(AffordableWorkers, TakeThreeFifthsOfTheFreeMemoryAtMost) {
  EXPECT_EQ(affordable_workers(2112, 1'000, 1'000'000'000, "GPU"), 2112);
  EXPECT_EQ(affordable_workers(2112, 1'000'000, 1'000'000'000, "GPU"), 600);
  EXPECT_EQ(affordable_workers(2112, 600'000'000, 1'000'000'000, "GPU"), 1);
}

TEST(AffordableWorkers, RefuseAPatchThatFitsNowhereWithFiguresAndAWayOut) {
  try {
    affordable_workers(4, 600'000'001, 1'000'000'000, "GPU: Small One");
    FAIL() << "was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        error.what(),
        "one patch of this case needs 601 MB of scratch, but of the memory of GPU: Small One 1000 MB are free, of "
        "which 60 % may be taken. Lower discretization.degree, free memory there, or run without --offload.");
  }
}

/// What 1056 fixed teams once asked for: 272 GB at D = 3, k = 6, where a GPU has 80.
TEST(PatchScratch, NeverAsksForMoreThanItsShareAtAnyDegree) {
  constexpr std::int64_t gpu_memory = 80'000'000'000;
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (int degree = 1; degree <= max_degree; ++degree) {
      ReferenceTablesView tables{};
      tables.dimension = dimension;
      tables.degree = degree;
      tables.num_basis = num_polynomials(dimension + 1, degree);
      tables.num_unknowns = dimension * tables.num_basis;
      tables.num_facet_modes = num_polynomials(dimension, degree - 1);
      tables.num_volume_modes = num_polynomials(dimension + 1, degree - 1);
      tables.num_curvature_modes = num_polynomials(dimension + 1, degree - 2);
      tables.basis_stride = (tables.num_basis + 3) / 4 * 4;
      tables.facet_stride = (tables.num_facet_modes + 3) / 4 * 4;
      PatchDescriptor patch;
      patch.num_elements = dimension == 3 ? 24 : 6;
      const std::int64_t bytes = 8 * patch_scratch_size(tables, patch, 32);
      const int workers = affordable_workers(device_shape(gpu_of(132), 0).workers, bytes, gpu_memory, "GPU");
      EXPECT_GE(workers, 1) << "D = " << dimension << ", k = " << degree;
      EXPECT_LE(workers * bytes, gpu_memory / 5 * 3) << "D = " << dimension << ", k = " << degree;
    }
}

/// Patches of one element, which even the highest degree solves in a moment.
TentBatch single_elements(int dimension, int degree, int num_patches) {
  std::mt19937 generator(7);
  TentBatch batch;
  batch.dimension = dimension;
  batch.degree = degree;
  batch.materials.push_back(random_material(generator));
  const std::vector<PolynomialField> fields{PolynomialField::random(dimension, 1, generator)};  // few terms to evaluate
  TentData data;
  data.source_fraction = 0;
  data.normal_kind = data.tangential_kind = BoundaryKind::absorbing;
  for (int patch = 0; patch < num_patches; ++patch) {
    TentGeometry tent = random_star(dimension, false, {}, generator);
    tent.cells.resize(1);
    raise_tent(tent, {batch.materials[0].dilatational_speed()}, 0.6, 0.9, generator);
    append_tent(batch, tent, {0}, fields, data, generator);
  }
  return batch;
}

/// Room for one and a half of the four workers: one solves all patches.
TEST(PatchScratch, LargePatchesAreSolvedByFewerWorkers) {
  const std::vector<Device> devices = available_devices();
  const Device device = devices.empty() ? host_device() : select_device(std::nullopt);
  const int lanes = device.kind == DeviceKind::gpu ? 32 : 1;
  TentBatch batch = single_elements(3, 7, 2);
  DeviceTents tents(batch, device);
  TrafficCounters traffic;
  PatchSolverTask task{};
  task.batch = tents.view();
  task.tables = tents.tables();
  const std::int64_t worker = 8 * patch_scratch_size(task.tables, batch.patches, lanes);
  PatchScratch scratch(device, traffic, {4, lanes}, worker * 3 / 2 * 5 / 3 + 8);
  scratch.prepare(batch.patches, task);
  EXPECT_EQ(scratch.num_workers(), 1);
  EXPECT_EQ(task.shape.workers, 1);
  if (device.is_host)
    solve_patches_host(task);
  else
    solve_patches_device(task, device.number);
  tents.download(batch);
  for (const ElementRecord& record : batch.records) EXPECT_EQ(record.status, int(Status::ok));
  for (std::size_t i = 0; i < batch.exact.size(); ++i) ASSERT_NEAR(batch.coefficients[i], batch.exact[i], 1e-8);
  EXPECT_GT(scratch.total_cycles().solution, 0);
}

TEST(PatchScratch, GrowsWithTheLargestPatchAndForgetsTheCyclesOfEarlierTasks) {
  const TentBatch batch = single_elements(2, 2, 5);
  const ReferenceTables tables(2, 2);
  TrafficCounters traffic;
  PatchScratch scratch(host_device(), traffic, {3, 1});
  PatchSolverTask task{};
  task.tables = tables.view();
  scratch.prepare(batch.patches, task);
  const long small = task.scratch_stride;
  EXPECT_EQ(task.shape.workers, 3);
  std::vector<PatchDescriptor> larger = batch.patches;
  larger[2].num_elements = 6;
  scratch.prepare(larger, task);
  EXPECT_GT(task.scratch_stride, small);
  scratch.prepare(batch.patches, task);
  EXPECT_GT(task.scratch_stride, small) << "what there is stays";
  task.cycles[1].assembly = 5;
  EXPECT_EQ(scratch.total_cycles().assembly, 5);
  scratch.prepare({}, task);
  EXPECT_EQ(scratch.total_cycles().assembly, 0);
}

}  // namespace
}  // namespace tentpole
