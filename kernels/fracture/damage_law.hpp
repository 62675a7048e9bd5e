#pragma once

#include <cmath>

namespace tentpole {

/// Interfacial damage: D in [0, 1] is the debonded area fraction at a point of a fracture facet. Scaled units on the
/// device, SI on the host. Source: thesis 2.3.2, equations 2.6 to 2.11.
struct FractureLaw {
  double threshold;        ///< s_low: effective traction at which damage begins
  double strength;         ///< s_high: effective traction at which the fastest damage rate is reached
  double relaxation_time;  ///< tau
  double delay_exponent;   ///< a
  double shear_factor;     ///< beta: weight of the tangential traction
  double friction;         ///< k_f of closed surfaces
};

/// s_eff = sqrt(<s_n>_+^2 + beta^2 |s_t|^2) of the intact Riemann traction (2.6).
inline double effective_traction(const FractureLaw& law, double normal, double tangential) {
  const double open = normal > 0 ? normal : 0, shear = law.shear_factor * tangential;
  return sqrt(open * open + shear * shear);
}

/// f of (2.7) and (2.8), the damage that an effective traction drives to: 0 below the threshold, 3 y^2 - 2 y^3, 1 above
/// the strength.
inline double target_damage(const FractureLaw& law, double effective) {
  const double y = (effective - law.threshold) / (law.strength - law.threshold);
  return y <= 0 ? 0.0 : (y >= 1 ? 1.0 : y * y * (3 - 2 * y));
}

/// Largest number of Gauss points in a panel.
inline constexpr int max_panel_points = 7;

/// Gauss rule of a panel, on [0, 1]; the weights sum to 1.
struct PanelRule {
  int num_points;
  const double* abscissa;  ///< [num_points]
  const double* weight;    ///< [num_points]
};

/// Integrates (2.10), dD/dt = (1 - exp(-a <f - D>_+)) / tau, over one panel of time. In q = exp(-a D) the law is
/// linear, q' = -(a / tau) <q - exp(-a f)>_+; with exp(-a f) replaced by its linear fit in the panel (least squares
/// over the Gauss points) q follows in closed form; of that and the previous q the smaller is taken, but none below the
/// smallest exp(-a f). So D grows monotonically and never beyond the largest f, for panels of any length; constant f is
/// exact.
///   target [num_points]: f at the points;  damage [num_points]: D at the points, written.
/// Returns q at the end of the panel.
inline double integrate_damage_panel(const FractureLaw& law, double duration, const PanelRule& rule,
                                     const double* target, double q_start, double* damage) {
  const auto [num_points, abscissa, weight] = rule;
  const double a = law.delay_exponent, rate = a / law.relaxation_time;
  double mean = 0, moment = 0, square = 0, lowest = 1;
  for (int p = 0; p < num_points; ++p) {
    const double drive = exp(-a * target[p]), offset = abscissa[p] - 0.5;
    mean += weight[p] * drive;
    moment += weight[p] * drive * offset;
    square += weight[p] * offset * offset;
    if (drive < lowest) lowest = drive;
  }
  const double slope = num_points > 1 ? moment / square / duration : 0;
  const double start = mean - slope * duration / 2;
  // Of expm1, so that panels far shorter than the relaxation time lose no digits.
  const auto relaxed = [&](double time) {
    const double part = -expm1(-rate * time);
    return start * part + q_start * exp(-rate * time) + slope * (time - part / rate);
  };
  double q = q_start;
  for (int p = 0; p <= num_points; ++p) {
    double next = relaxed((p < num_points ? abscissa[p] : 1.0) * duration);
    if (next < lowest) next = lowest;
    if (next < q) q = next;
    if (p < num_points) damage[p] = -log(q) / a;
  }
  return q;
}

/// D(t) for constant f >= D(0): D = f - ln(1 + (exp(a (f - D0)) - 1) exp(-a t / tau)) / a.
inline double relaxed_damage(const FractureLaw& law, double target, double start, double time) {
  const double a = law.delay_exponent;
  return target - log1p(expm1(a * (target - start)) * exp(-a * time / law.relaxation_time)) / a;
}

}  // namespace tentpole
