#pragma once

#include "host/problem/simulation.hpp"

namespace tentpole {

/// Evaluates the expressions of a case as the first tents of a run do: initial data on the cells, loads on the sides
/// and the body force in elements between t = 0 and a pole's height; the exact solution at one point of each. On large
/// meshes so many cells, spread evenly, as take about a second. Throws InputError with key, point and time where a
/// value is not finite.
void check_expressions(const Simulation& simulation);

}  // namespace tentpole
