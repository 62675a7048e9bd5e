#include "host/solver/mesh_names.hpp"

#include <algorithm>
#include <string>
#include <vector>

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

}  // namespace

NameUse name_use(const Case& settings) {
  NameUse use;
  for (const auto& [name, properties] : settings.materials)
    if (name != "all") use.regions.push_back(name);
  for (const auto& [name, condition] : settings.boundaries) use.boundaries.push_back(name);
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
      report("boundary." + toml_key(name), "the mesh has no such boundary (it has: " + listed(mesh.boundary_names) +
                                               "). Remove the table or name one of these.");
  for (const std::string& name : mesh.region_names)
    if (!settings.materials.count(name) && !settings.materials.count("all"))
      report("material." + toml_key(name),
             "the mesh has this region and the case no material for it. Add [material." + toml_key(name) + "].");
  for (const auto& [name, properties] : settings.materials)
    if (name != "all" && !contains(mesh.region_names, name))
      report("material." + toml_key(name), "the mesh has no such region (it has: " + listed(mesh.region_names) +
                                               "). Remove the table or name one of these.");
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace tentpole
