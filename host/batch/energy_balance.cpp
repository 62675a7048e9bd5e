#include "host/batch/energy_balance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "host/batch/patch_place.hpp"

namespace tentpole {
namespace {

/// Terms below it can be added up in any number, scaled or in SI, and stay finite.
constexpr double largest_summable = 1e280;
/// Below it numbers lose digits, so no balance can close.
constexpr double underflow = 1e-290;
/// Rounding of a displacement u makes strains of about 1e-15 u / h; flat cells amplify it.
constexpr double displacement_rounding = 1e-12;

/// Square of the largest mean initial displacement under the facets of an element that start from it.
double squared_initial_displacement(const HostBatch& batch, const ElementDescriptor& element, int dimension,
                                    int degree) {
  double largest = 0;
  const int num_modes = num_polynomials(dimension, degree - 1);
  for (int facet = 0; facet <= dimension + 1; ++facet) {
    if (element.facet_kind[facet] != FacetKind::inflow || has_source(element, facet)) continue;
    const double* displacement =
        &batch.prescribed[element.facet_data[facet] + (dimension + num_symmetric(dimension)) * num_modes];
    for (int i = 0; i < dimension; ++i) {
      const double mean = displacement[i * (dimension + 1)];
      largest = std::max(largest, mean * mean);
    }
  }
  return largest;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// NaN and infinities are not.
bool are_summable(const PatchEnergies& energies, double unit) {
  return std::isfinite(energies.imbalance()) && energies.largest * std::max(1.0, unit) <= largest_summable;
}

const char* const advice =
    " The numbers of the case are beyond what double precision resolves: check the units (all SI) of densities, "
    "stiffnesses, loads, sizes and times, and whether a relaxation time is far shorter than a wave takes through a "
    "cell.";

[[noreturn]] void refuse(const std::string& place, const std::string& problem) {
  throw std::runtime_error(place + ": " + problem + "." + advice);
}

}  // namespace

PatchEnergies patch_energies(const HostBatch& batch, const PatchDescriptor& patch, const Simulation& simulation) {
  PatchEnergies energies;
  double squared_displacement = 0;
  for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e) {
    const ElementRecord& record = batch.records[e];
    energies.change += record.outflow_energy - record.inflow_energy;
    energies.loss += record.dissipation;
    energies.work += record.external_work;
    energies.largest = std::max({energies.largest, record.inflow_energy, record.outflow_energy, record.dissipation,
                                 std::fabs(record.external_work)});
    squared_displacement =
        std::max(squared_displacement,
                 squared_initial_displacement(batch, batch.elements[e], simulation.dimension(), simulation.degree()));
  }
  for (int f = patch.first_fracture; f < patch.first_fracture + patch.num_fractures; ++f) {
    const FractureRecord& record = batch.fracture_records[f];
    energies.loss += record.fracture_work + record.friction_work;
    energies.largest = std::max({energies.largest, record.fracture_work, record.friction_work});
  }
  energies.largest =
      std::max(energies.largest, displacement_rounding * displacement_rounding * squared_displacement / balance_limit);
  return energies;
}

void raise_energy_scale(double& scale, const HostBatch& batch) {
  for (const PatchEnergies& energies : batch.energies)
    if (are_summable(energies, 1)) scale = std::max(scale, energies.largest);
}

bool is_balanced(const HostBatch& batch, int patch, double scale, const Simulation& simulation) {
  const PatchEnergies& energies = batch.energies[patch];
  return are_summable(energies, simulation.scaling.energy()) &&
         energies.imbalance() <= balance_limit * scale + underflow;
}

void require_balance(const HostBatch& batch, int patch, double scale, const Simulation& simulation) {
  if (is_balanced(batch, patch, scale, simulation)) return;
  const PatchEnergies& energies = batch.energies[patch];
  const double unit = simulation.scaling.energy();
  const std::string values = "energy in minus energy out " + number(-unit * energies.change) + ", work of loads " +
                             number(unit * energies.work) + ", losses " + number(unit * energies.loss) + " [J]";
  const std::string place = patch_place(batch, batch.patches[patch], simulation);
  if (!are_summable(energies, unit)) refuse(place, "the energies of its solution are not finite (" + values + ")");
  refuse(place, "the energy balance of its solution misses " + number(energies.imbalance() / scale) +
                    " of the largest energy in one element so far; " + number(balance_limit) + " is the limit (" +
                    values + ")");
}

void require_balance(const RunSummary::Energy& energy, double scale) {
  const double shares[] = {energy.initial,  energy.external_work, energy.kinetic,  energy.strain,
                           energy.fracture, energy.friction,      energy.numerical};
  for (const double share : shares) scale = std::max(scale, std::fabs(share));
  const double error = std::fabs(energy.balance_error());
  if (error <= balance_limit * scale + underflow && scale <= largest_summable) return;
  refuse("at the end of the run",
         "the energy balance misses " + number(error) + " J, " + number(error / scale) +
             " of the largest energy in it; " + number(balance_limit) + " is the limit (initial " +
             number(energy.initial) + ", work of loads " + number(energy.external_work) + ", kinetic " +
             number(energy.kinetic) + ", strain " + number(energy.strain) + ", fracture " + number(energy.fracture) +
             ", friction " + number(energy.friction) + ", numerical " + number(energy.numerical) + " [J])");
}

}  // namespace tentpole
