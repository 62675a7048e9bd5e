#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "host/mesh/msh/describe_msh.hpp"
#include "host/mesh/msh/read_msh.hpp"
#include "host/mesh/space_mesh.hpp"

// The way of a mesh file, from its bytes to the mesh of a run. The first byte says what the case asks for: the
// dimension, and whether it names regions, sides, a crack and periodic sides. Whatever the bytes are, they make a mesh
// that is sound or a MeshError; anything else ends the program.
namespace tentpole {
namespace {

std::optional<NameUse> name_use(std::uint8_t choice) {
  if ((choice & 4) == 0) return std::nullopt;
  NameUse use{{"plate"}, {"rim"}, {}};
  if ((choice & 8) != 0) use.cracks = {"notch"};
  return use;
}

void require(bool holds, const char* invariant) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", invariant);
  std::abort();
}

void check_mesh(const SpaceMesh& mesh) {
  require(mesh.num_cells() > 0 && mesh.mean_cell_size() > 0, "a mesh has cells");
  for (int cell = 0; cell < mesh.num_cells(); ++cell) {
    require(mesh.cell_measure(cell) > 0, "cells have a measure");
    for (int i = 0; i <= mesh.dimension; ++i) {
      require(i == 0 || mesh.cells[cell][i - 1] < mesh.cells[cell][i], "corners ascend");
      const std::int32_t other = mesh.neighbor[cell][i];
      require((other == none) != (mesh.facet_boundary[cell][i] == none), "a facet has a neighbour or a name");
      require(other == none || mesh.neighbor[other][mesh.neighbor_facet[cell][i]] == cell, "neighbours agree");
    }
  }
  for (const InnerSide& side : mesh.inner_sides)
    for (const auto& facet : side.facets) require(facet[0] < mesh.num_vertices(), "sides have vertices of the mesh");
}

}  // namespace
}  // namespace tentpole

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tentpole;
  if (size == 0) return 0;
  const std::uint8_t choice = data[0];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  PeriodicPairs periodic;
  if ((choice & 16) != 0) periodic.emplace_back("left", "right");
  try {
    const MshContents contents = read_msh("input", bytes);
    check_mesh(build_space_mesh(describe_msh("input", contents, 1 + (choice & 3) % 3, name_use(choice)), periodic));
  } catch (const MeshError& error) {
    require(error.what()[0] != '\0', "a refusal has a message");
  }
  return 0;
}
