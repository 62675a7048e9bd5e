#include <vector>

#include "bench/assembly/checked_operator.hpp"
#include "bench/assembly/own_rungs.hpp"
#include "kernels/element/with_dimension.hpp"
#include "kernels/formulation/one_field/element_matrix.hpp"

namespace tentpole {
namespace {

template <int D>
void assemble(const PatchBatch& batch, const ReferenceTablesView& tables, int element, double* matrix) {
  const ElementOperator<D> op = checked_operator<D>(batch, tables, element);
  std::vector<double> scratch(VolumeFactors::size(tables));
  const VolumeFactors factors = VolumeFactors::at(scratch.data(), tables);
  FacetWeights<D> weights;
  for (int f = 0; f < num_weighted_facets(op); ++f) build_facet_weights<D>(op, tables, f, weights);
  for (int a = 0; a < tables.num_basis; ++a) build_test_factors<D>(op, tables, a, factors);
  for (int component = 0; component < D * D; ++component) build_curvature_factor<D>(op, tables, component, factors);
  const OwnMatrix<D> own{tables, weights, num_weighted_facets(op), factors, matrix, tables.num_unknowns};
  for (int a = 0; a < tables.num_basis; ++a) assemble_own_rows<D>(own, a);
}

}  // namespace

void assemble_reference_tensor(const PatchBatch& batch, const ReferenceTablesView& tables, int element,
                               double* matrix) {
  with_dimension(tables.dimension, [&](auto D) { assemble<D>(batch, tables, element, matrix); });
}

}  // namespace tentpole
