#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/fracture/strength_distribution.hpp"
#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// What decides the tests in a cell after a patch. A cell is tested once per patch.
struct DefectTestKey {
  std::uint64_t seed;
  std::int64_t cell_serial;    ///< of the front's cell, never reused
  std::int64_t patch_counter;  ///< of the patch that moved it, never reused
};

/// A test for nucleation: it is positive where the largest effective traction exceeds the strength.
struct DefectTest {
  Point position;
  double strength;
};

/// The `sampled` model (thesis 2.3.3): after a patch, each cell of its footprint, an interval (D = 1) or triangle (D =
/// 2), is tested at random points with fresh strengths. The number of tests is Poisson with mean density * measure.
/// Only those no stronger than `strongest` are drawn, in their right number and distribution; with the largest
/// effective traction of the patch as `strongest`, the others could not be positive. Tests depend on the arguments
/// only. They are drawn again for each patch, so nucleation depends on the mesh: DefectField does not.
std::vector<DefectTest> draw_defect_tests(const DefectTestKey& key, std::span<const Point> corners, double density,
                                          const StrengthDistribution& distribution, double strongest);

}  // namespace tentpole
