#pragma once

#include "host/books/run_books.hpp"
#include "host/march/batch_builder.hpp"

namespace tentpole {

/// What advance_front moves: a front on a fixed mesh, what lies below it, and the books.
struct SolverState {
  RunBooks& books;
  Front& front;
  CellSources& sources;
  BatchBuilder& builder;
};

}  // namespace tentpole
