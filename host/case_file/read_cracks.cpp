#include <algorithm>

#include "host/case_file/number_text.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

using CrackPoint = std::array<double, 3>;

/// A corner of the polyline, which is given as an array of arrays; nullopt with a problem if it is none.
std::optional<CrackPoint> read_point(const TableReader& reader, const Node& node, const DomainSettings& domain) {
  std::vector<double> coordinates;
  for (const Node& child : node.children)
    if (child.kind == Node::Kind::number || child.kind == Node::Kind::integer) coordinates.push_back(child.number);
  const auto size = static_cast<std::size_t>(domain.dimension);
  const bool are_usable = std::ranges::all_of(coordinates, has_usable_size);
  if (!are_usable || node.kind != Node::Kind::array || coordinates.size() != node.children.size() ||
      coordinates.size() != size) {
    reader.report(node, "is no point. Give an array of " + std::to_string(size) +
                            (are_usable ? " number" : " finite number") + (size > 1 ? "s." : "."));
    return std::nullopt;
  }
  if (!lies_in_domain(domain, coordinates)) {
    reader.report(node, "lies outside the box of [domain]. Give a point between domain.min and domain.max.");
    return std::nullopt;
  }
  CrackPoint point{};
  std::copy(coordinates.begin(), coordinates.end(), point.begin());
  return point;
}

/// True if both points lie on one side of a generated box.
bool on_one_side(const DomainSettings& domain, const CrackPoint& first, const CrackPoint& second) {
  if (!domain.is_box()) return false;
  for (int axis = 0; axis < domain.dimension; ++axis)
    for (const double side : {domain.min[axis], domain.max[axis]})
      if (first[axis] == side && second[axis] == side) return true;
  return false;
}

/// A segment must have a length, and material on both sides.
void check_segment(const TableReader& reader, const Node& node, const DomainSettings& domain, const CrackPoint& first,
                   const CrackPoint& second) {
  if (domain.dimension == 2 && first == second)
    reader.report(node, "is the point before it once more. Name each corner of the polyline once.");
  else if (on_one_side(domain, first, second))
    reader.report(node,
                  "makes a crack along a side of the box, where there is nothing to separate from. Move it inwards.");
}

/// The corners of the polyline, or the point of a bar.
std::vector<CrackPoint> read_points(const TableReader& reader, const SectionContext& context) {
  std::vector<CrackPoint> corners;
  const Node* points = reader.find("points");
  const int dimension = context.domain.dimension;
  const bool is_array = points && points->kind == Node::Kind::array;
  if (dimension == 1 && (!is_array || points->children.size() != 1)) {
    reader.report("points", "must be an array of one point, because domain.dimension is 1. Write points = [[x]].");
    return corners;
  }
  if (dimension != 1 && (!is_array || points->children.size() < 2)) {
    reader.report("points", "must be an array of at least 2 points. Give the corners of the polyline.");
    return corners;
  }
  if (dimension == 0) return corners;
  std::optional<CrackPoint> previous;
  for (const Node& node : points->children) {
    const auto point = read_point(reader, node, context.domain);
    if (point && (previous || dimension == 1))
      check_segment(reader, node, context.domain, previous.value_or(*point), *point);
    if (point) corners.push_back(*point);
    previous = point;
  }
  return corners;
}

/// A side of a mesh file; whether it exists and lies inside is not known before the mesh is read.
void read_side(const TableReader& reader, const SectionContext& context, CrackSettings& crack) {
  const DomainSettings& domain = context.domain;
  const auto side = reader.text("side", Presence::required);
  crack.side = side.value_or("");
  if (side && side->empty()) reader.report("side", "is empty. Name a physical group of the mesh.");
  if (reader.has("points")) reader.report("points", "is given besides side. Remove one of them.");
  if (domain.dimension > 2)
    reader.report("side", "is for domain.dimension 1 and 2, which is " + std::to_string(domain.dimension) +
                              ". Remove the crack.");
  else if (domain.dimension > 0 && domain.is_box())
    reader.report("side",
                  "names a side inside the body, but a generated box has sides on its boundary only, where there is "
                  "nothing to separate from. Give points instead.");
}

CrackSettings read_crack(const TableReader& reader, const SectionContext& context) {
  CrackSettings crack;
  reader.allow_only({"points", "side", "damage"});
  crack.damage = reader
                     .number("damage", Presence::required,
                             from_to(0, 1, "Give 1 for an open crack, 0 for a line along which damage may grow."))
                     .value_or(0);
  crack.location = reader.location(reader.has("side") ? "side" : "points");
  if (reader.has("side"))
    read_side(reader, context, crack);
  else
    crack.points = read_points(reader, context);
  return crack;
}

}  // namespace

std::vector<CrackSettings> read_cracks(const TableReader& fracture, const SectionContext& context) {
  std::vector<CrackSettings> cracks;
  for (const Node* table : fracture.tables_in_array("crack"))
    cracks.push_back(read_crack(TableReader(*table, context.problems), context));
  return cracks;
}

}  // namespace tentpole
