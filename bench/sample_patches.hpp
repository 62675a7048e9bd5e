#pragma once

#include "tests/kernels/tent_samples.hpp"

namespace tentpole {

/// Patches of exactly `num_elements` tent elements: cells that follow each other around the pole of a random star, the
/// tent raised over them alone, one random material. Sides without a neighbour are absorbing and are given the data of
/// the known polynomial; the own block of an absorbing side is that of a side to an equal material, so a single element
/// has the matrix of an integration cell inside a body. The same arguments give the same patches.
/// Throws std::invalid_argument if no star of the dimension has so many cells.
TentBatch sample_patches(int space_dimension, int degree, int num_elements, int num_patches);

/// num_patches patches: those of the batch in turn, each copy with its own place for the answer. Copies share the data
/// below and on the boundary, so that large batches cost no more than their memory. No fracture facets.
TentBatch repeat_patches(const TentBatch& batch, int num_patches);

/// Largest coefficient error of the first num_elements elements against the polynomials they were made from, relative
/// to the largest coefficient of the element; NaN where a coefficient is.
double polynomial_error(const TentBatch& batch, int num_elements);

}  // namespace tentpole
