#include "bench/assembly/own_rungs.hpp"

namespace tentpole {

void assemble_batched(const PatchBatch& batch, const ReferenceTablesView& tables, int num_elements, double* matrices,
                      int num_threads) {
  const long size = static_cast<long>(tables.num_unknowns) * tables.num_unknowns;
#pragma omp parallel for schedule(monotonic : dynamic, 1) num_threads(num_threads)
  for (int element = 0; element < num_elements; ++element)
    assemble_reference_tensor(batch, tables, element, matrices + element * size);
}

}  // namespace tentpole
