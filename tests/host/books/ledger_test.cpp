#include "host/books/ledger.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/host/run/solved_run.hpp"
#include "tests/temporary_folder.hpp"

// Batches written down by hand, whose sums are known without solving anything.
namespace tentpole {
namespace {

/// Unit of energy of the bar below; its unit of time is 1/2 s.
constexpr double joule = 3 * 4 * 4 * 2;
constexpr double end_time = 1;  // [s]

Simulation bar() {
  Simulation simulation;
  simulation.mesh.dimension = 1;
  simulation.settings.degree = 2;
  simulation.settings.end_time = end_time;
  simulation.scaling = {.length = 2, .speed = 4, .density = 3, .dimension = 1};
  return simulation;
}

RecorderOptions recorder_options(const TemporaryFolder& folder) {
  RecorderOptions options;
  options.dimension = 1;
  options.degree = 2;
  options.folder = folder.path();
  options.snapshot_times = {0.75};
  return options;
}

/// A ledger whose history has the rows 0, 1/2 and 1 s, and whose recorder takes a snapshot at 3/4 s.
struct Books {
  TemporaryFolder folder;
  Simulation simulation = bar();
  Recorder recorder{recorder_options(folder)};
  History history{folder.path(), 0.5, end_time};
  Ledger ledger{simulation, recorder, history};

  RunSummary summary() const {
    RunSummary summary;
    ledger.fill(summary);
    return summary;
  }
  /// history.csv after the end.
  testing::Table rows() {
    history.finish(end_time, {});
    return testing::read_table(folder.read("history.csv"));
  }
};

/// An element that starts from the initial front.
ElementRecord record(double inflow_energy, double outflow_energy, double external_work = 0, double dissipation = 0) {
  ElementRecord record{};
  record.inflow_energy = record.initial_energy = inflow_energy;
  record.outflow_energy = outflow_energy;
  record.external_work = external_work;
  record.dissipation = dissipation;
  return record;
}

/// Adds a patch of one element between two scaled times.
void add_patch(HostBatch& batch, const ElementRecord& from, double first = 0, double last = 1) {
  ElementDescriptor element{};
  element.corner[1][0] = 1;
  for (int corner = 0; corner < 2; ++corner) element.corner[corner][1] = first;
  element.corner[2][1] = last;
  batch.patches.push_back({.first_element = static_cast<std::int32_t>(batch.elements.size()), .num_elements = 1});
  batch.elements.push_back(element);
  batch.cells.push_back(static_cast<std::int32_t>(40 + batch.cells.size()));
  batch.records.push_back(from);
  batch.energies.push_back({.change = from.outflow_energy - from.inflow_energy,
                            .loss = from.dissipation,
                            .work = from.external_work,
                            .largest = from.inflow_energy});
}

/// Adds a fracture facet to the last patch.
void add_fracture(HostBatch& batch, double fracture_work, double friction_work) {
  PatchDescriptor& patch = batch.patches.back();
  if (patch.num_fractures++ == 0) patch.first_fracture = static_cast<std::int32_t>(batch.fractures.size());
  batch.fractures.emplace_back().element[0] = patch.first_element;
  FractureRecord& record = batch.fracture_records.emplace_back();
  record.fracture_work = fracture_work;
  record.friction_work = friction_work;
}

/// Two patches with everything, the second after the first.
HostBatch two_patches() {
  HostBatch batch;
  add_patch(batch, record(1, 0, 2, 3));
  add_fracture(batch, 4, 5);
  add_patch(batch, record(10, 0, -20, 30), 1, 2);
  add_fracture(batch, 20, 25);
  add_fracture(batch, 20, 25);
  batch.slice_requests = {{0, 1}, {1, 2}};
  batch.slice_rows = {1, 2};
  batch.slice_energies = {6, 7, 60, 70};
  return batch;
}

/// The energies of a summary in scaled units, as the tests list them.
std::vector<double> scaled_energies(const RunSummary& summary) {
  const RunSummary::Energy& e = summary.energy;
  std::vector<double> values{e.initial, e.external_work, e.numerical, e.fracture, e.friction, e.kinetic, e.strain};
  for (double& value : values) value /= joule;
  return values;
}

TEST(Ledger, AddsUpWhatItsPatchesSayInJoule) {
  Books books;
  books.ledger.commit(two_patches(), false);
  EXPECT_EQ(scaled_energies(books.summary()), (std::vector<double>{11, -18, 33, 44, 55, 60, 70}))
      << "kinetic and strain energy are those at the end";
  EXPECT_EQ(books.summary().counts.patches, 2);
  EXPECT_EQ(books.summary().counts.elements, 2);
  EXPECT_EQ(books.summary().counts.dofs, 12) << "six polynomials of degree 2 in x and t";
  EXPECT_EQ(books.summary().counts.batches, 1);
  // The first patch goes from 0 to 1/2 s, the second from there to 1 s.
  const testing::Table rows = books.rows();
  EXPECT_EQ(rows.at("external_work"), (std::vector<double>{0, 2 * joule, -18 * joule}));
  EXPECT_EQ(rows.at("friction"), (std::vector<double>{0, 5 * joule, 55 * joule}));
  EXPECT_EQ(rows.at("strain"), (std::vector<double>{0, 7 * joule, 70 * joule}));
}

TEST(Ledger, TakesNothingFromPatchesThatAreNotAccepted) {
  Books first, second;
  first.ledger.commit(two_patches(), false, std::vector<std::uint8_t>{1, 0});
  second.ledger.commit(two_patches(), false, std::vector<std::uint8_t>{0, 1});
  EXPECT_EQ(scaled_energies(first.summary()), (std::vector<double>{1, 2, 3, 4, 5, 0, 0}));
  EXPECT_EQ(scaled_energies(second.summary()), (std::vector<double>{10, -20, 30, 40, 50, 60, 70}));
  EXPECT_EQ(first.summary().counts.patches, 1);
}

TEST(Ledger, SumsAreExactWhateverTheOrderOfPatchesAndBatches) {
  const double works[] = {1e16, 1, -1e16};  // summed as they come: 0
  for (const std::vector<int>& order : {std::vector{0, 1, 2}, std::vector{1, 0, 2}, std::vector{2, 1, 0}}) {
    Books books;
    HostBatch early, late;
    for (const int patch : order) add_patch(patch == order[0] ? early : late, record(0, 0, works[patch] / joule));
    for (const HostBatch* batch : {&early, &late}) books.ledger.commit(*batch, false);
    EXPECT_DOUBLE_EQ(books.summary().energy.external_work, 1);
  }
}

TEST(Ledger, AsksForTheSlicesOfTheHistoryAndTheElementsOfTheSnapshot) {
  Books books;
  HostBatch batch;
  const double times[][2] = {{0, 1}, {1, 2}, {1, 1.25}, {0.5, 2}};
  for (const auto& [first, last] : times) add_patch(batch, {}, first, last);
  books.ledger.mark_wanted(batch);
  EXPECT_EQ(batch.wanted, (std::vector<std::int32_t>{1, 3})) << "those that contain 3/4 s";
  std::vector<std::pair<std::int32_t, double>> requests;
  for (const SliceRequest& request : batch.slice_requests) requests.emplace_back(request.element, request.time);
  // An element answers for its last time and not for its first, except at the beginning.
  EXPECT_EQ(requests, (std::vector<std::pair<std::int32_t, double>>{{0, 0}, {0, 1}, {1, 2}, {3, 1}, {3, 2}}));
  EXPECT_EQ(batch.slice_rows, (std::vector<std::int32_t>{0, 1, 2, 1, 2}));
}

TEST(Ledger, MeasuresImbalanceAndGainByTheLargestEnergyThroughAnElement) {
  HostBatch batch;
  add_patch(batch, record(1, 1.5, 0.25, 0.125));
  add_patch(batch, record(4, 3));
  Books books;
  books.ledger.commit(batch, false);
  EXPECT_EQ(books.ledger.largest_imbalance(), 1 / 4.0) << "a loss that nothing explains";
  EXPECT_EQ(books.ledger.largest_increase(), (0.5 - 0.25) / 4) << "beyond the work, whatever was lost";
  EXPECT_EQ(books.ledger.energy_scale(), 4);
  Books only_first;
  only_first.ledger.commit(batch, false, std::vector<std::uint8_t>{1, 0});
  EXPECT_EQ(only_first.ledger.largest_imbalance(), (0.5 + 0.125 - 0.25) / 1.5);
}

TEST(Ledger, RefusesAPatchOutOfBalanceOnlyWhereItIsAskedToLook) {
  HostBatch sound, unsound;
  add_patch(sound, record(1, 1 + 0.9e-9));
  for (const double energy : {1.0, 1 + 1.1e-9}) add_patch(unsound, record(1, energy));
  EXPECT_NO_THROW(Books().ledger.commit(sound, true));
  EXPECT_NO_THROW(Books().ledger.commit(unsound, false));
  EXPECT_NO_THROW(Books().ledger.commit(unsound, true, std::vector<std::uint8_t>{1, 0}));
  try {
    Books().ledger.commit(unsound, true);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("cell 41"), std::string::npos) << error.what();
  }
}

TEST(Ledger, GoesOnFromASavedOneAsIfItHadNotStopped) {
  Books whole, before, after;
  HostBatch later;
  add_patch(later, record(4, 3));
  std::stringstream saved;
  whole.ledger.commit(two_patches(), false);
  before.ledger.commit(two_patches(), false);
  before.ledger.save(saved);
  after.ledger.load(saved);
  for (Books* books : {&whole, &after}) books->ledger.commit(later, false);
  EXPECT_EQ(scaled_energies(after.summary()), scaled_energies(whole.summary()));
  EXPECT_EQ(after.summary().counts.patches, 3);
  EXPECT_EQ(after.summary().counts.batches, 2);
  EXPECT_EQ(after.ledger.largest_imbalance(), whole.ledger.largest_imbalance());
  EXPECT_EQ(after.ledger.energy_scale(), whole.ledger.energy_scale());
}

}  // namespace
}  // namespace tentpole
