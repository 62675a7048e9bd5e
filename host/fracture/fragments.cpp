#include "host/fracture/fragments.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace tentpole {
namespace {

/// Union-find over cells; the smallest cell of a set is its root, so roots do not depend on the order of joining.
class CellSets {
 public:
  explicit CellSets(std::size_t num_cells) : parent_(num_cells) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::int32_t root(std::int32_t cell) {
    while (parent_[cell] != cell) cell = parent_[cell] = parent_[parent_[cell]];
    return cell;
  }

  void join(std::int32_t first, std::int32_t second) {
    const auto [smaller, larger] = std::minmax({root(first), root(second)});
    parent_[larger] = smaller;
  }

 private:
  std::vector<std::int32_t> parent_;
};

void add(CellContent& sum, const CellContent& cell) {
  sum.volume += cell.volume;
  sum.mass += cell.mass;
  for (int axis = 0; axis < 3; ++axis) sum.momentum[axis] += cell.momentum[axis];
}

}  // namespace

std::array<double, 3> Fragment::velocity() const {
  if (!(content.mass > 0)) return {};
  return {content.momentum[0] / content.mass, content.momentum[1] / content.mass, content.momentum[2] / content.mass};
}

Fragments find_fragments(std::span<const CellContent> cells, std::span<const CellConnection> connections) {
  CellSets sets(cells.size());
  for (const CellConnection& connection : connections) {
    assert(std::max(connection.first, connection.second) < static_cast<std::int32_t>(cells.size()) &&
           "connections name cells");
    if (connection.damage < separating_damage) sets.join(connection.first, connection.second);
  }
  Fragments result;
  result.fragment_of_cell.resize(cells.size());
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(cells.size()); ++cell) {
    const std::int32_t root = sets.root(cell);
    if (root == cell) {
      result.fragment_of_cell[cell] = static_cast<std::int32_t>(result.fragments.size());
      result.fragments.push_back({0, cell, {}});
    }
    result.fragment_of_cell[cell] = result.fragment_of_cell[root];
    Fragment& fragment = result.fragments[result.fragment_of_cell[cell]];
    ++fragment.num_cells;
    add(fragment.content, cells[cell]);
  }
  return result;
}

}  // namespace tentpole
