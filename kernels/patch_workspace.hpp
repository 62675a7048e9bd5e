#pragma once

#include "kernels/amplitude_coupling.hpp"
#include "kernels/element_residual.hpp"
#include "kernels/fracture_facet.hpp"

namespace tentpole {

/// Memory of one element while its patch is solved.
template <int D>
struct ElementWorkspace {
  ElementOperator<D>* op;
  double* matrix;       ///< condensed matrix
  double* diagonal;     ///< of A before elimination [unknowns_padded]
  double* right;        ///< b or residual, then L^-1 of it [unknowns_padded]
  double* solution;     ///< c [unknowns_padded]
  double* inflow_data;  ///< a block in the layout of initial data for each inflow facet
};

/// All scratch of one patch: a block per element, then arrays shared by its elements, the coupling solver, and a block
/// per fracture facet.
template <int D>
struct PatchWorkspace {
  ReferenceTablesView tables;
  PatchDescriptor patch;
  int lanes;
  double* memory;

  PatchShape patch_shape() const { return PatchShape(tables, patch.is_general != 0); }
  CondensedShape largest_shape() const { return CondensedShape(tables, patch_shape(), patch_shape().max_ports); }
  CondensedShape shape(const ElementWorkspace<D>& own) const {
    return CondensedShape(tables, patch_shape(), own.op->num_ports);
  }

  static long padded(long n) { return (n + 7) / 8 * 8; }
  static long doubles_of(long bytes) { return padded((bytes + 7) / 8); }
  long inflow_size() const {
    const long block = (D + num_symmetric(D)) * tables.num_facet_modes + D * (D + 1);
    return padded(patch.is_general ? (D + 2) * block : block);
  }
  long element_size() const {
    const CondensedShape shape = largest_shape();
    return doubles_of(sizeof(ElementOperator<D>)) + padded(shape.matrix_size()) + 3 * padded(shape.unknowns_padded) +
           inflow_size();
  }
  int num_links() const { return patch.num_elements * patch_shape().max_ports; }
  int num_amplitudes() const { return num_links() * patch_shape().amplitudes_per_port; }

  /// Doubles needed in all.
  long size() const { return coupling() + CouplingScratch::size(num_amplitudes(), lanes) - memory; }

  ElementWorkspace<D> element(int local) const {
    const CondensedShape shape = largest_shape();
    double* next = memory + local * element_size();
    const auto take = [&next](long count) {
      double* start = next;
      next += padded(count);
      return start;
    };
    ElementWorkspace<D> workspace;
    workspace.op = reinterpret_cast<ElementOperator<D>*>(take(doubles_of(sizeof(ElementOperator<D>))));
    workspace.matrix = take(shape.matrix_size());
    workspace.diagonal = take(shape.unknowns_padded);
    workspace.right = take(shape.unknowns_padded);
    workspace.solution = take(shape.unknowns_padded);
    workspace.inflow_data = take(inflow_size());
    return workspace;
  }
  double* volume_factors() const { return memory + patch.num_elements * element_size(); }
  double* residual_scratch() const { return volume_factors() + padded(VolumeFactors::size(tables)); }
  double* packed() const { return residual_scratch() + padded(ResidualScratch::size(tables)); }
  double* outgoing() const { return packed() + padded(8L * largest_shape().unknowns_padded); }
  double* incoming() const { return outgoing() + padded(num_amplitudes()); }
  const double** responses() const { return reinterpret_cast<const double**>(incoming() + padded(num_amplitudes())); }
  int* integers() const { return reinterpret_cast<int*>(responses() + padded(patch.num_elements)); }
  long num_integers() const { return 3L * patch.num_elements + 2L * num_links() + 1; }
  double* fractures() const { return reinterpret_cast<double*>(integers()) + doubles_of(sizeof(int) * num_integers()); }
  FractureLink* links() const { return reinterpret_cast<FractureLink*>(fractures()); }
  long links_size() const { return doubles_of(sizeof(FractureLink) * patch.num_fractures); }
  FractureWorkspace<D> fracture(int local) const {
    FractureWorkspace<D> own =
        FractureWorkspace<D>::at(fractures() + links_size() + local * FractureWorkspace<D>::size(tables), tables);
    own.link = links() + local;
    return own;
  }
  double* coupling() const {
    return fractures() + links_size() + patch.num_fractures * FractureWorkspace<D>::size(tables);
  }
};

}  // namespace tentpole
