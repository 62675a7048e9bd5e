#pragma once

#include <random>

#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// A law so slow that damage stays as given.
FractureLaw unbreakable_law();

/// Damage and gap that every line of a crack starts with.
struct CrackState {
  double damage = 0;
  double gap = 0;
};

/// Turns interior facets of all patches, which must be tents, into fracture facets: the crack goes through the pole.
/// D = 1: the one interior facet; D = 2: up to two of them, chosen at random. Sides are numbered at random.
void crack_tents(TentBatch& batch, const CrackState& state, std::mt19937& generator);

/// Random tents of one material under crack_tents; D = 1 and 2. `pressure` is added to the random field.
TentBatch cracked_tents(int dimension, int degree, const TentOptions& options, const CrackState& state,
                        std::uint32_t seed, double pressure = 0);

/// A law for the batch: damage begins at a fifth of the largest effective traction on its cracks as they are, its drive
/// is full at nine tenths. The cracks of the batch must be under unbreakable_law.
FractureLaw breaking_law(const TentBatch& batch, double relaxation_time);

/// The same batch with its fracture facets bonded: ordinary interior facets.
TentBatch without_cracks(TentBatch batch);

/// The same batch cut along its fracture facets: boundaries free of traction.
TentBatch cut_along_cracks(TentBatch batch);

/// Energies of one patch, fracture and friction work among them.
struct CrackedBalance {
  double closure = 0;   ///< E_out - E_in + dissipation + W_frac - W_ext
  double fracture = 0;  ///< W_frac without friction
  double friction = 0;
  double dissipation = 0;
  double largest = 0;  ///< energy through a facet, or work
};
CrackedBalance balance_with_cracks(const TentBatch& batch, const PatchDescriptor& patch);

/// Largest difference of the coefficients of solved elements, relative to the largest coefficient of their patch; not a
/// number if one of them is not.
double difference_of_solutions(const TentBatch& left, const TentBatch& right);

}  // namespace tentpole
