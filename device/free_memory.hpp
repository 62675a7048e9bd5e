#pragma once

#include <cstdint>
#include <optional>

namespace tentpole {

/// Bytes that this process may still take: what the system can hand out without swapping, and no more than is left of a
/// limit on the address space (ulimit -v). Nothing where the system does not say.
std::optional<std::int64_t> free_host_memory();

}  // namespace tentpole
