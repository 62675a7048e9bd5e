#include "host/run/result_settings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "host/case_file/number_text.hpp"
#include "host/mesh/toml_name.hpp"

namespace tentpole {
namespace {

/// FNV-1a of 64 bits.
class Checksum {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) value_ = (value_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
  }
  template <class Value>
  void add(const std::vector<Value>& values) {
    add(std::as_bytes(std::span(values)));
  }
  void add(double value) { add(std::as_bytes(std::span(&value, 1))); }
  std::string text() const { return std::to_string(value_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

std::string list_text(std::span<const double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "[" : ", ") + number_text(value);
  return text.empty() ? "[]" : text + "]";
}

std::string expression_text(const VectorExpression& expression) {
  std::string text;
  for (const Expression& component : expression.components()) text += (text.empty() ? "" : ", ") + component.text();
  return "[" + text + "]";
}

struct Box {
  std::array<double, 3> min{}, max{};  ///< [m]
};

Box bounding_box(const Simulation& simulation) {
  Box box;
  box.min.fill(INFINITY);
  box.max.fill(-INFINITY);
  for (const Point& vertex : simulation.mesh.vertices)
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], vertex[axis] * simulation.scaling.length);
      box.max[axis] = std::max(box.max[axis], vertex[axis] * simulation.scaling.length);
    }
  return box;
}

/// Values on normals along x and along y, which show the normal and all tangential components. The events are the
/// points of Roberts' low-discrepancy sequence in four dimensions.
std::string load_checksum(BoundaryCondition condition, const Box& box, double end_time) {
  constexpr int num_events = 4096;
  constexpr double root = 1.1673039782614187;  // of g^5 = g + 1
  Checksum checksum;
  for (int event = 1; event <= num_events; ++event) {
    std::array<double, 4> share;
    for (int axis = 0; axis < 4; ++axis) share[axis] = std::fmod(event * std::pow(root, -(axis + 1)), 1.0);
    std::array<double, 3> point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = std::lerp(box.min[axis], box.max[axis], share[axis]);
    if (condition.has_far_field()) try {
        for (const double component : condition.far_field_velocity(point, share[3] * end_time)) checksum.add(component);
      } catch (const InputError&) {
        checksum.add(std::nan(""));
      }
    for (const std::array<double, 3>& normal : {std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0}}) try {
        for (const double component : condition.value(point, share[3] * end_time, normal)) checksum.add(component);
      } catch (const InputError&) {
        checksum.add(std::nan(""));  // inside the domain a load need not be finite
      }
  }
  return checksum.text();
}

std::string kind_text(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::traction:
      return "traction";
    case BoundaryKind::velocity:
      return "velocity";
    case BoundaryKind::absorbing:
      return "absorbing";
  }
  return "unknown";
}

/// Collects settings under dotted keys.
class SettingList {
 public:
  void add(const std::string& key, std::string value) { settings_.emplace_back(key, std::move(value)); }
  void add(const std::string& key, const char* value) { settings_.emplace_back(key, value); }
  void add(const std::string& key, double value) { add(key, number_text(value)); }
  void add(const std::string& key, std::int64_t value) { add(key, std::to_string(value)); }
  std::vector<Setting> take() { return std::move(settings_); }

 private:
  std::vector<Setting> settings_;
};

void add_domain(const Simulation& simulation, SettingList& list) {
  const DomainSettings& domain = simulation.settings.domain;
  list.add("domain.dimension", std::int64_t{domain.dimension});
  if (domain.is_box()) {
    const auto size = static_cast<std::size_t>(domain.dimension);
    list.add("domain.min", list_text(std::span(domain.min).first(size)));
    list.add("domain.max", list_text(std::span(domain.max).first(size)));
    const std::vector<double> cells(domain.cells.begin(), domain.cells.begin() + domain.dimension);
    list.add("domain.cells", list_text(cells));
    const bool structured = domain.pattern == MeshPattern::structured;
    list.add("domain.pattern", structured ? "structured" : "unstructured");
    if (!structured) list.add("domain.seed", std::to_string(domain.seed));
  }
  const SpaceMesh& mesh = simulation.mesh;
  list.add("number of vertices", std::int64_t{mesh.num_vertices()});
  list.add("number of cells", std::int64_t{mesh.num_cells()});
  Checksum checksum;
  checksum.add(mesh.vertices);
  checksum.add(mesh.shifts);
  checksum.add(mesh.cells);
  checksum.add(mesh.corner_shift);
  checksum.add(mesh.cell_region);
  checksum.add(mesh.facet_boundary);
  checksum.add(simulation.scaling.length);
  for (const auto* names : {&mesh.region_names, &mesh.boundary_names})
    for (const std::string& name : *names) checksum.add(std::vector<char>(name.begin(), name.end()));
  list.add("checksum of the mesh", checksum.text());
}

void add_materials(const Case& settings, SettingList& list) {
  for (const auto& [name, material] : settings.materials) {
    const std::string key = "material." + toml_key(name);
    list.add(key + ".density", material.density);
    list.add(key + ".youngs_modulus", material.youngs_modulus);
    list.add(key + ".poisson_ratio", material.poisson_ratio);
    list.add(key + ".plane", material.plane == Plane::strain ? "strain" : "stress");
  }
}

void add_boundaries(const Simulation& simulation, SettingList& list) {
  const Box box = bounding_box(simulation);
  for (const auto& [name, condition] : simulation.settings.boundaries) {
    const std::string key = "boundary." + toml_key(name);
    if (condition.is_periodic()) {
      list.add(key + ".periodic", condition.periodic_partner());
      continue;
    }
    list.add(key + " (normal)", kind_text(condition.normal_kind()));
    list.add(key + " (tangential)", kind_text(condition.tangential_kind()));
    if (condition.has_far_field()) list.add(key + " (far field)", "given");
    list.add(key + ".ramp", condition.ramp().rise_time);
    list.add(key + ".ramp_order", condition.ramp().order == RampOrder::cubic ? "cubic" : "quintic");
    if (!condition.is_zero())
      list.add("checksum of " + key, load_checksum(condition, box, simulation.settings.end_time));
  }
}

void add_fields(const Case& settings, SettingList& list) {
  list.add("initial.displacement", expression_text(settings.initial_displacement));
  list.add("initial.velocity", expression_text(settings.initial_velocity));
  list.add("body_force.acceleration", expression_text(settings.body_force));
  if (settings.exact_displacement) list.add("exact.displacement", expression_text(*settings.exact_displacement));
}

void add_adaptivity(const AdaptivitySettings& adaptivity, SettingList& list) {
  if (!adaptivity.enabled) return list.add("adaptivity", "off");
  list.add("adaptivity.error_tolerance", adaptivity.error_tolerance);
  list.add("adaptivity.min_size", adaptivity.min_size);
  list.add("adaptivity.max_size", adaptivity.max_size);
  list.add("adaptivity.coarsening", adaptivity.coarsening);
  if (adaptivity.reference_energy) list.add("adaptivity.reference_energy", *adaptivity.reference_energy);
}

void add_nucleation(const NucleationSettings& nucleation, SettingList& list) {
  const std::string key = "fracture.nucleation.";
  list.add(key + "model", std::to_string(static_cast<int>(nucleation.model)));
  if (nucleation.model == NucleationModel::nowhere) return;
  list.add(key + "distribution", std::to_string(static_cast<int>(nucleation.distribution)));
  list.add(key + "seed", std::to_string(nucleation.seed));
  list.add(key + "density", nucleation.density);
  list.add(key + "minimum", nucleation.minimum);
  list.add(key + "maximum", nucleation.maximum);
  list.add(key + "mean", nucleation.mean);
  list.add(key + "tail_strength", nucleation.tail_strength);
  list.add(key + "tail_probability", nucleation.tail_probability);
  list.add(key + "weibull_modulus", nucleation.weibull_modulus);
  list.add(key + "weibull_scale", nucleation.weibull_scale);
}

void add_fracture(const FractureSettings& fracture, SettingList& list) {
  if (!fracture.enabled) return list.add("fracture", "off");
  list.add("fracture.threshold", fracture.threshold);
  list.add("fracture.strength", fracture.strength);
  list.add("fracture.relaxation_time", fracture.relaxation_time);
  list.add("fracture.delay_exponent", fracture.delay_exponent);
  list.add("fracture.shear_factor", fracture.shear_factor);
  list.add("fracture.friction", fracture.friction);
  list.add("fracture.max_damage_step", fracture.max_damage_step);
  if (fracture.process_zone_size) list.add("fracture.process_zone_size", *fracture.process_zone_size);
  if (fracture.growth_length) list.add("fracture.growth_length", *fracture.growth_length);
  int number = 0;
  for (const CrackSettings& crack : fracture.cracks) {
    const std::string key = "fracture.crack " + std::to_string(++number);
    std::string points;
    for (const auto& point : crack.points) points += list_text(point) + " ";
    if (crack.side.empty())
      list.add(key + " points", points);
    else
      list.add(key + " side", crack.side);
    list.add(key + " damage", crack.damage);
  }
  add_nucleation(fracture.nucleation, list);
}

void add_output(const OutputSettings& output, SettingList& list) {
  list.add("output.snapshots", list_text(output.snapshot_times));
  std::string fields;
  for (const std::string& field : output.fields) fields += field + " ";
  list.add("output.fields", fields);
  list.add("output.history_interval", output.history_interval);
  for (const ProbeSettings& probe : output.probes) {
    list.add("output.probe." + probe.name + ".point", list_text(probe.point));
    list.add("output.probe." + probe.name + ".interval", probe.interval);
  }
}

}  // namespace

std::vector<Setting> result_settings(const Simulation& simulation) {
  const Case& settings = simulation.settings;
  SettingList list;
  // What others derive from comes first, so that the first difference names the cause.
  for (const auto& [name, value] : settings.constants) list.add("constants." + name, value);
  list.add("time.end", settings.end_time);
  list.add("discretization.degree", std::int64_t{settings.degree});
  list.add("front.causality", settings.front.causality);
  list.add("front.smoothing", settings.front.smoothing ? "true" : "false");
  add_domain(simulation, list);
  add_materials(settings, list);
  add_boundaries(simulation, list);
  add_fields(settings, list);
  add_adaptivity(settings.adaptivity, list);
  add_fracture(settings.fracture, list);
  add_output(settings.output, list);
  return list.take();
}

std::string first_difference(const std::vector<Setting>& there, const std::vector<Setting>& here) {
  const auto value_of = [](const std::vector<Setting>& settings, const std::string& key) {
    const auto found =
        std::find_if(settings.begin(), settings.end(), [&](const Setting& setting) { return setting.first == key; });
    return found == settings.end() ? "absent" : found->second;
  };
  // Lists of output times can be very long.
  const auto shown = [](const std::string& value) { return value.size() < 80 ? value : value.substr(0, 77) + "..."; };
  for (const auto* settings : {&there, &here})
    for (const auto& [key, ignored] : *settings)
      if (const std::string old_value = value_of(there, key), new_value = value_of(here, key); old_value != new_value)
        return key + " is " + shown(old_value) + " there and " + shown(new_value) + " here";
  return "";
}

}  // namespace tentpole
