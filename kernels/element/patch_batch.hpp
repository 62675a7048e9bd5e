#pragma once

#include <cstdint>

#include "common/index.hpp"
#include "common/material.hpp"
#include "common/simplex.hpp"
#include "kernels/fracture/damage_law.hpp"

namespace tentpole {

/// What is prescribed on a boundary facet, separately for the normal and the tangential components.
enum class BoundaryKind : std::uint8_t { traction = 0, velocity = 1, absorbing = 2 };

/// What a facet of an element is to its patch.
enum class FacetKind : std::uint8_t {
  inflow,    ///< lies on the old front: data come from an element below, or are initial data
  outflow,   ///< lies on the new front
  interior,  ///< between two elements of the patch; vertical, or inclined where one material is on both sides
  boundary,  ///< vertical, on the boundary of the domain
  fracture,  ///< between two elements of the patch, vertical, and may be debonded (kernels/fracture/fracture_facet.hpp)
};

/// One spacetime element of a patch: a simplex with corners 0..D+1; facet j is opposite corner j.
/// - Tent element (pole in 0..D): over a front cell with the corners 0..D (ascending global vertex id), with the top of
///   the tent pole as corner D + 1. Facet D + 1 is the inflow facet, facet `pole` the outflow facet, the others contain
///   the pole. The top stands straight above the pole's bottom, or is moved (an inclined tent).
/// - General element (pole == none; vertex deletions and flips): all corners ascend by global vertex id, and any facet
///   may be of any kind.
/// The corners of a facet are listed so that both sides agree, and its code names the reference tables that fit: code j
/// = 0..D+1 for the facet opposite corner j with its corners ascending (in a tent element the top comes last); code D +
/// 2 + p for the outflow facet of a tent element with pole p, which has the top in place of corner p. Units: scaled
/// (docs/formulation.md, Scaling). A plain struct: it is copied to the device byte by byte.
struct ElementDescriptor {
  static constexpr int max_facets = max_dimension + 2;
  double corner[max_facets][max_dimension + 1];  ///< rows 0..D+1, columns x.. then t in column D
  std::int32_t pole;                             ///< corner that is the bottom of the tent pole, 0..D; or none
  std::int32_t material;                         ///< index into the materials
  std::int32_t result_slot;                      ///< element store slot that takes the coefficients
  std::int32_t body_force_data;                  ///< offset of the body force block in `prescribed`, or none
  std::int32_t source_slot[max_facets];  ///< inflow: slot of the element below, or none where initial data are given
  std::int32_t neighbor[max_facets];     ///< interior, fracture: element (index in the batch) across the facet
  std::int32_t facet_data[max_facets];   ///< inflow without source: offset of the initial data; boundary: offset of its
                                         ///< block, or none for zero data; fracture: index of the fracture facet
  FacetKind facet_kind[max_facets];
  std::uint8_t source_facet[max_facets];    ///< inflow: code of the facet seen from the source
  std::uint8_t neighbor_facet[max_facets];  ///< interior, fracture: number of the facet seen from the neighbour
  BoundaryKind normal_kind[max_facets];     ///< boundary
  BoundaryKind tangential_kind[max_facets];
};

/// Whether a facet has an element of the patch on either side.
constexpr bool is_shared(FacetKind kind) {
  return kind == FacetKind::interior || kind == FacetKind::fracture;
}

/// Whether an element of the store lies below the facet.
constexpr bool has_source(const ElementDescriptor& element, int facet) {
  return element.facet_kind[facet] == FacetKind::inflow && element.source_slot[facet] != none;
}

/// Number of codes of a facet.
constexpr int num_facet_tables(int dimension) {
  return 2 * dimension + 3;
}

/// Code of facet j of an element: which reference tables it takes.
constexpr int facet_table(const ElementDescriptor& element, int dimension, int facet) {
  return facet == element.pole ? dimension + 2 + facet : facet;
}

/// A patch is a run of consecutive elements of the batch.
struct PatchDescriptor {
  std::int32_t first_element = 0;
  std::int32_t num_elements = 0;
  std::int32_t is_general = 0;      ///< 1 where a tent is inclined or an element is general: more memory
  std::int32_t first_fracture = 0;  ///< its fracture facets are consecutive too
  std::int32_t num_fractures = 0;
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

/// A vertical facet between two elements of one patch that may be debonded: D = 2 the triangle that a crack edge of the
/// front sweeps, D = 1 the segment above a cracked vertex. Damage and gap are kept on lines parallel to the time axis,
/// through the k + 1 Gauss points of the front edge from its lower to its higher vertex id (D = 1: one line).
struct FractureFacet {
  std::int32_t element[2];  ///< index in the batch; side 0 and side 1
  std::uint8_t facet[2];    ///< number of the facet in each element
  std::uint8_t rising_end;  ///< end of the front edge that the tent raises: 0 the lower id, 1 the higher; D = 1: 0
  double damage[max_degree + 1];  ///< D on the old front
  double gap[max_degree + 1];     ///< normal opening on the old front: positive where the sides are apart
};

/// What comes back for each fracture facet. Energies in scaled units.
struct FractureRecord {
  double damage[max_degree + 1];  ///< on the new front
  double gap[max_degree + 1];
  double fracture_work;          ///< int s*.(v*_1 - v*_0) without the friction work; >= 0 but for rounding
  double friction_work;          ///< the part that sliding under pressure dissipates
  double largest_damage_change;  ///< over the lines
  double largest_effective_traction;
  std::int32_t rounds;          ///< of the damage loop
  std::int32_t mode_points[3];  ///< points in open, sticking, slipping mode
  std::int32_t status;          ///< Status of the patch; the rest is zero where it could not be solved
};

/// What comes back for each element. Energies in scaled units; E = int 1/2 w^T A_N w.
struct ElementRecord {
  double inflow_energy;         ///< through the inflow facets, of the data below
  double initial_energy;        ///< the part of it through facets with initial data
  double outflow_energy;        ///< through the outflow facets, of the solution
  double dissipation;           ///< numerical, all facets but those of outflow, >= 0
  double external_work;         ///< int v*.s* over boundary facets + int v.(rho b)
  double max_principal_stress;  ///< largest principal stress at the corners of the outflow facets
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
  FractureLaw fracture_law;           ///< scaled
  const FractureFacet* fracture_facets;
  FractureRecord* fracture_records;  ///< [fracture facet]
};

}  // namespace tentpole
