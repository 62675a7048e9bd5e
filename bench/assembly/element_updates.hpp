#pragma once

#include <vector>

#include "bench/assembly/cell_tables.hpp"
#include "kernels/element/patch_batch.hpp"
#include "kernels/reference/point_state.reference.hpp"

namespace tentpole {

/// What one quadrature point adds to an n x n block:
///   K[(i, a), column] += weight sum_t test[t][(i, a)] trial[i][t][column].
/// The double loop over rows and columns that does it is what the ladder is about.
struct UpdateRows {
  int num_basis;
  int num_unknowns;
  int num_terms;
  double weight;
  const double* test;     ///< [t][n]
  const double* trial;    ///< [i][t][n], or [t][n] for all i where component_stride is 0
  long component_stride;  ///< num_terms n or 0

  const double* trial_of(int row) const { return trial + row / num_basis * component_stride; }
};

/// All updates that the quadrature of one element makes, in order: points of the volume (1 term each), of the inflow
/// facet (d terms), of the vertical facets (D terms), and the rigid modes (all in one update, D (D + 1) / 2 terms);
/// then, if asked for, the points of the interior facets once more for the blocks of the neighbours.
/// Terms as in kernels/reference/patch_matrix.reference.hpp, kappa = 1, tents without fracture facets, same material
/// everywhere.
class ElementUpdates {
 public:
  /// `tables` and what `batch` points to must outlive the object. element: index in the batch.
  ElementUpdates(const CellTables& tables, const PatchBatch& batch, int element, bool with_neighbors);

  int size() const { return size_; }
  /// Element (index in the batch) whose unknowns are the columns of this update.
  int column_element(int update) const;

  /// Rows of an update in `scratch`, which takes scratch_size() doubles. Costs O(n), against O(n^2) of the double loop.
  UpdateRows form(int update, double* scratch) const;
  long scratch_size() const;

  const CellTables& tables() const { return *tables_; }

 private:
  enum class Kind { volume, inflow, vertical, rigid, neighbor };
  struct Segment {
    Kind kind;
    int facet;
    int first;  ///< update
  };
  struct Gradient {
    const double* values;  ///< [j][a], physical, j = D is time
    int num_basis;
    const double* along(int j) const { return values + static_cast<long>(j) * num_basis; }
  };

  void add_segment(Kind kind, int facet, int num_updates);
  const Segment& segment_of(int update) const;
  Gradient physical_gradient(const reference::Matrix& inverse, const double* table, double* out) const;
  void add_rigid_moments();
  /// What all kinds fill in: gradient first, then `num_terms` rows of tests, then the trials.
  struct RowScratch {
    double* gradient;
    double* test;
    double* trial;
  };
  RowScratch divide(double* scratch, int num_terms) const;
  UpdateRows form_volume(int point, double* scratch) const;
  UpdateRows form_inflow(int facet, int point, double* scratch) const;
  UpdateRows facet_update(int facet, int point, const RowScratch& rows) const;
  UpdateRows form_vertical(int facet, int point, double* scratch) const;
  UpdateRows form_neighbor(int facet, int point, double* scratch) const;
  UpdateRows form_rigid() const;
  /// rows[c][(j, b)] = velocity_factor[c] v_c + traction_factor[c] s_c in the frame of a vertical facet.
  struct FrameFactors {
    double velocity[max_dimension];
    double traction[max_dimension];
  };
  void frame_rows(int facet, const Gradient& gradient, const FrameFactors& factors, double* rows) const;
  FrameFactors test_factors() const;
  FrameFactors own_factors(int facet) const;
  double impedance(int component) const;

  const CellTables* tables_;
  int index_;
  const ElementDescriptor* element_;
  Material material_;
  reference::Geometry geometry_;
  std::vector<reference::Matrix> neighbor_inverse_;  ///< [facet]
  std::vector<reference::Vector> covector_;          ///< [facet], N dA
  std::vector<reference::Matrix> frame_;             ///< [facet][c][i], vertical facets
  std::vector<double> area_;                         ///< [facet]
  std::vector<double> rigid_moments_;                ///< [r][n]
  std::vector<Segment> segments_;
  int size_ = 0;
};

}  // namespace tentpole
