#pragma once

#include <array>
#include <string_view>

namespace tentpole {

/// What [output] fields may name. host/output/fields.cpp has a row for each.
inline constexpr std::array<std::string_view, 5> field_names{"displacement", "velocity", "stress",
                                                             "strain_energy_density", "damage"};

}  // namespace tentpole
