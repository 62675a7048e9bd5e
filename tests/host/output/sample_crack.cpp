#include "tests/host/output/sample_crack.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "kernels/element/quadrature.hpp"
#include "tests/host/output/sample_fields.hpp"

namespace tentpole {
namespace {

using Point = std::array<double, 3>;
using Edge = std::array<Point, 2>;

/// Time since the tip came to a point [s], negative before.
double age(const PitchedBox& box, const SampleCrack& crack, std::span<const double> place, double time) {
  const double offset = box.dimension == 2 ? place[1] - box.length[1] / 2 : 0;
  const double distance = std::hypot(offset, crack.core) - crack.core;
  return time - crack.start - distance / crack.speed;
}

double damage_at(double age, const SampleCrack& crack) {
  return age > 0 ? 1 - std::exp(-age / crack.tau) : 0;
}

/// Twice the way of a pulled end: int_0^s 2 V r^2 (3 - 2 r), which frees a face of the doubled stress.
double face_motion(const SampleCrack& crack, double age) {
  const double r = std::clamp(age / crack.ramp, 0.0, 1.0);
  return 2 * crack.velocity * (crack.ramp * (r * r * r - r * r * r * r / 2) + std::max(0.0, age - crack.ramp));
}

/// The waves of the bar and the release wave that leaves the crack into one half; side = -1 left, 1 right.
DisplacementField half_field(const PitchedBox& box, const SampleCrack& crack, int side) {
  const double speed = box.material.dilatational_speed();
  const DisplacementField waves = wave_field(box.length[0], speed, crack.velocity, crack.ramp);
  return [=](std::span<const double> event) {
    Point displacement = waves(event);
    const double travel = side * (event[0] - box.length[0] / 2) / speed;
    displacement[0] += side * face_motion(crack, age(box, crack, event, event.back() - travel));
    return displacement;
  };
}

/// Edges (D = 1: a vertex twice) of the cell below an element.
std::vector<Edge> cell_edges(const SpacetimeElement& element) {
  std::set<Point> places;
  for (int corner = 0; corner < element.dimension + 2; ++corner) {
    Point place{};
    for (int i = 0; i < element.dimension; ++i) place[i] = element.corner[corner][i];
    places.insert(place);
  }
  std::vector<Edge> edges;
  for (auto a = places.begin(); a != places.end(); ++a) {
    if (element.dimension == 1) edges.push_back({*a, *a});
    if (element.dimension == 2)
      for (auto b = std::next(a); b != places.end(); ++b) edges.push_back({*a, *b});
  }
  return edges;
}

std::vector<Edge> edges_between_regions(const PitchedElements& pitched) {
  std::array<std::set<Edge>, 2> edges;
  for (const SpacetimeElement& element : pitched.elements)
    for (const Edge& edge : cell_edges(element)) edges[element.region - 1].insert(edge);
  std::vector<Edge> common;
  std::set_intersection(edges[0].begin(), edges[0].end(), edges[1].begin(), edges[1].end(), std::back_inserter(common));
  return common;
}

double length(const CrackSegment& segment) {
  return std::hypot(segment.end[1][0] - segment.end[0][0], segment.end[1][1] - segment.end[0][1]);
}

}  // namespace

PitchedElements pitch_cracked(const PitchedBox& box, const SampleCrack& crack) {
  PitchedElements pitched = pitch_elements(box, half_field(box, crack, -1));
  const PitchedElements right = pitch_elements(box, half_field(box, crack, 1));
  const std::vector<Edge> cut = edges_between_regions(pitched);
  for (std::size_t index = 0; index < pitched.elements.size(); ++index) {
    SpacetimeElement& element = pitched.elements[index];
    if (element.region == 2) pitched.coefficients[index] = right.coefficients[index];
    element.coefficients = pitched.coefficients[index];
    for (const Edge& edge : cell_edges(element))
      if (std::binary_search(cut.begin(), cut.end(), edge))
        for (const Point& end : edge)
          element.damage = std::max(element.damage, damage_at(age(box, crack, end, element.time_max()), crack));
  }
  return pitched;
}

std::vector<CrackSegment> crack_segments(const PitchedBox& box, const PitchedElements& pitched,
                                         const SampleCrack& crack, double time) {
  std::vector<CrackSegment> segments;
  for (const Edge& edge : edges_between_regions(pitched)) {
    if (std::max(age(box, crack, edge[0], time), age(box, crack, edge[1], time)) <= 0) continue;
    CrackSegment segment;
    segment.end = edge;
    segment.id = static_cast<std::int64_t>(segments.size());
    segment.num_points = box.dimension == 1 ? 1 : box.degree + 1;
    const Quadrature gauss = gauss_jacobi(segment.num_points, 0);
    for (int point = 0; point < segment.num_points; ++point) {
      const double s = gauss.points[point];
      const Point place = {(1 - s) * edge[0][0] + s * edge[1][0], (1 - s) * edge[0][1] + s * edge[1][1], 0};
      const double since = age(box, crack, place, time);
      segment.damage[point] = damage_at(since, crack);
      segment.opening[point] = 2 * face_motion(crack, since);
    }
    segments.push_back(segment);
  }
  return segments;
}

void add_surfaces(int dimension, const std::vector<CrackSegment>& segments, int row, History& history) {
  for (const CrackSegment& segment : segments) {
    CrackEdgeState state;
    state.num_points = segment.num_points;
    state.damage = segment.damage;
    history.add_surface(row, dimension == 1 ? 1 : length(segment), state);
  }
}

FrontState front_state(const std::vector<CrackSegment>& segments, const PitchedElements& pitched) {
  FrontState state;
  double smallest = 1;
  for (const CrackSegment& segment : segments) smallest = std::min(smallest, segment.damage[0]);
  state.fragments = segments.size() == edges_between_regions(pitched).size() && smallest > 0.99 ? 2 : 1;
  // Any numbers, as if the mesh had been refined at every fracture edge.
  state.cells = 800 + 50 * std::ssize(segments);
  state.smallest_cell = 1e-5 / (1 + static_cast<double>(segments.size()));
  return state;
}

}  // namespace tentpole
