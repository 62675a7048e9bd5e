#include "host/run/memory_need.hpp"

#include <cmath>
#include <string>

#include <unistd.h>

#include "host/case_file/number_text.hpp"
#include "host/front/front_mesh.hpp"
#include "host/march/adaptive_state.hpp"
#include "host/mesh/mesh_description.hpp"
#include "host/mesh/mesh_facets.hpp"
#include "host/output/history.hpp"
#include "host/output/probe.hpp"

namespace tentpole {
namespace {

/// Capacity over size of a vector that grows by doubling, on average.
constexpr double growth = 1.5;
/// The element store doubles, too, and while it does both copies are there.
constexpr double store_growth = 2.25;
/// What the heap keeps beside the structures, and what lives for a moment; measured,
/// tests/host/command_line/memory_test.py.
constexpr double heap = 1.25;
constexpr double index = sizeof(std::int32_t);

double space_mesh(int dimension, double vertices, double cells) {
  const double corners = 4 * index, small_corners = 4;
  const double star = sizeof(CellCorner) * (dimension + 1);
  return cells * (3 * corners + 2 * small_corners + index + star + sizeof(double)) +
         vertices * (growth * sizeof(Point) + index);
}

/// Beside the mesh, when its cells are filled: lattice and description, and the table of facets with the sorted list.
double mesh_making(int dimension, double vertices, double cells) {
  const double lattice = vertices * growth * sizeof(Point) + cells * growth * sizeof(CellVertices);
  const double description = vertices * growth * sizeof(Point) + cells * (sizeof(CellVertices) + index);
  const double facets = cells * (2 * 4 * index + 4 + (dimension + 1) * double{sizeof(FacetOfCell)});
  return lattice + description + facets + vertices * 3 * index + cells * 4;
}

/// Edges that meet at a vertex of the boxes' lattices.
double edges_at_vertex(int dimension) {
  constexpr double edges[] = {0, 2, 6, 14};
  return edges[dimension];
}

double fixed_front(int dimension, double vertices, double cells) {
  const double limits = cells * growth * sizeof(double) +
                        vertices * (index + growth * edges_at_vertex(dimension) * (index + sizeof(double)));
  const double times_and_minima = vertices * (3 * sizeof(double) + 3 * index);
  const double sources = cells * 3 * index;
  return limits + times_and_minima + sources;
}

double adaptive_front(int dimension, double vertices, double cells) {
  const double cells_at_vertex = dimension == 1 ? 2 : 6;
  constexpr double block = 48;  // of the heap, for each star and what it has outgrown
  const double star = sizeof(std::vector<CellCorner>) + growth * cells_at_vertex * sizeof(CellCorner) + block;
  const double vertex = sizeof(Point) + sizeof(double) + 1 + star + sizeof(VertexMemory) + 4 * index;
  return cells * (growth * sizeof(FrontCell) + 2 * index) + vertices * growth * vertex;
}

double element_store(int dimension, int degree, double cells) {
  const double num_unknowns = dimension * num_polynomials(dimension + 1, degree), d = dimension + 1;
  return cells * (store_growth * (num_unknowns + d * d) * sizeof(double) + 2 * growth * index);
}

double output_rows(const Case& settings) {
  double bytes = settings.end_time / settings.output.history_interval * History::bytes_per_row();
  for (const ProbeSettings& probe : settings.output.probes)
    bytes += settings.end_time / probe.interval * Probe::bytes_per_row();
  return bytes;
}

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// In gigabytes, up to a tenth.
std::string gigabytes(double num_bytes) {
  return number_text(std::ceil(num_bytes / 1e8) / 10) + " GB";
}

}  // namespace

BoxCounts box_counts(const DomainSettings& domain) {
  constexpr double simplices_per_box[] = {0, 1, 2, 6};
  BoxCounts counts{1, simplices_per_box[domain.dimension]};
  for (int axis = 0; axis < domain.dimension; ++axis) {
    counts.vertices *= domain.cells[axis] + 1.0;
    counts.cells *= domain.cells[axis];
  }
  return counts;
}

MemoryNeed memory_need(const Case& settings, double num_vertices, double num_cells) {
  const int dimension = settings.domain.dimension;
  const bool is_adaptive = settings.adaptivity.enabled || settings.fracture.enabled;
  const double mesh = space_mesh(dimension, num_vertices, num_cells);
  MemoryNeed need;
  need.mesh = heap * (mesh + mesh_making(dimension, num_vertices, num_cells));
  const double front = is_adaptive ? adaptive_front(dimension, num_vertices, num_cells)
                                   : fixed_front(dimension, num_vertices, num_cells);
  need.run = heap * (mesh + front + element_store(dimension, settings.degree, num_cells));
  need.output = output_rows(settings);
  return need;
}

void check_memory(const Case& settings, double num_vertices, double num_cells) {
  const MemoryNeed need = memory_need(settings, num_vertices, num_cells);
  const double memory = physical_memory();
  if (need.peak() <= memory) return;
  const std::string file = settings.path.string(), machine = ", but this machine has " + gigabytes(memory);
  const bool is_output = need.output > std::max(need.mesh, need.run);
  const std::string rows = "the rows of history.csv and the probes need about " + gigabytes(need.output);
  const std::string cells = number_text(num_cells) + " cells need about " + gigabytes(need.peak()) + " at degree " +
                            std::to_string(settings.degree);
  if (is_output) throw InputError({{{file, 0, 0, "output", ""}, rows + machine + ". Give larger intervals."}});
  throw InputError({{{file, 0, 0, settings.domain.is_box() ? "domain.cells" : "domain.mesh", ""},
                     cells + machine + ". Give fewer cells or a lower degree."}});
}

}  // namespace tentpole
