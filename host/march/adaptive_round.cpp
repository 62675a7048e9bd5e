#include "host/march/adaptive_round.hpp"

#include <algorithm>
#include <exception>

#include "device/work_queue.hpp"
#include "host/batch/energy_balance.hpp"

namespace tentpole {
namespace {

/// Plans at different local minima only read the front, so threads share them. Of several failures the first in the
/// order of the vertices is thrown.
std::vector<RoundPatch> plan_patches(const AdaptiveState& state) {
  ScopedStage stage(state.books.timer, Stage::meshing);
  const std::vector<std::int32_t> minima = state.front.local_minima(state.books.simulation.scaled_end_time());
  const int count = static_cast<int>(minima.size());
  std::vector<RoundPatch> patches(count);
  std::exception_ptr failure;
  int failed = count;
#pragma omp parallel for num_threads(state.books.runner.num_host_threads()) schedule(monotonic : dynamic, 4)
  for (int i = 0; i < count; ++i) try {
      patches[i].plan = plan_patch(state, minima[i]);
    } catch (...) {
#pragma omp critical(tentpole_plan_failure)
      if (i < failed) {
        failed = i;
        failure = std::current_exception();
      }
    }
  if (failure) std::rethrow_exception(failure);
  return patches;
}

void write_batch(AdaptiveState& state, PatchWriter& writer, std::span<RoundPatch> patches, std::int32_t number,
                 HostBatch& batch) {
  ScopedStage stage(state.books.timer, Stage::meshing);
  for (RoundPatch& patch : patches) {
    patch.batch = number;
    patch.patch = static_cast<std::int32_t>(batch.patches.size());
    writer.write(patch.plan, batch);
  }
  batch.num_slots = state.books.store.num_slots();
  state.books.ledger.mark_wanted(batch);
}

}  // namespace

AdaptiveRound solve_round(AdaptiveState& state, PatchWriter& writer, int max_patches) {
  AdaptiveRound round{.patches = plan_patches(state), .batches = {}};
  const std::size_t size = max_patches, count = (round.patches.size() + size - 1) / size;
  round.batches.resize(count);  // before any is solved: they must not move
  try {
    WorkQueue queue;
    for (std::size_t number = 0; number < count; ++number) {
      const std::size_t first = number * size, length = std::min(size, round.patches.size() - first);
      HostBatch& batch = round.batches[number];
      write_batch(state, writer, std::span(round.patches).subspan(first, length), static_cast<std::int32_t>(number),
                  batch);
      queue.wait();
      queue.submit([&] { state.books.runner.run(batch); });
    }
    queue.wait();
    double energy_scale = state.books.ledger.energy_scale();
    for (const HostBatch& batch : round.batches) raise_energy_scale(energy_scale, batch);
    for (RoundPatch& patch : round.patches)
      patch.verdict = judge_patch(state, patch.plan, round.batch_of(patch), patch.patch, energy_scale);
  } catch (...) {
    give_up_round(state, round);
    throw;
  }
  return round;
}

void give_up_round(AdaptiveState& state, const AdaptiveRound& round) {
  for (const HostBatch& batch : round.batches)
    for (const ElementDescriptor& element : batch.elements) state.books.store.release(element.result_slot);
  state.books.store.end_batch();
}

}  // namespace tentpole
