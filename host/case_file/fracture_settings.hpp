#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host/case_file/input_error.hpp"

namespace tentpole {

/// Where new fracture surfaces may start: nowhere; at defects that are fixed in space; or at defects that are drawn
/// anew for every patch (thesis 2.3.3).
enum class NucleationModel { nowhere, field, sampled };

enum class StrengthLaw { normal, weibull };

/// [fracture.nucleation]: which strengths the defects have, and how many there are. docs/case-file.md; host/fracture.
struct NucleationSettings {
  NucleationModel model = NucleationModel::nowhere;
  StrengthLaw distribution = StrengthLaw::normal;
  double minimum = 0;                                        ///< [Pa], of either distribution
  double maximum = std::numeric_limits<double>::infinity();  ///< [Pa], of either distribution
  double mean = 0;              ///< [Pa], of the normal distribution before it is truncated to [minimum, maximum]
  double tail_strength = 0;     ///< [Pa]
  double tail_probability = 0;  ///< P(strength < tail_strength) of the normal distribution before it is truncated
  double weibull_modulus = 0;   ///< shape m of 1 - exp(-((s - minimum) / weibull_scale)^m)
  double weibull_scale = 0;     ///< [Pa]
  double density = 0;           ///< defects, or tests per patch, per m^D of the domain (D = 2: per m^2)
  std::uint64_t seed = 1;
};

/// [[fracture.crack]]: a line (D = 2) or a point (D = 1) on which the initial mesh has fracture surface.
struct CrackSettings {
  std::vector<std::array<double, 3>> points;  ///< [m], corners of the polyline; D = 1: one point
  double damage = 0;                          ///< in [0, 1]: 1 is an open crack, 0 a line along which damage may grow
  std::string side{};                         ///< instead of points: a side inside the body, by name
  SourceLocation location{};                  ///< of the points or the side
};

/// [fracture]
struct FractureSettings {
  bool enabled = false;
  double threshold = 0;                     ///< s_low [Pa]: effective traction at which damage begins
  double strength = 0;                      ///< s_high [Pa]: effective traction at which damage tends to 1
  double relaxation_time = 0;               ///< tau [s]
  double delay_exponent = 10;               ///< a
  double shear_factor = 1;                  ///< beta: weight of the tangential traction
  double friction = 0;                      ///< k_f of closed surfaces
  double max_damage_step = 0.2;             ///< largest change of damage in one patch, in (0, 1]
  std::optional<double> process_zone_size;  ///< [m]; absent: c_p tau of the material
  std::optional<double> growth_length;      ///< [m]; absent: process_zone_size / 4
  NucleationSettings nucleation;
  std::vector<CrackSettings> cracks;
};

}  // namespace tentpole
