#pragma once

#include "kernels/reference/point_state.reference.hpp"

namespace tentpole::reference {

/// Whether a facet between two elements is not parallel to the time axis: |N_t| > 1e-13 |N|. Facets of a tent whose top
/// stands straight above its bottom are parallel whatever rounding says.
bool is_inclined(const Discretization& discretization, const ElementDescriptor& element, int facet);

/// Components of the state w = (v, sigma) [D + D (D + 1) / 2], sigma in the order of symmetric_index and Mandel form
/// (sqrt 2 on shears), so that products are Euclidean.
Rows state_components(const PointState& state, int dimension);

/// A_N^- = A_0 R Lambda^- R^T A_0, the part of A_N = N_t A_0 - [0 N_x.; N_x.^T 0] that carries waves into the element,
/// for the outward covector N dA; A_N r = lambda A_0 r, R^T A_0 R = I, A_0 = diag(rho, C^-1). Found by LAPACK's dsygv,
/// so that no formula for the waves enters. Square, of the size of state_components.
Rows incoming_flux(const Vector& covector, const Material& material, int dimension);

}  // namespace tentpole::reference
