#include <cmath>
#include <limits>

#include "host/case_file/number_text.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

const Rule any_number{[](double) { return true; }, "must be a length", "Give metres."};

void read_mesh_file(const TableReader& reader, const std::filesystem::path& case_folder, DomainSettings& domain) {
  for (const char* key : {"min", "max", "cells", "pattern", "seed"})
    if (reader.has(key)) reader.report(key, "is of a generated box, but domain.mesh is given too. Remove one of them.");
  const auto mesh = reader.text("mesh", Presence::required);
  if (!mesh) return;
  domain.mesh_file = case_folder / *mesh;
  if (!std::filesystem::is_regular_file(domain.mesh_file))
    reader.report("mesh", "there is no such file: " + domain.mesh_file.string() +
                              ". Paths are relative to the folder of the case file.");
}

void read_box(const TableReader& reader, DomainSettings& domain) {
  const auto min = reader.numbers("min", Presence::required, domain.dimension, any_number);
  const auto max = reader.numbers("max", Presence::required, domain.dimension, any_number);
  const auto cells =
      reader.numbers("cells", Presence::required, domain.dimension,
                     {[](double n) { return n >= 1 && n <= 1e9 && n == std::floor(n); },
                      "must be an integer from 1 to 1e9", "Give the number of intervals in this direction."});
  if (const auto pattern = reader.choice("pattern", Presence::optional, {"structured", "unstructured"}))
    domain.pattern = *pattern == 0 ? MeshPattern::structured : MeshPattern::unstructured;
  if (const auto seed = reader.integer("seed", Presence::optional, not_negative("Give 0, 1, 2, ...")))
    domain.seed = static_cast<std::uint64_t>(*seed);
  for (int axis = 0; axis < domain.dimension; ++axis) {
    if (min) domain.min[axis] = (*min)[axis];
    if (max) domain.max[axis] = (*max)[axis];
    if (cells) domain.cells[axis] = static_cast<int>((*cells)[axis]);
    if (min && max && !(domain.min[axis] < domain.max[axis]))
      reader.report("max", "must exceed domain.min, but in direction " + std::string(1, "xyz"[axis]) + " " +
                               number_text(domain.max[axis]) + " <= " + number_text(domain.min[axis]) +
                               ". Give the corner with the larger coordinates.");
  }
}

}  // namespace

DomainSettings read_domain(const SectionContext& context, const std::filesystem::path& case_folder) {
  DomainSettings domain;
  const TableReader reader = context.section("domain");
  reader.allow_only({"dimension", "min", "max", "cells", "pattern", "seed", "mesh"});
  const auto dimension = reader.integer("dimension", Presence::required, from_to(1, 3, "Give 1, 2 or 3."));
  domain.dimension = static_cast<int>(dimension.value_or(0));
  if (reader.has("mesh"))
    read_mesh_file(reader, case_folder, domain);
  else if (domain.dimension > 0)
    read_box(reader, domain);
  return domain;
}

void check_mesh_is_numbered(const SectionContext& context) {
  const DomainSettings& domain = context.domain;
  if (!domain.is_box() || domain.dimension == 0) return;
  constexpr double simplices_per_cell[4] = {0, 1, 2, 6};
  double num_simplices = simplices_per_cell[domain.dimension];
  for (int axis = 0; axis < domain.dimension; ++axis) num_simplices *= domain.cells[axis];
  if (num_simplices <= std::numeric_limits<std::int32_t>::max()) return;
  context.section("domain").report(
      "cells", "makes " + number_text(num_simplices) + " simplices, but a mesh may have 2147483647. Give fewer cells.");
}

bool lies_in_domain(const DomainSettings& domain, const std::vector<double>& point) {
  if (!domain.is_box()) return true;
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    const bool is_valid_box = domain.min[axis] < domain.max[axis];  // else already reported
    if (is_valid_box && (point[axis] < domain.min[axis] || point[axis] > domain.max[axis])) return false;
  }
  return true;
}

}  // namespace tentpole
