#include "host/problem/check_expressions.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "host/problem/initial_element.hpp"
#include "host/problem/prescribed_data.hpp"

namespace tentpole {
namespace {

/// Of one expression, about 0.1 us each.
constexpr std::int64_t most_evaluations = 10'000'000;

/// Takes every item of a list, or every n-th where more would take too long.
int stride(std::int64_t num_items, std::int64_t evaluations_per_item) {
  return static_cast<int>(1 + num_items * evaluations_per_item / most_evaluations);
}

class FirstTents {
 public:
  explicit FirstTents(const Simulation& simulation)
      : simulation_(simulation),
        mesh_(simulation.mesh),
        data_(simulation),
        height_(std::min(simulation.scaled_end_time(), simulation.smallest_edge / simulation.scaling.length)) {}

  void check_cells() {
    const Case& settings = simulation_.settings;
    const bool starts_at_rest = settings.initial_displacement.is_zero() && settings.initial_velocity.is_zero();
    if (starts_at_rest && settings.body_force.is_zero() && !settings.exact_displacement) return;
    std::optional<VectorExpression> exact = settings.exact_displacement;
    const int dimension = mesh_.dimension, points = data_.num_facet_points();
    const int step = stride(mesh_.num_cells(), points * dimension * (3 + 6 * dimension));
    for (int cell = 0; cell < mesh_.num_cells(); cell += step) {
      const ElementDescriptor element = tent(cell, 0);
      block_.clear();
      if (!starts_at_rest) data_.add_initial(element, dimension + 1, block_);
      data_.add_body_force(element, block_);
      if (exact) exact->evaluate(middle(element), simulation_.time_in_seconds(height_ / 2));
    }
  }

  void check_sides() {
    const int dimension = mesh_.dimension;
    std::vector<CellCorner> loaded;
    for (int cell = 0; cell < mesh_.num_cells(); ++cell)
      for (int facet = 0; facet <= dimension; ++facet) {
        const std::int32_t boundary = mesh_.facet_boundary[cell][facet];
        if (boundary != none && has_data(simulation_.conditions[boundary])) loaded.push_back({cell, facet});
      }
    const int step = stride(std::ssize(loaded), data_.num_facet_points() * dimension);
    for (std::size_t i = 0; i < loaded.size(); i += step) {
      const auto [cell, facet] = loaded[i];
      block_.clear();
      data_.add_boundary(tent(cell, facet == 0 ? 1 : 0), facet, mesh_.facet_boundary[cell][facet], block_);
    }
  }

 private:
  /// An absorbing side takes the initial state, unless it has a far field of its own.
  static bool has_data(const BoundaryCondition& condition) { return condition.is_absorbing() || !condition.is_zero(); }

  /// The element over a cell whose pole stands on this corner.
  ElementDescriptor tent(int cell, int pole) const {
    ElementDescriptor element = initial_element(simulation_, cell);
    const int top = mesh_.dimension + 1;
    std::copy_n(element.corner[pole], mesh_.dimension, element.corner[top]);
    element.corner[top][mesh_.dimension] = height_;
    return element;
  }

  Point middle(const ElementDescriptor& element) const {
    Point point{};
    for (int corner = 0; corner <= mesh_.dimension; ++corner)
      for (int axis = 0; axis < mesh_.dimension; ++axis)
        point[axis] += element.corner[corner][axis] * simulation_.scaling.length / (mesh_.dimension + 1);
    return point;
  }

  const Simulation& simulation_;
  const SpaceMesh& mesh_;
  PrescribedData data_;
  double height_;  ///< of poles, scaled
  std::vector<double> block_;
};

}  // namespace

void check_expressions(const Simulation& simulation) {
  FirstTents tents(simulation);
  tents.check_cells();
  tents.check_sides();
}

}  // namespace tentpole
