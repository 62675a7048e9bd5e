#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "kernels/element/patch_batch.hpp"
#include "tests/kernels/patch_geometry.hpp"
#include "tests/kernels/polynomial_field.hpp"
#include "tests/kernels/tent_geometry.hpp"

namespace tentpole {

/// A batch of patches in host memory with a known answer. Every tent is given the initial data (or source elements),
/// boundary data and body force of a polynomial displacement, which the method reproduces exactly.
/// Copies are independent: view() points into the object it is called on.
struct TentBatch {
  int dimension = 0;
  int degree = 0;
  std::vector<PatchDescriptor> patches;
  std::vector<ElementDescriptor> elements;
  std::vector<double> prescribed;
  std::vector<Material> materials;
  std::vector<double> coefficients;       ///< [slot][num_unknowns]; NaN where a solver has to write
  std::vector<double> inverse_jacobians;  ///< [slot][(D + 1)^2]; NaN where a solver has to write
  std::vector<ElementRecord> records;     ///< [element], zero
  FractureLaw fracture_law{};
  std::vector<FractureFacet> fracture_facets;
  std::vector<FractureRecord> fracture_records;  ///< [fracture facet], zero
  std::vector<double> exact;  ///< [element][num_unknowns], of the polynomial; meaningless where homogeneous

  int num_basis() const { return num_polynomials(dimension + 1, degree); }
  int num_unknowns() const { return dimension * num_basis(); }
  int num_slots() const { return static_cast<int>(coefficients.size()) / num_unknowns(); }
  PatchBatch view();
};

/// How the data of a tent are given.
struct TentData {
  double source_fraction = 0.5;             ///< part of the elements with a source element below, others initial data
  std::optional<BoundaryKind> normal_kind;  ///< of every boundary facet; random where absent
  std::optional<BoundaryKind> tangential_kind;
  bool homogeneous = false;  ///< no body force, zero boundary data: only what comes from below
};

/// Appends one patch. material[element] indexes batch.materials (already there) and fields, one for each of
/// batch.materials.
void append_patch(TentBatch& batch, const PatchGeometry& patch, const std::vector<int>& material,
                  const std::vector<PolynomialField>& fields, const TentData& data, std::mt19937& generator);

/// Appends one patch: an element over every cell of the tent. material[cell] indexes batch.materials (already there)
/// and fields, one for each of batch.materials.
void append_tent(TentBatch& batch, const TentGeometry& tent, const std::vector<int>& material,
                 const std::vector<PolynomialField>& fields, const TentData& data, std::mt19937& generator);

/// Density 0.5..2, c_p 0.7..1.4, c_s / c_p 0.3..0.65.
Material random_material(std::mt19937& generator);

/// All that random_tents draws from.
struct TentOptions {
  int num_patches = 1;
  int num_materials = 1;           ///< above 1 cells take random ones, and the polynomial is a translation u(t)
  double boundary_fraction = 0.5;  ///< part of the tents whose pole is on the boundary
  double front_steepness = 0.6;    ///< max |grad tau| c_p of the old front, below 0.95
  double height_fraction = 0.9;    ///< of the causal limit
  StarShape shape;
  TentData data;
};

/// Random tents with a random polynomial of the batch's degree; the same seed gives the same batch.
TentBatch random_tents(int dimension, int degree, const TentOptions& options, std::uint32_t seed);

}  // namespace tentpole
