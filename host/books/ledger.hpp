#pragma once

#include <cstdint>
#include <span>

#include "common/exact_sum.hpp"
#include "host/batch/host_batch.hpp"
#include "host/books/exact_errors.hpp"
#include "host/output/history.hpp"
#include "host/output/recorder.hpp"
#include "host/output/run_summary.hpp"
#include "host/problem/simulation.hpp"

namespace tentpole {

/// Books of a run: counts and energies of all committed patches (exact sums, so the order of batches does not matter),
/// and what goes to the recorder and the history. Energies are SI [J per metre of each missing dimension].
class Ledger {
 public:
  Ledger(const Simulation& simulation, Recorder& recorder, History& history);

  /// Names the elements whose coefficients the output will need once the batch is solved, and the slices whose energies
  /// the history will need.
  void mark_wanted(HostBatch& batch) const;

  /// Books the patches of a solved batch that are accepted ([patch], or all of them where it is empty). With
  /// `check_balance` throws std::runtime_error for a patch whose energy balance does not close to 1e-9.
  void commit(const HostBatch& batch, bool check_balance, std::span<const std::uint8_t> accepted = {});

  /// Throws std::runtime_error unless the energy of a run that has reached its end is balanced (energy_balance.hpp).
  void require_balance() const;

  /// PatchEnergies::largest over all committed patches, scaled.
  double energy_scale() const { return energy_scale_; }

  /// Counts, energies and errors so far.
  void fill(RunSummary& summary) const;

  std::int64_t num_patches() const { return num_patches_; }
  /// Largest |E_out - E_in + dissipation + fracture work - work| of a patch relative to the largest energy that passed
  /// through one.
  double largest_imbalance() const;
  /// Largest E_out - E_in - work of a patch relative likewise; not positive but for rounding.
  double largest_increase() const;

  void save(std::ostream& stream) const;
  void load(std::istream& stream);

 private:
  void commit_patch(const HostBatch& batch, std::size_t patch_index, bool check_balance);
  void commit_fractures(const HostBatch& batch, const PatchDescriptor& patch);
  void commit_element(const HostBatch& batch, std::int32_t element);
  void record_wanted(const HostBatch& batch, std::size_t index);
  void request_slices(HostBatch& batch, std::int32_t element) const;
  void commit_slice(const HostBatch& batch, std::size_t request);

  const Simulation& simulation_;
  Recorder& recorder_;
  History& history_;
  ExactErrors errors_;
  OrthonormalBasis basis_;
  std::int64_t num_patches_ = 0;
  std::int64_t num_elements_ = 0;
  std::int64_t num_batches_ = 0;
  ExactSum initial_, external_work_, numerical_, kinetic_, strain_, fracture_, friction_, modelled_flops_;
  double largest_energy_ = 0;
  double energy_scale_ = 0;
  double largest_imbalance_ = 0;
  double largest_increase_ = 0;
};

}  // namespace tentpole
