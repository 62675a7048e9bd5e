#pragma once

#include "kernels/element/basis_recurrence.hpp"
#include "kernels/element/element_operator.hpp"
#include "kernels/element/simd.hpp"
#include "kernels/launch/transplant.hpp"

namespace tentpole {

/// xi = corner_0 + edge eta with edge[l][m] = corner_{m + 1, l} - corner_{0, l}.
template <int D>
struct TargetMap {
  double origin[D + 1];
  double edge[D + 1][D + 1];
};

template <int D>
inline TargetMap<D> target_map(const TransplantRequest& request) {
  TargetMap<D> map;
  for (int l = 0; l <= D; ++l) {
    map.origin[l] = request.corner[0][l];
    for (int m = 0; m <= D; ++m) map.edge[l][m] = request.corner[m + 1][l] - request.corner[0][l];
  }
  return map;
}

/// J^-1 of the target: (d eta / d xi) J^-1 of the source.
template <int D>
inline void transplant_jacobian(const TargetMap<D>& map, const double* source, double* target) {
  constexpr int d = D + 1;
  double slope[d][d];
  invert<d>(map.edge, slope);
  for (int m = 0; m < d; ++m)
    for (int j = 0; j < d; ++j) {
      double sum = 0;
      for (int l = 0; l < d; ++l) sum += slope[m][l] * source[l * d + j];
      target[m * d + j] = sum;
    }
}

/// Coefficients of the target: the source's polynomial at the target's quadrature points, tested with the basis there.
template <int D>
inline void transplant_coefficients(const TransplantTablesView& tables, const TargetMap<D>& map, const double* source,
                                    double* target) {
  constexpr int d = D + 1, max_factors = (max_degree + 1) * (max_degree + 2) / 2;
  const int num_basis = tables.num_basis;
  for (int unknown = 0; unknown < D * num_basis; ++unknown) target[unknown] = 0;
  for (int block = 0; block < tables.num_blocks; ++block) {
    const double* eta = tables.points + static_cast<long>(block) * (d + num_basis) * tables.block;
    Vector4 xi[d], factors[d * max_factors], displacement[D] = {};
    for (int l = 0; l < d; ++l) {
      xi[l] = broadcast4(map.origin[l]);
      for (int m = 0; m < d; ++m) xi[l] += map.edge[l][m] * load4(eta + m * tables.block);
    }
    basis_factors<d>(tables.recurrence, xi, factors);
    for_each_basis_function<d>(tables.recurrence, factors, [&](int a, const Vector4& phi) {
      for (int i = 0; i < D; ++i) displacement[i] += source[i * num_basis + a] * phi;
    });
    const double* weighted_basis = eta + d * tables.block;
    for (int i = 0; i < D; ++i)
      for (int b = 0; b < num_basis; ++b) {
        const Vector4 product = load4(weighted_basis + b * tables.block) * displacement[i];
        target[i * num_basis + b] += (product[0] + product[1]) + (product[2] + product[3]);
      }
  }
}

/// Carries out one request (transplant.hpp).
template <int D>
inline void transplant_element(const TransplantTask& task, int request_index) {
  constexpr int num_jacobian = (D + 1) * (D + 1);
  const TransplantRequest& request = task.requests[request_index];
  const long source = request.source_slot, target = request.target_slot, n = D * task.tables.num_basis;
  const TargetMap<D> map = target_map<D>(request);
  transplant_jacobian<D>(map, task.inverse_jacobians + source * num_jacobian,
                         task.inverse_jacobians + target * num_jacobian);
  transplant_coefficients<D>(task.tables, map, task.coefficients + source * n, task.coefficients + target * n);
}

}  // namespace tentpole
