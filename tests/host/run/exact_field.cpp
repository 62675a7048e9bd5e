#include "tests/host/run/exact_field.hpp"

namespace tentpole::testing {
namespace {

const char* const side_names[6] = {"left", "right", "bottom", "top", "back", "front"};

/// `factor` times the expressions.
std::vector<std::string> times(double factor, std::vector<std::string> expressions) {
  for (std::string& expression : expressions) expression = digits(factor) + "*(" + expression + ")";
  return expressions;
}

/// Part of a global vector along the side with normal sign * e_axis: along (-n_y, n_x) for D = 2, three global
/// components for D = 3.
std::string tangential_value(const std::vector<std::string>& vector, int axis, double sign) {
  if (vector.size() == 3) return expression_list(vector);
  return "\"" + times(axis == 0 ? sign : -sign, {vector[1 - axis]})[0] + "\"";
}

std::string by_components(const ExactField& field, int axis, double sign, bool velocity_along_normal) {
  const std::vector<std::string> traction = times(sign, field.stress[axis]);
  const std::vector<std::string>& normal = velocity_along_normal ? field.velocity : traction;
  const std::vector<std::string>& tangential = velocity_along_normal ? traction : field.velocity;
  std::string text = std::string(velocity_along_normal ? "normal_velocity" : "normal_traction") + " = \"" +
                     times(sign, normal)[axis] + "\"\n";
  if (field.dimension > 1)
    text += std::string(velocity_along_normal ? "tangential_traction" : "tangential_velocity") + " = " +
            tangential_value(tangential, axis, sign) + "\n";
  return text;
}

std::string side_section(const ExactField& field, int side, SideKind kind) {
  const int axis = side / 2;
  const double sign = side % 2 == 0 ? -1 : 1;
  const std::string header = std::string("[boundary.") + side_names[side] + "]\n";
  switch (kind) {
    case SideKind::velocity:
      return header + "velocity = " + expression_list(field.velocity) + "\n";
    case SideKind::traction:
      return header + "traction = " + expression_list(times(sign, field.stress[axis])) + "\n";
    case SideKind::roller:
      return header + by_components(field, axis, sign, true);
    case SideKind::slider:
      return header + by_components(field, axis, sign, false);
    case SideKind::absorbing:
      return header + "absorbing = true\n";
    case SideKind::periodic:
      return sign < 0 ? header + "periodic = \"" + side_names[side + 1] + "\"\n" : "";
  }
  return "";
}

}  // namespace

std::string field_sections(const ExactField& field, const std::vector<SideKind>& kinds) {
  std::string text;
  for (int side = 0; side < 2 * field.dimension; ++side) text += side_section(field, side, kinds[side]);
  text += "[initial]\ndisplacement = " + expression_list(field.displacement) +
          "\nvelocity = " + expression_list(field.velocity) + "\n";
  if (!field.body_force.empty()) text += "[body_force]\nacceleration = " + expression_list(field.body_force) + "\n";
  return text + "[exact]\ndisplacement = " + expression_list(field.displacement) + "\n";
}

}  // namespace tentpole::testing
