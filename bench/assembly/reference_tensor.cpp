#include <vector>

#include "bench/assembly/checked_operator.hpp"
#include "bench/assembly/own_rungs.hpp"
#include "kernels/element_matrix.hpp"
#include "kernels/with_dimension.hpp"

namespace tentpole {
namespace {

template <int D>
void assemble(const PatchBatch& batch, const ReferenceTablesView& tables, int element, double* matrix) {
  const ElementOperator<D> op = checked_operator<D>(batch, tables, element);
  std::vector<double> scratch(VolumeFactors::size(tables));
  const VolumeFactors factors = VolumeFactors::at(scratch.data(), tables);
  FacetWeights<D> weights;
  build_facet_weights<D>(op, tables, weights);
  build_volume_factors<D>(op, tables, factors, SerialLane{});
  assemble_own_matrix<D>(weights, factors, tables, matrix, tables.num_unknowns, SerialLane{});
}

}  // namespace

void assemble_reference_tensor(const PatchBatch& batch, const ReferenceTablesView& tables, int element,
                               double* matrix) {
  with_dimension(tables.dimension, [&](auto D) { assemble<D>(batch, tables, element, matrix); });
}

}  // namespace tentpole
