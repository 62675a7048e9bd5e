#pragma once

#include <cmath>

#include "kernels/condensed_element.hpp"
#include "kernels/fracture_link.hpp"
#include "kernels/lanes.hpp"
#include "kernels/patch_batch.hpp"
#include "kernels/simd.hpp"

namespace tentpole {

/// The small system that couples the elements of one patch through their amplitudes,
///     x_in = E (t + T x_in),     T = - lower right block of the condensed matrices,
/// where E hands the outgoing amplitudes of a port to the port on the other side of the facet, or through a fracture
/// facet (fracture_link.hpp). T is a contraction in energy and I - T has a condition below about 10
/// (docs/formulation.md), so GMRES without restart reaches rounding in some ten to thirty products with the small
/// blocks.
struct AmplitudeSystem {
  int num_elements;
  int amplitudes_per_port;
  int max_amplitudes;  ///< per element, D ports
  const double* const*
      response;                ///< [element]: lower right block transposed, -T^T, padded with zeros to multiples of 4
  const int* response_stride;  ///< [element]
  const int* num_amplitudes;   ///< [element]
  const int* source;           ///< [element * max_ports + port]: first entry of the partner port, or none; none also on
                               ///< fracture facets
  int max_ports;
  int num_fractures;
  const FractureLink* fractures;  ///< [num_fractures]
  int size() const { return num_elements * max_amplitudes; }
};

/// Scratch of the coupling solver.
struct CouplingScratch {
  static constexpr int max_iterations = 80;
  double* basis;       ///< [max_iterations + 1][size]
  double* product;     ///< [size + 4]
  double* hessenberg;  ///< [max_iterations + 1][max_iterations]
  double* partial;     ///< [lanes]

  static long size(int system_size, int lanes) {
    return static_cast<long>(system_size) * (max_iterations + 2) + 4 + (max_iterations + 4L) * (max_iterations + 1) +
           lanes;
  }
  static CouplingScratch at(double* scratch, int system_size) {
    CouplingScratch parts;
    parts.basis = scratch;
    parts.product = parts.basis + static_cast<long>(system_size) * (max_iterations + 1);
    parts.hessenberg = parts.product + system_size + 4;
    parts.partial = parts.hessenberg + (max_iterations + 4L) * (max_iterations + 1);
    return parts;
  }
};

/// Scalar product that every lane gets; its value depends on the number of lanes only.
template <class Lanes>
inline double shared_dot(const double* left, const double* right, int n, double* partial, const Lanes& lanes) {
  if constexpr (!Lanes::cooperative) {
    return dot(left, right, n);
  } else {
    double sum = 0;
    for (int i = lanes.first(); i < n; i += lanes.count()) sum += left[i] * right[i];
    lanes.synchronize();
    partial[lanes.first()] = sum;
    lanes.synchronize();
    double total = 0;
    for (int lane = 0; lane < lanes.count(); ++lane) total += partial[lane];
    return total;
  }
}

/// to += scale E from: outgoing amplitudes reach the port of the neighbour that receives them, or pass a fracture
/// facet.
template <class Lanes>
inline void add_exchanged(const AmplitudeSystem& system, const double* from, double* to, const Lanes& lanes) {
  for (int link = lanes.first(); link < system.num_elements * system.max_ports; link += lanes.count()) {
    const int source = system.source[link];
    if (source == none) continue;
    double* target = to + link * system.amplitudes_per_port;
    for (int entry = 0; entry < system.amplitudes_per_port; ++entry) target[entry] += from[source + entry];
  }
  for (int f = 0; f < system.num_fractures; ++f) add_through_fracture(system.fractures[f], from, to, lanes);
  lanes.synchronize();
}

/// to = E from.
template <class Lanes>
inline void exchange_amplitudes(const AmplitudeSystem& system, const double* from, double* to, const Lanes& lanes) {
  for (int i = lanes.first(); i < system.size(); i += lanes.count()) to[i] = 0;
  lanes.synchronize();
  add_exchanged(system, from, to, lanes);
}

/// out[0 .. 4 vectors) = sum_j rows[j][0 .. 4 vectors) x[j].
template <int vectors>
inline void combine_rows(const double* rows, long stride, int num_rows, const double* x, double* out) {
  Vector4 sum[vectors] = {};
  for (int j = 0; j < num_rows; ++j)
    for (int v = 0; v < vectors; ++v) sum[v] += x[j] * load4(rows + j * stride + 4 * v);
  for (int v = 0; v < vectors; ++v) store4(out + 4 * v, sum[v]);
}

/// out = -T x of one element; out has room for the padding.
template <class Lanes>
inline void respond(const double* response, long stride, int num_amplitudes, const double* x, double* out,
                    const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    for (int row = lanes.first(); row < num_amplitudes; row += lanes.count()) {
      double sum = 0;
      for (int j = 0; j < num_amplitudes; ++j) sum += response[j * stride + row] * x[j];
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

/// product = -T x of all elements; it has size() + 4 entries.
template <class Lanes>
inline void respond_all(const AmplitudeSystem& system, const double* x, double* product, const Lanes& lanes) {
  for (int element = 0; element < system.num_elements; ++element)
    respond(system.response[element], system.response_stride[element], system.num_amplitudes[element],
            x + element * system.max_amplitudes, product + element * system.max_amplitudes, lanes);
  lanes.synchronize();
}

/// to = (I - E T) from. `product` has size() + 4 entries.
template <class Lanes>
inline void apply_coupling(const AmplitudeSystem& system, const double* from, double* product, double* to,
                           const Lanes& lanes) {
  respond_all(system, from, product, lanes);
  for (int i = lanes.first(); i < system.size(); i += lanes.count()) to[i] = from[i];
  lanes.synchronize();
  add_exchanged(system, product, to, lanes);
}

/// Classical Gram-Schmidt, four basis vectors at a time: column[i] = basis_i . next, then next -= sum_i column[i]
/// basis_i. One pass suffices because I - T is well conditioned; the residual check of the patch would show a loss.
template <class Lanes>
inline void orthogonalize(const double* basis, int n, int count, double* next, double* column, double* partial,
                          const Lanes& lanes) {
  if constexpr (Lanes::cooperative) {
    for (int i = 0; i < count; ++i) {
      const double projection = shared_dot(basis + static_cast<long>(i) * n, next, n, partial, lanes);
      if (lanes.first() == 0) column[i] = projection;
    }
    lanes.synchronize();
    for (int j = lanes.first(); j < n; j += lanes.count())
      for (int i = 0; i < count; ++i) next[j] -= column[i] * basis[static_cast<long>(i) * n + j];
    lanes.synchronize();
  } else {
    int i = 0;
    for (; i + 4 <= count; i += 4) {
      const double* rows[4];
      Vector4 sum[4] = {};
      for (int r = 0; r < 4; ++r) rows[r] = basis + static_cast<long>(i + r) * n;
      int j = 0;
      for (; j + 4 <= n; j += 4) {
        const Vector4 value = load4(next + j);
        for (int r = 0; r < 4; ++r) sum[r] += value * load4(rows[r] + j);
      }
      for (int r = 0; r < 4; ++r) {
        column[i + r] = (sum[r][0] + sum[r][1]) + (sum[r][2] + sum[r][3]);
        for (int rest = j; rest < n; ++rest) column[i + r] += next[rest] * rows[r][rest];
      }
    }
    for (; i < count; ++i) column[i] = dot(basis + static_cast<long>(i) * n, next, n);
    for (i = 0; i + 4 <= count; i += 4) {
      const double* rows = basis + static_cast<long>(i) * n;
      for (int j = 0; j < n; ++j)
        next[j] -= (column[i] * rows[j] + column[i + 1] * rows[n + j]) +
                   (column[i + 2] * rows[2L * n + j] + column[i + 3] * rows[3L * n + j]);
    }
    for (; i < count; ++i)
      for (int j = 0; j < n; ++j) next[j] -= column[i] * basis[static_cast<long>(i) * n + j];
  }
}

/// Solves for the incoming amplitudes x; on entry x holds exchange(t), the right-hand side. Returns the number of
/// products, or -1 when the tolerance (relative residual 1e-14) was not reached in max_iterations. Source: Saad and
/// Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856.
template <class Lanes>
inline int solve_coupling(const AmplitudeSystem& system, double* x, const CouplingScratch& scratch,
                          const Lanes& lanes) {
  constexpr int limit = CouplingScratch::max_iterations;
  constexpr double tolerance = 1e-14;
  const int n = system.size();
  const double norm = sqrt(shared_dot(x, x, n, scratch.partial, lanes));
  if (!(norm > 0)) return norm == 0 ? 0 : -1;
  double *hessenberg = scratch.hessenberg, *cosine = hessenberg + (limit + 1) * limit, *sine = cosine + limit,
         *right = sine + limit;
  for (int i = lanes.first(); i < n; i += lanes.count()) scratch.basis[i] = x[i] / norm;
  if (lanes.first() == 0) right[0] = norm;
  lanes.synchronize();
  int count = 0;
  double residual = norm;
  while (count < limit && residual > tolerance * norm) {
    double* next = scratch.basis + static_cast<long>(count + 1) * n;
    double* column = hessenberg + count * (limit + 1);
    apply_coupling(system, scratch.basis + static_cast<long>(count) * n, scratch.product, next, lanes);
    orthogonalize(scratch.basis, n, count + 1, next, column, scratch.partial, lanes);
    const double length = sqrt(shared_dot(next, next, n, scratch.partial, lanes));
    if (length > 0)
      for (int j = lanes.first(); j < n; j += lanes.count()) next[j] /= length;
    lanes.synchronize();
    if (lanes.first() == 0) {
      for (int i = 0; i < count; ++i) {
        const double upper = column[i];
        column[i] = cosine[i] * upper + sine[i] * column[i + 1];
        column[i + 1] = -sine[i] * upper + cosine[i] * column[i + 1];
      }
      const double radius = sqrt(column[count] * column[count] + length * length);
      cosine[count] = column[count] / radius;
      sine[count] = length / radius;
      column[count] = radius;
      right[count + 1] = -sine[count] * right[count];
      right[count] *= cosine[count];
    }
    lanes.synchronize();
    residual = fabs(right[count + 1]);
    ++count;
  }
  if (lanes.first() == 0)
    for (int i = count - 1; i >= 0; --i) {
      for (int j = i + 1; j < count; ++j) right[i] -= hessenberg[j * (limit + 1) + i] * right[j];
      right[i] /= hessenberg[i * (limit + 1) + i];
    }
  lanes.synchronize();
  for (int j = lanes.first(); j < n; j += lanes.count()) {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += right[i] * scratch.basis[static_cast<long>(i) * n + j];
    x[j] = sum;
  }
  lanes.synchronize();
  return residual <= tolerance * norm ? count : -1;
}

}  // namespace tentpole
