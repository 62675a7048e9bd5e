#include "host/problem/mesh_names.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "host/case_file/nearest_name.hpp"
#include "host/mesh/toml_name.hpp"

namespace tentpole {
namespace {

/// Names as they stand in a table's header.
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + toml_key(name);
  return text.empty() ? "none" : text;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> inner_names(const SpaceMesh& mesh) {
  std::vector<std::string> names;
  for (const InnerSide& side : mesh.inner_sides) names.push_back(side.name);
  return names;
}

/// What is wrong with the table of a condition whose side is none of the boundary.
std::string no_such_boundary(const Case& settings, const SpaceMesh& mesh, const std::string& name) {
  if (!contains(inner_names(mesh), name))
    return "the mesh has no such boundary (it has: " + listed(mesh.boundary_names) +
           "). Remove the table or name one of these.";
  if (name_use(settings).has_crack(name))
    return "this side is a crack, on which [fracture] says what the surfaces bear. Remove the table.";
  const std::string inside =
      "this side lies inside the body, between cells, where no condition can be. Remove the table";
  if (mesh.dimension == max_dimension) return inside + ".";
  return inside + ", or make the side a crack: [[fracture.crack]] with side = " + toml_string(name) + ".";
}

std::string no_such_crack(const std::string& name, const std::vector<std::string>& inner) {
  if (inner.empty()) return "the mesh has no such side, and none inside the body. Give points instead.";
  return "the mesh has no such side inside the body. " + suggestion(name, inner);
}

}  // namespace

NameUse name_use(const Case& settings) {
  NameUse use;
  for (const auto& [name, properties] : settings.materials)
    if (name != "all") use.regions.push_back(name);
  for (const auto& [name, condition] : settings.boundaries) use.boundaries.push_back(name);
  for (const CrackSettings& crack : settings.fracture.cracks)
    if (!crack.side.empty()) use.cracks.push_back(crack.side);
  return use;
}

void check_mesh_names(const Case& settings, const SpaceMesh& mesh) {
  std::vector<Problem> problems;
  const auto report = [&](const std::string& key, const std::string& reason) {
    problems.push_back({{settings.path.string(), 0, 0, key, ""}, reason});
  };
  for (const std::string& name : mesh.boundary_names)
    if (!settings.boundaries.count(name))
      report("boundary." + toml_key(name),
             "the mesh has this boundary and the case no condition for it. Add [boundary." + toml_key(name) + "].");
  for (const auto& [name, condition] : settings.boundaries)
    if (!condition.is_periodic() && !contains(mesh.boundary_names, name))
      report("boundary." + toml_key(name), no_such_boundary(settings, mesh, name));
  for (const std::string& name : mesh.region_names)
    if (!settings.materials.count(name) && !settings.materials.count("all"))
      report("material." + toml_key(name),
             "the mesh has this region and the case no material for it. Add [material." + toml_key(name) + "].");
  for (const auto& [name, properties] : settings.materials)
    if (name != "all" && !contains(mesh.region_names, name))
      report("material." + toml_key(name), "the mesh has no such region (it has: " + listed(mesh.region_names) +
                                               "). Remove the table or name one of these.");
  const std::vector<std::string> inner = inner_names(mesh);
  for (const CrackSettings& crack : settings.fracture.cracks)
    if (!crack.side.empty() && !contains(inner, crack.side))
      problems.push_back({crack.location, no_such_crack(crack.side, inner)});
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace tentpole
