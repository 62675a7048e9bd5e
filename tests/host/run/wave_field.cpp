#include "tests/host/run/wave_field.hpp"

#include <cmath>

namespace tentpole::testing {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double frequency(const PlaneWave& wave) {
  return wave.speed * std::sqrt(dot(wave.wave_vector, wave.wave_vector));
}

/// "factor*sin(..)+" with the argument of this wave.
std::string term(double factor, const char* function, const PlaneWave& wave) {
  std::string argument;
  for (std::size_t i = 0; i < wave.wave_vector.size(); ++i)
    argument += digits(wave.wave_vector[i]) + "*" + std::string(1, "xyz"[i]) + "+";
  return "+(" + digits(factor) + ")*" + function + "(" + argument + digits(-frequency(wave)) + "*t+" +
         digits(wave.phase) + ")";
}

}  // namespace

ExactField wave_field(const std::vector<PlaneWave>& waves, const Solid& solid) {
  const int dimension = static_cast<int>(waves.front().wave_vector.size());
  ExactField field;
  field.dimension = dimension;
  field.displacement.assign(dimension, "0");
  field.velocity.assign(dimension, "0");
  field.stress.assign(dimension, std::vector<std::string>(dimension, "0"));
  for (const PlaneWave& wave : waves) {
    const auto& k = wave.wave_vector;
    const auto& p = wave.polarization;
    for (int i = 0; i < dimension; ++i) {
      field.displacement[i] += term(wave.amplitude * p[i], "sin", wave);
      field.velocity[i] += term(-wave.amplitude * frequency(wave) * p[i], "cos", wave);
      for (int j = 0; j < dimension; ++j) {
        const double stress = solid.mu * (p[i] * k[j] + p[j] * k[i]) + (i == j ? solid.lambda * dot(p, k) : 0.0);
        field.stress[i][j] += term(wave.amplitude * stress, "cos", wave);
      }
    }
  }
  return field;
}

Solid wave_solid(int dimension) {
  return dimension == 1 ? Solid{1, 0, 0.5} : Solid{1, 1, 1};
}

std::vector<PlaneWave> standard_waves(int dimension) {
  const Solid solid = wave_solid(dimension);
  const double fast = solid.dilatational_speed(), slow = solid.shear_speed();
  if (dimension == 1) return {{1, {5}, {1}, fast, 0.3}, {-0.7, {-4}, {1}, fast, 0.9}};
  if (dimension == 2) {
    const double c = std::cos(0.5), s = std::sin(0.5), cs = std::cos(1.1), ss = std::sin(1.1);
    return {{1, {5 * c, 5 * s}, {c, s}, fast, 0.3},
            {0.8, {-4.5 * cs, 4.5 * ss}, {-ss, -cs}, slow, 0.7},
            {0.5, {-5 * c, -5 * s}, {c, s}, fast, 0.1}};
  }
  return {{1, {1, 1.5, -1.2}, {1 / std::sqrt(4.69), 1.5 / std::sqrt(4.69), -1.2 / std::sqrt(4.69)}, fast, 0.3},
          {0.8, {-1.5, 0.75, 1}, {0, 0.8, -0.6}, slow, 0.7},
          {0.5, {0.5, -1, 1.5}, {2 / std::sqrt(5.0), 1 / std::sqrt(5.0), 0}, slow, 0.1}};
}

}  // namespace tentpole::testing
