#pragma once

#include <stdexcept>
#include <string>

#include "kernels/element/element_operator.hpp"

namespace tentpole {

/// Geometry and material of one element of a tent. Throws std::runtime_error where the solver would refuse it.
template <int D>
ElementOperator<D> checked_operator(const PatchBatch& batch, const ReferenceTablesView& tables, int element) {
  ElementOperator<D> op;
  if (build_element_operator<D>(batch, tables, false, batch.elements[element], op) != Status::ok)
    throw std::runtime_error("element " + std::to_string(element) + " of the benchmark is not an element of a tent");
  return op;
}

}  // namespace tentpole
