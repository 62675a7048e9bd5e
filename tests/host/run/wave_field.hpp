#pragma once

#include "tests/host/run/exact_field.hpp"

namespace tentpole::testing {

/// A harmonic plane wave: u = amplitude * polarization * sin(wave_vector . x - speed |wave_vector| t + phase).
struct PlaneWave {
  double amplitude;
  std::vector<double> wave_vector;   ///< [1/m]
  std::vector<double> polarization;  ///< along the wave vector with the P speed, or across with the S speed
  double speed;                      ///< [m/s]
  double phase;
};

/// The sum of the waves with its velocity and stress.
ExactField wave_field(const std::vector<PlaneWave>& waves, const Solid& solid);

/// The waves of the table in docs/formulation.md: two P waves for D = 1; for D = 2 two P waves and an S wave; for D = 3
/// a P wave and two S waves. In the solid of wave_solid(dimension).
std::vector<PlaneWave> standard_waves(int dimension);

/// Density 1 and Lame's constants 1; D = 1: modulus 1.
Solid wave_solid(int dimension);

}  // namespace tentpole::testing
