#include <cerrno>
#include <cstring>

#include <unistd.h>

#include "host/command_line/commands.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// In the source tree the program is in build/PRESET, installed it is in bin.
fs::path find_plot_script() {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path candidates[] = {folder / "../../scripts/plot.py", folder / "../share/tentpole/scripts/plot.py"};
  for (const fs::path& candidate : candidates)
    if (fs::is_regular_file(candidate)) return candidate.lexically_normal();
  throw InputError("plot: the script plot.py is neither " + candidates[0].lexically_normal().string() + " nor " +
                   candidates[1].lexically_normal().string() + ". Run it yourself: python3 scripts/plot.py DIR.");
}

}  // namespace

int plot_command(const std::vector<std::string>& arguments) {
  // Debian's packages (numpy, matplotlib, h5py) belong to Debian's Python; another one may come first in the path.
  const std::string python = "/usr/bin/python3", script = find_plot_script().string();
  std::vector<char*> argv{const_cast<char*>(python.c_str()), const_cast<char*>(script.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(python.c_str(), argv.data());
  throw InputError("plot: cannot start " + python + " (" + std::strerror(errno) + "). Install the package python3.");
}

}  // namespace tentpole
