#include "device/core_quota.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// A group: its hierarchy's mount, and its path below it.
struct Group {
  fs::path mount;
  fs::path path;
  bool is_version_2 = false;
};

std::optional<double> share(double quota, double period) {
  if (!(quota > 0 && period > 0)) return std::nullopt;
  return quota / period;
}

/// "50000 100000": microseconds in each period; "max 100000": no quota.
std::optional<double> quota_of_version_2(const fs::path& folder) {
  double quota = 0, period = 0;
  if (!(std::ifstream(folder / "cpu.max") >> quota >> period)) return std::nullopt;
  return share(quota, period);
}

/// A negative number: no quota.
std::optional<double> quota_of_version_1(const fs::path& folder) {
  double quota = 0, period = 0;
  if (!(std::ifstream(folder / "cpu.cfs_quota_us") >> quota)) return std::nullopt;
  if (!(std::ifstream(folder / "cpu.cfs_period_us") >> period)) return std::nullopt;
  return share(quota, period);
}

/// Of the group and those above, up to the mount.
std::optional<double> least_quota(const Group& group) {
  std::optional<double> least;
  for (fs::path path = group.path.relative_path();; path = path.parent_path()) {
    const fs::path folder = group.mount / path;
    const std::optional<double> quota = group.is_version_2 ? quota_of_version_2(folder) : quota_of_version_1(folder);
    if (quota) least = least ? std::min(*least, *quota) : *quota;
    if (path.empty()) return least;
  }
}

bool controls_cores(const std::string& controllers) {
  std::istringstream names(controllers);
  for (std::string name; std::getline(names, name, ',');)
    if (name == "cpu") return true;
  return false;
}

}  // namespace

std::optional<double> core_quota(const fs::path& groups, const fs::path& membership) {
  std::optional<double> least;
  const auto consider = [&](const Group& group) {
    const std::optional<double> quota = least_quota(group);
    if (quota) least = least ? std::min(*least, *quota) : *quota;
  };
  std::ifstream lines(membership);
  // "0::/job" (version 2) or "4:cpu,cpuacct:/job" (version 1).
  for (std::string line; std::getline(lines, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
    if (controllers.empty()) {
      consider({groups, path, true});
      consider({groups / "unified", path, true});
    } else if (controls_cores(controllers)) {
      consider({groups / controllers, path, false});
      consider({groups / "cpu", path, false});
    }
  }
  return least;
}

}  // namespace tentpole
