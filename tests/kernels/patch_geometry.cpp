#include "tests/kernels/patch_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "kernels/reference/point_state.reference.hpp"

namespace tentpole {
namespace {

double uniform(double low, double high, std::mt19937& generator) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

/// D = 2: triangles around the origin between spokes at random angles from 0 to 180 degrees; the straight side of the
/// half disc is exactly the x axis.
TentGeometry half_disc_star(std::mt19937& generator) {
  const int num_cells = std::uniform_int_distribution<int>(2, 4)(generator);
  TentGeometry tent;
  tent.dimension = 2;
  tent.position = {{0, 0}};
  for (int spoke = 0; spoke <= num_cells; ++spoke) {
    const double radius = uniform(0.6, 1.4, generator), jitter = uniform(-0.2, 0.2, generator);
    const double angle = (spoke + jitter) / num_cells * std::numbers::pi;
    if (spoke == 0 || spoke == num_cells)
      tent.position.push_back({spoke == 0 ? radius : -radius, 0.0});
    else
      tent.position.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    if (spoke > 0) tent.cells.push_back({0, spoke, spoke + 1});
  }
  shuffle_vertices(tent, generator);
  return tent;
}

/// The star of a vertex.
TentGeometry random_star_of(int dimension, bool at_boundary, std::mt19937& generator) {
  if (dimension == 2 && at_boundary) return half_disc_star(generator);
  return random_star(dimension, at_boundary, {}, generator);
}

/// Vertex ids in random order, corners of general elements and the bottom corners of tents ascending.
void shuffle_ids(PatchGeometry& patch, std::mt19937& generator) {
  std::vector<int> id(patch.position.size());
  std::iota(id.begin(), id.end(), 0);
  std::shuffle(id.begin(), id.end(), generator);
  const PatchGeometry from = patch;
  for (std::size_t vertex = 0; vertex < id.size(); ++vertex) {
    patch.position[id[vertex]] = from.position[vertex];
    patch.time[id[vertex]] = from.time[vertex];
  }
  for (PatchGeometry::Element& element : patch.elements) {
    for (int c = 0; c <= patch.dimension + 1; ++c) element.corners[c] = id[element.corners[c]];
    std::sort(element.corners.begin(), element.corners.begin() + patch.dimension + 2);
  }
}

ElementDescriptor descriptor(const PatchGeometry& patch, const PatchGeometry::Element& element) {
  ElementDescriptor result{};
  for (int c = 0; c <= patch.dimension + 1; ++c) {
    for (int j = 0; j < patch.dimension; ++j) result.corner[c][j] = patch.position[element.corners[c]][j];
    result.corner[c][patch.dimension] = patch.time[element.corners[c]];
  }
  return result;
}

std::vector<int> facet_vertices(const PatchGeometry& patch, const PatchGeometry::Element& element, int facet) {
  std::vector<int> vertices;
  for (int c = 0; c <= patch.dimension + 1; ++c)
    if (c != facet) vertices.push_back(element.corners[c]);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Signed area of a triangle of vertices.
double area(const PatchGeometry& patch, int a, int b, int c) {
  const auto &p = patch.position[a], &q = patch.position[b], &r = patch.position[c];
  return ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
}

/// D = 2: a polygon of vertices cut into triangles from its vertex number `apex`; false if one of them is flat or
/// turned over.
bool cut_polygon(const PatchGeometry& patch, const std::vector<int>& ring, std::size_t apex,
                 std::vector<std::array<int, 3>>& triangles) {
  triangles.clear();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const auto vertex = [&](std::size_t step) { return ring[(apex + step) % ring.size()]; };
    triangles.push_back({vertex(0), vertex(i), vertex(i + 1)});
    if (area(patch, triangles.back()[0], triangles.back()[1], triangles.back()[2]) < 0.05) return false;
  }
  return true;
}

/// The vertices around vertex 0 in order, from the cells that contain it.
std::vector<int> link_of(const TentGeometry& star, bool closed) {
  std::map<int, int> next;
  for (const auto& cell : star.cells) {
    std::vector<int> others;
    for (int c = 0; c <= 2; ++c)
      if (cell[c] != star.pole) others.push_back(cell[c]);
    const auto &p = star.position[star.pole], &q = star.position[others[0]], &r = star.position[others[1]];
    const double turn = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if (turn < 0) std::swap(others[0], others[1]);
    next[others[0]] = others[1];
  }
  int first = next.begin()->first;
  if (!closed)
    for (const auto& [from, to] : next)
      if (std::none_of(next.begin(), next.end(), [&](const auto& link) { return link.second == from; })) first = from;
  std::vector<int> ring{first};
  for (int vertex = first; next.count(vertex) && next[vertex] != first; vertex = next[vertex])
    ring.push_back(next[vertex]);
  return ring;
}

/// Times near a plane of random slope below 1 / wave_speed, rough by `roughness`.
void tilt(PatchGeometry& patch, double wave_speed, double roughness, std::mt19937& generator) {
  const double steepness = uniform(0, 0.5, generator) / wave_speed, angle = uniform(0, 6.28, generator);
  for (std::size_t vertex = 0; vertex < patch.position.size(); ++vertex)
    patch.time[vertex] =
        steepness * (patch.position[vertex][0] * std::cos(angle) + patch.position[vertex][1] * std::sin(angle)) +
        roughness / wave_speed * uniform(-1, 1, generator);
}

}  // namespace

bool PatchGeometry::is_general() const {
  return std::any_of(elements.begin(), elements.end(), [&](const Element& element) {
    if (element.pole == none) return true;
    const auto &bottom = position[element.corners[element.pole]], &top = position[element.corners[dimension + 1]];
    return !std::equal(bottom.begin(), bottom.begin() + dimension, top.begin());
  });
}

bool is_admissible(const PatchGeometry& patch, double wave_speed) {
  const int D = patch.dimension;
  struct Facet {
    int count = 0;
    reference::Vector sum{};  ///< of the outward covectors of its elements
  };
  std::map<std::vector<int>, Facet> facets;
  for (const auto& element : patch.elements) {
    const reference::Geometry geometry = reference::element_geometry(descriptor(patch, element), D);
    if (!(geometry.determinant > 0.01)) return false;
    for (int facet = 0; facet <= D + 1; ++facet) {
      const reference::Vector covector = reference::facet_covector(geometry, D, facet);
      Facet& entry = facets[facet_vertices(patch, element, facet)];
      ++entry.count;
      for (int j = 0; j <= D; ++j) entry.sum[j] += covector[j];
      if (element.pole != none && facet == D + 1 && covector[D] > 0) return false;
      if (element.pole != none && facet == element.pole && covector[D] < 0) return false;
    }
  }
  return std::all_of(facets.begin(), facets.end(), [&](const auto& entry) {
    const Facet& facet = entry.second;
    double space = 0;
    for (int j = 0; j < D; ++j) space += facet.sum[j] * facet.sum[j];
    const double time = std::abs(facet.sum[D]);
    if (facet.count == 2) return std::sqrt(space) + time < 1e-12;
    return time < 1e-9 * std::sqrt(space) || std::sqrt(space) * wave_speed <= 0.95 * time;
  });
}

PatchGeometry tent_patch(const TentGeometry& tent) {
  PatchGeometry patch;
  patch.dimension = tent.dimension;
  patch.position = tent.position;
  patch.time = tent.time;
  const int top = static_cast<int>(patch.position.size());
  patch.position.push_back(tent.position[tent.pole]);
  patch.time.push_back(tent.top_time);
  for (const auto& cell : tent.cells) {
    PatchGeometry::Element element{};
    std::copy_n(cell.begin(), tent.dimension + 1, element.corners.begin());
    element.corners[tent.dimension + 1] = top;
    element.pole =
        static_cast<int>(std::find(cell.begin(), cell.begin() + tent.dimension + 1, tent.pole) - cell.begin());
    patch.elements.push_back(element);
  }
  return patch;
}

PatchGeometry inclined_tent(int dimension, bool at_boundary, double wave_speed, double pole_speed,
                            double height_fraction, std::mt19937& generator) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    TentGeometry star = random_star_of(dimension, at_boundary, generator);
    const std::vector<double> speeds(star.cells.size(), wave_speed);
    raise_tent(star, speeds, 0.5, 0.9, generator);
    const double angle = at_boundary ? 0.0 : uniform(0, 6.28, generator);
    const auto at_height = [&](double height) {
      PatchGeometry patch = tent_patch(star);
      patch.time.back() = star.time[star.pole] + height;
      patch.position.back()[0] += pole_speed * height * (dimension == 1 ? 1.0 : std::cos(angle));
      if (dimension > 1) patch.position.back()[1] += pole_speed * height * std::sin(angle);
      return patch;
    };
    double low = 0, high = 3 / wave_speed;
    for (int step = 0; step < 40; ++step) {
      const double middle = (low + high) / 2;
      // Very low tents are refused for their volume; go up from there.
      (is_admissible(at_height(middle), wave_speed) || middle < 0.05 / wave_speed ? low : high) = middle;
    }
    const PatchGeometry patch = at_height(height_fraction * low);
    if (is_admissible(patch, wave_speed) && height_fraction * low > 0.05 / wave_speed) return patch;
  }
  throw std::runtime_error("inclined_tent: no admissible tent found");
}

PatchGeometry deletion_cone(int dimension, bool at_boundary, double wave_speed, std::mt19937& generator) {
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const TentGeometry star = random_star_of(dimension, at_boundary, generator);
    PatchGeometry patch;
    patch.dimension = dimension;
    patch.position = star.position;
    patch.time.resize(star.position.size());
    tilt(patch, wave_speed, 0.05, generator);
    patch.time[star.pole] -= uniform(0.1, 0.5, generator) / wave_speed;
    if (dimension == 1) {
      patch.elements.push_back({{0, 1, 2}, none});
    } else {
      const std::vector<int> ring = link_of(star, !at_boundary);
      std::vector<std::array<int, 3>> triangles;
      if (!cut_polygon(patch, ring, std::uniform_int_distribution<int>(0, 7)(generator) % ring.size(), triangles))
        continue;
      for (const auto& triangle : triangles)
        patch.elements.push_back({{star.pole, triangle[0], triangle[1], triangle[2]}, none});
    }
    shuffle_ids(patch, generator);
    if (is_admissible(patch, wave_speed)) return patch;
  }
  throw std::runtime_error("deletion_cone: no admissible patch found");
}

PatchGeometry square_cone(double wave_speed, std::mt19937& generator) {
  PatchGeometry patch;
  patch.dimension = 2;
  patch.position = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  patch.time = {-0.4 / wave_speed, 0.1 / wave_speed, 0, 0, 0.05 / wave_speed};
  patch.elements = {{{0, 1, 2, 3}, none}, {{0, 3, 4, 1}, none}};
  shuffle_ids(patch, generator);
  return patch;
}

PatchGeometry edge_flip(double wave_speed, std::mt19937& generator) {
  for (int attempt = 0; attempt < 10000; ++attempt) {
    PatchGeometry patch;
    patch.dimension = 2;
    for (int corner = 0; corner < 4; ++corner)
      patch.position.push_back({std::cos(corner * std::numbers::pi / 2) * uniform(0.6, 1.2, generator),
                                std::sin(corner * std::numbers::pi / 2) * uniform(0.6, 1.2, generator)});
    patch.time.resize(4);
    tilt(patch, wave_speed, 0.05, generator);
    for (const int end : {0, 2}) patch.time[end] -= uniform(0.1, 0.4, generator) / wave_speed;
    patch.elements = {{{0, 1, 2, 3}, none}};
    shuffle_ids(patch, generator);
    if (is_admissible(patch, wave_speed)) return patch;
  }
  throw std::runtime_error("edge_flip: no admissible patch found");
}

}  // namespace tentpole
