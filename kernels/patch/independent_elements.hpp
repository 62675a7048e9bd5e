#pragma once

#include "kernels/element/patch_batch.hpp"

namespace tentpole {

/// Elements across the interior facets of the elements of one patch.
struct ElementGraph {
  int num_elements;
  int max_ports;
  const int* neighbor;  ///< [element * max_ports + port]: the element across, or none; the element itself on a fracture
                        ///< facet, which reflects waves

  int across(int element, int port) const { return neighbor[element * max_ports + port]; }
  bool reflects(int element) const {
    for (int port = 0; port < max_ports; ++port)
      if (across(element, port) == element) return true;
    return false;
  }
};

/// Places the elements of a patch in its coupling system (amplitude_coupling.hpp): first those whose amplitudes are
/// unknowns, last an independent set, of which none is a neighbour of itself or of another in the set; ascending within
/// both. place: [num_elements]. Returns the number of the first kind. The set is greedy by least degree, the lowest
/// number first: an element with the fewest undecided neighbours joins, its neighbours do not. On rings and chains no
/// set is larger (n / 2 and (n + 1) / 2 elements). Source: Saad, Iterative Methods for Sparse Linear Systems, 2nd
/// edition, SIAM 2003, section 3.3.3. One lane calls it.
inline int place_elements(const ElementGraph& graph, int* place) {
  constexpr int undecided = -1, unknown = -2, independent = -3;
  for (int element = 0; element < graph.num_elements; ++element)
    place[element] = graph.reflects(element) ? unknown : undecided;
  while (true) {
    int best = none, least_degree = graph.max_ports + 1;
    for (int element = 0; element < graph.num_elements; ++element) {
      if (place[element] != undecided) continue;
      int degree = 0;
      for (int port = 0; port < graph.max_ports; ++port) {
        const int other = graph.across(element, port);
        degree += other != none && place[other] == undecided;
      }
      if (degree >= least_degree) continue;
      best = element;
      least_degree = degree;
    }
    if (best == none) break;
    place[best] = independent;
    for (int port = 0; port < graph.max_ports; ++port) {
      const int other = graph.across(best, port);
      if (other != none) place[other] = unknown;
    }
  }
  int next = 0;
  for (int element = 0; element < graph.num_elements; ++element)
    if (place[element] == unknown) place[element] = next++;
  const int num_unknown = next;
  for (int element = 0; element < graph.num_elements; ++element)
    if (place[element] == independent) place[element] = next++;
  return num_unknown;
}

}  // namespace tentpole
