#pragma once

#include "host/march/adaptive_state.hpp"

namespace tentpole {

enum class PatchOperation { tent, inclined_tent, deletion, flip };

/// What is to happen at a local minimum.
struct PatchPlan {
  PatchOperation operation = PatchOperation::tent;
  std::int32_t vertex = none;
  CellExchange exchange;  ///< of a tent only `below`: its cells stay, and an element joins each to the top of the pole
  InclinedTent top{};     ///< of a tent, inclined or not

  const Footprint& below() const { return exchange.below; }
  bool is_tent() const { return exchange.between.empty(); }
};

/// The operation at a local minimum: deletion where the solution needs fewer cells, a flip or a moved pole where cells
/// are badly shaped and `front.smoothing` is set, otherwise a vertical tent. Poles on a crack whose damage grows are
/// cut to max_pole_height. Does not change the front. Throws std::runtime_error where a pole has no height left.
PatchPlan plan_patch(const AdaptiveState& state, std::int32_t vertex);

}  // namespace tentpole
