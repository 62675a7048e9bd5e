#include "host/march/advance_front.hpp"

#include <utility>

#include "device/work_queue.hpp"
#include "host/batch/energy_balance.hpp"
#include "host/march/take_back.hpp"

namespace tentpole {
namespace {

void build(SolverState& state, HostBatch& batch, int max_patches) {
  ScopedStage stage(state.books.timer, Stage::meshing);
  state.builder.build(batch, max_patches);
  state.books.ledger.mark_wanted(batch);
}

/// An unsound solution is no part of the books: what throws here is taken back.
void solve(SolverState& state, HostBatch& batch, double& energy_scale) {
  state.books.runner.run(batch);
  raise_energy_scale(energy_scale, batch);
  for (int patch = 0; patch < std::ssize(batch.patches); ++patch)
    require_balance(batch, patch, energy_scale, state.books.simulation);
}

void commit(SolverState& state, const HostBatch& batch, bool check) {
  ScopedStage stage(state.books.timer, Stage::output);
  const double front_time = state.books.simulation.time_in_seconds(batch.front_minimum_time);
  state.books.is_committing = true;
  state.books.ledger.commit(batch, check);
  state.books.recorder.finish(front_time);
  FrontState front;
  front.cells = state.books.simulation.mesh.num_cells();
  front.smallest_cell = state.books.simulation.smallest_edge;
  state.books.history.finish(front_time, front);
  state.books.is_committing = false;
}

/// The batches on their way.
struct Pipeline {
  HostBatch pitched, running, solved;
};

bool advance(SolverState& state, const AdvanceOptions& options, Pipeline& pipeline) {
  auto& [pitched, running, solved] = pipeline;
  double energy_scale = state.books.ledger.energy_scale();
  WorkQueue queue;
  bool keep_going = true;
  do {
    pitched.clear();
    if (keep_going) build(state, pitched, options.max_patches);  // the device solves `running` meanwhile
    queue.wait();
    std::swap(solved, running);
    std::swap(running, pitched);
    if (!running.patches.empty()) queue.submit([&] { solve(state, running, energy_scale); });
    if (!solved.patches.empty()) {
      commit(state, solved, options.check);
      keep_going = options.after_batch(state.books.simulation.time_in_seconds(solved.front_minimum_time)) && keep_going;
      solved.clear();
    }
  } while (!running.patches.empty());
  return keep_going;
}

}  // namespace

bool advance_front(SolverState& state, const AdvanceOptions& options) {
  Pipeline pipeline;
  try {
    return advance(state, options, pipeline);
  } catch (...) {
    for (const HostBatch* batch : {&pipeline.pitched, &pipeline.running})
      take_back(*batch, state.books.simulation.mesh, state.front, state.sources);
    throw;
  }
}

}  // namespace tentpole
