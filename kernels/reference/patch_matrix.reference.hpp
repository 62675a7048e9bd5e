#pragma once

#include <span>
#include <vector>

#include "kernels/element/patch_batch.hpp"

namespace tentpole {

/// The linear system of one patch, unknown (i, a) of its element e at (e * num_unknowns + i * num_basis + a).
struct DensePatch {
  int size = 0;
  std::vector<double> matrix;  ///< [size][size], row = test function
  std::vector<double> rhs;     ///< [size]
};

/// s* = M s0 at one point of a fracture facet, with damage and contact mode as they are. All points of a facet
/// integrate it.
struct FrozenPoint {
  std::vector<double> barycentric;  ///< [D + 1] in the listed corners of the facet
  double weight;                    ///< of the mean over the facet
  std::vector<double> map;          ///< M in global axes, [D][D]
};
using FrozenFracture = std::vector<FrozenPoint>;

/// Matrix and right-hand side of patch number `patch` by quadrature point by point, exact for straight simplices:
///   volume             K += int v^ . (rho v_t - div sigma),                b += int v^ . (rho b)
///   inflow facets      K -= int w^T A_N w,                                  b -= int w^T A_N w_below
///   vertical facets    K -= int (v^ + Z^-1 s^) . (s* - s), the data part of s* going to b
///                      with s* = M s0 on fracture facets, s0 the intact traction
///   inclined facets    K -= int w^T A_N^- w,                                K += int w^T A_N^- w_neighbour
///   where N_t < 0      K += kappa int u^_0 . u |N_t|,                       b += kappa int u^_0 . u_below |N_t|
/// with sigma = lambda tr(E) I + 2 mu E, w = (v, sigma), and ^ marking test functions (docs/formulation.md, Element
/// problem). The solution does not depend on kappa > 0; scaled units make 1 the natural value.
/// Host only, serial, never tuned: the truth that every faster path is compared with. `batch` holds host pointers and
/// its store the coefficients and inverse Jacobians of the sources; nothing is written. Scaled units. Preconditions
/// (asserted nowhere else but by the element check of the solver): positive volumes, causal
/// inflow and outflow facets, vertical boundary facets.
/// fractures: of every fracture facet of the batch; throws std::invalid_argument where a facet of the patch has none.
DensePatch reference_patch_system(const PatchBatch& batch, int dimension, int degree, int patch, double kappa = 1,
                                  std::span<const FrozenFracture> fractures = {});

}  // namespace tentpole
