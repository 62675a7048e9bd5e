#include "host/problem/prescribed_data.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace tentpole {
namespace {

double factorial(int n) {
  return n < 2 ? 1.0 : n * factorial(n - 1);
}

/// Modes at all points of a rule, times the weight and `factor`.
std::vector<double> weighted_modes(const OrthonormalBasis& modes, const Quadrature& rule, double factor) {
  std::vector<double> table(static_cast<std::size_t>(rule.num_points()) * modes.size());
  for (int point = 0; point < rule.num_points(); ++point) {
    const std::span<double> row(&table[static_cast<std::size_t>(point) * modes.size()], modes.size());
    modes.values(
        {&rule.points[static_cast<std::size_t>(point) * rule.dimension], static_cast<std::size_t>(rule.dimension)},
        row);
    for (double& value : row) value *= factor * rule.weights[point];
  }
  return table;
}

/// Barycentric combination of element corners: position (scaled) in 0..D-1, time in `time`.
std::array<double, 3> combine(const ElementDescriptor& element, int dimension, std::span<const int> corners,
                              const double* eta, double& time) {
  std::array<double, 3> point{};
  time = 0;
  double first = 1;
  for (std::size_t i = 1; i < corners.size(); ++i) first -= eta[i - 1];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double barycentric = i == 0 ? first : eta[i - 1];
    for (int axis = 0; axis < dimension; ++axis) point[axis] += barycentric * element.corner[corners[i]][axis];
    time += barycentric * element.corner[corners[i]][dimension];
  }
  return point;
}

/// Corners of a facet in their listed order, ascending.
std::vector<int> facet_corners(int dimension, int facet) {
  std::vector<int> corners;
  for (int corner = 0; corner <= dimension + 1; ++corner)
    if (corner != facet) corners.push_back(corner);
  return corners;
}

/// Outward unit normal in space of a vertical facet; its first D corners lie on the front.
std::array<double, 3> outward_normal(const ElementDescriptor& element, int dimension, int facet) {
  std::array<double, 3> normal{}, edge[2]{}, inward{};
  const std::vector<int> corners = facet_corners(dimension, facet);
  for (int axis = 0; axis < dimension; ++axis) {
    for (int side = 0; side + 1 < dimension; ++side)
      edge[side][axis] = element.corner[corners[side + 1]][axis] - element.corner[corners[0]][axis];
    inward[axis] = element.corner[facet][axis] - element.corner[corners[0]][axis];
  }
  if (dimension == 1) {
    normal = {1, 0, 0};
  } else if (dimension == 2) {
    normal = {edge[0][1], -edge[0][0], 0};
  } else {
    normal = {edge[0][1] * edge[1][2] - edge[0][2] * edge[1][1], edge[0][2] * edge[1][0] - edge[0][0] * edge[1][2],
              edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]};
  }
  const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  const double side = normal[0] * inward[0] + normal[1] * inward[1] + normal[2] * inward[2];
  for (double& component : normal) component *= (side > 0 ? -1 : 1) / length;
  return normal;
}

/// Largest extent of a facet along an axis.
double facet_size(const ElementDescriptor& element, int dimension, const std::vector<int>& corners) {
  double size = 0;
  for (const int corner : corners)
    for (int axis = 0; axis < dimension; ++axis)
      size = std::max(size, std::fabs(element.corner[corner][axis] - element.corner[corners[0]][axis]));
  return size;
}

}  // namespace

PrescribedData::PrescribedData(const Simulation& simulation)
    : dimension_(simulation.dimension()),
      num_facet_modes_(num_polynomials(dimension_, simulation.degree() - 1)),
      scaling_(simulation.scaling),
      conditions_(simulation.conditions),
      far_field_(simulation),
      initial_(simulation.settings),
      body_force_(simulation.settings.body_force),
      facet_rule_(simplex_quadrature(dimension_, 2 * simulation.degree() + 4)),
      volume_rule_(simplex_quadrature(dimension_ + 1, 2 * simulation.degree() + 2)),
      num_volume_modes_(num_polynomials(dimension_ + 1, simulation.degree() - 1)) {
  for (const Material& material : simulation.materials) density_.push_back(material.density);
  // Means over the facet: weights sum to 1 / D!, and modes are normalised to unit mean square.
  facet_psi_ = weighted_modes({dimension_, simulation.degree() - 1}, facet_rule_, std::sqrt(factorial(dimension_)));
  facet_chi_ = weighted_modes({dimension_, 1}, facet_rule_, std::sqrt(factorial(dimension_)));
  volume_modes_ = weighted_modes({dimension_ + 1, simulation.degree() - 1}, volume_rule_, 1);
}

PrescribedData::Point PrescribedData::to_si(const Point& scaled) const {
  return {scaled[0] * scaling_.length, scaled[1] * scaling_.length, scaled[2] * scaling_.length};
}

std::int32_t PrescribedData::add_initial(const ElementDescriptor& element, int facet, std::vector<double>& prescribed) {
  const int num_strains = num_symmetric(dimension_), num_fields = dimension_ + num_strains, num_chi = dimension_ + 1;
  const std::size_t offset = prescribed.size();
  prescribed.resize(offset + num_fields * num_facet_modes_ + dimension_ * num_chi, 0.0);
  if (initial_.is_zero()) return static_cast<std::int32_t>(offset);
  double* block = &prescribed[offset];
  const std::vector<int> corners = facet_corners(dimension_, facet);
  const double step = 4e-3 * facet_size(element, dimension_, corners) * scaling_.length;
  for (int q = 0; q < facet_rule_.num_points(); ++q) {
    double time;
    const Point point = to_si(
        combine(element, dimension_, corners, &facet_rule_.points[static_cast<std::size_t>(q) * dimension_], time));
    const InitialPoint state = initial_.inside(point, step);
    const double* psi = &facet_psi_[static_cast<std::size_t>(q) * num_facet_modes_];
    const double* chi = &facet_chi_[static_cast<std::size_t>(q) * num_chi];
    for (int m = 0; m < num_facet_modes_; ++m) {
      for (int i = 0; i < dimension_; ++i)
        block[i * num_facet_modes_ + m] += psi[m] * state.velocity[i] / scaling_.speed;
      for (int s = 0; s < num_strains; ++s) block[(dimension_ + s) * num_facet_modes_ + m] += psi[m] * state.strain[s];
    }
    for (int i = 0; i < dimension_; ++i)
      for (int m = 0; m < num_chi; ++m)
        block[num_fields * num_facet_modes_ + i * num_chi + m] += chi[m] * state.displacement[i] / scaling_.length;
  }
  return static_cast<std::int32_t>(offset);
}

std::int32_t PrescribedData::add_boundary(const ElementDescriptor& element, int facet, int boundary,
                                          std::vector<double>& prescribed) {
  BoundaryCondition& condition = conditions_[boundary];
  if (condition.is_absorbing()) return add_far_field(element, facet, condition, prescribed);
  if (condition.is_zero()) return none;
  const std::size_t offset = prescribed.size();
  prescribed.resize(offset + dimension_ * num_facet_modes_, 0.0);
  double* block = &prescribed[offset];
  const std::vector<int> corners = facet_corners(dimension_, facet);
  const Point normal = outward_normal(element, dimension_, facet);
  const auto unit = [&](BoundaryKind kind) {
    return kind == BoundaryKind::velocity ? scaling_.speed : scaling_.stress();
  };
  const double normal_unit = unit(condition.normal_kind()), tangential_unit = unit(condition.tangential_kind());
  for (int q = 0; q < facet_rule_.num_points(); ++q) {
    double time;
    const Point point = to_si(
        combine(element, dimension_, corners, &facet_rule_.points[static_cast<std::size_t>(q) * dimension_], time));
    const Point value = condition.value(point, time * scaling_.time(), normal);
    const double along_normal = value[0] * normal[0] + value[1] * normal[1] + value[2] * normal[2];
    const double* psi = &facet_psi_[static_cast<std::size_t>(q) * num_facet_modes_];
    for (int i = 0; i < dimension_; ++i) {
      const double normal_part = along_normal * normal[i];
      const double scaled = normal_part / normal_unit + (value[i] - normal_part) / tangential_unit;
      for (int m = 0; m < num_facet_modes_; ++m) block[i * num_facet_modes_ + m] += psi[m] * scaled;
    }
  }
  return static_cast<std::int32_t>(offset);
}

/// What a facet of a side has in common at all its points; the position is left open.
SidePoint PrescribedData::side_point(const ElementDescriptor& element, int facet, const Point& normal) const {
  const std::vector<int> corners = facet_corners(dimension_, facet);
  double depth = 0;
  for (int axis = 0; axis < dimension_; ++axis)
    depth += normal[axis] * (element.corner[corners[0]][axis] - element.corner[facet][axis]);
  return {{}, normal, depth * scaling_.length, facet_size(element, dimension_, corners) * scaling_.length};
}

std::int32_t PrescribedData::add_far_field(const ElementDescriptor& element, int facet, BoundaryCondition& condition,
                                           std::vector<double>& prescribed) {
  if (far_field_.is_zero(condition)) return none;
  const std::size_t offset = prescribed.size();
  prescribed.resize(offset + dimension_ * num_facet_modes_, 0.0);
  double* block = &prescribed[offset];
  const std::vector<int> corners = facet_corners(dimension_, facet);
  SidePoint side = side_point(element, facet, outward_normal(element, dimension_, facet));
  bool is_zero = true;
  for (int q = 0; q < facet_rule_.num_points(); ++q) {
    double time;
    side.position = to_si(
        combine(element, dimension_, corners, &facet_rule_.points[static_cast<std::size_t>(q) * dimension_], time));
    const Point amplitude = far_field_.incoming_amplitude(condition, element.material, side, time * scaling_.time());
    const double* psi = &facet_psi_[static_cast<std::size_t>(q) * num_facet_modes_];
    for (int i = 0; i < dimension_; ++i) {
      is_zero = is_zero && amplitude[i] == 0;
      for (int m = 0; m < num_facet_modes_; ++m) block[i * num_facet_modes_ + m] += psi[m] * amplitude[i];
    }
  }
  if (!is_zero) return static_cast<std::int32_t>(offset);
  prescribed.resize(offset);
  return none;
}

std::int32_t PrescribedData::add_body_force(const ElementDescriptor& element, std::vector<double>& prescribed) {
  if (body_force_.is_zero()) return none;
  const std::size_t offset = prescribed.size();
  prescribed.resize(offset + dimension_ * num_volume_modes_, 0.0);
  double* block = &prescribed[offset];
  const int corners[5] = {0, 1, 2, 3, 4};
  const double factor = density_[element.material] / scaling_.force_density();
  for (int q = 0; q < volume_rule_.num_points(); ++q) {
    double time;
    const Point point = to_si(combine(element, dimension_, {corners, static_cast<std::size_t>(dimension_) + 2},
                                      &volume_rule_.points[static_cast<std::size_t>(q) * (dimension_ + 1)], time));
    const Point acceleration = body_force_.evaluate(point, time * scaling_.time());
    const double* modes = &volume_modes_[static_cast<std::size_t>(q) * num_volume_modes_];
    for (int i = 0; i < dimension_; ++i)
      for (int m = 0; m < num_volume_modes_; ++m)
        block[i * num_volume_modes_ + m] += modes[m] * factor * acceleration[i];
  }
  return static_cast<std::int32_t>(offset);
}

}  // namespace tentpole
