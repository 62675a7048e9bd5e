#include "host/run/checkpoint.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <new>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

#include "common/binary_stream.hpp"
#include "host/output/file_identity.hpp"
#include "host/run/result_settings.hpp"

namespace tentpole {
namespace {

template <class Book>
std::string saved(const Book& book) {
  std::ostringstream stream(std::ios::binary);
  book.save(stream);
  return std::move(stream).str();
}

/// A step of loading; what it throws names the section.
template <class Step>
void in_section(const char* name, const Step& step) {
  try {
    step();
  } catch (const std::bad_alloc&) {
    throw;  // the file may be as sound as large
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("section \"") + name + "\", " + error.what());
  }
}

template <class Book>
void restore(Book& book, const std::string& bytes, const char* name) {
  std::istringstream stream(bytes, std::ios::binary);
  in_section(name, [&] {
    book.load(stream);
    require_sound(stream, bytes_left(stream) == 0, "bytes are left over");
  });
}

/// Rows cross the border in pieces, so that packing them takes little memory on the device.
constexpr std::size_t rows_per_transfer = 1 << 16;

void read_elements(BatchRunner& runner, std::span<const std::int32_t> slots, CheckpointContents& contents) {
  std::vector<double> coefficients, inverse_jacobians;
  for (std::size_t first = 0; first < slots.size(); first += rows_per_transfer) {
    const std::size_t count = std::min(rows_per_transfer, slots.size() - first);
    runner.read_slots(slots.subspan(first, count), coefficients, inverse_jacobians);
    contents.coefficients.reserve(coefficients.size() / count * slots.size());
    contents.inverse_jacobians.reserve(inverse_jacobians.size() / count * slots.size());
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

constexpr double longest_run = 3.2e9;  ///< [s]; nanoseconds of it fit 64 bits

/// The arrays have checksums; this finds a file that a faulty program wrote. `num_rows`: elements that cells refer to.
void check_shapes(const CheckpointContents& contents, const Simulation& simulation, std::size_t num_rows) {
  const std::size_t d = simulation.dimension() + 1,
                    num_basis = num_polynomials(simulation.dimension() + 1, simulation.degree());
  const bool fits = contents.coefficients.size() == num_rows * num_basis * simulation.dimension() &&
                    contents.inverse_jacobians.size() == num_rows * d * d &&
                    contents.stage_seconds.size() == num_stages && contents.run_counts.size() == 4;
  if (!fits) throw std::runtime_error("its arrays do not fit together");
  const auto require = [](bool holds, const char* section, const char* fault) {
    if (!holds) throw std::runtime_error(std::string("section \"") + section + "\", " + fault);
  };
  require(all_finite(contents.coefficients), "coefficients", "a number is not finite");
  require(all_finite(contents.inverse_jacobians), "inverse_jacobians", "a number is not finite");
  for (const double seconds : contents.stage_seconds)
    require(seconds >= 0 && seconds <= longest_run, "stage_seconds", "a time is negative or longer than a century");
  for (const std::int64_t count : contents.run_counts) require(count >= 0, "run_counts", "a count is negative");
}

void restore_totals(const CheckpointContents& contents, RunBooks& books) {
  for (int stage = 0; stage < num_stages; ++stage)
    books.timer.add(static_cast<Stage>(stage), std::chrono::duration_cast<std::chrono::nanoseconds>(
                                                   std::chrono::duration<double>(contents.stage_seconds[stage])));
  books.traffic.bytes_to_device += contents.run_counts[0];
  books.traffic.bytes_from_device += contents.run_counts[1];
  books.traffic.launches += contents.run_counts[2];
  books.earlier_fallbacks = contents.run_counts[3];
  if (contents.builds.empty() || contents.builds.back() != books.builds.back())
    books.builds.insert(books.builds.begin(), contents.builds.begin(), contents.builds.end());
  else
    books.builds = contents.builds;
}

void require_same_build(const std::filesystem::path& file, const std::vector<std::string>& builds,
                        const std::string& here) {
  const std::string there = builds.empty() ? "an unknown program" : builds.back();
  if (there != here)
    throw InputError(
        file.string() + ": was written by another build of the program, which may round differently:\n  " + there +
        "\nThis is\n  " + here +
        "\nResume with that program, or with --force; then the result may differ in some bits from that of "
        "an uninterrupted run.");
}

/// Before anything is written: a run whose earlier output is gone would end with an incomplete result.
void require_output(const RunBooks& books, const FrontMarch& march) {
  WrittenFiles files;
  books.recorder.add_written(files);
  books.history.add_written(files);
  march.add_written(files);
  require_written(files);
}

/// Waits until the rows of all tables in the folder are on the disk.
void flush_tables(const OutputFolder& folder) {
  const Descriptor directory = folder.open();
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (entry.path().extension() != ".csv") continue;
    const Descriptor table(openat(directory, entry.path().filename().c_str(), O_RDONLY | O_CLOEXEC));
    if (table < 0 || fsync(table) != 0)
      throw std::runtime_error(entry.path().string() + ": cannot be flushed to the disk. Check the free space.");
  }
}

}  // namespace

void save_checkpoint(const OutputFolder& folder, RunBooks& books, const FrontMarch& march) {
  const ScopedStage stage(books.timer, Stage::output);
  CheckpointContents contents;
  contents.builds = books.builds;
  contents.settings = result_settings(books.simulation);
  read_elements(books.runner, march.save(contents), contents);
  contents.ledger = saved(books.ledger);
  contents.recorder = saved(books.recorder);
  contents.history = saved(books.history);
  for (int i = 0; i < num_stages; ++i) contents.stage_seconds.push_back(books.timer.seconds(static_cast<Stage>(i)));
  contents.run_counts = {books.traffic.bytes_to_device, books.traffic.bytes_from_device, books.traffic.launches,
                         books.num_fallbacks()};
  try {
    flush_tables(folder);
  } catch (const std::runtime_error&) {
    folder.open();  // that it is lost says more than that a table is
    throw;
  }
  write_checkpoint_file(folder, contents);
}

void load_checkpoint(const std::filesystem::path& file, RunBooks& books, FrontMarch& march, bool any_build) {
  restore_checkpoint(file, read_checkpoint_file(file), books, march, any_build);
}

void restore_checkpoint(const std::filesystem::path& file, const CheckpointContents& contents, RunBooks& books,
                        FrontMarch& march, bool any_build) {
  const std::string difference = first_difference(contents.settings, result_settings(books.simulation));
  if (!difference.empty())
    throw InputError(file.string() + ": belongs to a run with other settings: " + difference +
                     ". Resume with the case file and the --set and --seed of that run, or start anew.");
  if (!any_build) require_same_build(file, contents.builds, books.builds.back());
  std::vector<std::int32_t> slots;
  try {
    in_section("march", [&] { slots = march.load(contents); });
    check_shapes(contents, books.simulation, slots.size());
    restore(books.ledger, contents.ledger, "ledger");
    restore(books.recorder, contents.recorder, "recorder");
    restore(books.history, contents.history, "history");
    require_output(books, march);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(file.string() + ": cannot be resumed: " + error.what());
  }
  write_elements(books.runner, slots, contents);
  restore_totals(contents, books);
}

}  // namespace tentpole
