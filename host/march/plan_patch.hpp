#pragma once

#include <optional>

#include "host/march/adaptive_state.hpp"

namespace tentpole {

enum class PatchOperation { tent, inclined_tent, deletion, flip };

/// What is to happen at a local minimum.
struct PatchPlan {
  PatchOperation operation = PatchOperation::tent;
  std::int32_t vertex = none;
  Footprint footprint;  ///< cells below the patch
  InclinedTent top{};   ///< of a tent, inclined or not
  std::optional<DeletionPlan> deletion;
  std::optional<FlipPlan> flip;
};

/// The operation at a local minimum: deletion where the solution needs fewer cells, a flip or a moved pole where cells
/// are badly shaped and `front.smoothing` is set, otherwise a vertical tent. Poles on a crack whose damage grows are
/// cut to max_pole_height. Does not change the front. Throws std::runtime_error where a pole has no height left.
PatchPlan plan_patch(const AdaptiveState& state, std::int32_t vertex);

}  // namespace tentpole
