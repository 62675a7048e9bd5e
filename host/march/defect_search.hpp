#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "host/fracture/strength_distribution.hpp"
#include "host/march/refinement.hpp"
#include "kernels/element/orthonormal_basis.hpp"

namespace tentpole {

/// A front cell that a patch has just made, and the largest principal stress at its corners (scaled), a filter.
struct TestedCell {
  std::int32_t cell;
  double largest_stress;
};

/// Finds the defects that give way (docs/fracture.md, Nucleation): those in new front cells whose strength the largest
/// effective traction at their place exceeds. Cells whose largest principal stress is not tensile are not looked at.
class DefectSearch {
 public:
  explicit DefectSearch(AdaptiveState& state);

  /// Tests the cells of one round and appends to state.triggers, in the order of the cells. Reads the elements below
  /// the cells that hold weak defects from the device. Throws std::runtime_error, with the place, before it generates
  /// more defects in a cell than defect_load.hpp allows.
  void search(std::span<const TestedCell> cells);

 private:
  struct Candidate {
    std::int32_t cell;
    std::vector<DefectTrigger> triggers;  ///< normals still open
    std::vector<double> strength;         ///< [trigger], Pa
  };
  /// The weakest defect of a cell, as far as it has been looked for: cells are tested at every tent, defects stay. It
  /// holds for a place, not for a cell, whose corners inclined tents move: then it changes no answer, and runs that
  /// are resumed without it find the same defects.
  struct CellMemory {
    std::array<Point, 3> corners{};
    double searched = 0;  ///< [Pa]: no weaker defect than `weakest` below this strength
    double weakest = 0;   ///< [Pa]
  };
  std::vector<Defect> field_defects(std::int32_t cell, std::span<const Point> corners, double strongest);
  void refuse_crowd(std::span<const Point> corners, double strongest) const;
  std::optional<Candidate> candidate(const TestedCell& cell);
  void test(const Candidate& candidate, const double* coefficients, const double* inverse_jacobian);
  PlaneStress stress_at(std::int32_t cell, const Point& position, const double* coefficients,
                        const double* inverse_jacobian) const;

  AdaptiveState& state_;
  const FractureSettings& settings_;
  std::optional<StrengthDistribution> distribution_;
  std::optional<DefectField> field_;
  OrthonormalBasis basis_;
  std::vector<CellMemory> memory_;  ///< [cell slot]
};

}  // namespace tentpole
