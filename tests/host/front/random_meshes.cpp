#include "tests/host/front/random_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "host/mesh/lattice_triangulation.hpp"
#include "host/mesh/mesh_description.hpp"
#include "host/mesh/mesh_facets.hpp"
#include "host/mesh/simplex_geometry.hpp"
#include "host/mesh/unstructured_lattice.hpp"
#include "tests/host/mesh/mesh_angles.hpp"

namespace tentpole::testing {

namespace {

using Corners = std::array<Point, SpaceMesh::max_corners>;

/// Uniform in (-1, 1); std distributions differ between libraries, the engine does not.
double draw(std::mt19937_64& random) {
  return (static_cast<double>(random() >> 11) + 0.5) / 4503599627370496.0 - 1;
}

Corners corners_of(const std::vector<Point>& vertices, const CellVertices& cell, int dimension) {
  Corners corners{};
  for (int i = 0; i <= dimension; ++i) corners[i] = vertices[cell[i]];
  return corners;
}

/// Names every boundary facet "side" and builds the mesh.
SpaceMesh build(int dimension, std::vector<Point> vertices, std::vector<CellVertices> cells) {
  MeshDescription description;
  description.source = "random mesh";
  description.dimension = dimension;
  description.vertices = std::move(vertices);
  for (CellVertices& cell : cells) std::sort(cell.begin(), cell.begin() + dimension + 1);
  description.cells = std::move(cells);
  description.cell_region.assign(description.cells.size(), 0);
  description.region_names = {"all"};
  description.boundary_names = {"side"};
  const FacetTable facets = match_facets(description);
  for (std::size_t cell = 0; cell < description.cells.size(); ++cell)
    for (int facet = 0; facet <= dimension; ++facet)
      if (facets.neighbor[cell][facet] == none)
        description.named_facets.push_back({facet_vertices(dimension, description.cells[cell], facet), 0});
  return build_space_mesh(std::move(description));
}

/// Moves the vertices of a unit lattice at random, each as far as `accepts` likes the cells round it; side vertices
/// stay on their side.
template <typename Accepts>
void move_at_random(LatticeTriangulation& lattice, std::mt19937_64& random, int num_sweeps, double amplitude,
                    const Accepts& accepts) {
  std::vector<std::vector<int>> stars(lattice.vertices.size());
  for (std::size_t cell = 0; cell < lattice.cells.size(); ++cell)
    for (int i = 0; i <= lattice.dimension; ++i) stars[lattice.cells[cell][i]].push_back(static_cast<int>(cell));
  for (int sweep = 0; sweep < num_sweeps; ++sweep)
    for (std::size_t vertex = 0; vertex < stars.size(); ++vertex) {
      const Point start = lattice.vertices[vertex];
      for (int axis = 0; axis < lattice.dimension; ++axis) {
        const double step = amplitude * draw(random);
        if (!lattice.is_on_side(static_cast<int>(vertex), axis)) lattice.vertices[vertex][axis] += step;
      }
      const bool is_accepted = std::all_of(stars[vertex].begin(), stars[vertex].end(), [&](int cell) {
        const Corners corners = corners_of(lattice.vertices, lattice.cells[cell], lattice.dimension);
        return signed_simplex_measure(lattice.dimension, corners) > 0 && accepts(corners);
      });
      if (!is_accepted) lattice.vertices[vertex] = start;
    }
}

double circumsphere_excess(const Corners& p, const Point& x) {
  // Solve 2 (p_i - p_0) . c = |p_i - p_0|^2 for the centre relative to p_0; excess = |x - c|^2 - radius^2.
  const Point a = difference(p[1], p[0]), b = difference(p[2], p[0]), c = difference(p[3], p[0]);
  const Point bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double scale = 1 / (2 * dot(a, bc));
  Point centre{};
  for (int axis = 0; axis < 3; ++axis)
    centre[axis] = scale * (dot(a, a) * bc[axis] + dot(b, b) * ca[axis] + dot(c, c) * ab[axis]);
  const Point arm = difference(difference(x, p[0]), centre);
  return dot(arm, arm) - dot(centre, centre);
}

/// Adds a vertex: the cells whose circumsphere holds it give way to cells from it to the facets of their union. Facets
/// that contain the vertex (it lies on the cube's surface) carry no cell.
void insert_vertex(const std::vector<Point>& vertices, std::vector<CellVertices>& cells, int vertex) {
  std::map<FacetVertices, FacetVertices> hull;  // sorted -> outward orientation, facets met once
  std::vector<CellVertices> kept;
  for (const CellVertices& cell : cells) {
    if (circumsphere_excess(corners_of(vertices, cell, 3), vertices[vertex]) >= -1e-12) {
      kept.push_back(cell);
      continue;
    }
    const std::array<FacetVertices, 4> facets{
        FacetVertices{cell[1], cell[2], cell[3]}, FacetVertices{cell[0], cell[3], cell[2]},
        FacetVertices{cell[0], cell[1], cell[3]}, FacetVertices{cell[0], cell[2], cell[1]}};
    for (const FacetVertices& facet : facets) {
      FacetVertices key = facet;
      std::sort(key.begin(), key.end());
      if (!hull.erase(key)) hull[key] = facet;
    }
  }
  for (const auto& [key, facet] : hull) {
    const CellVertices cell{vertex, facet[0], facet[1], facet[2]};
    if (std::abs(signed_simplex_measure(3, corners_of(vertices, cell, 3))) > 1e-10) kept.push_back(cell);
  }
  cells = std::move(kept);
}

}  // namespace

double smallest_altitude(const SpaceMesh& mesh, int vertex) {
  double smallest = 1e300;
  for (const auto& [cell, corner] : mesh.star(vertex)) {
    Corners facet{};
    for (int i = 0, n = 0; i <= mesh.dimension; ++i)
      if (i != corner) facet[n++] = mesh.corner_position(cell, i);
    double facet_measure = 1;
    if (mesh.dimension == 2) facet_measure = distance(facet[0], facet[1]);
    if (mesh.dimension == 3)
      facet_measure = distance(cross(difference(facet[1], facet[0]), difference(facet[2], facet[0])), Point{}) / 2;
    smallest = std::min(smallest, mesh.dimension * mesh.cell_measure(cell) / facet_measure);
  }
  return smallest;
}

SpaceMesh bad_triangle_mesh(std::uint64_t seed, int n, double min_angle, double max_angle) {
  std::mt19937_64 random(seed);
  LatticeTriangulation lattice = structured_lattice(2, {n, n, 0});
  move_at_random(lattice, random, 25, 0.6, [&](const Corners& corners) {
    const AngleRange range = triangle_angles(corners);
    return range.smallest >= min_angle && range.largest <= max_angle;
  });
  for (Point& vertex : lattice.vertices)
    for (double& coordinate : vertex) coordinate /= n;
  return build(2, lattice.vertices, lattice.cells);
}

SpaceMesh sliver_tetrahedron_mesh(std::uint64_t seed, int n, double min_shape) {
  std::mt19937_64 random(seed);
  LatticeTriangulation lattice = structured_lattice(3, {n, n, n});
  move_at_random(lattice, random, 12, 0.4,
                 [&](const Corners& corners) { return simplex_shape(3, corners) >= min_shape; });
  return build(3, lattice.vertices, lattice.cells);
}

SpaceMesh delaunay_tetrahedron_mesh(std::uint64_t seed, int num_points) {
  std::mt19937_64 random(seed);
  LatticeTriangulation cube = structured_lattice(3, {1, 1, 1});
  for (int point = 0; point < num_points; ++point) {
    Point position{(draw(random) + 1) / 2, (draw(random) + 1) / 2, (draw(random) + 1) / 2};
    if (point % 3 == 0) position[random() % 3] = static_cast<double>(random() % 2);  // on a side of the cube
    cube.vertices.push_back(position);
    insert_vertex(cube.vertices, cube.cells, static_cast<int>(cube.vertices.size()) - 1);
  }
  return build(3, cube.vertices, cube.cells);
}

}  // namespace tentpole::testing
