#include "host/batch/dense_fallback.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/batch/patch_place.hpp"
#include "kernels/launch/patch_solver.hpp"
#include "kernels/patch/dense_patch_solve.hpp"
#include "kernels/reference/patch_matrix.reference.hpp"

namespace tentpole {

DenseFallback::DenseFallback(HostBatch& batch, const PatchDescriptor& patch, const Simulation& simulation,
                             const ReferenceTables& tables)
    : batch_(batch),
      patch_(patch),
      simulation_(simulation),
      tables_(tables),
      num_unknowns_(tables.view().num_unknowns),
      num_jacobian_((simulation.dimension() + 1) * (simulation.dimension() + 1)) {
  for (int e = 0; e < patch.num_elements; ++e)
    result_slots_.push_back(batch.elements[patch.first_element + e].result_slot);
}

void DenseFallback::solve(std::span<const std::int32_t> source_slots, std::span<const double> coefficients,
                          std::span<const double> inverse_jacobians) {
  const Status failed = static_cast<Status>(batch_.records[patch_.first_element].status);
  for (const Status geometric :
       {Status::inverted_element, Status::not_causal, Status::patch_not_general, Status::boundary_not_vertical})
    if (failed == geometric) fail(failed);
  // A batch of this patch alone over a store of its own: slot e takes element e, the sources follow.
  std::vector<ElementDescriptor> elements(batch_.elements.begin() + patch_.first_element,
                                          batch_.elements.begin() + patch_.first_element + patch_.num_elements);
  const int num_elements = patch_.num_elements;
  int source = num_elements;
  for (int e = 0; e < num_elements; ++e) {
    elements[e].result_slot = e;
    for (int facet = 0; facet <= simulation_.dimension() + 1; ++facet) {
      if (has_source(elements[e], facet)) elements[e].source_slot[facet] = source++;
      if (is_shared(elements[e].facet_kind[facet])) elements[e].neighbor[facet] -= patch_.first_element;
    }
  }
  coefficients_.assign((num_elements + source_slots.size()) * num_unknowns_, 0.0);
  inverse_jacobians_.assign((num_elements + source_slots.size()) * num_jacobian_, 0.0);
  std::copy(coefficients.begin(), coefficients.end(), coefficients_.begin() + num_elements * num_unknowns_);
  std::copy(inverse_jacobians.begin(), inverse_jacobians.end(),
            inverse_jacobians_.begin() + num_elements * num_jacobian_);

  const PatchDescriptor patch{0, num_elements};
  PatchBatch view{};
  view.num_patches = 1;
  view.num_elements = num_elements;
  view.patches = &patch;
  view.elements = elements.data();
  view.prescribed = batch_.prescribed.data();
  view.materials = simulation_.scaled_materials.data();
  view.coefficients = coefficients_.data();
  view.inverse_jacobians = inverse_jacobians_.data();
  view.records = &batch_.records[patch_.first_element];
  const DensePatch dense = reference_patch_system(view, simulation_.dimension(), simulation_.degree(), 0);
  std::vector<double> solution(dense.size);
  double residual = 0;
  DenseSolveScratch scratch;
  const Status status = solve_dense_patch(dense.matrix, dense.rhs, solution, residual, scratch);
  if (status != Status::ok) fail(status);
  std::copy(solution.begin(), solution.end(), coefficients_.begin());
  evaluate_patches_host(view, tables_.view());
  for (int e = 0; e < num_elements; ++e)
    if (batch_.records[patch_.first_element + e].status != static_cast<int>(Status::ok))
      fail(Status::residual_too_large);
}

void DenseFallback::fail(Status status) const {
  throw std::runtime_error(patch_place(batch_, patch_, simulation_) + ": the patch of " +
                           std::to_string(patch_.num_elements) + " elements could not be solved (" +
                           status_name(status) +
                           ", also by pivoted dense LU). Check the mesh there for very flat cells, "
                           "or lower front.causality.");
}

}  // namespace tentpole
