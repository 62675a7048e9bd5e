#include <algorithm>

#include "host/case_file/nearest_name.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

const std::vector<std::string> all_sides{"left", "right", "bottom", "top", "back", "front"};

std::vector<std::string> box_sides(int dimension) {
  return {all_sides.begin(), all_sides.begin() + 2 * dimension};
}

/// Axis of a side and the opposite side: left, right | bottom, top | back, front.
std::size_t side_index(const std::string& side) {
  return static_cast<std::size_t>(std::find(all_sides.begin(), all_sides.end(), side) - all_sides.begin());
}
const std::string& opposite(const std::string& side) {
  return all_sides[side_index(side) ^ 1];
}

Ramp read_ramp(const TableReader& reader, const SectionContext& context) {
  Ramp ramp;
  const auto rise_time = reader.number("ramp", Presence::optional, not_negative("Give the rise time in s."));
  const auto order = reader.choice("ramp_order", Presence::optional, {"cubic", "quintic"});
  if (order && !reader.has("ramp")) reader.report("ramp_order", "has no ramp. Give ramp = seconds, or remove it.");
  ramp.rise_time = rise_time.value_or(0);
  ramp.order = order.value_or(0) == 0 ? RampOrder::cubic : RampOrder::quintic;
  if (context.end_time > 0 && ramp.rise_time > context.end_time)
    context.warnings.push_back(to_string(reader.location("ramp")) +
                               ": the load is not fully applied when the run ends.");
  return ramp;
}

/// The keys that say what is prescribed, as far as they are given.
std::vector<std::string> given_conditions(const TableReader& reader) {
  std::vector<std::string> given;
  for (const char* key : {"normal_velocity", "tangential_velocity", "normal_traction", "tangential_traction",
                          "velocity", "traction", "absorbing", "periodic"})
    if (reader.has(key)) given.push_back(key);
  return given;
}

/// Which of the two keys of a component is given; nullopt with a problem unless it is exactly one.
std::optional<BoundaryKind> component_kind(const TableReader& reader, const std::string& component) {
  const std::string velocity = component + "_velocity", traction = component + "_traction";
  if (reader.has(velocity) && reader.has(traction)) {
    reader.report(traction, "is given besides " + velocity + ". Remove one of them.");
    return std::nullopt;
  }
  if (reader.has(velocity)) return BoundaryKind::velocity;
  if (reader.has(traction)) return BoundaryKind::traction;
  reader.report(velocity, "missing, and so is " + traction + ". Give one of them, e.g. " + traction + " = \"0\".");
  return std::nullopt;
}

/// Tangential data: D = 2 a scalar; D = 3 zero or three global components.
VectorExpression read_tangential(const TableReader& reader, const std::string& key, const SectionContext& context) {
  const Node* node = reader.find(key);
  if (context.domain.dimension == 3 && node->kind == Node::Kind::array)
    return reader.vector_expression(key, Presence::required, 3, context.constants).value_or(VectorExpression());
  const auto scalar = reader.expression(key, Presence::required, context.constants);
  if (!scalar) return {};
  if (context.domain.dimension == 2) return VectorExpression({*scalar});
  if (!scalar->is_zero())
    reader.report(key, "is ambiguous for domain.dimension = 3. Give \"0\" or three components in global axes.");
  return {};
}

std::optional<BoundaryCondition> read_components(const TableReader& reader, const SectionContext& context) {
  const int dimension = context.domain.dimension;
  const auto normal_kind = component_kind(reader, "normal");
  std::optional<BoundaryKind> tangential_kind = normal_kind;
  VectorExpression tangential;
  if (dimension == 1) {
    for (const char* key : {"tangential_velocity", "tangential_traction"})
      if (reader.has(key)) reader.report(key, "does not exist for domain.dimension = 1. Remove it.");
  } else {
    tangential_kind = component_kind(reader, "tangential");
    if (tangential_kind)
      tangential = read_tangential(
          reader, *tangential_kind == BoundaryKind::velocity ? "tangential_velocity" : "tangential_traction", context);
  }
  if (!normal_kind || !tangential_kind) return std::nullopt;
  const auto normal = reader.expression(*normal_kind == BoundaryKind::velocity ? "normal_velocity" : "normal_traction",
                                        Presence::required, context.constants);
  if (!normal) return std::nullopt;
  return BoundaryCondition::by_components(dimension, *normal_kind, *normal, *tangential_kind, tangential,
                                          read_ramp(reader, context));
}

std::optional<BoundaryCondition> read_vector(const TableReader& reader, const std::string& key,
                                             const SectionContext& context) {
  auto value = reader.vector_expression(key, Presence::required, context.domain.dimension, context.constants);
  if (!value) return std::nullopt;
  return BoundaryCondition::by_vector(key == "velocity" ? BoundaryKind::velocity : BoundaryKind::traction,
                                      std::move(*value), read_ramp(reader, context));
}

/// What an absorbing side may have besides: one of them given, the other is zero.
constexpr const char* far_field_keys[] = {"far_field_velocity", "far_field_traction"};

std::optional<BoundaryCondition> read_absorbing(const TableReader& reader, const SectionContext& context) {
  const auto absorbing = reader.boolean("absorbing", Presence::required);
  if (absorbing && !*absorbing)
    reader.report("absorbing", "leaves the side without a condition. Set it to true or give another condition.");
  if (!reader.has(far_field_keys[0]) && !reader.has(far_field_keys[1])) return BoundaryCondition::absorbing();
  const auto read = [&](const char* key) {
    return reader.vector_expression(key, Presence::optional, context.domain.dimension, context.constants)
        .value_or(VectorExpression());
  };
  return BoundaryCondition::absorbing(read(far_field_keys[0]), read(far_field_keys[1]));
}

std::optional<BoundaryCondition> read_periodic(const TableReader& reader, const std::string& side,
                                               const SectionContext& context) {
  const auto partner = reader.text("periodic", Presence::required);
  if (!partner) return std::nullopt;
  if (!context.domain.is_box()) {
    reader.report("periodic", "needs a generated box, but domain.mesh is given. Use another condition.");
    return std::nullopt;
  }
  if (*partner != opposite(side)) {
    reader.report("periodic", "must name the opposite side. Write periodic = \"" + opposite(side) + "\".");
    return std::nullopt;
  }
  const int cells = context.domain.cells[side_index(side) / 2];
  if (cells > 0 && cells < 3)
    reader.report("periodic", "needs at least 3 cells in its direction, but domain.cells has " + std::to_string(cells) +
                                  ". Give more cells.");
  return BoundaryCondition::periodic(*partner);
}

/// Reports a second way of prescribing the same side, a ramp without a load, and a far field of no absorbing side.
bool is_consistent(const TableReader& reader, const std::vector<std::string>& given) {
  const auto is_component = [](const std::string& key) { return key.find('_') != std::string::npos; };
  bool consistent = true;
  for (std::size_t i = 1; i < given.size(); ++i)
    if (!is_component(given[0]) || !is_component(given[i])) {
      reader.report(given[i], "is given besides " + given[0] + ". A side has one condition: remove one of them.");
      consistent = false;
    }
  for (const char* key : {"ramp", "ramp_order"})
    if (reader.has(key) && (given[0] == "absorbing" || given[0] == "periodic")) {
      reader.report(key, "has no load to ramp, because the side is " + given[0] + ". Remove it.");
      consistent = false;
    }
  for (const char* key : far_field_keys)
    if (reader.has(key) && given[0] != "absorbing") {
      reader.report(key, "is of an absorbing side, but the side has " + given[0] +
                             ". Remove it, or write absorbing = true instead of " + given[0] + ".");
      consistent = false;
    }
  return consistent;
}

std::optional<BoundaryCondition> read_side(const TableReader& reader, const std::string& side,
                                           const SectionContext& context) {
  reader.allow_only({"normal_velocity", "tangential_velocity", "normal_traction", "tangential_traction", "velocity",
                     "traction", "absorbing", "far_field_velocity", "far_field_traction", "periodic", "ramp",
                     "ramp_order"});
  const std::vector<std::string> given = given_conditions(reader);
  if (given.empty()) {
    reader.report("normal_traction",
                  "missing. Give the side a condition: normal_* and tangential_*, velocity, traction, "
                  "absorbing = true or periodic.");
    return std::nullopt;
  }
  if (!is_consistent(reader, given)) return std::nullopt;
  if (given[0] == "absorbing") return read_absorbing(reader, context);
  if (given[0] == "periodic") return read_periodic(reader, side, context);
  if (given[0] == "velocity" || given[0] == "traction") return read_vector(reader, given[0], context);
  return read_components(reader, context);
}

/// Periodic sides come in pairs: the partner may be left out, but not be something else.
void complete_periodic_pairs(const TableReader& reader, std::map<std::string, BoundaryCondition>& boundaries) {
  const auto given = boundaries;
  for (const auto& [side, condition] : given) {
    if (!condition.is_periodic()) continue;
    const std::string& partner = condition.periodic_partner();
    const auto other = given.find(partner);
    if (other == given.end() && !reader.has(partner))
      boundaries[partner] = BoundaryCondition::periodic(side);
    else if (other != given.end() && !other->second.is_periodic())
      reader.report(partner, "must be periodic too, because " + side + " is periodic with it. Write periodic = \"" +
                                 side + "\", or leave the table out.");
  }
}

}  // namespace

std::map<std::string, BoundaryCondition> read_boundaries(const SectionContext& context) {
  std::map<std::string, BoundaryCondition> boundaries;
  const TableReader reader = context.section("boundary");
  if (context.domain.dimension == 0) return boundaries;  // sides and components are unknown
  const bool is_box = context.domain.is_box();
  const std::vector<std::string> sides = box_sides(context.domain.dimension);
  for (const Node* table : reader.tables("[boundary.left]")) {
    if (is_box && std::find(sides.begin(), sides.end(), table->name) == sides.end()) {
      reader.report(*table, "unknown side of the box of dimension " + std::to_string(context.domain.dimension) + ". " +
                                suggestion(table->name, sides));
      continue;
    }
    if (auto condition = read_side(TableReader(*table, context.problems), table->name, context))
      boundaries[table->name] = std::move(*condition);
  }
  if (!is_box) return boundaries;
  complete_periodic_pairs(reader, boundaries);
  for (const std::string& side : sides)
    if (!boundaries.contains(side) && !reader.has(side))
      reader.report(side, "missing. Give [boundary." + side + "] a condition, e.g. traction or absorbing = true.");
  return boundaries;
}

}  // namespace tentpole
