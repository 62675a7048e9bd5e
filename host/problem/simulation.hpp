#pragma once

#include <vector>

#include "host/case_file/case.hpp"
#include "host/mesh/space_mesh.hpp"
#include "host/problem/scaling.hpp"
#include "kernels/fracture/damage_law.hpp"

namespace tentpole {

/// A case made concrete: its mesh, materials per region and conditions per boundary; all that a run reads and never
/// changes.
struct Simulation {
  Case settings;
  SpaceMesh mesh;  ///< scaled lengths
  Scaling scaling;
  std::vector<Material> materials;            ///< [region], SI
  std::vector<Material> scaled_materials;     ///< [region]
  std::vector<BoundaryCondition> conditions;  ///< [boundary]
  std::vector<double> cell_wave_speed;        ///< [cell], scaled c_p
  double smallest_edge = 0;                   ///< [m]
  double largest_edge = 0;                    ///< [m]
  std::vector<std::string> warnings;          ///< of case and mesh

  int dimension() const { return mesh.dimension; }
  int degree() const { return settings.degree; }
  double scaled_end_time() const { return settings.end_time / scaling.time(); }
  /// SI time [s]; the end time maps to itself exactly, so that output at the end is not missed by a rounding error.
  double time_in_seconds(double scaled) const {
    return scaled == scaled_end_time() ? settings.end_time : scaled * scaling.time();
  }
  /// The inverse: the end time maps to the scaled end time exactly.
  double scaled_time(double seconds) const { return seconds / scaling.time(); }
};

/// The law of the case's cracks in scaled units; zero where there is no fracture.
FractureLaw scaled_fracture_law(const Simulation& simulation);

}  // namespace tentpole
