#include "host/fracture/maximal_effective_traction.hpp"

#include <algorithm>
#include <cmath>

namespace tentpole {
namespace {

/// c = cos 2 theta of the maximum.
double decisive_cosine(double mean, double radius, double shear_factor) {
  if (mean <= 0) return shear_factor * radius > mean + radius ? 0 : 1;
  const double excess = radius * (shear_factor * shear_factor - 1);
  return mean < excess ? mean / excess : 1;
}

PlaneNormal direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

EffectiveTractionMaximum maximal_effective_traction(const PlaneStress& stress, double shear_factor) {
  const double mean = (stress.xx + stress.yy) / 2, difference = (stress.xx - stress.yy) / 2;
  const double radius = std::hypot(difference, stress.xy);
  const double principal_angle = std::atan2(stress.xy, difference) / 2;
  const double cosine = radius > 0 ? decisive_cosine(mean, radius, shear_factor) : 1;
  EffectiveTractionMaximum maximum{};
  maximum.normal_traction = mean + radius * cosine;
  maximum.tangential_traction = radius * std::sqrt((1 - cosine) * (1 + cosine));
  maximum.effective_traction =
      std::hypot(std::max(maximum.normal_traction, 0.0), shear_factor * maximum.tangential_traction);
  maximum.num_orientations = cosine < 1 ? 2 : 1;
  const double turn = std::acos(cosine) / 2;
  maximum.normal[0] = direction(principal_angle + turn);
  maximum.normal[1] = direction(principal_angle - turn);
  maximum.every_orientation = radius == 0;
  return maximum;
}

double maximal_effective_traction(double stress) {
  return std::max(stress, 0.0);
}

}  // namespace tentpole
