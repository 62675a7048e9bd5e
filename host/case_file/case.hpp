#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/case_file/boundary_condition.hpp"
#include "host/case_file/expression.hpp"
#include "host/case_file/fracture_settings.hpp"
#include "host/case_file/input_error.hpp"
#include "host/case_file/material_properties.hpp"
#include "host/mesh/box_mesh.hpp"

namespace tentpole {

/// [domain]: a box with a generated mesh, or a mesh file.
struct DomainSettings {
  int dimension = 2;
  std::filesystem::path mesh_file;  ///< empty: the box below; otherwise resolved against the folder of the case file
  std::array<double, 3> min{};      ///< [m], the first D
  std::array<double, 3> max{};      ///< [m], the first D
  std::array<int, 3> cells{};       ///< intervals per direction, the first D
  MeshPattern pattern = MeshPattern::structured;
  std::uint64_t seed = 1;  ///< of the unstructured pattern

  bool is_box() const { return mesh_file.empty(); }
};

/// [front]
struct FrontSettings {
  double causality = 0.95;  ///< gamma in |grad tau| <= gamma / c, in (0, 1)
  bool smoothing = false;   ///< inclined tent poles improve the shape of cells; needs adaptivity or fracture
};

/// [adaptivity]
struct AdaptivitySettings {
  bool enabled = false;
  double error_tolerance = 0;  ///< dissipation that one element may have, over the reference energy
  double min_size = 0;         ///< [m]: a cell whose longest edge is at most this is not refined
  double max_size = std::numeric_limits<double>::infinity();  ///< [m]: coarsening makes no edge longer than this
  double coarsening = 0.05;  ///< elements below this part of the tolerance may be coarsened, in [0, 1); 0: none are
  std::optional<double> reference_energy;  ///< [J] (D = 2: per metre of thickness, D = 1: per m^2); absent: estimated
};

/// [[output.probe]]: a point whose state is recorded.
struct ProbeSettings {
  std::string name;
  std::array<double, 3> point{};  ///< [m]
  SourceLocation point_location{};
  double interval = 0;  ///< [s]; end / 200 unless given
};

/// [output]
struct OutputSettings {
  std::vector<double> snapshot_times;  ///< [s], ascending, in (0, end]; `snapshots = n` gives end * i / n, i = 1..n
  std::vector<std::string> fields{"displacement", "velocity", "stress"};  ///< of field_names.hpp
  std::vector<ProbeSettings> probes;
  double history_interval = 0;  ///< [s]; end / 200 unless given
};

/// A run as the user described it. SI units.
struct Case {
  std::filesystem::path path;  ///< of the case file, as given
  std::string title;           ///< the file's name without extension unless given
  Constants constants;
  DomainSettings domain;
  std::map<std::string, MaterialProperties> materials;  ///< by region
  std::map<std::string, BoundaryCondition> boundaries;  ///< by side or physical group; for a box every side has one
  VectorExpression initial_displacement;                ///< [m]
  VectorExpression initial_velocity;                    ///< [m/s]
  VectorExpression body_force;                          ///< acceleration b [N/kg]; the force density is rho b
  std::optional<VectorExpression> exact_displacement;   ///< [m]
  double end_time = 0;                                  ///< [s]
  int degree = 2;                                       ///< polynomial degree k in spacetime, 1..7
  FrontSettings front;
  AdaptivitySettings adaptivity;
  FractureSettings fracture;
  OutputSettings output;
  std::optional<double> checkpoint_minutes;  ///< wall-clock minutes between checkpoints; absent: none are written
  int batch_size = 0;                        ///< [run] patches per batch; 0: the solver chooses
  std::vector<std::string> warnings;         ///< what the user should know although the case is valid

  /// Material of a region as the kernels take it. Throws InputError that names the region if it has none.
  Material material(const std::string& region) const;

  /// Length over which damage goes from 0 to 1 [m]: as given, or c_p tau of the fastest material.
  double process_zone_size() const;
};

/// Reads and validates a case file. Each override is "section.key=value" with a TOML
/// value, or text that is taken as a string; it replaces what the file says before anything is validated.
/// Throws InputError with all problems of the file and the overrides at once.
Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// Sets what the case draws at random from: the unstructured pattern of a box, and the defects of nucleation.
/// Throws InputError for a mesh file without nucleation, where nothing is.
void set_seed(Case& settings, std::uint64_t seed);

}  // namespace tentpole
