#pragma once

#include <array>
#include <cstdint>

#include "common/simplex.hpp"
#include "kernels/element/transplant_tables.hpp"
#include "kernels/launch/launch.hpp"

namespace tentpole {

/// Asks for the polynomial of one element of the store on another simplex: the same function in the basis of the
/// target.
struct TransplantRequest {
  std::int32_t source_slot;
  std::int32_t target_slot;
  double corner[max_dimension + 2][max_dimension + 1];  ///< of the target, D + 2 rows: reference coordinates xi in the
                                                        ///< source
};

/// Everything one launch needs; all pointers in the memory of the device that runs it.
struct TransplantTask {
  TransplantTablesView tables;
  int num_requests;
  const TransplantRequest* requests;  ///< [num_requests]
  double* coefficients;               ///< element store: [slot][num_unknowns]
  double* inverse_jacobians;          ///< element store: [slot][l][j], (D + 1)^2 each
  LaunchShape shape;
};

/// Request for one part of a front cell that was cut. The part gets an element of its own below it, so that no facet is
/// ever shared by parts: the simplex of the part and the corner of the parent's element that is not on the cell.
/// Corners of the target: the vertices of the part in ascending id, then that corner; so the part lists its corners as
/// facet_table D + 1. `source_facet`: facet_table of the parent's element; part[i]: barycentric coordinates in the
/// parent cell of the part's i-th vertex (D + 1 of them). Slots are left to the caller.
using CellPart = std::array<std::array<double, max_dimension + 1>, max_dimension + 1>;
TransplantRequest cell_part_request(int dimension, int source_facet, const CellPart& part);

/// Re-expands the polynomials, exact but for rounding:
///   target coefficients   c_ib = int phi_b(eta) u_i(xi(eta)) d eta over the reference simplex, xi(eta) affine from the
///                         corners, by a rule of degree 2 k;
///   target J^-1           (d eta / d xi) J^-1 of the source.
/// Several requests may read one source; no target is a source or a target of another request of the same launch.
/// Precondition: targets have a volume. On the host: one `parallel for`. Flops per request and point: 4 D num_basis.
void transplant_host(const TransplantTask& task);

/// The same on an OpenMP device: threads on a CPU device (shape.lanes == 1), one thread per request on a GPU.
/// Synchronous. Without offload in the build it aborts with a message: nobody may call it there.
void transplant_device(const TransplantTask& task, int device_number);

}  // namespace tentpole
