#pragma once

#include "kernels/basis_recurrence.hpp"
#include "kernels/contact_mode.hpp"
#include "kernels/element_operator.hpp"
#include "kernels/fracture_link.hpp"

namespace tentpole {

/// One line of a fracture facet, parallel to the time axis from the old to the new front.
struct FractureLine {
  double duration;  ///< H
  int num_panels;   ///< of equal length: at most tau / 10 long, at least 4 and at most 16 of them
  int first_point;  ///< its points are consecutive
};

/// One integration point. Points integrate the facet: the weights of all sum to 1.
struct FracturePoint {
  double weight;
  double damage;
  double direction;  ///< sign of the intact tangential traction
  int mode;          ///< ContactMode
  int is_frozen;     ///< the mode flips from round to round and stays as it is
};

/// What one line reports of a round.
struct LineChange {
  double damage = 0;     ///< largest change of D at its points
  double effective = 0;  ///< largest effective traction
  int modes = 0;         ///< points whose mode or direction of sliding changed where D > 0
  double end_damage = 0;
  double end_gap = 0;
};

/// Scratch of one fracture facet while its patch is solved, and how waves pass it.
template <int D>
struct FractureWorkspace {
  static constexpr int max_panels = 16;
  FractureLink* link;        ///< in the array of links of the patch
  FractureLine* lines;       ///< [num_lines]
  FracturePoint* points;     ///< [num_lines * max_panels * num_panel_points]
  double* psi;               ///< [point][num_facet_modes]
  double* map;               ///< W, [c][c'][m][m']
  double* intact;            ///< [c][m]
  LineChange* line_changes;  ///< [num_lines], of the last round

  static long padded(long n) { return (n + 7) / 8 * 8; }
  static long doubles_of(long bytes) { return padded((bytes + 7) / 8); }
  static long max_points(const ReferenceTablesView& tables) {
    return static_cast<long>(tables.num_lines) * max_panels * tables.num_panel_points;
  }
  static long size(const ReferenceTablesView& tables) {
    const long modes = tables.num_facet_modes;
    return doubles_of(sizeof(FractureLine) * tables.num_lines) +
           doubles_of(sizeof(FracturePoint) * max_points(tables)) + padded(max_points(tables) * modes) +
           padded(D * D * modes * modes) + padded(D * modes) + doubles_of(sizeof(LineChange) * tables.num_lines);
  }
  static FractureWorkspace at(double* memory, const ReferenceTablesView& tables) {
    const long modes = tables.num_facet_modes;
    const auto take = [&memory](long count) {
      double* start = memory;
      memory += count;
      return start;
    };
    FractureWorkspace workspace{};
    workspace.lines = reinterpret_cast<FractureLine*>(take(doubles_of(sizeof(FractureLine) * tables.num_lines)));
    workspace.points = reinterpret_cast<FracturePoint*>(take(doubles_of(sizeof(FracturePoint) * max_points(tables))));
    workspace.psi = take(padded(max_points(tables) * modes));
    workspace.map = take(padded(D * D * modes * modes));
    workspace.intact = take(padded(D * modes));
    workspace.line_changes = reinterpret_cast<LineChange*>(take(doubles_of(sizeof(LineChange) * tables.num_lines)));
    return workspace;
  }
};

/// psi_m at the facet point with reference coordinates eta; D = 1 and 2.
template <int D>
inline void facet_modes_at(const ReferenceTablesView& tables, const double (&eta)[D], double* psi) {
  constexpr int max_factors = max_degree * (max_degree + 1) / 2;
  const BasisRecurrence recurrence{tables.degree - 1, tables.facet_recurrence};
  const double normalization = 1 / sqrt(D == 2 ? 2.0 : 1.0);
  double factors[D * max_factors];
  basis_factors<D>(recurrence, eta, factors);
  for_each_basis_function<D>(recurrence, factors, [&](int m, double value) { psi[m] = normalization * value; });
}

/// Lays the lines and points of a facet. Listed corners of the facet: the front vertices in ascending id, then the top;
/// the line at `position` along the front edge reaches `share` of the pole's height.
template <int D>
inline void lay_fracture_points(const FractureFacet& facet, const FractureLaw& law, const ReferenceTablesView& tables,
                                double height, const FractureWorkspace<D>& workspace) {
  int next_point = 0;
  for (int line = 0; line < tables.num_lines; ++line) {
    const double position = tables.line_point[line],
                 share = D == 1 ? 1.0 : (facet.rising_end == 1 ? position : 1 - position);
    // Mean over a triangle: the height along the edge varies linearly with mean 1/2.
    const double line_weight = D == 1 ? 1.0 : 2 * share * tables.line_weight[line];
    FractureLine& laid = workspace.lines[line];
    laid.duration = share * height;
    const double wanted = ceil(laid.duration / (0.1 * law.relaxation_time));
    laid.num_panels =
        wanted < 4 ? 4 : (wanted > workspace.max_panels ? workspace.max_panels : static_cast<int>(wanted));
    laid.first_point = next_point;
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
        facet_modes_at<D>(tables, eta, workspace.psi + static_cast<long>(next_point) * tables.num_facet_modes);
        FracturePoint& point = workspace.points[next_point];
        point.weight = line_weight * tables.panel_weight[p] / laid.num_panels;
        point.damage = facet.damage[line];
        point.direction = 0;
        point.mode =
            static_cast<int>(facet.gap[line] > 0 || facet.damage[line] == 0 ? ContactMode::open : ContactMode::stick);
        point.is_frozen = 0;
      }
  }
}

inline int num_points(const FractureLine* lines, int num_lines, int num_panel_points) {
  return lines[num_lines - 1].first_point + lines[num_lines - 1].num_panels * num_panel_points;
}

/// W = I - sum_q w_q psi(q) psi(q)^T (x) (I - M_q): D = 0 is exact whatever the quadrature.
template <int D, class Lanes>
inline void assemble_traction_map(const FractureLaw& law, const ReferenceTablesView& tables, double normal_sign,
                                  const FractureWorkspace<D>& workspace, const Lanes& lanes) {
  const int num_modes = tables.num_facet_modes,
            count = num_points(workspace.lines, tables.num_lines, tables.num_panel_points);
  for (int m = lanes.first(); m < num_modes; m += lanes.count()) {
    for (int cc = 0; cc < D * D; ++cc)
      for (int n = 0; n < num_modes; ++n)
        workspace.map[(cc * num_modes + m) * num_modes + n] = cc % (D + 1) == 0 && m == n ? 1.0 : 0.0;
    for (int q = 0; q < count; ++q) {
      const FracturePoint& point = workspace.points[q];
      if (point.damage == 0) continue;
      const TractionMap map =
          traction_map(law, static_cast<ContactMode>(point.mode), point.damage, point.direction, normal_sign);
      const double* psi = workspace.psi + static_cast<long>(q) * num_modes;
      const double weight = point.weight * psi[m];
      double* rows = workspace.map + m * num_modes;
      const long block = static_cast<long>(num_modes) * num_modes;
      for (int n = 0; n < num_modes; ++n) {
        rows[n] -= weight * (1 - map.normal) * psi[n];
        if constexpr (D == 2) {
          rows[2 * block + n] += weight * map.friction * psi[n];
          rows[3 * block + n] -= weight * (1 - map.tangential) * psi[n];
        }
      }
    }
  }
  lanes.synchronize();
}

}  // namespace tentpole
