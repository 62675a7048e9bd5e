#pragma once

#include <memory>
#include <vector>

#include "bench/lu/patch_systems.hpp"
#include "kernels/launch/patch_solver.hpp"

namespace tentpole {

/// Every variant solves the diagonally scaled system (s_a K_ab s_b) y = s_a b_a, c = s y, of the first patch, starting
/// from a copy of its matrix; `solution` receives c. The memory of a variant lives in its object, so that repetitions
/// do not allocate.

/// LAPACK's dgetrf and dgetrs (pivoting by rows).
class LapackSolve {
 public:
  void solve(const PatchSystems& systems, std::vector<double>& solution);

 private:
  std::vector<double> factors_;
  std::vector<int> pivots_;
};

/// Eigen's PartialPivLU, one thread.
class EigenSolve {
 public:
  EigenSolve();
  ~EigenSolve();
  void solve(const PatchSystems& systems, std::vector<double>& solution);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// Ours without structure: right-looking in blocks of 192 pivots, each a partial elimination of everything that is left
/// (kernels/coupling/eliminate.hpp: 4 x 8 tiles in registers). No pivoting: sym(K) is positive (docs/formulation.md).
class DenseSolve {
 public:
  void solve(const PatchSystems& systems, std::vector<double>& solution);

 private:
  std::vector<double> matrix_, packed_, right_;
};

/// Ours with structure: trace condensation, element LU and a coupling system (kernels/launch/patch_solver.hpp), for the
/// first num_patches patches, in threads over patches. Assembly and records belong to that solver's call and are not
/// part of its time.
class CondensedSolve {
 public:
  CondensedSolve(PatchSystems& systems, int num_patches, int num_threads);

  /// Solves the patches and returns the time of the solution stage [s]: the call's wall time times the share of the
  /// stage in the cycles of all threads.
  double solve();
  /// Of patch 0.
  std::vector<double> solution() const;
  /// Operations of elimination, coupling and recovery of all these patches (flops_per_element less its assembly).
  double flops() const;

 private:
  PatchSystems* systems_;
  ReferenceTables tables_;
  PatchSolverTask task_{};
  std::vector<double> scratch_;
  std::vector<StageCycles> cycles_;
};

}  // namespace tentpole
