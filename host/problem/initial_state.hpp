#pragma once

#include <array>

#include "host/case_file/case.hpp"

namespace tentpole {

/// The initial state of a case at a point. SI units.
struct InitialPoint {
  std::array<double, 3> velocity{};      ///< [m/s]
  std::array<double, 3> displacement{};  ///< [m]
  std::array<double, 6> strain{};        ///< D (D + 1) / 2 tensor components, order xx, yy, zz, xy, yz, xz
};

/// A point of a side of the body and how far expressions may be evaluated from it. SI units.
struct SidePoint {
  std::array<double, 3> position;  ///< [m]
  std::array<double, 3> normal;    ///< outward, length 1
  double depth;                    ///< [m] of the body below the side there
  double width;                    ///< [m] of the part of the side round it
};

/// Initial displacement and velocity of a case, and the strain of the displacement by differences of the expression.
/// Keeps copies of the expressions, so it serves one thread. Throws InputError where an expression is not finite.
class InitialState {
 public:
  explicit InitialState(const Case& settings)
      : dimension_(settings.domain.dimension),
        displacement_(settings.initial_displacement),
        velocity_(settings.initial_velocity) {}

  /// True if the body is at rest, not displaced, everywhere.
  bool is_zero() const { return displacement_.is_zero() && velocity_.is_zero(); }

  /// At a point inside the body: sixth-order central differences along the axes with this step [m] (relative error
  /// about 1e-13 for smooth data and a step of 0.4 % of a cell).
  InitialPoint inside(const std::array<double, 3>& point, double step);

  /// At a point of a side: differences of order 6 from the side into the body along the normal, where outside of it
  /// the expression may mean nothing, and central ones along the side.
  InitialPoint on_side(const SidePoint& point);

 private:
  InitialPoint without_strain(const std::array<double, 3>& point);

  int dimension_;
  VectorExpression displacement_;
  VectorExpression velocity_;
};

}  // namespace tentpole
