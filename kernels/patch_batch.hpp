#pragma once

#include <cstdint>

#include "common/material.hpp"
#include "common/simplex.hpp"

namespace tentpole {

/// What is prescribed on a boundary facet, separately for the normal and the tangential components.
enum class BoundaryKind : std::uint8_t { traction = 0, velocity = 1, absorbing = 2 };

/// Index of an absent slot, neighbour or data block.
inline constexpr std::int32_t none = -1;

/// One spacetime element of a tent: the simplex over a front cell with the D + 1 corners 0..D (ascending global vertex
/// id) and the top of the tent pole as corner D + 1. Facet j is opposite corner j: facet D + 1 is the inflow facet,
/// facet `pole` the outflow facet, the other D are vertical. Facet corners are listed so that neighbours agree: inflow
/// 0..D; outflow the same with the top in place of the pole's bottom; vertical ascending, the top last. Units: scaled
/// (docs/formulation.md, Scaling). A plain struct: it is copied to the device byte by byte.
struct ElementDescriptor {
  double corner[max_dimension + 2][max_dimension + 1];  ///< rows 0..D+1, columns x.. then t in column D
  std::int32_t pole;                                    ///< corner that is the bottom of the tent pole, 0..D
  std::int32_t material;                                ///< index into the materials
  std::int32_t result_slot;                             ///< element store slot that takes the coefficients
  std::int32_t source_slot;                             ///< slot of the element below the inflow facet, or none
  std::int32_t source_pole;                             ///< the source's outflow facet is opposite this corner
  std::int32_t inflow_data;      ///< where source_slot is none: offset into `prescribed` of the initial data (below)
  std::int32_t body_force_data;  ///< offset of the body force block, or none
  std::int32_t neighbor[max_dimension + 1];       ///< element (index in the batch) across facet j; none: boundary facet
  std::int32_t boundary_data[max_dimension + 1];  ///< offset of the boundary block of facet j, or none: zero data
  std::uint8_t neighbor_facet[max_dimension + 1];  ///< facet number of facet j seen from the neighbour
  BoundaryKind normal_kind[max_dimension + 1];     ///< where neighbor is none
  BoundaryKind tangential_kind[max_dimension + 1];
};

/// A patch is a run of consecutive elements of the batch.
struct PatchDescriptor {
  std::int32_t first_element;
  std::int32_t num_elements;
};

/// Data blocks in `prescribed`, all as mode coefficients, mode fastest. psi_m: orthonormal polynomials of degree k - 1
/// on the facet (mean of psi_m psi_n over the facet = delta_mn), num_facet_modes of them; the degree-1 modes are the
/// first D + 1 of degree 1.
///   initial data:  velocity[D][num_facet_modes], strain[D (D+1)/2][num_facet_modes] (order xx, yy, zz, xy, yz, xz; xy
///   is the tensor
///                  component), displacement[D][D + 1] (degree-1 modes) on the inflow facet;
///   boundary data: value[D][num_facet_modes] in global axes: its part along the facet normal is the prescribed
///   velocity or
///                  traction (on the outward normal) after normal_kind, its tangential part after tangential_kind;
///                  absorbing takes (traction + Z velocity) of the far field;
///   body force:    rho b [D][num_volume_modes] in the orthonormal polynomials of degree k - 1 of the reference
///   simplex.

/// What comes back for each element. Energies in scaled units; E = int 1/2 w^T A_N w.
struct ElementRecord {
  double inflow_energy;         ///< through the inflow facet, of the data below
  double outflow_energy;        ///< through the outflow facet, of the solution
  double dissipation;           ///< numerical, inflow + vertical + boundary facets, >= 0
  double external_work;         ///< int v*.s* over boundary facets + int v.(rho b)
  double max_principal_stress;  ///< largest principal stress at the corners of the outflow facet
  double residual;              ///< relative residual of the element's equations, after refinement
  std::int32_t status;          ///< Status
  std::int32_t num_iterations;  ///< of the amplitude coupling (same for all elements of a patch)
};

/// Everything one launch reads and writes; pointers are to the memory of the device that runs it.
struct PatchBatch {
  int num_patches;
  int num_elements;
  const PatchDescriptor* patches;     ///< [num_patches]
  const ElementDescriptor* elements;  ///< [num_elements]
  const double* prescribed;           ///< data blocks, see above
  const Material* materials;          ///< [num_materials], scaled
  double* coefficients;               ///< element store: [slot][num_unknowns], dof (i, a) at i * num_basis + a
  double* inverse_jacobians;          ///< element store: [slot][l][j] = d xi_l / d x_j, (D + 1)^2 each
  ElementRecord* records;             ///< [num_elements]
};

}  // namespace tentpole
