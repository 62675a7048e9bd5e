#include "host/front/front.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "host/front/front_slope.hpp"
#include "host/front/vertex_order.hpp"
#include "host/mesh/printed_number.hpp"

namespace tentpole {

namespace {

/// Rounding of the times may make a front steeper than the limit by a little; more than this is a fault.
constexpr double steepness_tolerance = 1e-9;

}  // namespace

Front::Front(const SpaceMesh& mesh, std::span<const double> cell_wave_speed, double causality, double start_time)
    : mesh_(&mesh),
      limits_(mesh, cell_wave_speed, causality),
      times_(mesh.vertices.size(), start_time),
      num_earlier_neighbors_(mesh.vertices.size()),
      minimum_(times_),
      finished_end_time_(-std::numeric_limits<double>::infinity()) {
  find_all_minima();
}

void Front::find_all_minima() {
  queue_.clear();
  finished_.clear();
  for (int vertex = 0; vertex < num_vertices(); ++vertex) {
    num_earlier_neighbors_[vertex] = 0;
    for (const std::int32_t other : neighbors(vertex))
      if (vertex_precedes(times_[other], other, times_[vertex], vertex)) ++num_earlier_neighbors_[vertex];
    if (is_local_minimum(vertex)) queue_.push_back(vertex);
  }
}

double Front::pole_top_time(int vertex, double end_time) const {
  const double bottom = times_[vertex];
  const double latest = limits_.latest_time(*mesh_, vertex, times_);
  double top = latest;
  if (latest >= end_time)
    top = end_time;
  else if (2 * (latest - bottom) > end_time - bottom)
    top = bottom + (end_time - bottom) / 2;
  if (!(top > bottom))
    throw std::runtime_error("vertex " + std::to_string(vertex) + ": the front cannot rise from " + printed(bottom) +
                             " (latest time " + printed(latest) + ", end time " + printed(end_time) +
                             "). The cells there are too small for the precision of the times.");
  return top;
}

std::vector<int> Front::next_minima(int limit, double end_time) {
  if (end_time > finished_end_time_) {
    queue_.insert(queue_.end(), finished_.begin(), finished_.end());
    finished_.clear();
  }
  finished_end_time_ = end_time;
  std::vector<int> minima;
  while (static_cast<int>(minima.size()) < limit && !queue_.empty()) {
    const std::int32_t vertex = queue_.front();
    queue_.pop_front();
    if (times_[vertex] < end_time)
      minima.push_back(vertex);
    else
      finished_.push_back(vertex);
  }
  std::sort(minima.begin(), minima.end());
  return minima;
}

void Front::raise(int vertex, double new_time) {
  assert(is_local_minimum(vertex) && new_time > times_[vertex] && "only a local minimum rises");
  const double old_time = times_[vertex];
  times_[vertex] = new_time;
  minimum_.change(vertex, new_time);
  assert(steepness(vertex) <= 1 + steepness_tolerance && "the front stays causal");
  for (const std::int32_t other : neighbors(vertex)) {
    const bool was_before = vertex_precedes(old_time, vertex, times_[other], other);
    const bool is_before = vertex_precedes(new_time, vertex, times_[other], other);
    if (was_before == is_before) continue;
    ++num_earlier_neighbors_[vertex];
    if (--num_earlier_neighbors_[other] == 0) queue_.push_back(other);
  }
  if (is_local_minimum(vertex)) queue_.push_back(vertex);
}

void Front::set_times(std::span<const double> times) {
  if (times.size() != times_.size())
    throw std::invalid_argument("front times of " + std::to_string(times.size()) + " vertices for a mesh of " +
                                std::to_string(times_.size()));
  for (std::size_t vertex = 0; vertex < times.size(); ++vertex)
    if (!std::isfinite(times[vertex]))
      throw std::invalid_argument("vertex " + std::to_string(vertex) + ": its time is " + printed(times[vertex]) + ".");
  std::vector<double> candidate(times.begin(), times.end());
  times_.swap(candidate);
  for (int vertex = 0; vertex < num_vertices(); ++vertex)
    if (const double steepest = steepness(vertex); steepest > 1 + steepness_tolerance) {
      times_.swap(candidate);
      throw std::invalid_argument("vertex " + std::to_string(vertex) + ": the front is " + printed(steepest) +
                                  " times as steep as is causal.");
    }
  minimum_ = MinimumTree(times_);
  find_all_minima();
}

double Front::steepness(int vertex) const {
  double steepest = 0;
  for (const CellCorner& entry : star(vertex)) {
    std::array<Point, SpaceMesh::max_corners> corners{};
    std::array<double, SpaceMesh::max_corners> corner_times{};
    for (int i = 0; i <= mesh_->dimension; ++i) {
      corners[i] = mesh_->corner_position(entry.cell, i);
      corner_times[i] = times_[mesh_->cells[entry.cell][i]];
    }
    const double slope = front_slope(mesh_->dimension, corners, corner_times);
    steepest = std::max(steepest, slope / limits_.slope_limit(entry.cell));
  }
  return steepest;
}

}  // namespace tentpole
