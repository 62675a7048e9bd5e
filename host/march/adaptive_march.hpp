#pragma once

#include "host/march/advance_adaptive_front.hpp"

namespace tentpole {

/// Marches a front that is refined by [adaptivity] and cracked by [fracture], D = 1 and 2.
class AdaptiveMarch : public FrontMarch {
 public:
  /// Fits the front to the prepared cracks. Throws InputError where they do not lie in the domain.
  AdaptiveMarch(RunBooks& books, const OutputFolder& folder);

  bool advance(const AdvanceOptions& options) override;
  int num_cells() const override { return state_.front.mesh().num_cells(); }
  void fill(RunSummary& summary) override;
  std::vector<std::int32_t> save(CheckpointContents& contents) const override;
  std::vector<std::int32_t> load(const CheckpointContents& contents) override;
  void add_written(WrittenFiles& files) const override { cracks_.add_written(files); }

 private:
  AdaptiveState state_;
  PatchWriter writer_;
  DefectSearch search_;
  CrackSeries cracks_;
  AdaptiveLoop loop_;
};

}  // namespace tentpole
