#pragma once

#include <cstdint>

#include "host/mesh/space_mesh.hpp"

namespace tentpole::testing {

/// A mesh of the unit square of 2 n^2 triangles whose vertices are moved at random as far as all angles stay between
/// the given ones [degrees]; after 25 sweeps most triangles are bad.
SpaceMesh bad_triangle_mesh(std::uint64_t seed, int n, double min_angle, double max_angle);

/// Delaunay tetrahedra of random points in and on the unit cube (Bowyer, Watson 1981): full of slivers.
SpaceMesh delaunay_tetrahedron_mesh(std::uint64_t seed, int num_points);

/// Kuhn mesh of n^3 boxes whose inner vertices are moved at random as far as every tetrahedron keeps the fraction
/// `min_shape` of the regular one's shape (72 sqrt(3) V / (sum l^2)^(3/2)).
SpaceMesh sliver_tetrahedron_mesh(std::uint64_t seed, int n, double min_shape);

/// Smallest altitude of a vertex over the cells of its star.
double smallest_altitude(const SpaceMesh& mesh, int vertex);

}  // namespace tentpole::testing
