#include "host/mesh/gmsh_module_loader.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>

namespace tentpole {

namespace {

constexpr const char* module_name = "tentpole_gmsh_module.so";

std::vector<std::filesystem::path> module_places() {
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return {folder / module_name, folder.parent_path() / "lib" / "tentpole" / module_name, TENTPOLE_GMSH_MODULE};
}

GmshModule load() {
  std::string tried;
  for (const std::filesystem::path& place : module_places()) {
    if (!std::filesystem::exists(place)) {
      tried += "\n  " + place.string() + ": not there";
      continue;
    }
    // Local, so that no symbol of Gmsh or of the libraries it brings can replace one of ours. Never closed: an OpenMP
    // runtime cannot be unloaded.
    void* handle = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
      tried += std::string("\n  ") + dlerror();
      continue;
    }
    return {reinterpret_cast<decltype(&tentpole_gmsh_read)>(dlsym(handle, "tentpole_gmsh_read")),
            reinterpret_cast<decltype(&tentpole_gmsh_release)>(dlsym(handle, "tentpole_gmsh_release"))};
  }
  throw std::runtime_error("the module that reads .msh files could not be loaded:" + tried +
                           "\nInstall the Gmsh library (Debian: libgmsh-dev) and build again.");
}

}  // namespace

const GmshModule& gmsh_module() {
  static const GmshModule module = load();
  return module;
}

}  // namespace tentpole
