#include "tests/kernels/general_patches.hpp"

namespace tentpole {
namespace {

PatchGeometry geometry(int dimension, GeneralKind kind, double speed, std::mt19937& generator) {
  const auto tent = [&](bool at_boundary, double mach, double height) {
    return inclined_tent(dimension, at_boundary, speed, mach * speed, height, generator);
  };
  switch (kind) {
    case GeneralKind::slow_pole:
      return tent(false, 0.3, 0.9);
    case GeneralKind::fast_pole:
      return tent(false, 0.8, 0.9);
    case GeneralKind::supersonic:
      return tent(false, 1.5, 0.9);
    case GeneralKind::sliding_pole:
      return tent(true, 0.4, 0.9);
    case GeneralKind::low_tents:
      return tent(false, 0.3, 0.1);
    case GeneralKind::deletion:
      return deletion_cone(dimension, false, speed, generator);
    case GeneralKind::edge_deletion:
      return deletion_cone(dimension, true, speed, generator);
    case GeneralKind::square:
      return square_cone(speed, generator);
    case GeneralKind::flip:
      return edge_flip(speed, generator);
  }
  return {};
}

}  // namespace

TentBatch general_patches(int dimension, int degree, GeneralKind kind, int num_patches, const TentData& data,
                          std::uint32_t seed) {
  std::mt19937 generator(seed);
  TentBatch batch;
  batch.dimension = dimension;
  batch.degree = degree;
  batch.materials = {random_material(generator)};
  const std::vector<PolynomialField> fields = {PolynomialField::random(dimension, degree, generator)};
  for (int patch = 0; patch < num_patches; ++patch) {
    const PatchGeometry one = geometry(dimension, kind, batch.materials[0].dilatational_speed(), generator);
    append_patch(batch, one, std::vector<int>(one.elements.size(), 0), fields, data, generator);
  }
  return batch;
}

std::vector<GeneralKind> general_kinds(int dimension) {
  using enum GeneralKind;
  if (dimension == 1) return {slow_pole, fast_pole, low_tents, deletion};
  return {slow_pole, fast_pole, supersonic, sliding_pole, low_tents, deletion, edge_deletion, square, flip};
}

const char* name_of(GeneralKind kind) {
  switch (kind) {
    case GeneralKind::slow_pole:
      return "slow pole";
    case GeneralKind::fast_pole:
      return "fast pole";
    case GeneralKind::supersonic:
      return "supersonic pole";
    case GeneralKind::sliding_pole:
      return "pole that slides along the boundary";
    case GeneralKind::low_tents:
      return "low tents";
    case GeneralKind::deletion:
      return "deletion";
    case GeneralKind::edge_deletion:
      return "deletion at the boundary";
    case GeneralKind::square:
      return "square";
    case GeneralKind::flip:
      return "flip";
  }
  return "";
}

}  // namespace tentpole
