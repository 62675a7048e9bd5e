#pragma once

#include <cstdint>

#include "host/front/front_mesh.hpp"

namespace tentpole {

/// A cell that contains a point (its facets included, up to 1e-10 of its altitudes), found by walking from cell to cell
/// across the facet that the point lies farthest behind; where the walk ends at a boundary or takes too long, all cells
/// are looked at. `start`: a cell to begin with, or none. Returns none outside the domain.
std::int32_t locate(const FrontMesh& mesh, const Point& point, std::int32_t start = none);

}  // namespace tentpole
