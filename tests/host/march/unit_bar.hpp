#pragma once

#include <string>

#include "tests/host/run/case_text.hpp"

namespace tentpole::testing {

/// A bar of length 4 with rho = c_p = Z = 1, for D = 2 of width 0.5 in plane strain with nu = 0.21.
inline constexpr double bar_length = 4, bar_width = 0.5;

/// Domain, material, end time and degree; structured cells of this length, so that mid-span is a mesh line.
CaseText unit_bar(int dimension, int degree, double cell_length, double end);

/// Sides of the bar. `left`, `right`: "key = value" of the normal part, the tangential traction is zero; the long sides
/// slide without friction.
std::string bar_sides(int dimension, const std::string& left, const std::string& right);

/// What a test says of [fracture]; the tests' damage grows within tau = 1 unless they say otherwise.
struct FractureText {
  double threshold = 0.748, strength = 0.998, relaxation_time = 1, friction = 0, max_damage_step = 0.2;
};
std::string fracture_section(const FractureText& text);

/// [[fracture.crack]] across the bar at x.
std::string crack_across(int dimension, double x, double damage);

/// [[output.probe]] at x, in the middle of the width.
std::string bar_probe(int dimension, const std::string& name, double x, double interval);

}  // namespace tentpole::testing
