#pragma once

#include <cstdint>
#include <vector>

#include "host/batch/patch_energies.hpp"
#include "kernels/launch/slice_energies.hpp"

namespace tentpole {

/// One batch of tents on the host: what goes to the device and what comes back.
struct HostBatch {
  std::vector<PatchDescriptor> patches;
  std::vector<ElementDescriptor> elements;
  std::vector<double> prescribed;
  std::vector<FractureFacet> fractures;
  std::vector<std::int32_t> crack_edges;  ///< [fracture facet]: crack edge of the front below it
  std::vector<std::int32_t> cells;        ///< [element]: front cell below it
  std::vector<double> damage;     ///< [element]: largest on the crack edges of that cell; empty without fracture
  std::int32_t num_slots = 0;     ///< slots the store must have
  double front_minimum_time = 0;  ///< of the front after this batch, scaled

  std::vector<std::int32_t> wanted;          ///< elements whose coefficients come back
  std::vector<SliceRequest> slice_requests;  ///< by element: where energies are wanted
  std::vector<std::int32_t> slice_rows;      ///< [slice request]: row of the history

  std::vector<ElementRecord> records;            ///< [element]
  std::vector<FractureRecord> fracture_records;  ///< [fracture facet]
  std::vector<PatchEnergies> energies;           ///< [patch], of those that are solved
  std::vector<double> wanted_coefficients;       ///< [wanted][num_unknowns], scaled
  std::vector<double> slice_energies;            ///< [slice request][2]: kinetic, strain, scaled
  double modelled_flops = 0;                     ///< of its patches

  void clear() { *this = HostBatch{}; }
};

}  // namespace tentpole
