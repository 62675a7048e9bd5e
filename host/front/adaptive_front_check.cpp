#include <algorithm>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>

#include "common/binary_stream.hpp"
#include "host/front/adaptive_front.hpp"
#include "host/front/progress_rule.hpp"
#include "host/mesh/printed_number.hpp"

namespace tentpole {

double AdaptiveFront::steepness() const {
  double steepest = 0;
  for (int cell = 0; cell < mesh_.num_cell_slots(); ++cell)
    if (mesh_.is_alive_cell(cell))
      steepest = std::max(steepest, time_slope(mesh_.simplex(cell)) / slope_limit_of(cell));
  return steepest;
}

void AdaptiveFront::check() const {
  mesh_.check();
  for (int cell = 0; cell < mesh_.num_cell_slots(); ++cell) {
    if (!mesh_.is_alive_cell(cell)) continue;
    const FrontSimplex simplex = mesh_.simplex(cell);
    if (!may_be_on_front(simplex, slope_limit_of(cell)))
      throw std::runtime_error("front, cell " + std::to_string(cell) + ": it is " +
                               printed(time_slope(simplex) / slope_limit_of(cell)) +
                               " times as steep as is causal and uses " +
                               printed(edge_limit_use(simplex, slope_limit_of(cell))) + " of the progress limit");
  }
  LocalMinima fresh;
  for (int cell = 0; cell < mesh_.num_cell_slots(); ++cell)
    if (mesh_.is_alive_cell(cell)) fresh.add_cell(mesh_.vertices(cell), mesh_.times());
  fresh.settle();
  if (fresh.all().size() != minima_.all().size() ||
      !std::all_of(fresh.all().begin(), fresh.all().end(), [&](int vertex) { return minima_.contains(vertex); }))
    throw std::runtime_error("front: the list of local minima is wrong");
  for (int index = 0; index < cracks_.size(); ++index) {
    if (cracks_.is_retired(index)) continue;
    const auto [a, b] = cracks_.edge(index);
    const bool exists =
        mesh_.dimension() == 1 ? a == b && mesh_.star(a).size() == 2 : a != b && mesh_.cells_with(a, b).size == 2;
    if (!exists) throw std::runtime_error("front, crack edge " + std::to_string(index) + ": it is no edge of the mesh");
  }
}

void AdaptiveFront::save(std::ostream& stream) const {
  mesh_.save(stream);
  cracks_.save(stream);
}

void AdaptiveFront::load(std::istream& stream) {
  AdaptiveFront other = *this;
  other.mesh_.load(stream);
  for (int cell = 0; cell < other.mesh_.num_cell_slots(); ++cell)
    if (other.mesh_.is_alive_cell(cell) && other.mesh_.cell(cell).region >= static_cast<int>(slope_limit_.size()))
      throw std::runtime_error("the front in the checkpoint has more regions than the mesh");
  other.cracks_.load(stream, other.mesh_.num_vertex_slots());
  other.find_all_minima();
  other.check();
  *this = std::move(other);
}

}  // namespace tentpole
