#pragma once

#include "host/output/spacetime_element.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {

/// Energies of an element on the slice t = const [J, per unit of the missing dimensions].
struct SliceEnergy {
  double kinetic = 0;  ///< int 1/2 rho |v|^2
  double strain = 0;   ///< int 1/2 sigma : E
};

/// The plain twin of kernels/launch/slice_energies.hpp, in SI units, for the tests and samples of this folder.
/// Energies on the part of the slice `time` [s] that the element covers (0 where it does not). Exact when
/// `rule` = simplex_quadrature(D, 2 (degree - 1)); quads and wedges are cut into simplices.
SliceEnergy slice_energy(const OrthonormalBasis& basis, const Quadrature& rule, const SpacetimeElement& element,
                         double time);

}  // namespace tentpole
