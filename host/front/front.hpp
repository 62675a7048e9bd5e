#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "host/front/minimum_tree.hpp"
#include "host/front/tent_pole_height.hpp"
#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// The front: the piecewise linear surface t = tau(x) over a SpaceMesh up to which the solution is known.
/// Invariants: |grad tau| <= gamma / c on every cell (causal), and the progress rule of tent_pole_height.hpp, so that
/// every local minimum can rise. A vertex is a local minimum if it precedes all its neighbours in (time, vertex id);
/// two local minima never share a cell. How far a vertex may rise depends on its neighbours' times only, and these
/// cannot change while it is the local minimum: the tents that result do not depend on the order or the size of
/// batches. Units: those of the mesh and the wave speeds. The mesh must outlive the front and stay unchanged.
class Front {
 public:
  /// A flat front. `cell_wave_speed` [num_cells]: fastest wave of each cell, > 0; `causality`: gamma in (0, 1].
  /// Throws std::invalid_argument with the cell and the value otherwise.
  Front(const SpaceMesh& mesh, std::span<const double> cell_wave_speed, double causality = 0.95, double start_time = 0);

  int num_vertices() const { return static_cast<int>(times_.size()); }
  double time(int vertex) const { return times_[vertex]; }
  std::span<const double> times() const { return times_; }
  std::span<const CellCorner> star(int vertex) const { return mesh_->star(vertex); }

  /// Vertices that share a cell with this one, ascending.
  std::span<const std::int32_t> neighbors(int vertex) const { return limits_.neighbors(vertex); }

  bool is_local_minimum(int vertex) const { return num_earlier_neighbors_[vertex] == 0; }

  /// Earliest time on the front; O(1).
  double minimum_time() const { return minimum_.value(); }

  /// Time of the top of the tent pole at a local minimum: the smallest of the causal limit, the progress rule and
  /// `end_time`; where less than two heights remain to `end_time`, half of the rest, so that no slivers arise.
  /// Strictly later than time(vertex); throws std::runtime_error if it cannot be (precision of the times exhausted).
  double pole_top_time(int vertex, double end_time) const;

  /// Up to `limit` local minima earlier than `end_time` that no earlier call has handed out, ascending; empty if none
  /// is left. A vertex handed out is either raised or put back; meanwhile further calls give other minima, which touch
  /// none of those handed out, so the next batch can be meshed while this one is solved. O(1) per vertex and O(degree)
  /// in raise.
  std::vector<int> next_minima(int limit, double end_time);

  /// Gives a vertex from next_minima back without a tent (its patch was refused).
  void put_back(int vertex) { queue_.push_back(vertex); }

  /// Raises a local minimum to `new_time` <= pole_top_time; itself or its neighbours may become local minima.
  void raise(int vertex, double new_time);

  /// Replaces all times (a resumed run) and forgets what was handed out. Throws std::invalid_argument if not causal.
  void set_times(std::span<const double> times);

  /// Largest |grad tau| c / gamma over the cells round a vertex; <= 1 up to rounding.
  double steepness(int vertex) const;

 private:
  void find_all_minima();

  const SpaceMesh* mesh_;
  TentPoleLimits limits_;
  std::vector<double> times_;
  std::vector<std::int32_t> num_earlier_neighbors_;
  MinimumTree minimum_;
  std::deque<std::int32_t> queue_;      ///< local minima not handed out
  std::vector<std::int32_t> finished_;  ///< local minima at or beyond finished_end_time_
  double finished_end_time_;
};

}  // namespace tentpole
