#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// How far a local minimum of the front may rise, from its neighbours' times alone (docs/formulation.md, Progress).
/// With g = gamma / c of a cell and edges e = vw:
///   D = 1  tau_w + g |e|;
///   D = 2  rule B: the smaller of the exact causal limit of each cell (v, q, r), tau_q + s x + h sqrt(g^2 - s^2), with
///   s the
///          slope along qr, x the foot of v's altitude measured from q, h the altitude; and of tau_w + f_e g |e|,
///          f_e = (1 - eps) min(1, sin phi over the obtuse angles at either end of e in the cell), eps = 0.3;
///   D = 3  rule A: tau_w + g |e| / R_T (edge_slope_amplification.hpp).
/// The edge limits are the smallest over the cells at the edge and are kept with the neighbour lists.
class TentPoleLimits {
 public:
  /// `cell_wave_speed` [num_cells], > 0; causality = gamma in (0, 1]. Throws std::invalid_argument otherwise.
  TentPoleLimits(const SpaceMesh& mesh, std::span<const double> cell_wave_speed, double causality);

  /// Vertices that share a cell with this one, ascending.
  std::span<const std::int32_t> neighbors(int vertex) const {
    return {neighbor_.data() + offset_[vertex], static_cast<std::size_t>(offset_[vertex + 1] - offset_[vertex])};
  }

  /// Latest time that `vertex` may have, given the `times` [num_vertices] of its neighbours.
  double latest_time(const SpaceMesh& mesh, int vertex, std::span<const double> times) const;

  /// Largest |grad tau| at which the cell is causal: gamma / c.
  double slope_limit(int cell) const { return slope_limit_[cell]; }

 private:
  void collect_edge_limits(const SpaceMesh& mesh);

  std::vector<double> slope_limit_;     ///< [num_cells]
  std::vector<std::int32_t> offset_;    ///< [num_vertices + 1]
  std::vector<std::int32_t> neighbor_;  ///< CSR
  std::vector<double> edge_limit_;      ///< CSR: largest |tau_v - tau_w|
};

}  // namespace tentpole
