#include "host/front/local_minima.hpp"

#include <algorithm>

#include "host/front/vertex_order.hpp"

namespace tentpole {

void LocalMinima::count(std::span<const std::int32_t> vertices, const std::vector<double>& times, int change) {
  const auto size = static_cast<std::size_t>(*std::max_element(vertices.begin(), vertices.end())) + 1;
  if (size > place_.size()) {
    num_others_.resize(size, 0);
    num_earlier_.resize(size, 0);
    place_.resize(size, -1);
  }
  for (const std::int32_t vertex : vertices) {
    num_others_[vertex] += change * (static_cast<int>(vertices.size()) - 1);
    for (const std::int32_t other : vertices)
      if (other != vertex && vertex_precedes(times[other], other, times[vertex], vertex))
        num_earlier_[vertex] += change;
    touched_.push_back(vertex);
  }
}

void LocalMinima::add_cell(std::span<const std::int32_t> vertices, const std::vector<double>& times) {
  count(vertices, times, 1);
}

void LocalMinima::remove_cell(std::span<const std::int32_t> vertices, const std::vector<double>& times) {
  count(vertices, times, -1);
}

void LocalMinima::raise_in_cell(std::span<const std::int32_t> vertices, std::int32_t vertex, double old_time,
                                double new_time, const std::vector<double>& times) {
  touched_.push_back(vertex);
  for (const std::int32_t other : vertices) {
    if (other == vertex) continue;
    const bool was_before = vertex_precedes(old_time, vertex, times[other], other);
    const bool is_before = vertex_precedes(new_time, vertex, times[other], other);
    if (was_before == is_before) continue;
    ++num_earlier_[vertex];
    --num_earlier_[other];
    touched_.push_back(other);
  }
}

void LocalMinima::settle() {
  for (const std::int32_t vertex : touched_) {
    const bool is_minimum = num_others_[vertex] > 0 && num_earlier_[vertex] == 0;
    if (is_minimum && !contains(vertex)) insert(vertex);
    if (!is_minimum && contains(vertex)) erase(vertex);
  }
  touched_.clear();
}

void LocalMinima::insert(std::int32_t vertex) {
  place_[vertex] = static_cast<std::int32_t>(minima_.size());
  minima_.push_back(vertex);
}

void LocalMinima::erase(std::int32_t vertex) {
  place_[minima_.back()] = place_[vertex];
  minima_[place_[vertex]] = minima_.back();
  minima_.pop_back();
  place_[vertex] = -1;
}

}  // namespace tentpole
