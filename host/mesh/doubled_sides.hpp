#pragma once

#include <string>

#include "host/mesh/mesh_description.hpp"

// Sides whose vertices are there twice, once for the cells on either side, as Gmsh's plugin Crack makes them.
namespace tentpole {

/// Joins the vertices at one place where a side that is a crack (NameUse) has one of them: its cells are neighbours
/// then, and the side lies inside. The vertex with the smallest index stays.
void merge_doubled_cracks(MeshDescription& description);

/// Name of a side of which some facet is there twice, with different vertices at the same places; or empty.
std::string find_doubled_side(const MeshDescription& description);

}  // namespace tentpole
