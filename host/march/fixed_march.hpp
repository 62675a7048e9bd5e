#pragma once

#include "host/march/front_march.hpp"
#include "host/march/solver_state.hpp"

namespace tentpole {

/// Marches a front on the mesh of the simulation, D = 1 to 3.
class FixedMarch : public FrontMarch {
 public:
  explicit FixedMarch(RunBooks& books);

  bool advance(const AdvanceOptions& options) override;
  int num_cells() const override { return books_.simulation.mesh.num_cells(); }
  void fill(RunSummary& summary) override;
  std::vector<std::int32_t> save(CheckpointContents& contents) const override;
  std::vector<std::int32_t> load(const CheckpointContents& contents) override;

 private:
  RunBooks& books_;
  Front front_;
  CellSources sources_;
  BatchBuilder builder_;
  SolverState state_;
};

}  // namespace tentpole
