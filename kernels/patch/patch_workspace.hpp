#pragma once

#include "kernels/coupling/amplitude_coupling.hpp"
#include "kernels/formulation/one_field/element_matrix.hpp"
#include "kernels/formulation/one_field/facet_traces.hpp"
#include "kernels/fracture/fracture_facet.hpp"

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

/// Where the arrays of an element lie, in doubles from the start of its block and of its slot. Everything else in them
/// has a size that the compiler knows.
struct ElementLayout {
  long diagonal, right, solution, inflow_data, gradients, matrix, block_size;
  long factors, traces, fluxes, curvature, slot_size;
  long gradient_size, trace_size;  ///< of one facet
};

/// Memory of one element while its patch is solved: a block from the first step to the last, and a slot while its range
/// of elements is worked on. Facets are numbered as in the descriptor. It is passed by value; the layout is that of its
/// PatchWorkspace.
template <int D>
class ElementWorkspace {
 public:
  static constexpr int d = D + 1, num_facets = D + 2, num_fields = D + num_symmetric(D);

  ElementWorkspace(const ElementLayout& layout, double* block, double* slot)
      : layout_(&layout), block_(block), slot_(slot) {}

  ElementOperator<D>& op() const { return *reinterpret_cast<ElementOperator<D>*>(block_); }
  /// [facet], in the order of FacetWeights
  FacetBalance* balance() const { return reinterpret_cast<FacetBalance*>(block_ + balance_at); }
  double* inverse_upper() const { return block_ + inverse_upper_at; }  ///< [4][4] of the pivots (lanes of a team)
  int* is_regular() const { return reinterpret_cast<int*>(block_ + is_regular_at); }  ///< whether all pivots were
  double* diagonal() const { return block_ + layout_->diagonal; }  ///< of A before elimination [unknowns_padded]
  double* right() const {
    return block_ + layout_->right;
  }  ///< b or residual, L^-1 of it, correction [unknowns_padded]
  double* solution() const { return block_ + layout_->solution; }        ///< c [unknowns_padded]
  double* inflow_data() const { return block_ + layout_->inflow_data; }  ///< a block of data for each inflow facet
  double* matrix() const { return block_ + layout_->matrix; }            ///< condensed matrix
  /// [i][l][facet_stride]: gradient modes of the source below a facet, then of the solution
  double* gradient(int facet) const { return block_ + layout_->gradients + facet * layout_->gradient_size; }

  FacetWeights<D>& weights() const { return *reinterpret_cast<FacetWeights<D>*>(slot_); }
  PortFactors<D>* ports() const { return reinterpret_cast<PortFactors<D>*>(slot_ + ports_at); }  ///< [vertical facet]
  /// [inflow facets, then outflow facets]
  FrontFacetRecord* front() const { return reinterpret_cast<FrontFacetRecord*>(slot_ + front_at); }
  /// [D][d]: degree-1 modes of the solution on a rigid facet
  double* displacement(int rigid) const { return slot_ + displacements_at + rigid * D * d; }
  double* motion(int rigid) const {
    return slot_ + motions_at + rigid * D * d;
  }                                                                 ///< [D][d]: rigid motion that is added
  double* factors() const { return slot_ + layout_->factors; }      ///< VolumeFactors
  double* curvature() const { return slot_ + layout_->curvature; }  ///< [D][num_volume_modes]
  double* trace(int facet) const { return slot_ + layout_->traces + facet * layout_->trace_size; }  ///< [field][stride]
  double* flux(int facet) const {
    return slot_ + layout_->fluxes + facet * layout_->gradient_size;
  }  ///< [l][i][stride]

  static constexpr long padded(long n) { return (n + 7) / 8 * 8; }
  static constexpr long doubles_of(long bytes) { return padded((bytes + 7) / 8); }

 private:
  static constexpr long balance_at = doubles_of(sizeof(ElementOperator<D>)),
                        inverse_upper_at = balance_at + doubles_of(num_facets * sizeof(FacetBalance)),
                        is_regular_at = inverse_upper_at + 16;
  static constexpr long ports_at = doubles_of(sizeof(FacetWeights<D>)),
                        front_at = ports_at + doubles_of(d * sizeof(PortFactors<D>)),
                        displacements_at = front_at + doubles_of(num_facets * sizeof(FrontFacetRecord)),
                        motions_at = displacements_at + padded(num_facets * D * d);

 public:
  static constexpr long fixed_block = is_regular_at + 8, fixed_slot = motions_at + padded(num_facets * D * d);

 private:
  const ElementLayout* layout_;
  double *block_, *slot_;
};

/// All scratch of one patch: a block per element, slots, arrays shared by the elements, the coupling solver, and a
/// block per fracture facet. Where elements are worked on one by one a single slot serves all; where lanes take them
/// side by side each has its own.
template <int D>
class PatchWorkspace {
 public:
  static constexpr int d = D + 1, num_facets = D + 2, num_fields = D + num_symmetric(D);

  template <class Lanes>
  PatchWorkspace(const ReferenceTablesView& reference_tables, const PatchDescriptor& solved_patch, double* memory,
                 const Lanes& lanes)
      : tables(reference_tables), patch(solved_patch), memory_(memory), num_lanes_(lanes.count()) {
    lay_out_block();
    lay_out_slot();
    slot_step_ = Lanes::cooperative ? layout_.slot_size : 0;
    slots_ = memory_ + patch.num_elements * layout_.block_size;
    packed_ = slots_ + (Lanes::cooperative ? patch.num_elements : 1) * layout_.slot_size;
  }

  ReferenceTablesView tables;
  PatchDescriptor patch;

  PatchShape patch_shape() const { return PatchShape(tables, patch.is_general != 0); }
  CondensedShape largest_shape() const { return CondensedShape(tables, patch_shape(), patch_shape().max_ports); }
  CondensedShape shape(const ElementWorkspace<D>& own) const {
    return CondensedShape(tables, patch_shape(), own.op().num_ports);
  }
  /// Numbers of a block of inflow data.
  int inflow_block() const { return num_fields * tables.num_facet_modes + D * d; }

  ElementWorkspace<D> element(int local) const {
    return {layout_, memory_ + local * layout_.block_size, slots_ + local * slot_step_};
  }

  int num_links() const { return patch.num_elements * patch_shape().max_ports; }
  int num_amplitudes() const { return num_links() * patch_shape().amplitudes_per_port; }
  double* packed() const { return packed_; }  ///< [8][unknowns_padded]
  double* outgoing() const { return packed() + 8L * padded(largest_shape().unknowns_padded); }
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
  static constexpr long padded(long n) { return ElementWorkspace<D>::padded(n); }
  static constexpr long doubles_of(long bytes) { return ElementWorkspace<D>::doubles_of(bytes); }
  static long take(long& next, long count) {
    const long start = next;
    next += padded(count);
    return start;
  }

  void lay_out_block() {
    const CondensedShape largest = largest_shape();
    long next = ElementWorkspace<D>::fixed_block;
    layout_.gradient_size = D * d * tables.facet_stride;
    layout_.diagonal = take(next, largest.unknowns_padded);
    layout_.right = take(next, largest.unknowns_padded);
    layout_.solution = take(next, largest.unknowns_padded);
    layout_.inflow_data = take(next, (patch.is_general ? num_facets : 1) * inflow_block());
    layout_.gradients = take(next, num_facets * layout_.gradient_size);
    layout_.matrix = take(next, largest.matrix_size());
    layout_.block_size = next;
  }
  void lay_out_slot() {
    long next = ElementWorkspace<D>::fixed_slot;
    layout_.trace_size = num_fields * tables.facet_stride;
    layout_.factors = take(next, VolumeFactors::size(tables));
    layout_.traces = take(next, num_facets * layout_.trace_size);
    layout_.fluxes = take(next, num_facets * layout_.gradient_size);
    layout_.curvature = take(next, D * tables.num_volume_modes);
    layout_.slot_size = next;
  }
  double* coupling_memory() const {
    return fractures() + links_size() + patch.num_fractures * FractureWorkspace<D>::size(tables);
  }

  ElementLayout layout_;
  double *memory_, *slots_, *packed_;
  int num_lanes_;
  long slot_step_;
};

}  // namespace tentpole
