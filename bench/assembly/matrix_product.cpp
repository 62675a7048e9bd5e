#include <algorithm>
#include <vector>

#include <cblas.h>

#include "bench/assembly/checked_operator.hpp"
#include "bench/assembly/own_rungs.hpp"
#include "kernels/element/with_dimension.hpp"
#include "kernels/formulation/one_field/element_matrix.hpp"

namespace tentpole {
namespace {

/// K[rows][columns] += left right^T, all row-major.
void add_product(int rows, int columns, int inner, const double* left, int left_stride, const double* right,
                 int right_stride, double* matrix, int stride) {
  cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, rows, columns, inner, 1.0, left, left_stride, right,
              right_stride, 1.0, matrix, stride);
}

/// out[b][m] += factor F_l[b][m].
void add_table(double factor, const double* table, long size, double* out) {
#pragma omp simd
  for (long entry = 0; entry < size; ++entry) out[entry] += factor * table[entry];
}

/// - int what^T A_N w: for each component i and derivative l of the test, the trials' modes in one factor.
template <int D>
void add_inflow(const ElementOperator<D>& op, const ReferenceTablesView& tables, const FrontFacet<D>& facet,
                double* matrix) {
  constexpr int d = D + 1;
  const int num_basis = tables.num_basis, n = tables.num_unknowns, stride = tables.facet_stride;
  const long size = static_cast<long>(num_basis) * stride;
  double weight[d * d][D * D];
  inflow_weights<D>(op, facet, weight);
  const double* derivative = tables.facet_derivative(facet.facet);
  std::vector<double> trial(D * size);
  for (int i = 0; i < D; ++i)
    for (int l = 0; l < d; ++l) {
      std::fill(trial.begin(), trial.end(), 0.0);
      for (int j = 0; j < D; ++j)
        for (int m = 0; m < d; ++m)
          add_table(weight[l * d + m][i * D + j], derivative + m * size, size, trial.data() + j * size);
      add_product(num_basis, n, tables.num_facet_modes, derivative + l * size, stride, trial.data(), stride,
                  matrix + static_cast<long>(i) * num_basis * n, n);
    }
}

/// Y X^T with one column for every component of the frame and facet mode.
template <int D>
void add_vertical(const VerticalFacet<D>& facet, const ReferenceTablesView& tables, double* matrix) {
  const int num_basis = tables.num_basis, n = tables.num_unknowns, stride = tables.facet_stride;
  const long size = static_cast<long>(num_basis) * stride;
  const double* derivative = tables.facet_derivative(facet.facet);
  std::vector<double> test(D * size), trial(D * size);
  for (int c = 0; c < D; ++c) {
    double test_velocity, test_traction, trial_velocity, trial_traction;
    facet_factors<D>(facet, c, test_velocity, test_traction, trial_velocity, trial_traction);
    std::fill(test.begin(), test.end(), 0.0);
    std::fill(trial.begin(), trial.end(), 0.0);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l <= D; ++l) {
        const double velocity = facet.velocity[c][i][l], traction = facet.traction[c][i][l];
        add_table(test_velocity * velocity + test_traction * traction, derivative + l * size, size,
                  test.data() + i * size);
        add_table(trial_velocity * velocity + trial_traction * traction, derivative + l * size, size,
                  trial.data() + i * size);
      }
    add_product(n, n, tables.num_facet_modes, test.data(), stride, trial.data(), stride, matrix, n);
  }
}

/// K_ij = D_t H_ij + sum_r m_ri m_rj^T
template <int D>
void set_volume_and_rigid(const VolumeFactors& factors, const ReferenceTablesView& tables, double* matrix) {
  const int num_basis = tables.num_basis, n = tables.num_unknowns, stride = tables.basis_stride;
  const int num_modes = tables.num_curvature_modes, num_rigid = ElementOperator<D>::num_rigid;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      double* block = matrix + static_cast<long>(i) * num_basis * n + j * num_basis;
      cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, num_basis, num_basis, num_rigid, 1.0,
                  factors.rigid + i * stride, D * stride, factors.rigid + j * stride, D * stride, 0.0, block, n);
      if (num_modes > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, num_basis, num_basis, num_modes, 1.0,
                    factors.time_derivative, num_modes,
                    factors.curvature + static_cast<long>(i * D + j) * num_modes * stride, stride, 1.0, block, n);
    }
}

template <int D>
void assemble(const PatchBatch& batch, const ReferenceTablesView& tables, int element, double* matrix) {
  const ElementOperator<D> op = checked_operator<D>(batch, tables, element);
  std::vector<double> scratch(VolumeFactors::size(tables));
  const VolumeFactors factors = VolumeFactors::at(scratch.data(), tables);
  for (int a = 0; a < tables.num_basis; ++a) build_test_factors<D>(op, tables, a, factors);
  for (int component = 0; component < D * D; ++component) build_curvature_factor<D>(op, tables, component, factors);
  set_volume_and_rigid<D>(factors, tables, matrix);
  for (int f = 0; f < op.num_inflow; ++f) add_inflow<D>(op, tables, op.inflow[f], matrix);
  for (int f = 0; f < op.num_vertical; ++f) add_vertical<D>(op.vertical[f], tables, matrix);
}

}  // namespace

void assemble_matrix_product(const PatchBatch& batch, const ReferenceTablesView& tables, int element, double* matrix) {
  with_dimension(tables.dimension, [&](auto D) { assemble<D>(batch, tables, element, matrix); });
}

}  // namespace tentpole
