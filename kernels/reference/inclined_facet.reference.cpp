#include "kernels/reference/inclined_facet.reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <lapacke.h>

namespace tentpole::reference {
namespace {

/// Compliance C^-1 in Mandel form: E = (sigma - lambda tr(sigma) I / (2 mu + D lambda)) / (2 mu).
double compliance(const Material& material, int dimension, int r, int s) {
  double value = r == s ? 1.0 : 0.0;
  if (r < dimension && s < dimension) value -= material.lambda / (2 * material.mu + dimension * material.lambda);
  return value / (2 * material.mu);
}

/// Entry (v_i, sigma_ab) of N_x.: sigma N in component i, Mandel form.
double normal_product(const Vector& covector, int i, int a, int b) {
  if (a == b) return i == a ? covector[a] : 0.0;
  return ((i == a ? covector[b] : 0.0) + (i == b ? covector[a] : 0.0)) / std::numbers::sqrt2;
}

}  // namespace

bool is_inclined(const Discretization& disc, const ElementDescriptor& element, int facet) {
  const int D = disc.dimension;
  if (element.facet_kind[facet] != FacetKind::interior) return false;
  if (element.pole != none &&
      std::equal(element.corner[D + 1], element.corner[D + 1] + D, element.corner[element.pole]))
    return false;
  const Vector covector = facet_covector(element_geometry(element, D), D, facet);
  double square = 0;
  for (int j = 0; j <= D; ++j) square += covector[j] * covector[j];
  return std::abs(covector[D]) > 1e-13 * std::sqrt(square);
}

Rows state_components(const PointState& state, int dimension) {
  Rows components = state.velocity;
  components.resize(dimension + num_symmetric(dimension));
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j) {
      Row& row = components[dimension + symmetric_index(dimension, i, j)];
      row = state.stress[i * dimension + j];
      if (i != j)
        for (double& entry : row) entry *= std::numbers::sqrt2;
    }
  return components;
}

Rows incoming_flux(const Vector& covector, const Material& material, int dimension) {
  const int D = dimension, size = D + num_symmetric(D);
  std::vector<double> mass(size * size, 0.0), flux(size * size, 0.0);
  for (int i = 0; i < D; ++i) mass[i * size + i] = material.density;
  for (int r = 0; r < num_symmetric(D); ++r)
    for (int s = 0; s < num_symmetric(D); ++s) mass[(D + r) * size + D + s] = compliance(material, D, r, s);
  for (int entry = 0; entry < size * size; ++entry) flux[entry] = covector[D] * mass[entry];
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) {
        const int r = D + symmetric_index(D, a, b);
        flux[i * size + r] -= normal_product(covector, i, a, b);
        flux[r * size + i] -= normal_product(covector, i, a, b);
      }
  std::vector<double> wave = flux, factor = mass, speed(size);
  if (LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'V', 'U', size, wave.data(), size, factor.data(), size, speed.data()) != 0)
    throw std::runtime_error("incoming_flux: the material is not stable");
  Rows incoming(size, Row(size, 0.0));
  for (int c = 0; c < size; ++c) {
    Row scaled(size, 0.0);  // A_0 r_c
    for (int r = 0; r < size; ++r)
      for (int s = 0; s < size; ++s) scaled[r] += mass[r * size + s] * wave[s * size + c];
    for (int r = 0; r < size; ++r)
      for (int s = 0; s < size; ++s) incoming[r][s] += std::min(speed[c], 0.0) * scaled[r] * scaled[s];
  }
  return incoming;
}

}  // namespace tentpole::reference
