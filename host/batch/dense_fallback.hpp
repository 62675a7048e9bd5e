#pragma once

#include <span>
#include <vector>

#include "common/status.hpp"
#include "host/batch/host_batch.hpp"
#include "host/problem/simulation.hpp"
#include "kernels/element/reference_tables.hpp"

namespace tentpole {

/// Solves one patch of a batch again, on the host, by pivoted dense LU of the reference matrix
/// (kernels/patch/dense_patch_solve.hpp), and fills its records. For patches whose residual check failed; counted by
/// the caller.
class DenseFallback {
 public:
  DenseFallback(HostBatch& batch, const PatchDescriptor& patch, const Simulation& simulation,
                const ReferenceTables& tables);

  /// Rows of the element store below the patch, in the order of its elements and their facets that have a source.
  /// Throws std::runtime_error with the place, the time and both statuses when the dense solution fails as well.
  void solve(std::span<const std::int32_t> source_slots, std::span<const double> coefficients,
             std::span<const double> inverse_jacobians);

  std::span<const std::int32_t> result_slots() const { return result_slots_; }
  std::span<const double> coefficients() const { return {coefficients_.data(), result_slots_.size() * num_unknowns_}; }
  std::span<const double> inverse_jacobians() const {
    return {inverse_jacobians_.data(), result_slots_.size() * num_jacobian_};
  }

 private:
  [[noreturn]] void fail(Status status) const;

  HostBatch& batch_;
  PatchDescriptor patch_;
  const Simulation& simulation_;
  const ReferenceTables& tables_;
  std::size_t num_unknowns_;
  std::size_t num_jacobian_;
  std::vector<std::int32_t> result_slots_;
  std::vector<double> coefficients_;  ///< results first, then sources
  std::vector<double> inverse_jacobians_;
};

}  // namespace tentpole
