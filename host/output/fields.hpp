#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/output/spacetime_element.hpp"

namespace tentpole {

enum class FieldPlace { point, cell };

/// A field of snapshots. What writes, checks and restores snapshots walks the table of these rows, so a new field is a
/// row of fields.cpp and a name for the case file (host/case_file/field_names.hpp).
struct OutputField {
  std::string_view name;
  int num_components;
  FieldPlace place;
  /// Appends the components. A field of cells has one value for the whole element and is given no values at a point.
  void (*append)(const SpacetimeElement& element, const PointFields& at_point, std::vector<double>& values);
};

/// Rows of these names, in their order. Throws std::invalid_argument for a name that has none or comes twice.
std::vector<const OutputField*> output_fields(const std::vector<std::string>& names);

}  // namespace tentpole
