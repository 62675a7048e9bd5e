#include "device/stage_timer.hpp"

namespace tentpole {

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::initialization:
      return "initialization";
    case Stage::meshing:
      return "meshing";
    case Stage::assembly:
      return "assembly";
    case Stage::solution:
      return "solution";
    case Stage::post_solution:
      return "post_solution";
    case Stage::transfer:
      return "transfer";
    case Stage::fracture:
      return "fracture";
    case Stage::output:
      return "output";
    case Stage::total:
      return "total";
  }
  return "unknown stage";
}

void StageTimer::add(Stage stage, std::chrono::nanoseconds duration) {
  nanoseconds_[static_cast<int>(stage)] += duration.count();
}

double StageTimer::seconds(Stage stage) const {
  return 1e-9 * static_cast<double>(nanoseconds_[static_cast<int>(stage)]);
}

double StageTimer::percent(Stage stage) const {
  const double total = seconds(Stage::total);
  return total > 0 ? 100 * seconds(stage) / total : 0;
}

ScopedStage::ScopedStage(StageTimer& timer, Stage stage)
    : timer_(timer), stage_(stage), start_(std::chrono::steady_clock::now()) {}

ScopedStage::~ScopedStage() {
  timer_.add(stage_, std::chrono::steady_clock::now() - start_);
}

}  // namespace tentpole
