#include "host/mesh/gmsh_file.hpp"

#include <fstream>

#include "host/mesh/msh/describe_msh.hpp"
#include "host/mesh/msh/read_msh.hpp"

namespace tentpole {

namespace {

std::string read_bytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw MeshError(path, "", "cannot be opened. Check the name and the permissions.");
  constexpr std::size_t piece = std::size_t{1} << 20;
  std::string bytes;
  for (std::size_t size = 0; stream; bytes.resize(size)) {
    bytes.resize(size + piece);
    stream.read(bytes.data() + size, piece);
    size += static_cast<std::size_t>(stream.gcount());
  }
  if (stream.bad()) throw MeshError(path, "", "cannot be read. Check that it is a file on a disk that works.");
  return bytes;
}

}  // namespace

SpaceMesh read_gmsh_file(const std::string& path, int dimension, const PeriodicPairs& periodic,
                         const std::optional<NameUse>& use) {
  return build_space_mesh(describe_msh(path, read_msh(path, read_bytes(path)), dimension, use), periodic);
}

}  // namespace tentpole
