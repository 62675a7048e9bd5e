#pragma once

#include <vector>

namespace tentpole {

/// Points and weights on the unit simplex of a dimension; weights sum to 1 / dimension!.
struct Quadrature {
  int dimension = 0;
  std::vector<double> points;   ///< [num_points][dimension]
  std::vector<double> weights;  ///< [num_points], positive
  int num_points() const { return static_cast<int>(weights.size()); }
};

/// Stroud's conical product of Gauss-Jacobi rules, exact for total degree <= `degree`; (degree / 2 + 1)^dimension
/// points. dimension 0 gives one point of weight 1. Throws std::invalid_argument outside 0 <= dimension <= 4, degree >=
/// 0.
Quadrature simplex_quadrature(int dimension, int degree);

/// Gauss-Jacobi rule on [0, 1] for the weight (1 - x)^alpha, exact to degree 2 num_points - 1.
Quadrature gauss_jacobi(int num_points, int alpha);

}  // namespace tentpole
