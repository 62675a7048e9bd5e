#include "host/march/advance_adaptive_front.hpp"

#include <algorithm>

#include "host/march/front_report.hpp"
#include "host/march/record_cracks.hpp"
#include "host/output/time_coverage.hpp"

namespace tentpole {
namespace {

/// Whether a row of the history is due: collecting the state of the front is worth it only then.
bool history_is_due(const AdaptiveState& state, double earlier, double now) {
  const std::vector<double>& times = state.books.history.times();
  return std::ranges::any_of(times, [&](double time) {
    return front_has_passed(now, time) && !(earlier > 0 && front_has_passed(earlier, time));
  });
}

/// Books the accepted patches and writes the output that the front has passed.
void book_round(AdaptiveLoop& loop, const AdaptiveRound& round, const std::vector<std::vector<std::uint8_t>>& accepted,
                double earlier_time, const AdvanceOptions& options) {
  AdaptiveState& state = loop.state;
  ScopedStage stage(state.books.timer, Stage::output);
  for (std::size_t number = 0; number < round.batches.size(); ++number) {
    state.books.ledger.commit(round.batches[number], options.check, accepted[number]);
    record_cracks(state.books, round.batches[number], accepted[number], loop.cracks);
  }
  const double time = state.books.simulation.time_in_seconds(state.front.minimum_time());
  state.books.recorder.finish(time);
  if (history_is_due(state, earlier_time, time)) state.books.history.finish(time, front_state(state));
  if (state.has_fracture()) loop.cracks.finish(time);
}

}  // namespace

bool advance_adaptive_front(AdaptiveLoop& loop, const AdvanceOptions& options) {
  AdaptiveState& state = loop.state;
  while (true) {
    const double earlier_time = state.books.simulation.time_in_seconds(state.front.minimum_time());
    const AdaptiveRound round = solve_round(state, loop.writer, options.max_patches);
    if (round.patches.empty()) return true;
    state.books.is_committing = true;
    std::vector<std::vector<std::uint8_t>> accepted;
    {
      ScopedStage stage(state.books.timer, Stage::fracture);
      accepted = commit_round(state, loop.search, round);
    }
    if (options.check) state.front.check();
    book_round(loop, round, accepted, earlier_time, options);
    state.books.is_committing = false;
    state.counts.cells_min = std::min<std::int64_t>(state.counts.cells_min, state.front.mesh().num_cells());
    state.counts.cells_max = std::max<std::int64_t>(state.counts.cells_max, state.front.mesh().num_cells());
    if (!options.after_batch(state.books.simulation.time_in_seconds(state.front.minimum_time()))) return false;
  }
}

}  // namespace tentpole
