#pragma once

#include "kernels/formulation/one_field/element_residual.hpp"

namespace tentpole {

/// From the descriptors of a patch to the matrices and right-hand sides of its elements.

/// Builds the operators of all elements before any is assembled: across an inclined facet an element needs its
/// neighbour's. Returns the first status that is not ok.
template <int D, class Lanes>
TENTPOLE_STEP Status build_operators(const PatchBatch& batch, const PatchWorkspace<D>& workspace, const Lanes& lanes) {
  const PatchDescriptor& patch = workspace.patch;
  share(lanes, patch.num_elements, [&](int e) {
    ElementOperator<D>& op = workspace.element(e).op();
    op.status = build_element_operator<D>(batch, workspace.tables, patch.is_general != 0,
                                          batch.elements[patch.first_element + e], op);
  });
  lanes.synchronize();
  Status status = Status::ok;
  for (int e = 0; e < patch.num_elements && status == Status::ok; ++e) status = workspace.element(e).op().status;
  return status;
}

/// Finds the rigid modes with which the neighbours across the inclined facets of an element take its displacement.
template <int D>
inline void find_receivers(const PatchBatch& batch, const PatchWorkspace<D>& workspace, int e) {
  const PatchDescriptor& patch = workspace.patch;
  const ElementDescriptor& element = batch.elements[patch.first_element + e];
  ElementOperator<D>& op = workspace.element(e).op();
  for (int f = 0; f < op.num_inclined; ++f) {
    const int facet = op.inclined[f].facet;
    const ElementOperator<D>& other = workspace.element(element.neighbor[facet] - patch.first_element).op();
    op.inclined[f].receiver = nullptr;
    for (int g = 0; g < other.num_inclined; ++g)
      if (other.inclined[g].facet == element.neighbor_facet[facet] && other.inclined[g].rigid != none)
        op.inclined[f].receiver = &other.rigid[other.inclined[g].rigid];
  }
}

/// Where the data below one inflow facet come from and go to.
template <int D>
struct InflowSource {
  bool is_given;                   ///< by a block of prescribed data
  const double* given;             ///< that block
  const double* coefficients;      ///< of the element below
  const double* inverse_jacobian;  ///< of the element below
  int code;                        ///< of the facet seen from below
  double* gradient;                ///< scratch
  double* data;                    ///< block in the layout of initial data; nullptr where there is no such facet
};
template <int D>
inline InflowSource<D> inflow_source(const PatchBatch& batch, const PatchWorkspace<D>& workspace, int e, int f) {
  const ElementDescriptor& element = batch.elements[workspace.patch.first_element + e];
  const ElementWorkspace<D> own = workspace.element(e);
  InflowSource<D> source{};
  if (f >= own.op().num_inflow) return source;
  const int facet = own.op().inflow[f].facet;
  const long slot = element.source_slot[facet];
  source.data = own.inflow_data() + f * workspace.inflow_block();
  source.gradient = own.gradient(facet);
  source.is_given = slot == none;
  if (source.is_given) {
    source.given = batch.prescribed + element.facet_data[facet];
  } else {
    source.coefficients = batch.coefficients + slot * workspace.tables.num_unknowns;
    source.inverse_jacobian = batch.inverse_jacobians + slot * (D + 1) * (D + 1);
    source.code = element.source_facet[facet];
  }
  return source;
}

/// Part `item` of the data below one inflow facet in its own modes (layout of an initial data block): four modes of all
/// fields for each block of modes, then one displacement mode each. Copied from the prescribed data, or the trace of
/// the source element. Facet corners of source and element agree one by one, so no change of modes is needed.
template <int D>
inline void load_inflow_data(const ReferenceTablesView& tables, const InflowSource<D>& source, int item) {
  constexpr int num_fields = D + num_symmetric(D);
  const int num_modes = tables.num_facet_modes, m = 4 * item, mode = item - num_mode_blocks(tables),
            entry = num_fields * num_modes + mode;
  if (mode >= 0) {
    source.data[entry] =
        source.is_given ? source.given[entry] : displacement_mode<D>(tables, source.code, source.coefficients, mode);
    return;
  }
  Vector4 trace[num_fields];
  if (source.is_given)
    for (int field = 0; field < num_fields; ++field)
      trace[field] = load_modes(source.given + field * num_modes, num_modes, m);
  else
    velocity_and_strain<D>(source.inverse_jacobian, source.gradient, tables.facet_stride, m, trace);
  for (int field = 0; field < num_fields; ++field)
    store_modes(trace[field], num_modes, m, source.data + field * num_modes);
}

/// The data of all inflow facets of the elements of a range, and the small factors of their matrices.
template <int D, class Lanes>
TENTPOLE_STEP void prepare_elements(const PatchBatch& batch, const PatchWorkspace<D>& workspace, ElementRange range,
                                    const Lanes& lanes) {
  constexpr int num_facets = D + 2;
  const ReferenceTablesView& tables = workspace.tables;
  const int max_inflow = workspace.patch.is_general ? num_facets : 1;
  const auto source_of = [&](int index) {
    return inflow_source<D>(batch, workspace, range.first + index / max_inflow, index % max_inflow);
  };
  share(lanes, range.count * max_inflow, D * (D + 1) * num_mode_blocks(tables), [&](int index) {
    return [&tables, source = source_of(index)](int block) {
      if (source.data == nullptr || source.is_given) return;
      gradient_block<D>(tables, tables.facet_derivative(source.code), source.coefficients, source.gradient, block);
    };
  });
  if (workspace.patch.is_general)
    share(lanes, range.count, [&](int e) { find_receivers<D>(batch, workspace, range.first + e); });
  share(lanes, range.count, num_facets, [&](int e) {
    return [&tables, own = workspace.element(range.first + e)](int f) {
      if (f < num_weighted_facets(own.op())) build_facet_weights<D>(own.op(), tables, f, own.weights());
      if (f < own.op().num_vertical && own.op().vertical[f].port != none)
        build_port_factors<D>(own.op().vertical[f], own.ports()[f]);
    };
  });
  share(lanes, range.count, tables.num_basis, [&](int e) {
    return [&tables, own = workspace.element(range.first + e)](int a) {
      build_test_factors<D>(own.op(), tables, a, VolumeFactors::at(own.factors(), tables));
    };
  });
  share(lanes, range.count, D * D, [&](int e) {
    return [&tables, own = workspace.element(range.first + e)](int component) {
      build_curvature_factor<D>(own.op(), tables, component, VolumeFactors::at(own.factors(), tables));
    };
  });
  lanes.synchronize();
  share(lanes, range.count * max_inflow, num_mode_blocks(tables) + D * (D + 1), [&](int index) {
    return [&tables, source = source_of(index)](int item) {
      if (source.data != nullptr) load_inflow_data<D>(tables, source, item);
    };
  });
}

/// The condensed matrices of the elements of a range (kernels/coupling/condensed_element.hpp) without their right-hand
/// sides. Flops: 2 n^2 (pairs (1 + vertical facets) + num_curvature_modes + num_rigid) for A, flat in k but for the
/// volume term.
template <int D, class Lanes>
TENTPOLE_STEP void assemble_matrices(const PatchWorkspace<D>& workspace, ElementRange range, const Lanes& lanes) {
  const ReferenceTablesView& tables = workspace.tables;
  share(lanes, range.count, workspace.largest_shape().rows, [&](int e) {
    const ElementWorkspace<D> own = workspace.element(range.first + e);
    return [shape = workspace.shape(own), matrix = own.matrix()](int row) {
      if (row < shape.rows) clear_padding(shape, matrix, row);
    };
  });
  lanes.synchronize();
  share(lanes, range.count, tables.num_basis, [&](int e) {
    const ElementWorkspace<D> own = workspace.element(range.first + e);
    const OwnMatrix<D> matrix{tables,
                              own.weights(),
                              num_weighted_facets(own.op()),
                              VolumeFactors::at(own.factors(), tables),
                              own.matrix(),
                              workspace.shape(own).stride};
    return [matrix](int a) { assemble_own_rows<D>(matrix, a); };
  });
  const int max_ports = workspace.patch_shape().max_ports;
  share(lanes, range.count * max_ports, tables.num_basis, [&](int index) {
    const ElementWorkspace<D> own = workspace.element(range.first + index / max_ports);
    const int f = index % max_ports;
    const bool is_port = f < own.op().num_vertical && own.op().vertical[f].port != none;
    return [=, &tables, &facet = own.op().vertical[f], &factors = own.ports()[f], shape = workspace.shape(own)](int a) {
      if (is_port) assemble_port<D>(facet, factors, tables, shape, a, own.matrix());
    };
  });
  if (workspace.patch.is_general)
    share(lanes, range.count, tables.num_basis, [&](int e) {
      return [&tables, own = workspace.element(range.first + e), &workspace](int a) {
        for (int f = 0; f < own.op().num_inclined; ++f)
          assemble_inclined_port<D>(own.op(), own.op().inclined[f], tables, workspace.shape(own), a, own.matrix());
      };
    });
  lanes.synchronize();
}

/// Assembles the elements of a range with their right-hand sides, keeps their diagonals and clears their solutions.
template <int D, class Lanes>
inline void assemble_elements(const PatchBatch& batch, const PatchWorkspace<D>& workspace, ElementRange range,
                              const Lanes& lanes) {
  prepare_elements<D>(batch, workspace, range, lanes);
  assemble_matrices<D>(workspace, range, lanes);
  element_residuals<D>(batch, workspace, range, nullptr, lanes);
  share(lanes, range.count, workspace.largest_shape().rows, [&](int e) {
    const ElementWorkspace<D> own = workspace.element(range.first + e);
    return [own, shape = workspace.shape(own)](int row) {
      if (row >= shape.rows) return;
      double* entries = own.matrix() + static_cast<long>(row) * shape.stride;
      Vector4 right{};
      if (row < shape.unknowns_padded) {
        right[0] = own.right()[row];
        own.diagonal()[row] = entries[row];
        own.solution()[row] = 0;
      }
      store4(entries + shape.right_column(), right);
    };
  });
  lanes.synchronize();
}

}  // namespace tentpole
