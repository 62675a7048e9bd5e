#pragma once

#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// Patches beyond tents with vertical poles. All of one material.
enum class GeneralKind {
  slow_pole,      ///< tents whose pole moves at 0.3 c_p
  fast_pole,      ///< at 0.8 c_p, above the shear speed
  supersonic,     ///< at 1.5 c_p: facets couple one way only
  sliding_pole,   ///< D = 2: at the boundary, at 0.4 c_p along it
  low_tents,      ///< slow poles, a tenth of the height
  deletion,       ///< cones
  edge_deletion,  ///< D = 2: cones of a vertex on the boundary
  square,         ///< D = 2: a cone with a vertical inner facet
  flip,           ///< D = 2: edge flips
};

/// `num_patches` patches with a random polynomial of the batch's degree.
TentBatch general_patches(int dimension, int degree, GeneralKind kind, int num_patches, const TentData& data,
                          std::uint32_t seed);

/// The kinds that exist in a dimension.
std::vector<GeneralKind> general_kinds(int dimension);
const char* name_of(GeneralKind kind);

}  // namespace tentpole
