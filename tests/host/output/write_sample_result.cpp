// write_sample_result FOLDER DIMENSION DEGREE FIELD ORDER_SEED [REPETITIONS]: a complete result folder from a known
// field (FIELD = quadratic or wave) for the Python tests and for looking at scripts/plot.py.
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
#include "tests/host/output/sample_fields.hpp"
#include "tests/host/output/slice_energy.hpp"

namespace {

using namespace tentpole;

constexpr double wave_velocity = 6.1;  // [m/s]
constexpr double wave_ramp = 1e-8;     // [s]

PitchedBox sample_box(int dimension, int degree, bool wave) {
  PitchedBox box;
  box.dimension = dimension;
  box.degree = degree;
  if (!wave) return box;
  box.length = {1e-3, 2e-4, 2e-4};
  box.cells = dimension == 1 ? std::array{60, 1, 1} : dimension == 2 ? std::array{44, 9, 1} : std::array{15, 3, 3};
  box.tent_height = dimension == 3 ? 5e-9 : 2.5e-9;
  box.end = 5e-8;
  return box;
}

RecorderOptions recorder_options(const PitchedBox& box, const std::filesystem::path& folder) {
  RecorderOptions options;
  options.dimension = box.dimension;
  options.degree = box.degree;
  options.folder = folder;
  options.snapshot_times = equally_spaced_times(5, box.end);
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
    const double r = std::min(1.0, (i + 0.5) * step / wave_ramp);
    const double velocity = wave_velocity * r * r * (3 - 2 * r);
    history.add_interval(i * step, (i + 1) * step,
                         {.external_work = 2 * area * impedance * velocity * velocity * step});
  }
}

void write_result(const PitchedBox& box, const PitchedElements& pitched, const std::filesystem::path& folder, bool wave,
                  unsigned seed) {
  Recorder recorder(recorder_options(box, folder));
  History history(folder, box.end / 50, box.end);
  std::vector<std::size_t> order(pitched.elements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  for (const std::size_t index : order) {
    recorder.record(pitched.elements[index]);
    add_history(box, pitched.elements[index], history);
  }
  if (wave) add_end_work(box, history);
  recorder.finish(box.end);
  history.finish(box.end, {.cells = static_cast<std::int64_t>(pitched.elements.size())});
  RunSummary summary;
  summary.title = "sample field";
  summary.dimension = box.dimension;
  summary.degree = box.degree;
  summary.end_time = box.end;
  summary.counts.elements = static_cast<std::int64_t>(pitched.elements.size());
  write_run_summary(folder, summary);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 6) {
    std::cerr << "write_sample_result FOLDER DIMENSION DEGREE quadratic|wave ORDER_SEED [REPETITIONS]\n";
    return 2;
  }
  const bool wave = std::string(arguments[4]) == "wave";
  const PitchedBox box = sample_box(std::atoi(arguments[2]), std::atoi(arguments[3]), wave);
  const double speed = box.material.dilatational_speed();
  const PitchedElements pitched = pitch_elements(
      box, wave ? wave_field(box.length[0], speed, wave_velocity, wave_ramp) : quadratic_field(box.dimension));
  const int repetitions = count > 6 ? std::atoi(arguments[6]) : 1;
  for (int i = 0; i < repetitions; ++i)
    write_result(box, pitched, arguments[1], wave, static_cast<unsigned>(std::atoi(arguments[5])));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
