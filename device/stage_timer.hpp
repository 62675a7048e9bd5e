#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace tentpole {

/// The stages whose times a run reports.
enum class Stage {
  initialization,
  meshing,
  assembly,
  solution,
  post_solution,
  transfer,
  fracture,
  output,
  total,
};
inline constexpr int num_stages = 9;

/// As in the summary of a run: "initialization", ..., "post_solution", ..., "total".
const char* stage_name(Stage stage);

/// Wall-clock seconds spent in each stage. Any thread may add at any time. Stages that overlap in time (meshing on the
/// host while the device solves) are each counted in full, so their sum may exceed the total.
class StageTimer {
 public:
  void add(Stage stage, std::chrono::nanoseconds duration);
  double seconds(Stage stage) const;  ///< [s]
  /// 100 * seconds(stage) / seconds(total); 0 as long as the total is 0.
  double percent(Stage stage) const;

 private:
  std::array<std::atomic<std::int64_t>, num_stages> nanoseconds_{};
};

/// Adds the time from construction to destruction to one stage.
class ScopedStage {
 public:
  ScopedStage(StageTimer& timer, Stage stage);
  ~ScopedStage();
  ScopedStage(const ScopedStage&) = delete;
  ScopedStage& operator=(const ScopedStage&) = delete;

 private:
  StageTimer& timer_;
  Stage stage_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace tentpole
