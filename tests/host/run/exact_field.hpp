#pragma once

#include <string>
#include <vector>

#include "tests/host/run/case_text.hpp"

namespace tentpole::testing {

/// A solution of the elastodynamic equations as expressions in x, y, z, t.
struct ExactField {
  int dimension = 0;
  std::vector<std::string> displacement;         ///< [i]
  std::vector<std::string> velocity;             ///< [i]
  std::vector<std::vector<std::string>> stress;  ///< [i][j]
  std::vector<std::string> body_force;           ///< [i], N/kg; empty: none
};

/// What is prescribed on a side of a box.
enum class SideKind { velocity, traction, roller, slider, absorbing, periodic };

/// Sections [boundary.*], [initial], [body_force] and [exact] for this field: every prescribed value is the field's
/// own. `kinds`: per side, left, right, bottom, top, back, front. roller: normal velocity and tangential traction;
/// slider: the opposite (D = 1: its normal part alone).
std::string field_sections(const ExactField& field, const std::vector<SideKind>& kinds);

}  // namespace tentpole::testing
