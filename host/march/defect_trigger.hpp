#pragma once

#include <cstdint>
#include <optional>

#include "host/fracture/defect_field.hpp"
#include "host/fracture/maximal_effective_traction.hpp"

namespace tentpole {

/// A defect whose strength was exceeded: a fracture surface is to start or go on there.
struct DefectTrigger {
  Point position;                     ///< scaled
  std::array<PlaneNormal, 2> normal;  ///< of the surfaces that bear most; D = 1 needs none
  int num_normals;
  std::optional<DefectId> defect;  ///< of the field; none for a test of the sampled model
};

/// A surface in the making: it goes straight on from a vertex.
struct CrackGrowth {
  std::int32_t vertex;  ///< where its next edge begins
  Point direction;      ///< of unit length
  double remaining;     ///< length that is missing, scaled
};

}  // namespace tentpole
