#include "host/fracture/defect_field.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "host/fracture/planar_orientation.hpp"
#include "host/fracture/random_numbers.hpp"

namespace tentpole {
namespace {

constexpr int num_layers = 12;
constexpr double mean_per_box = 2;

/// Boxes [first, last] of a grid whose defects may lie in [low, high]; a position is rounded, hence the margin.
struct BoxRange {
  std::int64_t first, last;

  BoxRange(double low, double high, double size)
      : first(static_cast<std::int64_t>(std::floor(low / size - margin(low / size)))),
        last(static_cast<std::int64_t>(std::floor(high / size + margin(high / size)))) {}

  static double margin(double index) { return 1e-6 + 1e-15 * std::abs(index); }
};

}  // namespace

/// Where defects are asked for: a box, or the closed simplex in it.
struct DefectField::Region {
  Point low, high;
  std::span<const Point> corners;  ///< empty: the box [low, high)

  bool contains(const Point& point, int dimension) const {
    if (corners.size() == 3) return is_in_triangle(corners, point);
    for (int axis = 0; axis < dimension; ++axis) {
      const bool is_below = corners.empty() ? point[axis] < high[axis] : point[axis] <= high[axis];
      if (point[axis] < low[axis] || !is_below) return false;
    }
    return true;
  }
};

DefectField::DefectField(int dimension, double density, const StrengthDistribution& distribution, std::uint64_t seed)
    : dimension_(dimension), density_(density), distribution_(distribution), seed_(seed) {
  assert((dimension == 1 || dimension == 2) && density >= 0 && "a field of defects lies on a line or in a plane");
  for (int layer = 0; layer < num_layers && density > 0; ++layer) {
    const double highest = std::ldexp(1.0, -2 * layer), lowest = layer + 1 == num_layers ? 0 : highest / 4;
    const double box = mean_per_box / (density * (highest - lowest));
    layers_.push_back({lowest, highest, distribution.strength(lowest), dimension == 1 ? box : std::sqrt(box)});
  }
}

double DefectField::mean_number(double measure, double strongest) const {
  return density_ * measure * distribution_.probability(strongest);
}

double DefectField::mean_number_searched(double measure, double strongest) const {
  double rank = 0;
  for (const Layer& layer : layers_)
    if (layer.weakest <= strongest) rank = std::max(rank, layer.highest_rank);
  return density_ * measure * rank;
}

void DefectField::add_box(const DefectId& box, const Region& region, double strongest,
                          std::vector<Defect>& defects) const {
  const RandomKey key{seed_, RandomPurpose::defect_field};
  RandomCounter counter{static_cast<std::uint64_t>(box.box[0]), static_cast<std::uint64_t>(box.box[1]),
                        static_cast<std::uint64_t>(box.layer), 0};
  const Layer& layer = layers_[box.layer];
  const std::int64_t num_defects = poisson_number(mean_per_box, uniform_numbers(key, counter)[0]);
  for (std::int64_t number = 0; number < num_defects; ++number) {
    counter[3] = static_cast<std::uint64_t>(number + 1);
    const std::array<double, 4> uniform = uniform_numbers(key, counter);
    Defect defect{box, {}, 0};
    for (int axis = 0; axis < dimension_; ++axis)
      defect.position[axis] = (static_cast<double>(box.box[axis]) + uniform[axis]) * layer.box_size;
    if (!region.contains(defect.position, dimension_)) continue;
    const double rank = layer.lowest_rank + uniform[2] * (layer.highest_rank - layer.lowest_rank);
    defect.id.number = static_cast<std::int32_t>(number);
    defect.strength = distribution_.strength(rank);
    if (defect.strength <= strongest) defects.push_back(defect);
  }
}

void DefectField::add_layer(int layer, const Region& region, double strongest, std::vector<Defect>& defects) const {
  const double size = layers_[layer].box_size;
  const BoxRange columns(region.low[0], region.high[0], size);
  const BoxRange rows(region.low[1], region.high[1], size);
  for (std::int64_t column = columns.first; column <= columns.last; ++column) {
    if (dimension_ == 1) {
      add_box({layer, {column, 0}, 0}, region, strongest, defects);
      continue;
    }
    for (std::int64_t row = rows.first; row <= rows.last; ++row)
      add_box({layer, {column, row}, 0}, region, strongest, defects);
  }
}

std::vector<Defect> DefectField::in_region(const Region& region, double strongest) const {
  std::vector<Defect> defects;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer)
    if (layers_[layer].weakest <= strongest) add_layer(static_cast<int>(layer), region, strongest, defects);
  return defects;
}

std::vector<Defect> DefectField::in_box(const Point& low, const Point& high, double strongest) const {
  return in_region({low, high, {}}, strongest);
}

std::vector<Defect> DefectField::in_simplex(std::span<const Point> corners, double strongest) const {
  assert(static_cast<int>(corners.size()) == dimension_ + 1 && "an interval for D = 1, a triangle for D = 2");
  Region region{corners[0], corners[0], corners};
  for (const Point& corner : corners)
    for (int axis = 0; axis < dimension_; ++axis) {
      region.low[axis] = std::min(region.low[axis], corner[axis]);
      region.high[axis] = std::max(region.high[axis], corner[axis]);
    }
  return in_region(region, strongest);
}

}  // namespace tentpole
