#include "host/mesh/msh/repeated_cells.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <span>

#include "host/mesh/insertion_sort.hpp"
#include "host/mesh/toml_name.hpp"

namespace tentpole {

namespace {

struct SortedCell {
  CellVertices vertices;
  std::int32_t cell;

  auto operator<=>(const SortedCell&) const = default;
};

std::vector<SortedCell> sorted_cells(const MeshDescription& mesh) {
  std::vector<SortedCell> all;
  all.reserve(mesh.cells.size());
  for (const CellVertices& cell : mesh.cells) {
    all.push_back({cell, static_cast<std::int32_t>(all.size())});
    insertion_sort(all.back().vertices, mesh.dimension + 1);
  }
  std::sort(all.begin(), all.end());
  return all;
}

bool has_several_regions(const MeshDescription& mesh) {
  return std::adjacent_find(mesh.cell_region.begin(), mesh.cell_region.end(), std::not_equal_to<>()) !=
         mesh.cell_region.end();
}

/// Marks those of the cells `run`, which have the same corners, that repeat the first with another region.
void merge_run(MeshDescription& mesh, std::span<const SortedCell> run, std::vector<bool>& is_dropped) {
  std::set<std::int32_t> known;
  std::vector<std::int32_t> regions;  // without none, in the order of the file
  std::vector<std::string> names;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const std::int32_t region = mesh.cell_region[run[i].cell];
    const bool is_new = known.insert(region).second;
    is_dropped[run[i].cell] = i > 0 && is_new;
    if (region == none || !is_new) continue;
    regions.push_back(region);
    names.push_back(mesh.region_names[region]);
  }
  if (!regions.empty())
    mesh.cell_region[run[0].cell] = regions[chosen_region(mesh, names, mesh.cell_label(run[0].cell))];
}

template <class Value>
void drop(std::vector<Value>& values, const std::vector<bool>& is_dropped) {
  std::size_t num_kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_dropped[i]) values[num_kept++] = values[i];
  values.resize(num_kept);
}

/// A name that no cell has any more needs no material.
void drop_regions_without_cells(MeshDescription& mesh) {
  std::vector<std::int32_t> new_index(mesh.region_names.size(), none);
  for (const std::int32_t region : mesh.cell_region)
    if (region != none) new_index[region] = 0;
  std::vector<std::string> names;
  for (std::size_t region = 0; region < new_index.size(); ++region) {
    if (new_index[region] == none) continue;
    new_index[region] = static_cast<std::int32_t>(names.size());
    names.push_back(mesh.region_names[region]);
  }
  mesh.region_names = names;
  for (std::int32_t& region : mesh.cell_region)
    if (region != none) region = new_index[region];
}

}  // namespace

std::size_t chosen_region(const MeshDescription& mesh, const std::vector<std::string>& names, const std::string& cell) {
  std::vector<bool> is_used;
  for (const std::string& name : names) is_used.push_back(!mesh.use || mesh.use->has_region(name));
  const auto [chosen, rival] = choose_name(is_used);
  if (!rival) return chosen;
  const std::string &first = names[chosen], &second = names[*rival];
  throw MeshError(mesh.source, cell,
                  "belongs to two physical groups, " + first + " and " + second +
                      (mesh.use ? ", and both have a material. Keep one of [material." + toml_key(first) +
                                      "] and [material." + toml_key(second) + "], or make the groups disjoint."
                                : ". Keep one."));
}

void merge_repeated_cells(MeshDescription& mesh) {
  if (!has_several_regions(mesh)) return;
  const std::vector<SortedCell> all = sorted_cells(mesh);
  std::vector<bool> is_dropped(all.size(), false);
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    while (last < all.size() && all[last].vertices == all[first].vertices) ++last;
    if (last - first > 1) merge_run(mesh, std::span(all).subspan(first, last - first), is_dropped);
  }
  drop(mesh.cells, is_dropped);
  drop(mesh.cell_region, is_dropped);
  drop(mesh.cell_number, is_dropped);
  drop_regions_without_cells(mesh);
}

}  // namespace tentpole
