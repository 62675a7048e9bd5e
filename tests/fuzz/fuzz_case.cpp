#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "host/mesh/mesh_error.hpp"
#include "host/problem/check_expressions.hpp"
#include "host/run/check_probes.hpp"
#include "host/run/check_workload.hpp"
#include "host/run/make_simulation.hpp"
#include "host/run/memory_need.hpp"
#include "host/run/tent_estimate.hpp"

// The way of a case file, from its bytes to a checked case with the mesh of its box and the first tents on it. Whatever
// the bytes are, they make a case that can be run, an InputError or a MeshError; anything else ends the program.
namespace tentpole {
namespace {

void require(bool holds, const char* invariant) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", invariant);
  std::abort();
}

/// A file that is in memory only.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("case", 0)) {
    require(descriptor_ >= 0 && write(descriptor_, data, size) == static_cast<ssize_t>(size), "a file can be made");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// Larger meshes and higher degrees take longer and show nothing else.
bool is_small(const Case& settings, double most_cells) {
  return settings.domain.is_box() && box_counts(settings.domain).cells <= most_cells;
}

void check(const Simulation& simulation) {
  require(simulation.scaling.length > 0 && simulation.scaling.speed > 0, "units are positive");
  require(simulation.smallest_edge > 0 && simulation.smallest_edge <= simulation.largest_edge, "edges have a length");
  check_workload(simulation);
  check_probes(simulation);
  const TentEstimate tents = estimate_tents(simulation, 20);
  require(tents.patches >= 1 && tents.elements >= tents.patches, "a run has tents");
  if (simulation.degree() <= 2) check_expressions(simulation);
}

}  // namespace
}  // namespace tentpole

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tentpole;
  const MemoryFile file(data, size);
  try {
    Case settings = read_case(file.path());
    if (is_small(settings, 24)) check(make_simulation(std::move(settings)));
  } catch (const InputError& error) {
    require(error.what()[0] != '\0', "a refusal has a message");
  } catch (const MeshError& error) {
    require(error.what()[0] != '\0', "a refusal has a message");
  }
  return 0;
}
