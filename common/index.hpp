#pragma once

#include <cstdint>

namespace tentpole {

/// The index of a neighbour, element, vertex or edge that is not there.
inline constexpr std::int32_t none = -1;

}  // namespace tentpole
