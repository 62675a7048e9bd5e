#pragma once

#include "host/case_file/fracture_settings.hpp"

namespace tentpole {

/// Distribution of the nucleation strengths of defects, all within [minimum, maximum]. Units: [Pa], or any one unit of
/// stress. Source: thesis 2.4.1, equation 2.12 and 2.13.
///   normal   F(s) = (Phi((s - mu) / sigma) - Phi((s_min - mu) / sigma)) / (Phi((s_max - mu) / sigma) - Phi((s_min -
///   mu)
///            / sigma)). mu and sigma belong to the normal distribution before truncation; the formula printed as
///            (2.12) is its density.
///   weibull  F(s) = W(s) / W(s_max), W(s) = 1 - exp(-((s - s_min) / s_0)^m). Not in the thesis.
class StrengthDistribution {
 public:
  /// Needs minimum < maximum (infinity allowed) and standard_deviation > 0.
  static StrengthDistribution truncated_normal(double mean, double standard_deviation, double minimum, double maximum);
  /// Needs minimum < maximum (infinity allowed), modulus > 0 and scale > 0.
  static StrengthDistribution weibull(double minimum, double modulus, double scale, double maximum);
  /// As [fracture.nucleation] says; sigma is tail_standard_deviation.
  static StrengthDistribution from_settings(const NucleationSettings& settings);

  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  /// F: the probability of a strength below this one.
  double probability(double strength) const;
  /// The inverse of F, for a probability in [0, 1]: a strength is drawn by a uniform number.
  double strength(double probability) const;

 private:
  StrengthLaw law_ = StrengthLaw::normal;
  double minimum_ = 0, maximum_ = 0;
  double location_ = 0;  ///< mu, or s_min
  double scale_ = 1;     ///< sigma, or s_0
  double modulus_ = 1;   ///< m
  double lowest_ = 0;    ///< probability of strengths below the minimum before truncation
  double kept_ = 1;      ///< probability of strengths between minimum and maximum before truncation

  /// Truncates what the other members describe.
  void truncate();
  double untruncated_probability(double strength) const;
};

/// sigma of the normal distribution with this mean and P(strength < tail_strength) = tail_probability *before*
/// truncation: sigma = (tail_strength - mean) / Phi^-1(tail_probability) (thesis 2.4.1). After truncation the tail has
/// another probability: 1.59e-4 instead of 2e-4 for the thesis' bar with maximum 4 GPa.
/// Needs tail_strength < mean and a tail_probability in (0, 0.5).
double tail_standard_deviation(double mean, double tail_strength, double tail_probability);

}  // namespace tentpole
