#pragma once

#include <vector>

#include "host/output/crack_series.hpp"
#include "host/output/history.hpp"
#include "tests/host/output/pitched_elements.hpp"

namespace tentpole {

/// A made-up crack for pictures and for reading back: the waves of wave_field meet in the middle of the box and part it
/// along the mesh edges between its regions, from the middle of its width outwards (D = 2) or at one vertex (D = 1). No
/// solution of anything, but each half is a body with travelling waves whose end becomes free.
struct SampleCrack {
  double velocity = 6.1;  ///< of the pulled ends [m/s]
  double ramp = 1e-8;     ///< [s]
  double start = 6e-8;    ///< the middle fails [s]
  double speed = 1.2e4;   ///< of the crack tips far from the start [m/s]
  double core = 4e-5;     ///< the tips start faster within this distance, so the front of the release is round [m]
  double tau = 3e-9;      ///< damage = 1 - exp(-(time since the tip came) / tau)
};

/// Elements of both halves, each with its own displacement; damage is set for those that touch the crack.
PitchedElements pitch_cracked(const PitchedBox& box, const SampleCrack& crack);

/// The edges (D = 1: vertex) between the regions that the tips have reached at `time` [s].
std::vector<CrackSegment> crack_segments(const PitchedBox& box, const PitchedElements& pitched,
                                         const SampleCrack& crack, double time);

/// Adds the segments to a row of the history.
void add_surfaces(int dimension, const std::vector<CrackSegment>& segments, int row, History& history);

/// What history.csv says about the front with these segments.
FrontState front_state(const std::vector<CrackSegment>& segments, const PitchedElements& pitched);

}  // namespace tentpole
