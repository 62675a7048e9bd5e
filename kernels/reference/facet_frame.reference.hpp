#pragma once

#include "kernels/reference/point_state.reference.hpp"

namespace tentpole::reference {

/// Unit normal and D - 1 tangents of a vertical facet, from the spatial part of its covector; `area` is
/// the length of that part.
Rows facet_frame(const Vector& covector, double area, int dimension);

}  // namespace tentpole::reference
