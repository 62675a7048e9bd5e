#include "kernels/reference/facet_frame.reference.hpp"

#include <cmath>

namespace tentpole::reference {

Rows facet_frame(const Vector& covector, double area, int dimension) {
  Rows frame{Row(covector.begin(), covector.begin() + dimension)};
  for (double& component : frame[0]) component /= area;
  if (dimension == 2) frame.push_back({-frame[0][1], frame[0][0]});
  if (dimension == 3) {
    // The axis least aligned with the normal, made orthogonal to it, then the cross product.
    int axis = 0;
    for (int j = 1; j < 3; ++j)
      if (std::abs(frame[0][j]) < std::abs(frame[0][axis])) axis = j;
    Row tangent(3);
    const double length = std::sqrt(1 - frame[0][axis] * frame[0][axis]);
    for (int j = 0; j < 3; ++j) tangent[j] = ((j == axis) - frame[0][axis] * frame[0][j]) / length;
    const Row n = frame[0];
    frame.push_back(tangent);
    frame.push_back({n[1] * tangent[2] - n[2] * tangent[1], n[2] * tangent[0] - n[0] * tangent[2],
                     n[0] * tangent[1] - n[1] * tangent[0]});
  }
  return frame;
}

}  // namespace tentpole::reference
