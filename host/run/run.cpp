#include "host/run/run.hpp"

#include <chrono>
#include <memory>

#include "host/march/adaptive_march.hpp"
#include "host/march/fixed_march.hpp"
#include "host/output/checkpoint_file.hpp"
#include "host/output/file_identity.hpp"
#include "host/output/output_times.hpp"
#include "host/problem/check_expressions.hpp"
#include "host/run/check_probes.hpp"
#include "host/run/check_workload.hpp"
#include "host/run/checkpoint.hpp"
#include "host/run/out_of_memory.hpp"

namespace tentpole {
namespace {

RecorderOptions recorder_options(const Simulation& simulation, const RunOptions& run, const OutputFolder& folder) {
  const Case& settings = simulation.settings;
  RecorderOptions options;
  options.dimension = simulation.dimension();
  options.degree = simulation.degree();
  options.folder = folder;
  options.plane_stress = settings.materials.begin()->second.plane == Plane::stress;
  options.require_folder = run.require_folder;
  options.snapshot_times = settings.output.snapshot_times;
  options.fields = settings.output.fields;
  for (const ProbeSettings& probe : settings.output.probes)
    options.probes.push_back({probe.name, probe.point, times_at_interval(probe.interval, settings.end_time)});
  return options;
}

void fill_stages(const StageTimer& timer, RunSummary::Stages& stages) {
  const auto put = [&](StageTime& to, Stage stage) { to.seconds = timer.seconds(stage); };
  put(stages.initialization, Stage::initialization);
  put(stages.meshing, Stage::meshing);
  put(stages.assembly, Stage::assembly);
  put(stages.solution, Stage::solution);
  put(stages.post_solution, Stage::post_solution);
  put(stages.transfer, Stage::transfer);
  put(stages.fracture, Stage::fracture);
  put(stages.output, Stage::output);
  put(stages.total, Stage::total);
}

/// Small batches keep an interactive run responsive; a GPU needs many patches in flight.
int batch_size(const Case& settings, const Device& device) {
  if (settings.batch_size > 0) return settings.batch_size;
  return device.kind == DeviceKind::gpu ? 16384 : 512;
}

std::unique_ptr<FrontMarch> make_march(RunBooks& books, const OutputFolder& folder) {
  const Case& settings = books.simulation.settings;
  if (settings.adaptivity.enabled || settings.fracture.enabled) return std::make_unique<AdaptiveMarch>(books, folder);
  return std::make_unique<FixedMarch>(books);
}

std::string other_build_warning(const RunBooks& books) {
  return "resumed from a checkpoint of another build (" + books.builds[books.builds.size() - 2] +
         "): the result may differ in some bits from that of an uninterrupted run.";
}

const Simulation& checked(const Simulation& simulation) {
  check_workload(simulation);
  check_probes(simulation);
  check_expressions(simulation);
  return simulation;
}

/// Everything that a run owns; the parts refer to each other.
class Run {
 public:
  /// All tests come first, then what takes memory; nothing is read or written before open_folder().
  Run(const Simulation& simulation, const RunOptions& options);
  Run(const Run&) = delete;

  /// Prepares the folder, and goes back to the checkpoint where the run is resumed. Call once, before advance().
  void open_folder();
  /// Advances to the end; false if interrupted. Then, at the case's interval, and when it throws, writes a checkpoint.
  bool advance();
  /// Call once, after advance().
  RunSummary summary();
  std::filesystem::path checkpoint_file() const { return folder_ / checkpoint_name; }
  /// After the end: its result is complete, and there is nothing to go on from.
  void finish(const RunSummary& summary);

 private:
  using Clock = std::chrono::steady_clock;

  template <class Step>
  auto saving_after_failure(const Step& step);
  void hold_reserve();
  void save();
  std::string save_after_failure();
  void count_total_time();
  bool checkpoint_is_due() const;

  const Simulation& simulation_;
  const RunOptions& options_;
  const OutputFolder folder_;
  StageTimer timer_;
  TrafficCounters traffic_;
  Clock::time_point counted_ = Clock::now();  ///< up to here the total time is counted
  Clock::time_point last_save_ = Clock::now();
  MemoryReserve reserve_;
  ElementStore store_;
  BatchRunner runner_;
  Recorder recorder_;
  History history_;
  Ledger ledger_;
  RunBooks books_;
  std::unique_ptr<FrontMarch> march_;
};

Run::Run(const Simulation& simulation, const RunOptions& options)
    : simulation_(checked(simulation)),
      options_(options),
      folder_(options.folder),
      runner_(simulation, options.device, options.threads, timer_, traffic_),
      recorder_(recorder_options(simulation, options, folder_)),
      history_(folder_, simulation.settings.output.history_interval, simulation.settings.end_time),
      ledger_(simulation, recorder_, history_),
      books_{simulation, store_, runner_, ledger_, recorder_, history_, timer_, traffic_},
      march_(make_march(books_, folder_)) {}

void Run::open_folder() {
  if (options_.prepare_folder)
    options_.prepare_folder();
  else
    std::filesystem::create_directories(options_.folder);
  folder_.claim();
  if (options_.resume) load_checkpoint(*options_.resume, books_, *march_, options_.any_build);
  if (books_.builds.size() > 1) options_.note(other_build_warning(books_));
  timer_.add(Stage::initialization, Clock::now() - counted_);
}

/// A step of the run; the message of a failure also says how to go on.
template <class Step>
auto Run::saving_after_failure(const Step& step) {
  // The type decides about the exit code, so it stays.
  try {
    return step();
  } catch (const FolderLost&) {
    throw;  // no checkpoint: it would be written into another run's folder
  } catch (const InputError& error) {
    throw InputError(error.what() + save_after_failure());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(error.what() + save_after_failure());
  } catch (const std::bad_alloc& error) {
    throw std::runtime_error(out_of_memory_text(error) + save_after_failure());
  }
}

bool Run::advance() {
  hold_reserve();
  bool interrupted = false;
  AdvanceOptions advance;
  advance.max_patches = batch_size(simulation_.settings, options_.device);
  advance.check = options_.check;
  advance.after_batch = [&](double front_time) {
    hold_reserve();
    options_.report({front_time, simulation_.settings.end_time, ledger_.num_patches(), march_->num_cells()});
    interrupted = interrupted || options_.interrupted();
    return !interrupted && !checkpoint_is_due();
  };
  while (!saving_after_failure([&] { return march_->advance(advance); })) {
    save();
    if (interrupted) return false;
  }
  saving_after_failure([&] { ledger_.require_balance(); });
  return true;
}

/// What a checkpoint takes: elements below the front once as they come and once in the file's contents, output that
/// waits, HDF5's buffers.
void Run::hold_reserve() {
  constexpr std::size_t buffers = 32 << 20;
  const int d = simulation_.dimension() + 1;
  const std::size_t row = simulation_.dimension() * num_polynomials(d, simulation_.degree()) + d * d;
  reserve_.hold(buffers + 4 * row * sizeof(double) * march_->num_cells());
}

bool Run::checkpoint_is_due() const {
  const auto& interval = simulation_.settings.checkpoint_minutes;
  return interval && Clock::now() - last_save_ >= std::chrono::duration<double, std::ratio<60>>(*interval);
}

void Run::save() {
  options_.require_folder();
  count_total_time();
  save_checkpoint(folder_, books_, *march_);
  last_save_ = Clock::now();
}

/// What the message of the failure says about going on.
std::string Run::save_after_failure() {
  if (books_.is_committing) {
    const bool exists = std::filesystem::exists(checkpoint_file());
    return exists ? "\nThe checkpoint " + checkpoint_file().string() + " was written earlier in the run." : "";
  }
  try {
    save();
    return "\nThe state before it is in the checkpoint " + checkpoint_file().string() + ".";
  } catch (const std::exception& error) {
    return std::string("\nNo checkpoint could be written: ") + error.what();
  }
}

void Run::finish(const RunSummary& summary) {
  options_.require_folder();
  write_run_summary(folder_, summary);
  remove_checkpoint_file(folder_);
}

void Run::count_total_time() {
  const Clock::time_point now = Clock::now();
  timer_.add(Stage::total, now - counted_);
  counted_ = now;
}

RunSummary Run::summary() {
  count_total_time();
  RunSummary summary;
  summary.warnings = simulation_.warnings;
  ledger_.fill(summary);
  march_->fill(summary);
  summary.threads = runner_.num_threads();
  summary.counts.dense_fallbacks = books_.num_fallbacks();
  summary.title = simulation_.settings.title;
  summary.dimension = simulation_.dimension();
  summary.degree = simulation_.degree();
  summary.end_time = simulation_.settings.end_time;
  summary.device = options_.device.is_host ? "host" : options_.device.name;
  summary.seed = simulation_.settings.domain.seed;
  summary.traffic = {traffic_.bytes_to_device, traffic_.bytes_from_device, traffic_.launches};
  if (summary.counts.dense_fallbacks > 0)
    summary.warnings.push_back(
        std::to_string(summary.counts.dense_fallbacks) +
        " patches missed the residual tolerance and were solved by pivoted dense LU on the host. "
        "Check the mesh for very flat cells.");
  if (books_.builds.size() > 1) summary.warnings.push_back(other_build_warning(books_));
  fill_stages(timer_, summary.stages);
  return summary;
}

}  // namespace

void prepare_run(const Simulation& simulation, const RunOptions& options) {
  const Run run(simulation, options);
}

RunResult run_simulation(const Simulation& simulation, const RunOptions& options) {
  Run run(simulation, options);
  run.open_folder();
  RunResult result;
  result.interrupted = !run.advance();
  result.summary = run.summary();
  if (result.interrupted) {
    result.checkpoint = run.checkpoint_file();
  } else {
    run.finish(result.summary);
  }
  return result;
}

}  // namespace tentpole
