#include "host/adaptive/adaptive_round.hpp"

#include <algorithm>

#include "device/work_queue.hpp"

namespace tentpole {
namespace {

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
  AdaptiveRound round;
  {
    ScopedStage stage(state.books.timer, Stage::meshing);
    for (const std::int32_t vertex : state.front.local_minima(state.books.simulation.scaled_end_time()))
      round.patches.push_back({plan_patch(state, vertex), 0, 0, {}});
  }
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
  } catch (...) {
    give_up_round(state, round);
    throw;
  }
  for (RoundPatch& patch : round.patches)
    patch.verdict = judge_patch(state, patch.plan, round.batch_of(patch), patch.patch);
  return round;
}

void give_up_round(AdaptiveState& state, const AdaptiveRound& round) {
  for (const HostBatch& batch : round.batches)
    for (const ElementDescriptor& element : batch.elements) state.books.store.release(element.result_slot);
  state.books.store.end_batch();
}

}  // namespace tentpole
