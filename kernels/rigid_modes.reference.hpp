#pragma once

#include <vector>

#include "kernels/point_state.reference.hpp"

namespace tentpole::reference {

/// Translations and infinitesimal rotations over an element's inflow facet, orthonormal in the mean over the facet, so
/// that uhat_0 = sum_r <uhat . mode_r> mode_r is the |N_t|-weighted projection of uhat (N_t is constant on the facet).
/// Values [mode][q][i] at the points of the facet rule; D (D + 1) / 2 modes.
std::vector<Rows> rigid_modes(const Discretization& discretization, const ElementDescriptor& element);

}  // namespace tentpole::reference
