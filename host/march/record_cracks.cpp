#include "host/march/record_cracks.hpp"

#include <algorithm>

#include "host/field/solved_element.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

/// The contact mode of most points of a facet.
CrackMode mode_of(const FractureRecord& record) {
  return static_cast<CrackMode>(std::max_element(record.mode_points, record.mode_points + 3) - record.mode_points);
}

/// The corner of a tent element at an end of the front edge of a facet; corners ascend by vertex. D = 1: the pole.
int edge_corner(const ElementDescriptor& element, int facet, int dimension, int end) {
  if (dimension == 1) return element.pole;
  const int first = facet == 0 ? 1 : 0, last = facet == 2 ? 1 : 2;
  return end == 0 ? first : last;
}

/// The strip of fracture facet f.
CrackStrip strip_of(const Simulation& simulation, const HostBatch& batch, int f) {
  const int dimension = simulation.dimension();
  const FractureFacet& facet = batch.fractures[f];
  const FractureRecord& record = batch.fracture_records[f];
  const ElementDescriptor& element = batch.elements[facet.element[0]];
  CrackStrip strip;
  strip.dimension = dimension;
  strip.id = batch.crack_edges[f];
  strip.mode = mode_of(record);
  for (int end = 0; end < 2; ++end) {
    const double* bottom = element.corner[edge_corner(element, facet.facet[0], dimension, end)];
    const double* top = bottom == element.corner[element.pole] ? element.corner[dimension + 1] : bottom;
    for (int axis = 0; axis < dimension; ++axis) strip.end[end][axis] = bottom[axis] * simulation.scaling.length;
    strip.old_time[end] = simulation.time_in_seconds(bottom[dimension]);
    strip.new_time[end] = simulation.time_in_seconds(top[dimension]);
  }
  strip.below.num_points = strip.above.num_points = dimension == 1 ? 1 : simulation.degree() + 1;
  std::copy_n(facet.damage, strip.below.num_points, strip.below.damage.begin());
  std::copy_n(record.damage, strip.above.num_points, strip.above.damage.begin());
  return strip;
}

/// Normal gap between the two elements of a fracture facet, from their solutions.
class FacetGap {
 public:
  FacetGap(const Simulation& simulation, const HostBatch& batch, int f) {
    for (int side = 0; side < 2; ++side) {
      const std::int32_t index = batch.fractures[f].element[side];
      const auto wanted = std::ranges::lower_bound(batch.wanted, index);  // ascending
      element_[side] = spacetime_element(simulation, batch, index);
      coefficients_[side] = solved_coefficients(simulation, batch, wanted - batch.wanted.begin());
      element_[side].coefficients = coefficients_[side];
    }
  }

  /// Openings at these points [m] of the strip at `time` [s].
  std::vector<double> at(const OrthonormalBasis& basis, const CrackStrip& strip, std::span<const double> fractions,
                         double time) const {
    const ElementFields minus(basis, element_[0]), plus(basis, element_[1]);
    const std::array<double, 2> normal = normal_of(strip);
    std::vector<double> gaps;
    for (const double fraction : fractions) {
      std::array<double, 4> event{};
      std::ranges::copy(strip.position(fraction), event.begin());
      event[strip.dimension] = time;
      const auto point = std::span(event).first(strip.dimension + 1);
      const auto left = minus.at(point).displacement, right = plus.at(point).displacement;
      gaps.push_back((right[0] - left[0]) * normal[0] + (right[1] - left[1]) * normal[1]);
    }
    return gaps;
  }

 private:
  /// Unit normal from the first element to the second.
  std::array<double, 2> normal_of(const CrackStrip& strip) const {
    const std::array<double, 4> from = element_[0].centroid(), to = element_[1].centroid();
    std::array<double, 2> normal{1, 0};
    if (strip.dimension == 2) {
      const double length = strip.measure();
      normal = {(strip.end[1][1] - strip.end[0][1]) / length, (strip.end[0][0] - strip.end[1][0]) / length};
    }
    const double across = (to[0] - from[0]) * normal[0] + (strip.dimension == 2 ? (to[1] - from[1]) * normal[1] : 0);
    if (across < 0) normal = {-normal[0], -normal[1]};
    return normal;
  }

  std::array<SpacetimeElement, 2> element_;
  std::array<std::vector<double>, 2> coefficients_;
};

class CrackRecorder {
 public:
  CrackRecorder(const RunBooks& books, const HostBatch& batch, CrackSeries& cracks)
      : books_(books),
        batch_(batch),
        cracks_(cracks),
        basis_(books.simulation.dimension() + 1, books.simulation.degree()) {}

  void record(int f) {
    const CrackStrip strip = strip_of(books_.simulation, batch_, f);
    add_to_history(strip);
    add_to_files(strip, f);
  }

 private:
  void add_to_history(const CrackStrip& strip) {
    const OutputRange rows = books_.history.rows(strip.time_min(), strip.time_max());
    for (int row = rows.first; row < rows.last; ++row) {
      const double time = books_.history.times()[row];
      if (const std::optional<StripPart> part = part_at(strip, time))
        books_.history.add_surface(row, (part->end - part->begin) * strip.measure(), damage_at(strip, *part, time));
    }
  }

  void add_to_files(const CrackStrip& strip, int f) {
    const OutputRange files = cracks_.range(strip.time_min(), strip.time_max());
    if (files.empty()) return;
    const FacetGap gap(books_.simulation, batch_, f);
    for (int file = files.first; file < files.last; ++file) {
      const double time = cracks_.times()[file];
      const std::optional<StripPart> part = part_at(strip, time);
      if (!part) continue;
      const CrackEdgeState state = damage_at(strip, *part, time);
      CrackSegment segment;
      segment.end = {strip.position(part->begin), strip.position(part->end)};
      segment.id = strip.id;
      segment.begin = part->begin;
      segment.mode = strip.mode;
      segment.num_points = state.num_points;
      std::vector<double> fractions = gauss_jacobi(state.num_points, 0).points;
      for (double& fraction : fractions) fraction = part->begin + (part->end - part->begin) * fraction;
      std::ranges::copy(state.damage, segment.damage.begin());
      std::ranges::copy(gap.at(basis_, strip, fractions, time), segment.opening.begin());
      cracks_.add(file, segment);
    }
  }

  const RunBooks& books_;
  const HostBatch& batch_;
  CrackSeries& cracks_;
  OrthonormalBasis basis_;
};

}  // namespace

void record_cracks(const RunBooks& books, const HostBatch& batch, std::span<const std::uint8_t> accepted,
                   CrackSeries& cracks) {
  CrackRecorder recorder(books, batch, cracks);
  for (std::size_t patch = 0; patch < batch.patches.size(); ++patch) {
    if (!accepted[patch]) continue;
    const PatchDescriptor& descriptor = batch.patches[patch];
    for (int f = descriptor.first_fracture; f < descriptor.first_fracture + descriptor.num_fractures; ++f)
      recorder.record(f);
  }
}

}  // namespace tentpole
