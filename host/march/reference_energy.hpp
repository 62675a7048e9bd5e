#pragma once

#include "host/problem/simulation.hpp"

namespace tentpole {

/// Energy that `adaptivity.error_tolerance` is a fraction of, scaled units: `adaptivity.reference_energy` if the case
/// gives it, otherwise what is known before the run of the energy that will pass through the domain:
///   initial energy + sum over loaded boundary facets of area * int_0^end (Z v^2 or s^2 / Z) dt
///   + int rho/2 (b t_end)^2 dV (body force).
/// The boundary term is the work that a load does on a body that sends no waves back. A constant, so that one
/// tolerance holds for the whole run and does not depend on batches (docs/decisions/0006-adaptive-rounds.md).
/// At least the smallest positive number. Throws InputError where an expression is not finite.
double reference_energy(const Simulation& simulation);

}  // namespace tentpole
