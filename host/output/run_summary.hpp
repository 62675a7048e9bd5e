#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/output/output_folder.hpp"

namespace tentpole {

/// Time spent in one stage.
struct StageTime {
  double seconds = 0;
};

/// Everything in summary.json (docs/results.md). Units: s, J (per unit of the missing dimensions), m, bytes.
struct RunSummary {
  std::string title;
  std::string formulation = "one-field";
  int dimension = 0;
  int degree = 0;
  double end_time = 0;  ///< [s]
  std::string device;   ///< "host" or the name of the OpenMP device
  int threads = 0;
  std::uint64_t seed = 0;

  struct Counts {
    std::int64_t patches = 0;
    std::int64_t elements = 0;
    std::int64_t dofs = 0;  ///< unknowns solved for, over all accepted elements
    std::int64_t rejected = 0;
    std::int64_t min_size_hits = 0;  ///< refinements that were wanted and not made because cells have the least size
    std::int64_t splits = 0;         ///< cells cut in two
    std::int64_t deletions = 0;      ///< vertices taken out
    std::int64_t flips = 0;          ///< edges turned
    std::int64_t inclined = 0;       ///< tents with an inclined pole
    std::int64_t cells_min = 0;
    std::int64_t cells_max = 0;
    double smallest_cell = 0;  ///< [m], shortest edge that the front ever had
    double largest_cell = 0;   ///< [m], longest edge that it ever had
    std::int64_t batches = 0;
    std::int64_t dense_fallbacks = 0;  ///< patches that needed the pivoted dense solution
  } counts;

  struct Stages {
    StageTime initialization, meshing, assembly, solution, post_solution, transfer, fracture, output;
    StageTime total;  ///< wall time of the run
  } stages;

  /// Useful floating point operations of assembly, solution and post-solution, where they were counted.
  std::optional<double> flops;

  struct Energy {
    double initial = 0;
    double external_work = 0;
    double kinetic = 0;
    double strain = 0;
    double fracture = 0;
    double friction = 0;
    double numerical = 0;
    /// Over all patches, relative to the largest energy that passed through one element: the largest gain of energy
    /// beyond the external work (not positive but for rounding), and the largest defect of the balance.
    double largest_patch_increase = 0;
    double largest_patch_imbalance = 0;
    /// initial + external_work - kinetic - strain - fracture - friction - numerical.
    double balance_error() const;
  } energy;

  /// One of the parts into which fully failed edges cut the body.
  struct Fragment {
    double size = 0;                        ///< [m^D]
    double mass = 0;                        ///< [kg, per unit of the missing dimensions]
    std::array<double, 3> mean_velocity{};  ///< [m/s]
  };

  struct FirstNucleation {
    double time = 0;                   ///< [s], of the front there
    std::array<double, 3> position{};  ///< [m], of the defect that gave way
  };

  /// At the end of the run.
  struct Fracture {
    std::int64_t nucleations = 0;
    std::int64_t extensions = 0;
    std::int64_t branches = 0;
    std::int64_t coalescences = 0;
    double crack_length = 0;    ///< [m^(D-1)], surfaces with D >= 0.999
    double surface_length = 0;  ///< [m^(D-1)], all fracture surfaces
    double damage_mean = 0;     ///< over all fracture surfaces
    double damage_max = 0;
    std::optional<FirstNucleation> first_nucleation{};
    std::vector<Fragment> fragments{};  ///< one entry for a body that is whole; empty where nobody looked
    /// Whether a failed surface runs through the whole body.
    bool spalled() const { return fragments.size() > 1; }
  } fracture;

  struct Errors {
    double displacement_l2 = 0;
    double displacement_l2_relative = 0;
    double energy_norm = 0;
  };
  std::optional<Errors> errors;  ///< when the case has [exact]

  struct Traffic {
    std::int64_t bytes_to_device = 0;
    std::int64_t bytes_from_device = 0;
    std::int64_t launches = 0;
  } traffic;

  std::vector<std::string> warnings;
};

/// Writes summary.json into `folder`, atomically, with what the program knows about itself added: version, git
/// revision, compiler, processor, cores, peak resident memory. percent = share of the stage in the total; rates:
/// patches and dofs per second of the total, gflops = flops per second of assembly + solution + post-solution. Numbers
/// that are not finite become null and a warning that names them. Throws std::runtime_error if the file cannot be
/// written.
void write_run_summary(const OutputFolder& folder, const RunSummary& summary);

}  // namespace tentpole
