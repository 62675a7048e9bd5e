#pragma once

#include "kernels/coupling/fracture_link.hpp"
#include "kernels/element/patch_batch.hpp"
#include "kernels/element/simd.hpp"
#include "kernels/launch/lanes.hpp"

namespace tentpole {

/// The small system that couples the elements of one patch through their amplitudes,
///     x = E (t + T x),     T = - lower right block of the condensed matrices,
/// where x are the incoming amplitudes and E hands the outgoing amplitudes of a port to the port on the other side of
/// the facet, or through a fracture facet (fracture_link.hpp). The elements are placed (independent_elements.hpp) such
/// that no element of the last places, the set I, feeds itself or another of I, E_II = 0; R are the others. So
///     x_I = E_IR (t_R + T_R x_R),     x_R = E_RR (t_R + T_R x_R) + E_RI (t_I + T_I x_I),
/// and x_R alone, the start of every vector, is unknown. T is a contraction in energy and I - E T has a condition below
/// about 10 (docs/formulation.md). The map for x_R is a contraction, too, and the inverse of its system is a block of
/// the inverse of I - E T. Where R has no neighbours in R either a wave runs through two elements in one product: GMRES
/// without restart reaches rounding in some two to twenty products with the small blocks.
struct AmplitudeSystem {
  int num_elements;
  int num_unknown_elements;  ///< in R
  int amplitudes_per_port;
  int max_amplitudes;             ///< per element, D ports
  const int* place;               ///< [element]; all that follows is by place
  const double* const* response;  ///< [place]: lower right block transposed, -T^T, padded with zeros to multiples of 4
  const int* response_stride;     ///< [place]
  const int* num_amplitudes;      ///< [place]
  const int* source;  ///< [place * max_ports + port]: first entry of the partner port, or none (fracture facets too)
  int max_ports;
  int num_fractures;
  const FractureLink* fractures;  ///< [num_fractures], between elements in R
  int size() const { return num_elements * max_amplitudes; }
  int num_unknowns() const { return num_unknown_elements * max_amplitudes; }
  /// First amplitude of an element.
  int offset(int element) const { return place[element] * max_amplitudes; }
};

/// A run of places: first, ..., end - 1.
struct PlaceRange {
  int first, end;
};
inline PlaceRange all_places(const AmplitudeSystem& system) {
  return {0, system.num_elements};
}
inline PlaceRange unknown_places(const AmplitudeSystem& system) {
  return {0, system.num_unknown_elements};
}
inline PlaceRange independent_places(const AmplitudeSystem& system) {
  return {system.num_unknown_elements, system.num_elements};
}

/// to = E from at some places: what arrives there when the elements emit `from`. The range has all of R or
/// nothing of it.
template <class Lanes>
TENTPOLE_STEP void exchange_amplitudes(const AmplitudeSystem& system, PlaceRange places, const double* from, double* to,
                                       const Lanes& lanes) {
  const int first = places.first * system.max_ports, num_links = places.end * system.max_ports - first,
            per_port = system.amplitudes_per_port;
  share(lanes, num_links, per_port, [&](int link) {
    const int source = system.source[first + link];
    double* target = to + (first + link) * per_port;
    return [=](int entry) { target[entry] = source == none ? 0.0 : from[source + entry]; };
  });
  if (places.first == 0 && system.num_fractures > 0) {
    load_intact_tractions(system.fractures, system.num_fractures, from, lanes);
    share(lanes, system.num_fractures, system.fractures[0].size(), [&](int f) {
      return [=, &link = system.fractures[f]](int entry) { add_through_fracture(link, entry, from, to); };
    });
  }
  lanes.synchronize();
}

/// out[0 .. 4 vectors) = -sum_j rows[j][0 .. 4 vectors) x[j].
template <int vectors>
inline void combine_rows(const double* rows, long stride, int num_rows, const double* x, double* out) {
  Vector4 sum[vectors] = {};
  for (int j = 0; j < num_rows; ++j)
    for (int v = 0; v < vectors; ++v) sum[v] -= x[j] * load4(rows + j * stride + 4 * v);
  for (int v = 0; v < vectors; ++v) store4(out + 4 * v, sum[v]);
}

/// out = T x of one element by one thread; out has room for the padding.
inline void respond(const double* response, long stride, int num_amplitudes, const double* x, double* out) {
  int first = 0;
  for (; first + 24 <= num_amplitudes; first += 24)
    combine_rows<6>(response + first, stride, num_amplitudes, x, out + first);
  for (; first + 12 <= num_amplitudes; first += 12)
    combine_rows<3>(response + first, stride, num_amplitudes, x, out + first);
  for (; first < num_amplitudes; first += 4) combine_rows<1>(response + first, stride, num_amplitudes, x, out + first);
}

/// One entry of T x of an element.
inline double respond_entry(const double* response, long stride, int num_amplitudes, const double* x, int entry) {
  double sum = 0;
  for (int j = 0; j < num_amplitudes; ++j) sum -= response[j * stride + entry] * x[j];
  return sum;
}

/// product = T x at some places; it has size() + 4 entries. Entries before the range stay, up to three behind it do
/// not.
template <class Lanes>
TENTPOLE_STEP void respond_at(const AmplitudeSystem& system, PlaceRange places, const double* x, double* product,
                              const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    share(lanes, places.end - places.first, system.max_amplitudes, [&](int index) {
      const int place = places.first + index, first = place * system.max_amplitudes;
      return [=, &system](int entry) {
        if (entry < system.num_amplitudes[place])
          product[first + entry] = respond_entry(system.response[place], system.response_stride[place],
                                                 system.num_amplitudes[place], x + first, entry);
      };
    });
  } else {
    for (int place = places.first; place < places.end; ++place)
      respond(system.response[place], system.response_stride[place], system.num_amplitudes[place],
              x + place * system.max_amplitudes, product + place * system.max_amplitudes);
  }
  lanes.synchronize();
}

/// product = t + T x at some places: the waves they emit. As respond_at.
template <class Lanes>
inline void emit_amplitudes(const AmplitudeSystem& system, PlaceRange places, const double* t, const double* x,
                            double* product, const Lanes& lanes) {
  respond_at(system, places, x, product, lanes);
  const int end = places.end * system.max_amplitudes;
  for (int i = places.first * system.max_amplitudes + lanes.first(); i < end; i += lanes.count()) product[i] += t[i];
  lanes.synchronize();
}

}  // namespace tentpole
