#pragma once

#include <array>
#include <cstdint>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

enum class MeshPattern { structured, unstructured };

/// A line, rectangle or box, divided into cells[0] x cells[1] x cells[2] equal boxes and those into simplices.
struct BoxMesh {
  int dimension = 2;   ///< 1..3; later axes are not read
  Point min{0, 0, 0};  ///< [m]
  Point max{1, 1, 1};  ///< [m], > min
  std::array<int, max_dimension> cells{1, 1, 1};
  MeshPattern pattern = MeshPattern::structured;
  std::uint64_t seed = 1;  ///< of the unstructured pattern
  PeriodicPairs periodic;  ///< pairs of opposite sides
};

/// Meshes a box. One region "all"; sides "left"/"right" (x), "bottom"/"top" (y), "back"/"front" (z), lower one first.
/// structured: D = 2, two triangles per rectangle, the diagonals alternate from row to row (every inner vertex has six
/// cells, and no direction is preferred); D = 3, six tetrahedra per box round its main diagonal (Kuhn).
/// unstructured: D = 1, inner vertices displaced by up to 0.3 of a cell; D = 2, displaced, flipped to Delaunay and
/// smoothed (in units of the boxes, so their aspect ratio is kept); D = 3, the Kuhn mesh displaced as far as its shapes
/// allow. Opposite sides carry the same mesh, so any pair may be periodic. The mesh is a function of the arguments
/// alone, bit for bit on every machine. Throws MeshError for sizes or counts out of range.
SpaceMesh make_box_mesh(const BoxMesh& box);

}  // namespace tentpole
