#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "host/fracture/strength_distribution.hpp"
#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Names a defect of a field for good.
struct DefectId {
  std::int32_t layer;
  std::array<std::int64_t, 2> box;  ///< of the layer's grid; box[1] is 0 for D = 1
  std::int32_t number;              ///< in its box
  auto operator<=>(const DefectId&) const = default;
};

struct Defect {
  DefectId id;
  Point position;
  double strength;
};

/// Defects that are fixed in space: a Poisson process of the whole line or plane with independent strengths, which the
/// seed alone decides. Nothing is stored: defects are generated where they are asked for. So any mesh, any order of
/// queries and any cut-off see the same defects.
///
/// Only weak defects matter and most are strong, so the process is cut by rank (the probability F(strength)) in layers:
/// layer j has the defects of rank in (4^-(j+1), 4^-j], the last of twelve all weaker ones. Each layer is a Poisson
/// process of its own on a grid of boxes with two defects on average, drawn from the numbers that belong to (seed,
/// layer, box). A query visits no layer above the rank of its cut-off, so its cost grows with the number of defects in
/// the bounding box that are weaker than about the cut-off, not with the density; below the minimum it costs nothing.
/// Units: any one length and stress; runs use [m] and [Pa], so the field does not depend on their scaling.
class DefectField {
 public:
  /// `density` per unit of length (D = 1) or area (D = 2); D = 1 or 2.
  DefectField(int dimension, double density, const StrengthDistribution& distribution, std::uint64_t seed);

  /// Defects no stronger than `strongest` in the box [low, high), ascending in id. Boxes that share a side share no
  /// defect.
  std::vector<Defect> in_box(const Point& low, const Point& high, double strongest) const;
  /// The same in the closed interval (D = 1) or triangle (D = 2) with these corners, of any orientation. No defect is
  /// lost between two triangles with common corners; one exactly on their common side is in both.
  std::vector<Defect> in_simplex(std::span<const Point> corners, double strongest) const;
  /// Expected number of such defects in a region of this length or area.
  double mean_number(double measure, double strongest) const;
  /// Expected number of defects that a query of such a region generates: those of all layers up to the cut-off.
  double mean_number_searched(double measure, double strongest) const;

 private:
  struct Region;
  struct Layer {
    double lowest_rank, highest_rank;
    double weakest;   ///< strength of the lowest rank
    double box_size;  ///< side of the boxes of its grid
  };
  void add_layer(int layer, const Region& region, double strongest, std::vector<Defect>& defects) const;
  void add_box(const DefectId& box, const Region& region, double strongest, std::vector<Defect>& defects) const;
  std::vector<Defect> in_region(const Region& region, double strongest) const;

  int dimension_;
  double density_;
  StrengthDistribution distribution_;
  std::uint64_t seed_;
  std::vector<Layer> layers_;  ///< none where the density is 0
};

}  // namespace tentpole
