#pragma once

#include <vector>

#include "kernels/reference/point_state.reference.hpp"

namespace tentpole::reference {

/// A facet through which displacement enters an element: an inflow facet, or an inclined one with N_t < 0.
struct EntryFacet {
  int facet;
  double weight;  ///< |N_t| dA
};
std::vector<EntryFacet> entry_facets(const Discretization& discretization, const ElementDescriptor& element);

/// Translations and infinitesimal rotations over the entry facets of an element, orthonormal in the sum over them of
/// weight times the mean product, so that uhat_0 = sum_r [sum_f weight_f <uhat . mode_r>_f] mode_r is the
/// |N_t|-weighted projection of uhat. Values [mode][entry][q][i] at the points of the facet rule; D (D + 1) / 2 modes.
std::vector<std::vector<Rows>> rigid_modes(const Discretization& discretization, const ElementDescriptor& element,
                                           const std::vector<EntryFacet>& entries);

}  // namespace tentpole::reference
