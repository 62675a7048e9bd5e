#pragma once

#include "kernels/coupling/fracture_link.hpp"
#include "kernels/element/basis_recurrence.hpp"
#include "kernels/element/element_operator.hpp"
#include "kernels/fracture/contact_mode.hpp"

namespace tentpole {

/// One line of a fracture facet, parallel to the time axis from the old to the new front, and what happened along it.
struct FractureLine {
  double duration;                        ///< H
  int num_panels;                         ///< of equal length: at most tau / 10 long, at least 4 and at most 16 of them
  int first_point;                        ///< its points are consecutive
  double damage_change, traction_change;  ///< of the last round: largest |next D - D| and |(next M - M) s0|
  double largest_normal;                  ///< |s0_n| of its points
  double secant_product;                  ///< sum over its points of weight s ds, s = next D - D, ds the change of s
  double secant_square;                   ///< the same of weight ds^2
  double end_damage, end_gap;             ///< on the new front
};

/// One integration point. The maps of the last solution were made from `damage` and `contact`; `next_damage` and
/// `next_contact` follow from its tractions.
struct FracturePoint {
  double weight;  ///< of the mean over the facet: all sum to 1
  double damage, next_damage;
  double previous_damage, previous_step;  ///< D and next D - D of the round before
  ContactState contact, next_contact;
  bool is_frozen;  ///< the mode flips from round to round and stays as it is
};

/// Scratch of one fracture facet while its patch is solved, and how waves pass it. Arrays over points are padded with
/// zeros to point_stride, a multiple of 4.
template <int D>
struct FractureWorkspace {
  static constexpr int max_panels = 16, num_fields = 2 * D - 1;
  FractureLink* link;     ///< in the array of links of the patch
  FractureLine* lines;    ///< [num_lines]
  FracturePoint* points;  ///< [point]
  double* psi;            ///< [m][point_stride]
  double* traction;       ///< [c][point_stride]: s0 of side 0 in the frame
  double* loss;           ///< [field][point_stride]: weight (I - M), fields normal, tangential, friction
  double* map;            ///< W, [(c, m)][(c', m')]
  double* intact;         ///< [(c, m)]
  double* target;         ///< [(c, m)]: sqrt(|F|) s* of side 0
  long point_stride;

  static long padded(long n) { return (n + 7) / 8 * 8; }
  static long doubles_of(long bytes) { return padded((bytes + 7) / 8); }
  static long max_points(const ReferenceTablesView& tables) {
    return padded(static_cast<long>(tables.num_lines) * max_panels * tables.num_panel_points);
  }
  static long size(const ReferenceTablesView& tables) {
    const long modes = tables.num_facet_modes, points = max_points(tables);
    return doubles_of(sizeof(FractureLine) * tables.num_lines) + doubles_of(sizeof(FracturePoint) * points) +
           points * (modes + D + num_fields) + padded(D * D * modes * modes) + 2 * padded(D * modes);
  }
  static FractureWorkspace at(double* memory, const ReferenceTablesView& tables) {
    const long modes = tables.num_facet_modes, points = max_points(tables);
    const auto take = [&memory](long count) {
      double* start = memory;
      memory += count;
      return start;
    };
    FractureWorkspace workspace{};
    workspace.lines = reinterpret_cast<FractureLine*>(take(doubles_of(sizeof(FractureLine) * tables.num_lines)));
    workspace.points = reinterpret_cast<FracturePoint*>(take(doubles_of(sizeof(FracturePoint) * points)));
    workspace.psi = take(points * modes);
    workspace.traction = take(points * D);
    workspace.loss = take(points * num_fields);
    workspace.map = take(padded(D * D * modes * modes));
    workspace.intact = take(padded(D * modes));
    workspace.target = take(padded(D * modes));
    workspace.point_stride = points;
    return workspace;
  }

  int num_points(const ReferenceTablesView& tables) const {
    const FractureLine& last = lines[tables.num_lines - 1];
    return last.first_point + last.num_panels * tables.num_panel_points;
  }
  int points_padded(const ReferenceTablesView& tables) const { return (num_points(tables) + 3) / 4 * 4; }
};

/// psi_m at the facet point with reference coordinates eta, into psi[m * stride]; D = 1 and 2.
template <int D>
inline void facet_modes_at(const ReferenceTablesView& tables, const double (&eta)[D], double* psi, long stride) {
  constexpr int max_factors = max_degree * (max_degree + 1) / 2;
  const BasisRecurrence recurrence{tables.degree - 1, tables.facet_recurrence};
  const double normalization = 1 / sqrt(D == 2 ? 2.0 : 1.0);
  double factors[D * max_factors];
  basis_factors<D>(recurrence, eta, factors);
  for_each_basis_function<D>(recurrence, factors,
                             [&](int m, double value) { psi[m * stride] = normalization * value; });
}

/// Part of the pole's height to which the line at `position` along the front edge rises.
template <int D>
inline double rising_share(const FractureFacet& facet, double position) {
  return D == 1 ? 1.0 : (facet.rising_end == 1 ? position : 1 - position);
}

/// Divides the lines into panels. height: of the tent pole.
template <int D>
inline void lay_fracture_lines(const FractureFacet& facet, const FractureLaw& law, const ReferenceTablesView& tables,
                               double height, const FractureWorkspace<D>& workspace) {
  int next_point = 0;
  for (int line = 0; line < tables.num_lines; ++line) {
    FractureLine& laid = workspace.lines[line];
    laid = FractureLine{};
    laid.duration = rising_share<D>(facet, tables.line_point[line]) * height;
    const double wanted = ceil(laid.duration / (0.1 * law.relaxation_time));
    laid.num_panels =
        wanted < 4 ? 4 : (wanted > workspace.max_panels ? workspace.max_panels : static_cast<int>(wanted));
    laid.first_point = next_point;
    next_point += laid.num_panels * tables.num_panel_points;
  }
}

/// Lays the points of one line with the damage and contact of the old front. Listed corners of the facet: the front
/// vertices in ascending id, then the top.
template <int D>
inline void lay_fracture_points(const FractureFacet& facet, const ReferenceTablesView& tables, int line,
                                const FractureWorkspace<D>& workspace) {
  const FractureLine& laid = workspace.lines[line];
  const double position = tables.line_point[line], share = rising_share<D>(facet, position);
  // Mean over a triangle: the height along the edge varies linearly with mean 1/2.
  const double line_weight = D == 1 ? 1.0 : 2 * share * tables.line_weight[line];
  int next_point = laid.first_point;
  for (int panel = 0; panel < laid.num_panels; ++panel)
    for (int p = 0; p < tables.num_panel_points; ++p, ++next_point) {
      const double rise = (panel + tables.panel_point[p]) / laid.num_panels;
      double eta[D];
      if constexpr (D == 1) {
        eta[0] = rise;
      } else {
        eta[0] = facet.rising_end == 1 ? position * (1 - rise) : position;
        eta[1] = share * rise;
      }
      facet_modes_at<D>(tables, eta, workspace.psi + next_point, workspace.point_stride);
      FracturePoint& point = workspace.points[next_point];
      point.weight = line_weight * tables.panel_weight[p] / laid.num_panels;
      point.damage = facet.damage[line];
      point.previous_damage = point.previous_step = 0;
      point.contact = {facet.gap[line] > 0 ? ContactMode::open : ContactMode::stick, 0};
      point.is_frozen = false;
    }
}

/// Zeros behind the last point in the array over points of mode `row`, or of field row - num_facet_modes.
template <int D>
inline void clear_fracture_padding(const ReferenceTablesView& tables, const FractureWorkspace<D>& workspace, int row) {
  const int field = row - tables.num_facet_modes;
  double* values =
      field < 0 ? workspace.psi + row * workspace.point_stride : workspace.loss + field * workspace.point_stride;
  for (int q = workspace.num_points(tables); q < workspace.points_padded(tables); ++q) values[q] = 0;
}

/// sum_q loss_q psi_m(q) psi_n(q).
inline double weighted_product(const double* loss, const double* left, const double* right, int count) {
  Vector4 sum{};
  for (int q = 0; q < count; q += 4) sum += load4(loss + q) * load4(left + q) * load4(right + q);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// weight (I - M) at point q.
template <int D>
inline void load_point_loss(const FractureLaw& law, const FractureWorkspace<D>& workspace, int q) {
  const FracturePoint& point = workspace.points[q];
  const TractionMap map = traction_map(law, point.contact, point.damage, workspace.link->normal_sign);
  const long stride = workspace.point_stride;
  workspace.loss[q] = point.weight * (1 - map.normal);
  if constexpr (D == 2) {
    workspace.loss[stride + q] = point.weight * (1 - map.tangential);
    workspace.loss[2 * stride + q] = -point.weight * map.friction;
  }
}

/// Entries of two modes, n <= m, of W = I - sum_q w_q psi(q) psi(q)^T (x) (I - M_q): D = 0 is exact whatever the
/// quadrature.
template <int D>
inline void assemble_map_entries(const ReferenceTablesView& tables, const FractureWorkspace<D>& workspace, int m,
                                 int n) {
  const int num_modes = tables.num_facet_modes, padded = workspace.points_padded(tables), size = D * num_modes;
  const long stride = workspace.point_stride;
  const double *left = workspace.psi + m * stride, *right = workspace.psi + n * stride;
  const auto put = [&](int c, int other, const double* loss) {
    const double value = (c == other && m == n ? 1.0 : 0.0) - weighted_product(loss, left, right, padded);
    workspace.map[(c * num_modes + m) * size + other * num_modes + n] = value;
    workspace.map[(c * num_modes + n) * size + other * num_modes + m] = value;
  };
  put(0, 0, workspace.loss);
  if constexpr (D == 2) {
    put(1, 1, workspace.loss + stride);
    put(1, 0, workspace.loss + 2 * stride);
    workspace.map[m * size + num_modes + n] = workspace.map[n * size + num_modes + m] = 0;
  }
}

/// Modes [(c, m)] / sqrt(|F|) at a point, component c.
template <int D>
inline double value_at(const FractureWorkspace<D>& workspace, const double* modes, int num_modes, int c, int q) {
  double sum = 0;
  for (int m = 0; m < num_modes; ++m) sum += modes[c * num_modes + m] * workspace.psi[m * workspace.point_stride + q];
  return sum / sqrt(workspace.link->measure);
}

/// s0 of side 0 at point q from its modes in `intact`.
template <int D>
inline void evaluate_traction(const ReferenceTablesView& tables, const FractureWorkspace<D>& workspace, int q) {
  for (int c = 0; c < D; ++c)
    workspace.traction[c * workspace.point_stride + q] =
        value_at<D>(workspace, workspace.intact, tables.num_facet_modes, c, q);
}

/// Components of a traction at a point, in the frame of the facet.
struct PointTraction {
  double normal;
  double tangential;
};

/// s0 of side 0 at point q.
template <int D>
inline PointTraction traction_at(const FractureWorkspace<D>& workspace, int q) {
  return {workspace.traction[q], D == 1 ? 0.0 : workspace.traction[(D - 1) * workspace.point_stride + q]};
}

}  // namespace tentpole
