#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tentpole {

/// The local minima of a front whose cells come and go. For each vertex it counts, over the cells round it, the other
/// corners that precede it in (time, scrambled id); vertices that have cells and count 0 are the local minima. A change
/// costs O(cells touched). `times` are indexed by vertex and must hold what they held when a cell was added.
class LocalMinima {
 public:
  /// `vertices`: corners of one cell. Call settle() after a group of these.
  void add_cell(std::span<const std::int32_t> vertices, const std::vector<double>& times);
  void remove_cell(std::span<const std::int32_t> vertices, const std::vector<double>& times);

  /// One cell round `vertex`, whose time rises from `old_time` to `new_time`. Call settle() after all of them.
  void raise_in_cell(std::span<const std::int32_t> vertices, std::int32_t vertex, double old_time, double new_time,
                     const std::vector<double>& times);

  /// Finds which vertices of the changed cells are local minima now.
  void settle();

  bool contains(std::int32_t vertex) const { return place_[vertex] >= 0; }

  /// In no particular order.
  std::span<const std::int32_t> all() const { return minima_; }

 private:
  void count(std::span<const std::int32_t> vertices, const std::vector<double>& times, int change);
  void insert(std::int32_t vertex);
  void erase(std::int32_t vertex);

  std::vector<std::int32_t> num_others_;   ///< [vertex] other corners of its cells
  std::vector<std::int32_t> num_earlier_;  ///< [vertex] those of them that precede it
  std::vector<std::int32_t> place_;        ///< [vertex] index in minima_, or -1
  std::vector<std::int32_t> minima_;
  std::vector<std::int32_t> touched_;
};

}  // namespace tentpole
