// write_sample_result FOLDER DIMENSION DEGREE FIELD ORDER_SEED [REPETITIONS]: a complete result folder from a known
// field (FIELD = quadratic, wave or crack) for the Python tests and for looking at scripts/plot.py.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <random>
#include <string>

#include "host/output/history.hpp"
#include "host/output/output_times.hpp"
#include "host/output/recorder.hpp"
#include "host/output/run_summary.hpp"
#include "tests/host/output/sample_crack.hpp"
#include "tests/host/output/sample_fields.hpp"
#include "tests/host/output/slice_energy.hpp"

namespace {

using namespace tentpole;

enum class SampleField { quadratic, wave, crack };

constexpr SampleCrack sample_crack;

PitchedBox sample_box(int dimension, int degree, SampleField field) {
  PitchedBox box;
  box.dimension = dimension;
  box.degree = degree;
  if (field == SampleField::quadratic) return box;
  box.length = {1e-3, 2e-4, 2e-4};
  box.cells = dimension == 1 ? std::array{60, 1, 1} : dimension == 2 ? std::array{44, 9, 1} : std::array{15, 3, 3};
  box.tent_height = dimension == 3 ? 5e-9 : 2.5e-9;
  box.end = field == SampleField::crack ? 1.1e-7 : 5e-8;
  return box;
}

RecorderOptions recorder_options(const PitchedBox& box, const std::filesystem::path& folder, int num_snapshots) {
  RecorderOptions options;
  options.dimension = box.dimension;
  options.degree = box.degree;
  options.folder = folder;
  options.snapshot_times = equally_spaced_times(num_snapshots, box.end);
  options.fields = {"displacement", "velocity", "stress", "strain_energy_density", "damage"};
  std::array<double, 3> middle = box.length;
  for (double& x : middle) x *= 0.5;
  options.probes = {{"middle", middle, times_at_interval(box.end / 50, box.end)},
                    {"corner", {0, 0, 0}, times_at_interval(box.end / 50, box.end)}};
  return options;
}

void add_history(const PitchedBox& box, const SpacetimeElement& element, History& history) {
  static const OrthonormalBasis basis(box.dimension + 1, box.degree);
  static const Quadrature rule = simplex_quadrature(box.dimension, 2 * (box.degree - 1));
  const OutputRange rows = history.rows(element.time_min(), element.time_max());
  for (int row = rows.first; row < rows.last; ++row) {
    const SliceEnergy energy = slice_energy(basis, rule, element, history.times()[row]);
    history.add_energy(row, energy.kinetic, energy.strain);
  }
}

/// Work of the pulled ends, 2 Z v^2 per area and time, for the wave with these constants.
void add_end_work(const PitchedBox& box, History& history) {
  const double impedance = box.material.density * box.material.dilatational_speed();
  double area = 1;
  for (int i = 1; i < box.dimension; ++i) area *= box.length[i];
  const int num_steps = 1000;
  const double step = box.end / num_steps;
  for (int i = 0; i < num_steps; ++i) {
    const double r = std::min(1.0, (i + 0.5) * step / sample_crack.ramp);
    const double velocity = sample_crack.velocity * r * r * (3 - 2 * r);
    history.add_interval(i * step, (i + 1) * step,
                         {.external_work = 2 * area * impedance * velocity * velocity * step});
  }
}

/// The crack at all output times, and the rows of the history with it.
void add_crack(const PitchedBox& box, const PitchedElements& pitched, const RecorderOptions& options,
               History& history) {
  CrackSeries cracks({.dimension = box.dimension, .folder = options.folder, .times = options.snapshot_times});
  const double fracture_energy = 6 * (box.dimension == 1 ? 1 : box.length[1]);  // 6 J/m^2, any number
  history.add_interval(sample_crack.start, box.end, {.fracture = fracture_energy});
  for (std::size_t file = 0; file < options.snapshot_times.size(); ++file)
    for (const CrackSegment& segment : crack_segments(box, pitched, sample_crack, options.snapshot_times[file]))
      cracks.add(static_cast<int>(file), segment);
  cracks.finish(box.end);
  std::size_t num_before = 0;
  for (int row = 0; row < std::ssize(history.times()); ++row) {
    const double time = history.times()[row];
    const std::vector<CrackSegment> segments = crack_segments(box, pitched, sample_crack, time);
    add_surfaces(box.dimension, segments, row, history);
    for (; num_before < segments.size(); ++num_before)
      history.add_event(num_before == 0 ? CrackEvent::nucleation : CrackEvent::extension, time);
    history.finish(time, front_state(segments, pitched));
  }
}

void write_result(const PitchedBox& box, const PitchedElements& pitched, const std::filesystem::path& folder,
                  SampleField field, unsigned seed) {
  std::filesystem::create_directories(folder);
  const RecorderOptions options = recorder_options(box, folder, field == SampleField::crack ? 11 : 5);
  Recorder recorder(options);
  History history(folder, box.end / 50, box.end);
  std::vector<std::size_t> order(pitched.elements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  for (const std::size_t index : order) {
    recorder.record(pitched.elements[index]);
    add_history(box, pitched.elements[index], history);
  }
  if (field != SampleField::quadratic) add_end_work(box, history);
  recorder.finish(box.end);
  if (field == SampleField::crack) add_crack(box, pitched, options, history);
  history.finish(box.end, {.cells = static_cast<std::int64_t>(pitched.elements.size())});
  RunSummary summary;
  summary.title = "sample field";
  summary.dimension = box.dimension;
  summary.degree = box.degree;
  summary.end_time = box.end;
  summary.counts.elements = static_cast<std::int64_t>(pitched.elements.size());
  write_run_summary(folder, summary);
}

PitchedElements pitch_sample(const PitchedBox& box, SampleField field) {
  if (field == SampleField::crack) return pitch_cracked(box, sample_crack);
  const double speed = box.material.dilatational_speed();
  return pitch_elements(box, field == SampleField::wave
                                 ? wave_field(box.length[0], speed, sample_crack.velocity, sample_crack.ramp)
                                 : quadratic_field(box.dimension));
}

SampleField field_named(const std::string& name) {
  if (name == "wave") return SampleField::wave;
  return name == "crack" ? SampleField::crack : SampleField::quadratic;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 6) {
    std::cerr << "write_sample_result FOLDER DIMENSION DEGREE quadratic|wave|crack ORDER_SEED [REPETITIONS]\n";
    return 2;
  }
  const SampleField field = field_named(arguments[4]);
  const PitchedBox box = sample_box(std::atoi(arguments[2]), std::atoi(arguments[3]), field);
  const PitchedElements pitched = pitch_sample(box, field);
  const int repetitions = count > 6 ? std::atoi(arguments[6]) : 1;
  for (int i = 0; i < repetitions; ++i)
    write_result(box, pitched, arguments[1], field, static_cast<unsigned>(std::atoi(arguments[5])));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
