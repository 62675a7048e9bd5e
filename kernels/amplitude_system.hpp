#pragma once

#include "kernels/fracture_link.hpp"
#include "kernels/lanes.hpp"
#include "kernels/patch_batch.hpp"
#include "kernels/simd.hpp"

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
inline void exchange_amplitudes(const AmplitudeSystem& system, PlaceRange places, const double* from, double* to,
                                const Lanes& lanes) {
  const int end = places.end * system.max_ports;
  for (int link = places.first * system.max_ports + lanes.first(); link < end; link += lanes.count()) {
    const int source = system.source[link];
    double* target = to + link * system.amplitudes_per_port;
    for (int entry = 0; entry < system.amplitudes_per_port; ++entry)
      target[entry] = source == none ? 0.0 : from[source + entry];
  }
  if (places.first == 0)
    for (int f = 0; f < system.num_fractures; ++f) add_through_fracture(system.fractures[f], from, to, lanes);
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

/// out = T x of one element; out has room for the padding.
template <class Lanes>
inline void respond(const double* response, long stride, int num_amplitudes, const double* x, double* out,
                    const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    for (int row = lanes.first(); row < num_amplitudes; row += lanes.count()) {
      double sum = 0;
      for (int j = 0; j < num_amplitudes; ++j) sum -= response[j * stride + row] * x[j];
      out[row] = sum;
    }
  } else {
    int first = 0;
    for (; first + 24 <= num_amplitudes; first += 24)
      combine_rows<6>(response + first, stride, num_amplitudes, x, out + first);
    for (; first + 12 <= num_amplitudes; first += 12)
      combine_rows<3>(response + first, stride, num_amplitudes, x, out + first);
    for (; first < num_amplitudes; first += 4)
      combine_rows<1>(response + first, stride, num_amplitudes, x, out + first);
  }
}

/// product = T x at some places; it has size() + 4 entries. Entries before the range stay, up to three behind it do
/// not.
template <class Lanes>
inline void respond_at(const AmplitudeSystem& system, PlaceRange places, const double* x, double* product,
                       const Lanes& lanes) {
  for (int place = places.first; place < places.end; ++place)
    respond(system.response[place], system.response_stride[place], system.num_amplitudes[place],
            x + place * system.max_amplitudes, product + place * system.max_amplitudes, lanes);
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
