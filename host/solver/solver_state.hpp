#pragma once

#include "host/solver/batch_builder.hpp"
#include "host/solver/run_books.hpp"

namespace tentpole {

/// What advance_front moves: a front on a fixed mesh, what lies below it, and the books.
struct SolverState {
  RunBooks& books;
  Front& front;
  CellSources& sources;
  BatchBuilder& builder;
};

}  // namespace tentpole
