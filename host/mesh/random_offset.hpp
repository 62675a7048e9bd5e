#pragma once

#include <cstdint>

namespace tentpole {

/// A number uniform in (-1, 1) that depends on (seed, item, axis) only, the same on every machine: Philox4x32-10
/// (Salmon et al., SC 2011) keyed by the seed, counted by item and axis; 32 bits of it are used.
double random_offset(std::uint64_t seed, std::uint32_t item, std::uint32_t axis);

}  // namespace tentpole
