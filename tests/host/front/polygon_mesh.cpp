#include "tests/host/front/polygon_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/mesh/mesh_description.hpp"

namespace tentpole::testing {

SpaceMesh polygon_mesh(int num_sides, const Point& centre) {
  MeshDescription description;
  description.source = "polygon";
  description.dimension = 2;
  for (int i = 0; i < num_sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / num_sides;
    const int next = (i + 1) % num_sides;
    description.vertices.push_back({std::cos(angle), std::sin(angle), 0});
    description.cells.push_back({std::min(i, next), std::max(i, next), num_sides, none});
    description.named_facets.push_back({{i, next, none}, 0});
  }
  description.vertices.push_back(centre);
  description.cell_region.assign(num_sides, 0);
  description.region_names = {"all"};
  description.boundary_names = {"side"};
  return build_space_mesh(description);
}

}  // namespace tentpole::testing
