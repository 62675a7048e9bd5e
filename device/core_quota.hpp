#pragma once

#include <filesystem>
#include <optional>

namespace tentpole {

/// How many cores' worth of time the control groups of this process grant it (batch systems, containers), e.g. 0.5:
/// the least of its group and those above. None where there is no quota or no control group. Reads cpu.max (version 2)
/// and cpu.cfs_quota_us, cpu.cfs_period_us (version 1). `groups`: where the groups are mounted; `membership`: which
/// ones the process is in. A container may see its own group as the root of `groups` under a path that it cannot see.
std::optional<double> core_quota(const std::filesystem::path& groups = "/sys/fs/cgroup",
                                 const std::filesystem::path& membership = "/proc/self/cgroup");

}  // namespace tentpole
