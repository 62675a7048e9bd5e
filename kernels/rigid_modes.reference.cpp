#include "kernels/rigid_modes.reference.hpp"

#include <cmath>

namespace tentpole::reference {
namespace {

/// int a . b over the facet, divided by its area; a and b are [q][i].
double mean_product(const Discretization& disc, const Rows& a, const Rows& b) {
  double sum = 0;
  for (int q = 0; q < disc.facet_rule.num_points(); ++q)
    for (int i = 0; i < disc.dimension; ++i) sum += disc.facet_rule.weights[q] * a[q][i] * b[q][i];
  return sum;
}

/// Modified Gram-Schmidt in the mean over the facet.
void orthonormalize(const Discretization& disc, std::vector<Rows>& modes) {
  for (std::size_t r = 0; r < modes.size(); ++r) {
    for (std::size_t s = 0; s < r; ++s) {
      const double product = mean_product(disc, modes[r], modes[s]);
      for (std::size_t q = 0; q < modes[r].size(); ++q)
        for (int i = 0; i < disc.dimension; ++i) modes[r][q][i] -= product * modes[s][q][i];
    }
    const double norm = std::sqrt(mean_product(disc, modes[r], modes[r]));
    for (Row& point : modes[r])
      for (double& component : point) component /= norm;
  }
}

}  // namespace

std::vector<Rows> rigid_modes(const Discretization& disc, const ElementDescriptor& element) {
  const int D = disc.dimension, num_points = disc.facet_rule.num_points();
  std::vector<Rows> modes(num_symmetric(D), Rows(num_points, Row(D, 0.0)));
  for (int q = 0; q < num_points; ++q) {
    const Row barycentric = facet_barycentric(disc, q);
    Vector from_centroid{};
    for (int c = 0; c <= D; ++c)
      for (int j = 0; j < D; ++j) from_centroid[j] += (barycentric[c] - 1.0 / (D + 1)) * element.corner[c][j];
    int rotation = D;
    for (int i = 0; i < D; ++i) {
      modes[i][q][i] = 1;
      for (int j = i + 1; j < D; ++j, ++rotation) {
        modes[rotation][q][i] = -from_centroid[j];
        modes[rotation][q][j] = from_centroid[i];
      }
    }
  }
  orthonormalize(disc, modes);
  return modes;
}

}  // namespace tentpole::reference
