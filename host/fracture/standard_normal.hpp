#pragma once

namespace tentpole {

/// Phi(x), the probability that a standard normal number is below x; accurate in the lower tail, too.
double normal_probability(double x);

/// x with Phi(x) = probability, for a probability in (0, 1); the ends give -infinity and +infinity. Relative error
/// below 1e-14 for probabilities from 1e-300 to 0.5; above, that of 1 - probability is all that limits it. A rational
/// approximation (Abramowitz and Stegun 26.2.23, error 4.5e-4) and three steps of Halley's method on Phi.
double normal_quantile(double probability);

}  // namespace tentpole
