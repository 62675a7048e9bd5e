#pragma once

#include "kernels/patch/independent_elements.hpp"
#include "kernels/patch/patch_workspace.hpp"

namespace tentpole {

/// The integers of a coupling system in the memory of its patch; names as in AmplitudeSystem and ElementGraph.
struct CouplingIntegers {
  int *response_stride, *num_amplitudes, *place, *source, *neighbor, *num_unknown_elements;
};
template <int D>
inline CouplingIntegers coupling_integers(const PatchWorkspace<D>& workspace) {
  const int num_elements = workspace.patch.num_elements, num_links = workspace.num_links();
  CouplingIntegers own;
  own.response_stride = workspace.integers();
  own.num_amplitudes = own.response_stride + num_elements;
  own.place = own.num_amplitudes + num_elements;
  own.source = own.place + num_elements;
  own.neighbor = own.source + num_links;
  own.num_unknown_elements = own.neighbor + num_links;
  return own;
}

/// Calls visit(facet, port) for each port of an element.
template <int D, class Visit>
inline void for_each_port(const ElementOperator<D>& op, Visit visit) {
  for (int f = 0; f < op.num_vertical; ++f)
    if (op.vertical[f].port != none) visit(op.vertical[f].facet, op.vertical[f].port);
  for (int f = 0; f < op.num_inclined; ++f)
    if (op.inclined[f].port != none) visit(op.inclined[f].facet, op.inclined[f].port);
}

/// The element across each port of element e of the patch; e itself across a fracture facet.
template <int D>
inline void find_neighbors(const PatchBatch& batch, const PatchDescriptor& patch, const ElementOperator<D>& op, int e,
                           int max_ports, int* neighbor) {
  const ElementDescriptor& element = batch.elements[patch.first_element + e];
  for (int port = 0; port < max_ports; ++port) neighbor[e * max_ports + port] = none;
  for_each_port<D>(op, [&](int facet, int port) {
    const bool reflects = element.facet_kind[facet] == FacetKind::fracture;
    neighbor[e * max_ports + port] = reflects ? e : element.neighbor[facet] - patch.first_element;
  });
}

/// Which entry of the outgoing amplitudes feeds each port of element e.
template <int D>
inline void find_sources(const PatchBatch& batch, const PatchDescriptor& patch, const PatchWorkspace<D>& workspace,
                         const AmplitudeSystem& system, int e, int* source) {
  const ElementDescriptor& element = batch.elements[patch.first_element + e];
  int* own = source + system.place[e] * system.max_ports;
  for (int port = 0; port < system.max_ports; ++port) own[port] = none;
  for_each_port<D>(workspace.element(e).op(), [&](int facet, int port) {
    if (element.facet_kind[facet] == FacetKind::fracture) return;
    const int other = element.neighbor[facet] - patch.first_element;
    for_each_port<D>(workspace.element(other).op(), [&](int other_facet, int other_port) {
      if (other_facet == element.neighbor_facet[facet])
        own[port] = system.offset(other) + other_port * system.amplitudes_per_port;
    });
  });
}

/// The coupling system of a patch: places of the elements, which entry of the outgoing amplitudes feeds each port, and
/// where each element's response block lies.
template <int D, class Lanes>
TENTPOLE_STEP AmplitudeSystem connect_elements(const PatchBatch& batch, const PatchWorkspace<D>& workspace,
                                               const Lanes& lanes) {
  const PatchDescriptor& patch = workspace.patch;
  const PatchShape shape = workspace.patch_shape();
  const CouplingIntegers own = coupling_integers<D>(workspace);
  share(lanes, patch.num_elements,
        [&](int e) { find_neighbors<D>(batch, patch, workspace.element(e).op(), e, shape.max_ports, own.neighbor); });
  lanes.synchronize();
  if (lanes.first() == 0)
    *own.num_unknown_elements = place_elements({patch.num_elements, shape.max_ports, own.neighbor}, own.place);
  lanes.synchronize();
  AmplitudeSystem system;
  system.num_elements = patch.num_elements;
  system.num_unknown_elements = *own.num_unknown_elements;
  system.amplitudes_per_port = shape.amplitudes_per_port;
  system.max_amplitudes = shape.max_ports * shape.amplitudes_per_port;
  system.place = own.place;
  system.response = workspace.responses();
  system.response_stride = own.response_stride;
  system.num_amplitudes = own.num_amplitudes;
  system.source = own.source;
  system.max_ports = shape.max_ports;
  system.num_fractures = patch.num_fractures;
  system.fractures = workspace.links();
  share(lanes, patch.num_elements, [&](int e) {
    const ElementWorkspace<D> element = workspace.element(e);
    const CondensedShape condensed = workspace.shape(element);
    const int place = own.place[e];
    workspace.responses()[place] =
        element.matrix() + static_cast<long>(condensed.unknowns_padded) * condensed.stride + condensed.unknowns_padded;
    own.response_stride[place] = condensed.stride;
    own.num_amplitudes[place] = condensed.num_amplitudes;
    find_sources<D>(batch, patch, workspace, system, e, own.source);
  });
  lanes.synchronize();
  return system;
}

}  // namespace tentpole
