#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

/// A part of the design that this version does not have: its keys may be given, but it may not be switched on.
void refuse_if_enabled(const TableReader& reader, const std::string& what) {
  if (!reader.is_given()) return;
  const auto enabled = reader.boolean("enabled", Presence::required);
  if (enabled.value_or(false)) reader.report("enabled", what + " is not available yet. Set enabled = false.");
}

void check_order(const TableReader& reader, const char* smaller, const std::optional<double>& low, const char* larger,
                 const std::optional<double>& high) {
  if (low && high && !(*low < *high))
    reader.report(
        larger, std::string("must exceed ") + smaller + ". Give a larger " + larger + " or a smaller " + smaller + ".");
}

void check_nucleation(const TableReader& reader) {
  reader.allow_only({"model", "mean", "minimum", "maximum", "tail_strength", "tail_probability", "density", "seed"});
  reader.choice("model", Presence::required, {"field", "sampled", "none"});
  const Rule strength = positive("Give a strength in Pa.");
  const auto mean = reader.number("mean", Presence::optional, strength);
  const auto minimum = reader.number("minimum", Presence::optional, strength);
  const auto maximum = reader.number("maximum", Presence::optional, strength);
  const auto tail_strength = reader.number("tail_strength", Presence::optional, strength);
  reader.number("tail_probability", Presence::optional, between(0, 0.5, "Give P(strength < tail_strength)."));
  reader.number("density", Presence::optional, not_negative("Give the number of defects per m^2."));
  reader.integer("seed", Presence::optional, not_negative("Give 0, 1, 2, ..."));
  check_order(reader, "minimum", minimum, "mean", mean);
  check_order(reader, "mean", mean, "maximum", maximum);
  check_order(reader, "tail_strength", tail_strength, "mean", mean);
}

/// Point i of a crack; the polyline is given as an array of arrays.
void check_crack_point(const TableReader& reader, const Node& node, const SectionContext& context) {
  const int dimension = context.domain.dimension;
  std::vector<double> point;
  for (const Node& child : node.children)
    if (child.kind == Node::Kind::number || child.kind == Node::Kind::integer) point.push_back(child.number);
  if (node.kind != Node::Kind::array || point.size() != node.children.size() ||
      point.size() != static_cast<std::size_t>(dimension))
    reader.report(node, "is no point. Give an array of " + std::to_string(dimension) + " numbers.");
  else if (!lies_in_domain(context.domain, point))
    reader.report(node, "lies outside the box of [domain]. Give a point between domain.min and domain.max.");
}

void check_crack(const TableReader& reader, const SectionContext& context) {
  reader.allow_only({"points", "damage"});
  reader.number("damage", Presence::optional, from_to(0, 1, "Give the debonded fraction of the crack."));
  const Node* points = reader.find("points");
  if (!points || points->kind != Node::Kind::array || points->children.size() < 2) {
    reader.report("points", "must be an array of at least 2 points. Give the corners of the polyline.");
    return;
  }
  if (context.domain.dimension == 0) return;
  for (const Node& node : points->children) check_crack_point(reader, node, context);
}

}  // namespace

void check_adaptivity(const SectionContext& context) {
  const TableReader reader = context.section("adaptivity");
  reader.allow_only({"enabled", "error_tolerance", "min_size", "max_size"});
  reader.number("error_tolerance", Presence::optional,
                positive("Give the dissipation that an element may have, over the reference energy."));
  const auto min_size = reader.number("min_size", Presence::optional, positive("Give a length in m."));
  const auto max_size = reader.number("max_size", Presence::optional, positive("Give a length in m."));
  check_order(reader, "min_size", min_size, "max_size", max_size);
  refuse_if_enabled(reader, "adaptive refinement");
}

void check_fracture(const SectionContext& context) {
  const TableReader reader = context.section("fracture");
  reader.allow_only({"enabled", "threshold", "strength", "relaxation_time", "delay_exponent", "shear_factor",
                     "friction", "max_damage_step", "nucleation", "crack"});
  const auto threshold = reader.number("threshold", Presence::optional, positive("Give a traction in Pa."));
  const auto strength = reader.number("strength", Presence::optional, positive("Give a traction in Pa."));
  check_order(reader, "threshold", threshold, "strength", strength);
  reader.number("relaxation_time", Presence::optional, positive("Give a time in s."));
  reader.number("delay_exponent", Presence::optional, positive("The usual value is 10."));
  reader.number("shear_factor", Presence::optional, not_negative("The usual value is 1."));
  reader.number("friction", Presence::optional, not_negative("Give the coefficient of friction."));
  reader.number("max_damage_step", Presence::optional, from_to(1e-6, 1, "The usual value is 0.2."));
  if (const Node* nucleation = reader.find("nucleation")) {
    if (nucleation->kind == Node::Kind::table)
      check_nucleation(TableReader(*nucleation, context.problems));
    else
      reader.report(*nucleation, "must be a table. Write [fracture.nucleation].");
  }
  const std::vector<const Node*> cracks = reader.tables_in_array("crack");
  for (const Node* crack : cracks) check_crack(TableReader(*crack, context.problems), context);
  if (cracks.empty() || reader.has("enabled"))
    refuse_if_enabled(reader, "fracture");
  else
    reader.report(*cracks.front(),
                  "prepared cracks are not available yet. Remove them or set fracture.enabled = false.");
}

}  // namespace tentpole
