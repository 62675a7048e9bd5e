#include "host/mesh/random_offset.hpp"

#include <Random123/philox.h>

namespace tentpole {

double random_offset(std::uint64_t seed, std::uint32_t item, std::uint32_t axis) {
  r123::Philox4x32 philox;
  const r123::Philox4x32::key_type key{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const r123::Philox4x32::ctr_type counter{{item, axis, 0, 0}};
  const auto bits = static_cast<double>(philox(counter, key)[0]);
  return (bits + 0.5) / 2147483648.0 - 1;
}

}  // namespace tentpole
