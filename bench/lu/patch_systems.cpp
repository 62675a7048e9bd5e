#include "bench/lu/patch_systems.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bench/assembly/patch_system.hpp"
#include "bench/sample_patches.hpp"
#include "kernels/patch/dense_patch_solve.hpp"

namespace tentpole {

PatchSystems::PatchSystems(int space_dimension, int the_degree, int the_num_elements, int the_num_patches)
    : dimension(space_dimension),
      degree(the_degree),
      num_elements(the_num_elements),
      num_patches(the_num_patches),
      batch(sample_patches(dimension, degree, num_elements, num_patches)),
      system(polynomial_patch_system(batch)),
      scale(system.size),
      scaled(system.matrix),
      solution(system.size) {
  const std::size_t size = system.size;
  for (std::size_t a = 0; a < size; ++a) scale[a] = 1 / std::sqrt(system.matrix[a * size + a]);
  for (std::size_t a = 0; a < size; ++a)
    for (std::size_t b = 0; b < size; ++b) scaled[a * size + b] *= scale[a] * scale[b];
  DenseSolveScratch scratch;
  double residual = 0;
  if (solve_dense_patch(system.matrix, system.rhs, solution, residual, scratch) != Status::ok)
    throw std::runtime_error("the reference could not solve a patch of the benchmark");
}

SolutionError solution_error(const PatchSystems& systems, const std::vector<double>& solution) {
  const std::size_t size = systems.scale.size();
  double residual = 0, terms = 0, difference = 0, largest = 0;
  for (std::size_t a = 0; a < size; ++a) {
    double sum = systems.system.rhs[a], absolute = std::abs(sum);
    for (std::size_t b = 0; b < size; ++b) {
      const double term = systems.system.matrix[a * size + b] * solution[b];
      sum -= term;
      absolute += std::abs(term);
    }
    if (!std::isfinite(sum)) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    residual = std::max(residual, std::abs(sum) * systems.scale[a]);
    terms = std::max(terms, absolute * systems.scale[a]);
    difference = std::max(difference, std::abs(solution[a] - systems.solution[a]) / systems.scale[a]);
    largest = std::max(largest, std::abs(systems.solution[a]) / systems.scale[a]);
  }
  return {residual / terms, difference / largest};
}

}  // namespace tentpole
