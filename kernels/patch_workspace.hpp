#pragma once

#include "kernels/amplitude_coupling.hpp"
#include "kernels/element_matrix.hpp"
#include "kernels/facet_traces.hpp"
#include "kernels/fracture_facet.hpp"

namespace tentpole {

/// What one facet of an element gives to its balance.
struct FacetBalance {
  double dissipation;
  double external_work;
};

/// What a facet of the front adds to the record of its element.
struct FrontFacetRecord {
  double energy;            ///< that crosses it
  double principal_stress;  ///< largest at its corners; outflow facets only
};

/// Memory of one element while its patch is solved. Facets are numbered as in the descriptor.
template <int D>
struct ElementWorkspace {
  static constexpr int d = D + 1, num_facets = D + 2, num_fields = D + num_symmetric(D);

  // From the first step to the last.
  ElementOperator<D>* op;
  double* matrix;         ///< condensed matrix
  double* inverse_upper;  ///< [4][4] of the pivot block (lanes of a team)
  int* is_regular;        ///< whether all pivots were
  double* diagonal;       ///< of A before elimination [unknowns_padded]
  double* right;          ///< b or residual, then L^-1 of it, then the correction [unknowns_padded]
  double* solution;       ///< c [unknowns_padded]
  double* inflow_data;    ///< a block in the layout of initial data for each inflow facet
  double* gradients;      ///< [facet][i][l][facet_stride]: gradient modes of the source below, then of the solution
  FacetBalance* balance;  ///< [facet]

  // While its range of elements is worked on.
  FacetWeights<D>* weights;
  PortFactors<D>* ports;    ///< [vertical facet]
  FrontFacetRecord* front;  ///< [inflow facets, then outflow facets]
  VolumeFactors factors;
  double* traces;         ///< [facet][num_fields][facet_stride]
  double* fluxes;         ///< [facet][l][i][facet_stride]
  double* curvature;      ///< [D][num_volume_modes]
  double* displacements;  ///< [rigid facet][D][d]: degree-1 modes of the solution
  double* motions;        ///< [rigid facet][D][d]: rigid motion that is added
  long gradient_size, trace_size;

  double* gradient(int facet) const { return gradients + facet * gradient_size; }
  double* trace(int facet) const { return traces + facet * trace_size; }
  double* flux(int facet) const { return fluxes + facet * gradient_size; }
  double* displacement(int rigid) const { return displacements + rigid * D * d; }
  double* motion(int rigid) const { return motions + rigid * D * d; }
};

/// All scratch of one patch: a block per element, arrays shared by the elements, the coupling solver, and a block per
/// fracture facet. What an element needs for a few steps only (its slot) stands once where elements are worked on one
/// by one, and for every element where lanes take them side by side.
template <int D>
class PatchWorkspace {
 public:
  static constexpr int d = D + 1, num_facets = D + 2, num_fields = D + num_symmetric(D);

  template <class Lanes>
  PatchWorkspace(const ReferenceTablesView& reference_tables, const PatchDescriptor& solved_patch, double* memory,
                 const Lanes& lanes)
      : tables(reference_tables), patch(solved_patch), memory_(memory), num_lanes_(lanes.count()) {
    const CondensedShape largest = largest_shape();
    matrix_size_ = padded(largest.matrix_size());
    vector_size_ = padded(largest.unknowns_padded);
    inflow_size_ = padded((patch.is_general ? num_facets : 1) * inflow_block());
    gradient_size_ = D * d * tables.facet_stride;
    trace_size_ = num_fields * tables.facet_stride;
    factors_size_ = padded(VolumeFactors::size(tables));
    element_size_ = fixed_size + 3 * vector_size_ + inflow_size_ + padded(num_facets * gradient_size_) + matrix_size_;
    slot_size_ = fixed_slot_size + factors_size_ + padded(num_facets * trace_size_) +
                 padded(num_facets * gradient_size_) + padded(D * tables.num_volume_modes);
    slot_step_ = Lanes::cooperative ? slot_size_ : 0;
    slots_ = memory_ + patch.num_elements * element_size_;
    packed_ = slots_ + (Lanes::cooperative ? patch.num_elements : 1) * slot_size_;
  }

  ReferenceTablesView tables;
  PatchDescriptor patch;

  PatchShape patch_shape() const { return PatchShape(tables, patch.is_general != 0); }
  CondensedShape largest_shape() const { return CondensedShape(tables, patch_shape(), patch_shape().max_ports); }
  CondensedShape shape(const ElementWorkspace<D>& own) const {
    return CondensedShape(tables, patch_shape(), own.op->num_ports);
  }
  /// Numbers of a block of inflow data.
  int inflow_block() const { return num_fields * tables.num_facet_modes + D * d; }

  ElementWorkspace<D> element(int local) const {
    double *next = memory_ + local * element_size_, *slot = slots_ + local * slot_step_;
    ElementWorkspace<D> own;
    own.op = reinterpret_cast<ElementOperator<D>*>(take(next, doubles_of(sizeof(ElementOperator<D>))));
    own.balance = reinterpret_cast<FacetBalance*>(take(next, doubles_of(num_facets * sizeof(FacetBalance))));
    own.inverse_upper = take(next, 16);
    own.is_regular = reinterpret_cast<int*>(take(next, 8));
    own.diagonal = take(next, vector_size_);
    own.right = take(next, vector_size_);
    own.solution = take(next, vector_size_);
    own.inflow_data = take(next, inflow_size_);
    own.gradients = take(next, padded(num_facets * gradient_size_));
    own.matrix = next;
    own.weights = reinterpret_cast<FacetWeights<D>*>(take(slot, doubles_of(sizeof(FacetWeights<D>))));
    own.ports = reinterpret_cast<PortFactors<D>*>(take(slot, doubles_of(d * sizeof(PortFactors<D>))));
    own.front = reinterpret_cast<FrontFacetRecord*>(take(slot, doubles_of(num_facets * sizeof(FrontFacetRecord))));
    own.displacements = take(slot, padded(num_facets * D * d));
    own.motions = take(slot, padded(num_facets * D * d));
    own.factors = VolumeFactors::at(take(slot, factors_size_), tables);
    own.traces = take(slot, padded(num_facets * trace_size_));
    own.fluxes = take(slot, padded(num_facets * gradient_size_));
    own.curvature = slot;
    own.gradient_size = gradient_size_;
    own.trace_size = trace_size_;
    return own;
  }

  int num_links() const { return patch.num_elements * patch_shape().max_ports; }
  int num_amplitudes() const { return num_links() * patch_shape().amplitudes_per_port; }
  double* packed() const { return packed_; }
  double* outgoing() const { return packed() + 8 * vector_size_; }
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
  CouplingScratch coupling() const { return CouplingScratch::at(coupling_memory(), num_amplitudes()); }

  /// Doubles needed in all.
  long size() const { return coupling_memory() + CouplingScratch::size(num_amplitudes(), num_lanes_) - memory_; }

 private:
  static constexpr long padded(long n) { return (n + 7) / 8 * 8; }
  static constexpr long doubles_of(long bytes) { return padded((bytes + 7) / 8); }
  static constexpr long fixed_size =
      doubles_of(sizeof(ElementOperator<D>)) + doubles_of(num_facets * sizeof(FacetBalance)) + 16 + 8;
  static constexpr long fixed_slot_size = doubles_of(sizeof(FacetWeights<D>)) + doubles_of(d * sizeof(PortFactors<D>)) +
                                          doubles_of(num_facets * sizeof(FrontFacetRecord)) +
                                          2 * padded(num_facets * D * d);

  static double* take(double*& next, long count) {
    double* start = next;
    next += count;
    return start;
  }
  double* coupling_memory() const {
    return fractures() + links_size() + patch.num_fractures * FractureWorkspace<D>::size(tables);
  }

  double *memory_, *slots_, *packed_;
  int num_lanes_;
  long element_size_, matrix_size_, vector_size_, inflow_size_, gradient_size_, trace_size_;
  long slot_size_, slot_step_, factors_size_;
};

}  // namespace tentpole
