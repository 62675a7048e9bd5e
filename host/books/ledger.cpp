#include "host/books/ledger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "common/binary_stream.hpp"
#include "host/batch/energy_balance.hpp"
#include "host/field/solved_element.hpp"

namespace tentpole {
namespace {

struct TimeRange {
  double first, last;  ///< [s]
};

struct ScaledTimes {
  double first, last;
};

ScaledTimes scaled_times(const ElementDescriptor& element, int dimension) {
  ScaledTimes times{element.corner[0][dimension], element.corner[0][dimension]};
  for (int corner = 1; corner <= dimension + 1; ++corner) {
    times.first = std::min(times.first, element.corner[corner][dimension]);
    times.last = std::max(times.last, element.corner[corner][dimension]);
  }
  return times;
}

TimeRange time_range(const Simulation& simulation, const ElementDescriptor& element) {
  const ScaledTimes scaled = scaled_times(element, simulation.dimension());
  return {simulation.time_in_seconds(scaled.first), simulation.time_in_seconds(scaled.last)};
}

}  // namespace

Ledger::Ledger(const Simulation& simulation, Recorder& recorder, History& history)
    : simulation_(simulation),
      recorder_(recorder),
      history_(history),
      errors_(simulation.settings.exact_displacement, simulation.dimension(), simulation.degree()),
      basis_(simulation.dimension() + 1, simulation.degree()) {}

void Ledger::mark_wanted(HostBatch& batch) const {
  const int dimension = simulation_.dimension();
  for (std::size_t e = 0; e < batch.elements.size(); ++e) {
    const ElementDescriptor& element = batch.elements[e];
    const TimeRange range = time_range(simulation_, element);
    std::array<double, 3> lower, upper;
    for (int axis = 0; axis < dimension; ++axis) {
      lower[axis] = upper[axis] = element.corner[0][axis];
      for (int corner = 1; corner <= dimension + 1; ++corner) {
        lower[axis] = std::min(lower[axis], element.corner[corner][axis]);
        upper[axis] = std::max(upper[axis], element.corner[corner][axis]);
      }
      lower[axis] *= simulation_.scaling.length;
      upper[axis] *= simulation_.scaling.length;
    }
    const std::size_t size = dimension;
    const bool wanted =
        errors_.active() || recorder_.wants(range.first, range.last, {lower.data(), size}, {upper.data(), size});
    if (wanted) batch.wanted.push_back(static_cast<std::int32_t>(e));
    request_slices(batch, static_cast<std::int32_t>(e));
  }
}

void Ledger::request_slices(HostBatch& batch, std::int32_t element) const {
  const ScaledTimes scaled = scaled_times(batch.elements[element], simulation_.dimension());
  const OutputRange rows =
      history_.rows(simulation_.time_in_seconds(scaled.first), simulation_.time_in_seconds(scaled.last));
  for (int row = rows.first; row < rows.last; ++row) {
    // Which element answers for a row is decided in seconds; rounding of the scaled time must not move the slice out of
    // it.
    const double time = std::clamp(simulation_.scaled_time(history_.times()[row]), scaled.first, scaled.last);
    batch.slice_requests.push_back({element, time});
    batch.slice_rows.push_back(row);
  }
}

void Ledger::commit(const HostBatch& batch, bool check_balance, std::span<const std::uint8_t> accepted) {
  ++num_batches_;
  modelled_flops_ += batch.modelled_flops;
  std::vector<std::uint8_t> element_accepted(batch.elements.size(), accepted.empty());
  for (std::size_t patch = 0; patch < accepted.size(); ++patch)
    for (int e = 0; e < batch.patches[patch].num_elements; ++e)
      element_accepted[batch.patches[patch].first_element + e] = accepted[patch];
  for (std::size_t e = 0; e < batch.records.size(); ++e)
    if (element_accepted[e])
      largest_energy_ = std::max({largest_energy_, batch.records[e].inflow_energy, batch.records[e].outflow_energy});
  for (std::size_t patch = 0; patch < batch.patches.size(); ++patch)
    if (element_accepted[batch.patches[patch].first_element]) commit_patch(batch, patch, check_balance);
  for (std::size_t index = 0; index < batch.wanted.size(); ++index)
    if (element_accepted[batch.wanted[index]]) record_wanted(batch, index);
  for (std::size_t request = 0; request < batch.slice_rows.size(); ++request)
    if (element_accepted[batch.slice_requests[request].element]) commit_slice(batch, request);
}

void Ledger::commit_slice(const HostBatch& batch, std::size_t request) {
  const double unit = simulation_.scaling.energy();
  const double kinetic = unit * batch.slice_energies[2 * request],
               strain = unit * batch.slice_energies[2 * request + 1];
  const int row = batch.slice_rows[request];
  history_.add_energy(row, kinetic, strain);
  if (row + 1 == static_cast<int>(history_.times().size())) {
    kinetic_ += kinetic;
    strain_ += strain;
  }
}

void Ledger::commit_patch(const HostBatch& batch, std::size_t patch_index, bool check_balance) {
  const PatchDescriptor& patch = batch.patches[patch_index];
  ++num_patches_;
  for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e) commit_element(batch, e);
  commit_fractures(batch, patch);
  const PatchEnergies& energies = batch.energies[patch_index];
  const double imbalance = energies.imbalance();
  energy_scale_ = std::max(energy_scale_, energies.largest);
  largest_imbalance_ = std::max(largest_imbalance_, imbalance);
  largest_increase_ = std::max(largest_increase_, energies.change - energies.work);
  if (check_balance && !(imbalance <= 1e-9 * largest_energy_)) {
    char message[160];
    std::snprintf(message, sizeof message,
                  "cell %d: the energy balance of its patch is off by %.3g of the largest cell energy (limit 1e-9)",
                  batch.cells[patch.first_element], imbalance / largest_energy_);
    throw std::runtime_error(message);
  }
}

/// Books what the fracture facets of a patch take.
void Ledger::commit_fractures(const HostBatch& batch, const PatchDescriptor& patch) {
  const double unit = simulation_.scaling.energy();
  for (int f = patch.first_fracture; f < patch.first_fracture + patch.num_fractures; ++f) {
    const FractureRecord& record = batch.fracture_records[f];
    EnergyFlow flow;
    flow.fracture = unit * record.fracture_work;
    flow.friction = unit * record.friction_work;
    fracture_ += flow.fracture;
    friction_ += flow.friction;
    const TimeRange range = time_range(simulation_, batch.elements[batch.fractures[f].element[0]]);
    history_.add_interval(range.first, range.last, flow);
  }
}

void Ledger::commit_element(const HostBatch& batch, std::int32_t element) {
  ++num_elements_;
  const ElementRecord& record = batch.records[element];
  const double unit = simulation_.scaling.energy();
  initial_ += unit * record.initial_energy;
  external_work_ += unit * record.external_work;
  numerical_ += unit * record.dissipation;
  EnergyFlow flow;
  flow.external_work = unit * record.external_work;
  flow.numerical = unit * record.dissipation;
  const TimeRange range = time_range(simulation_, batch.elements[element]);
  history_.add_interval(range.first, range.last, flow);
}

void Ledger::record_wanted(const HostBatch& batch, std::size_t index) {
  const std::int32_t element_index = batch.wanted[index];
  const std::vector<double> coefficients = solved_coefficients(simulation_, batch, index);
  SpacetimeElement element = spacetime_element(simulation_, batch, element_index);
  element.coefficients = coefficients;
  if (errors_.active()) errors_.add(element);
  recorder_.record(element);
}

void Ledger::fill(RunSummary& summary) const {
  summary.counts.patches = num_patches_;
  summary.counts.elements = num_elements_;
  summary.counts.dofs = num_elements_ * basis_.size() * simulation_.dimension();
  summary.counts.batches = num_batches_;
  summary.flops = modelled_flops_.value();
  summary.energy.initial = initial_.value();
  summary.energy.external_work = external_work_.value();
  summary.energy.kinetic = kinetic_.value();
  summary.energy.strain = strain_.value();
  summary.energy.fracture = fracture_.value();
  summary.energy.friction = friction_.value();
  summary.energy.numerical = numerical_.value();
  summary.energy.largest_patch_increase = largest_increase();
  summary.energy.largest_patch_imbalance = largest_imbalance();
  summary.errors = errors_.result();
}

void Ledger::require_balance() const {
  RunSummary summary;
  fill(summary);
  tentpole::require_balance(summary.energy, simulation_.scaling.energy() * energy_scale_);
}

double Ledger::largest_imbalance() const {
  return largest_energy_ > 0 ? largest_imbalance_ / largest_energy_ : 0;
}
double Ledger::largest_increase() const {
  return largest_energy_ > 0 ? largest_increase_ / largest_energy_ : 0;
}

void Ledger::save(std::ostream& stream) const {
  for (const std::int64_t count : {num_patches_, num_elements_, num_batches_}) write_value(stream, count);
  for (const ExactSum* sum :
       {&initial_, &external_work_, &numerical_, &kinetic_, &strain_, &fracture_, &friction_, &modelled_flops_})
    write_value(stream, *sum);
  for (const double value : {largest_energy_, energy_scale_, largest_imbalance_, largest_increase_})
    write_value(stream, value);
  errors_.save(stream);
}

void Ledger::load(std::istream& stream) {
  for (std::int64_t* count : {&num_patches_, &num_elements_, &num_batches_})
    *count = read_number(stream, std::numeric_limits<std::int64_t>::max(), "a count");
  for (ExactSum* sum :
       {&initial_, &external_work_, &numerical_, &kinetic_, &strain_, &fracture_, &friction_, &modelled_flops_})
    *sum = read_value<ExactSum>(stream);
  for (double* value : {&largest_energy_, &energy_scale_, &largest_imbalance_, &largest_increase_})
    *value = read_number(stream, std::numeric_limits<double>::max(), "an energy");
  errors_.load(stream);
}

}  // namespace tentpole
