#pragma once

#include "host/march/refinement.hpp"

namespace tentpole {

struct RayExit;

/// Makes the next edges of a surface: each along an edge of the front that is seen in about the wanted direction, or to
/// a cut of the edge that the ray crosses, in cells of at most limits.crack_size. Ends when no more than half of an
/// edge is missing, or at another crack or the boundary (a coalescence).
class CrackGrower {
 public:
  CrackGrower(AdaptiveState& state, Refinement& refinement) : state_(state), refinement_(refinement) {}

  /// Goes on as far as splits are admissible now; whether the surface is complete. `growth` keeps what is missing.
  bool grow(CrackGrowth& growth);

  enum class Start { begun, must_wait, impossible };

  /// As grow() for a surface that has not begun. What is missing after its first edge joins state.growths; where that
  /// edge is not admissible now, or lies outside the domain or on a crack, nothing is made.
  Start start(CrackGrowth growth);

 private:
  enum class Outcome { made, refused, ended };

  const FrontMesh& mesh() const { return state_.front.mesh(); }
  std::int32_t cut_or_nearest(const RayExit& exit, const CrackGrowth& growth);
  Outcome add_edge(CrackGrowth& growth);

  AdaptiveState& state_;
  Refinement& refinement_;
};

/// Unit vector from a vertex to another.
Point direction_between(const FrontMesh& mesh, std::int32_t from, std::int32_t to);

/// Whether the domain ends at the vertex.
bool is_on_boundary(const FrontMesh& mesh, std::int32_t vertex);

}  // namespace tentpole
