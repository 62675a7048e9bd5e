#include "host/fracture/defect_tests.hpp"

#include <cassert>
#include <cmath>

#include "host/fracture/planar_orientation.hpp"
#include "host/fracture/random_numbers.hpp"

namespace tentpole {
namespace {

/// Numbers of one cell and patch, one after the other.
class RandomSequence {
 public:
  explicit RandomSequence(const DefectTestKey& key)
      : key_{key.seed, RandomPurpose::defect_tests},
        counter_{static_cast<std::uint64_t>(key.cell_serial), static_cast<std::uint64_t>(key.patch_counter), 0, 0} {}

  std::array<double, 4> next() {
    const std::array<double, 4> numbers = uniform_numbers(key_, counter_);
    ++counter_[2];
    return numbers;
  }

 private:
  RandomKey key_;
  RandomCounter counter_;
};

double measure(std::span<const Point> corners) {
  if (corners.size() == 2) return std::abs(corners[1][0] - corners[0][0]);
  return std::abs(signed_double_area(corners[0], corners[1], corners[2])) / 2;
}

/// Uniform in the interval or triangle: a parallelogram folded along its diagonal.
Point random_point(std::span<const Point> corners, double first, double second) {
  if (corners.size() == 2)
    second = 0;
  else if (first + second > 1)
    first = 1 - first, second = 1 - second;
  Point point = corners[0];
  for (std::size_t axis = 0; axis + 1 < corners.size(); ++axis)
    point[axis] += first * (corners[1][axis] - corners[0][axis]) +
                   (corners.size() == 3 ? second * (corners[2][axis] - corners[0][axis]) : 0);
  return point;
}

/// Poisson number of any mean: the sum over parts of it.
std::int64_t draw_number(double mean, RandomSequence& sequence) {
  const double parts = std::max(1.0, std::ceil(mean / largest_poisson_mean));
  std::int64_t number = 0;
  for (double part = 0; part < parts; ++part) number += poisson_number(mean / parts, sequence.next()[0]);
  return number;
}

}  // namespace

std::vector<DefectTest> draw_defect_tests(const DefectTestKey& key, std::span<const Point> corners, double density,
                                          const StrengthDistribution& distribution, double strongest) {
  assert((corners.size() == 2 || corners.size() == 3) && "an interval for D = 1, a triangle for D = 2");
  const double weak = distribution.probability(strongest);
  RandomSequence sequence(key);
  std::vector<DefectTest> tests(draw_number(density * measure(corners) * weak, sequence));
  for (DefectTest& test : tests) {
    const std::array<double, 4> uniform = sequence.next();
    test = {random_point(corners, uniform[0], uniform[1]), distribution.strength(uniform[2] * weak)};
  }
  return tests;
}

}  // namespace tentpole
