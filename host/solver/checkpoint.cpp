#include "host/solver/checkpoint.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

#include "host/solver/result_settings.hpp"

namespace tentpole {
namespace {

template <class Book>
std::string saved(const Book& book) {
  std::ostringstream stream(std::ios::binary);
  book.save(stream);
  return std::move(stream).str();
}

template <class Book>
void restore(Book& book, const std::string& bytes, const char* name) {
  std::istringstream stream(bytes, std::ios::binary);
  book.load(stream);
  if (stream.peek() != std::istringstream::traits_type::eof())
    throw std::runtime_error(std::string("its ") + name + " was written by another version of the program");
}

/// Rows cross the border in pieces, so that packing them takes little memory on the device.
constexpr std::size_t rows_per_transfer = 1 << 16;

void read_elements(BatchRunner& runner, std::span<const std::int32_t> slots, CheckpointContents& contents) {
  std::vector<double> coefficients, inverse_jacobians;
  for (std::size_t first = 0; first < slots.size(); first += rows_per_transfer) {
    runner.read_slots(slots.subspan(first, std::min(rows_per_transfer, slots.size() - first)), coefficients,
                      inverse_jacobians);
    contents.coefficients.insert(contents.coefficients.end(), coefficients.begin(), coefficients.end());
    contents.inverse_jacobians.insert(contents.inverse_jacobians.end(), inverse_jacobians.begin(),
                                      inverse_jacobians.end());
  }
}

void write_elements(BatchRunner& runner, std::span<const std::int32_t> slots, const CheckpointContents& contents) {
  if (slots.empty()) return;
  const std::span<const double> coefficients = contents.coefficients, inverse_jacobians = contents.inverse_jacobians;
  const std::size_t n = coefficients.size() / slots.size(), d2 = inverse_jacobians.size() / slots.size();
  for (std::size_t first = 0; first < slots.size(); first += rows_per_transfer) {
    const std::size_t count = std::min(rows_per_transfer, slots.size() - first);
    runner.write_slots(slots.subspan(first, count), coefficients.subspan(first * n, count * n),
                       inverse_jacobians.subspan(first * d2, count * d2));
  }
}

/// Numbers the elements in use 0, 1, .. in the order of their cells; returns the slots that hold them.
std::vector<std::int32_t> renumber(const CellSources& sources, std::vector<std::int32_t>& cell_element) {
  std::vector<std::int32_t> slots;
  cell_element.assign(sources.slot.size(), none);
  for (std::size_t cell = 0; cell < sources.slot.size(); ++cell) {
    if (sources.slot[cell] == none) continue;
    cell_element[cell] = static_cast<std::int32_t>(slots.size());
    slots.push_back(sources.slot[cell]);
  }
  return slots;
}

/// The arrays have checksums; this finds a file that a faulty program wrote.
void check_shapes(const CheckpointContents& contents, const Simulation& simulation) {
  const std::size_t num_cells = simulation.mesh.cells.size(), d = simulation.dimension() + 1;
  std::size_t num_elements = 0, num_basis = 1;
  bool fits = contents.front_times.size() == simulation.mesh.vertices.size() &&
              contents.cell_element.size() == num_cells && contents.cell_pole.size() == num_cells;
  for (std::size_t cell = 0; fits && cell < num_cells; ++cell) {
    const std::int32_t element = contents.cell_element[cell], pole = contents.cell_pole[cell];
    if (element != none) fits = element == static_cast<std::int32_t>(num_elements++);
    fits = fits && pole >= 0 && pole < static_cast<std::int32_t>(d);
  }
  for (std::size_t i = 1; i <= d; ++i) num_basis = num_basis * (simulation.degree() + i) / i;  // binomial(k + d, d)
  fits = fits && contents.coefficients.size() == num_elements * num_basis * simulation.dimension() &&
         contents.inverse_jacobians.size() == num_elements * d * d && contents.stage_seconds.size() == num_stages &&
         contents.run_counts.size() == 4;
  if (!fits) throw std::runtime_error("its arrays do not fit together");
}

void restore_totals(const CheckpointContents& contents, SolverState& state) {
  for (int stage = 0; stage < num_stages; ++stage)
    state.timer.add(static_cast<Stage>(stage), std::chrono::duration_cast<std::chrono::nanoseconds>(
                                                   std::chrono::duration<double>(contents.stage_seconds[stage])));
  state.traffic.bytes_to_device += contents.run_counts[0];
  state.traffic.bytes_from_device += contents.run_counts[1];
  state.traffic.launches += contents.run_counts[2];
  state.earlier_fallbacks = contents.run_counts[3];
}

/// Waits until the rows of all tables in the folder are on the disk.
void flush_tables(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    const int descriptor = open(entry.path().c_str(), O_RDONLY);
    if (descriptor < 0 || fsync(descriptor) != 0) {
      if (descriptor >= 0) close(descriptor);
      throw std::runtime_error(entry.path().string() + ": cannot be flushed to the disk. Check the free space.");
    }
    close(descriptor);
  }
}

}  // namespace

void save_checkpoint(const std::filesystem::path& file, const std::filesystem::path& result_folder,
                     SolverState& state) {
  const ScopedStage stage(state.timer, Stage::output);
  CheckpointContents contents;
  contents.settings = result_settings(state.simulation);
  contents.front_times.assign(state.front.times().begin(), state.front.times().end());
  const std::vector<std::int32_t> slots = renumber(state.sources, contents.cell_element);
  contents.cell_pole = state.sources.pole;
  read_elements(state.runner, slots, contents);
  contents.ledger = saved(state.ledger);
  contents.recorder = saved(state.recorder);
  contents.history = saved(state.history);
  for (int i = 0; i < num_stages; ++i) contents.stage_seconds.push_back(state.timer.seconds(static_cast<Stage>(i)));
  contents.run_counts = {state.traffic.bytes_to_device, state.traffic.bytes_from_device, state.traffic.launches,
                         state.num_fallbacks()};
  flush_tables(result_folder);
  write_checkpoint_file(file, contents);
}

void load_checkpoint(const std::filesystem::path& file, SolverState& state) {
  const CheckpointContents contents = read_checkpoint_file(file);
  const std::string difference = first_difference(contents.settings, result_settings(state.simulation));
  if (!difference.empty())
    throw InputError(file.string() + ": belongs to a run with other settings: " + difference +
                     ". Resume with the case file and the --set and --seed of that run, or start anew.");
  try {
    check_shapes(contents, state.simulation);
    state.front.set_times(contents.front_times);
    restore(state.ledger, contents.ledger, "ledger");
    restore(state.recorder, contents.recorder, "recorder");
    restore(state.history, contents.history, "history");
  } catch (const std::exception& error) {
    throw InputError(file.string() + ": cannot be resumed: " + error.what());
  }
  state.sources.slot = contents.cell_element;
  state.sources.pole = contents.cell_pole;
  const auto used = [](std::int32_t slot) { return slot != none; };
  std::vector<std::int32_t> slots(std::count_if(state.sources.slot.begin(), state.sources.slot.end(), used));
  for (std::int32_t& slot : slots) slot = state.store.acquire();
  write_elements(state.runner, slots, contents);
  restore_totals(contents, state);
}

}  // namespace tentpole
