#pragma once

#include "host/march/adaptive_state.hpp"
#include "tests/host/march/march_books.hpp"

namespace tentpole::testing {

/// The state of an adaptive march over the unit square, at rest, before its first patch. Lengths of the state are in
/// units of unit().
struct RestingFront {
  /// Surfaces grow by `growth_length` [m], in cells with edges of at most `crack_size` [m].
  RestingFront(int intervals, double crack_size, double growth_length);

  double unit() const { return simulation.scaling.length; }
  Point place(std::int32_t vertex) const;  ///< [m]

  Simulation simulation;
  MarchBooks books;
  AdaptiveState state;
};

}  // namespace tentpole::testing
