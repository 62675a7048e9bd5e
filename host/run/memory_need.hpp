#pragma once

#include <algorithm>

#include "host/case_file/case.hpp"

namespace tentpole {

/// What a run on the host allocates, estimated from the sizes of its structures [bytes]; the scratch of the threads is
/// not part of it. An adaptive run needs more as its cells become more.
struct MemoryNeed {
  double mesh = 0;    ///< while a generated mesh is made
  double run = 0;     ///< mesh, front and the elements below the front
  double output = 0;  ///< rows of history.csv and of the probes
  double peak() const { return std::max(mesh, run) + output; }
};

MemoryNeed memory_need(const Case& settings, double num_vertices, double num_cells);

/// Numbers of the mesh of a box, before it is made.
struct BoxCounts {
  double vertices = 1, cells = 1;
};
BoxCounts box_counts(const DomainSettings& domain);

/// Throws InputError with the figures where that is more than the memory of this machine.
void check_memory(const Case& settings, double num_vertices, double num_cells);

}  // namespace tentpole
