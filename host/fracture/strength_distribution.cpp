#include "host/fracture/strength_distribution.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "host/fracture/standard_normal.hpp"

namespace tentpole {

StrengthDistribution StrengthDistribution::truncated_normal(double mean, double standard_deviation, double minimum,
                                                            double maximum) {
  assert(minimum < maximum && standard_deviation > 0 && "a distribution has an interval and a width");
  StrengthDistribution result;
  result.law_ = StrengthLaw::normal;
  result.minimum_ = minimum;
  result.maximum_ = maximum;
  result.location_ = mean;
  result.scale_ = standard_deviation;
  result.truncate();
  return result;
}

StrengthDistribution StrengthDistribution::weibull(double minimum, double modulus, double scale, double maximum) {
  assert(minimum < maximum && modulus > 0 && scale > 0 && "a distribution has an interval and a width");
  StrengthDistribution result;
  result.law_ = StrengthLaw::weibull;
  result.minimum_ = minimum;
  result.maximum_ = maximum;
  result.location_ = minimum;
  result.scale_ = scale;
  result.modulus_ = modulus;
  result.truncate();
  return result;
}

StrengthDistribution StrengthDistribution::from_settings(const NucleationSettings& settings) {
  if (settings.distribution == StrengthLaw::weibull)
    return weibull(settings.minimum, settings.weibull_modulus, settings.weibull_scale, settings.maximum);
  return truncated_normal(settings.mean,
                          tail_standard_deviation(settings.mean, settings.tail_strength, settings.tail_probability),
                          settings.minimum, settings.maximum);
}

void StrengthDistribution::truncate() {
  lowest_ = untruncated_probability(minimum_);
  kept_ = untruncated_probability(maximum_) - lowest_;
}

double StrengthDistribution::untruncated_probability(double strength) const {
  const double x = (strength - location_) / scale_;
  if (law_ == StrengthLaw::normal) return normal_probability(x);
  return x > 0 ? -std::expm1(-std::pow(x, modulus_)) : 0;
}

double StrengthDistribution::probability(double strength) const {
  if (strength <= minimum_) return 0;
  if (strength >= maximum_) return 1;
  return std::clamp((untruncated_probability(strength) - lowest_) / kept_, 0.0, 1.0);
}

double StrengthDistribution::strength(double probability) const {
  const double untruncated = lowest_ + probability * kept_;
  const double x =
      law_ == StrengthLaw::normal ? normal_quantile(untruncated) : std::pow(-std::log1p(-untruncated), 1 / modulus_);
  return std::clamp(location_ + scale_ * x, minimum_, maximum_);
}

double tail_standard_deviation(double mean, double tail_strength, double tail_probability) {
  return (tail_strength - mean) / normal_quantile(tail_probability);
}

}  // namespace tentpole
