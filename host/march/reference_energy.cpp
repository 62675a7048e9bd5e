#include "host/march/reference_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "host/mesh/simplex_geometry.hpp"
#include "host/problem/initial_element.hpp"
#include "host/problem/prescribed_data.hpp"

namespace tentpole {
namespace {

constexpr int num_time_samples = 64;

/// int rho/2 v.v + sigma:E/2 of the initial data over one cell; modes are orthonormal with respect to the mean.
double initial_energy(const Simulation& simulation, PrescribedData& data, int cell) {
  const int dimension = simulation.dimension(), num_modes = num_polynomials(dimension, simulation.degree() - 1);
  const Material& material = simulation.scaled_materials[simulation.mesh.cell_region[cell]];
  std::vector<double> block;
  data.add_initial(initial_element(simulation, cell), dimension + 1, block);
  double density = 0;
  for (int m = 0; m < num_modes; ++m) {
    double trace = 0, square = 0;
    for (int i = 0; i < dimension; ++i) {
      const double velocity = block[i * num_modes + m];
      density += material.density * velocity * velocity / 2;
      trace += block[(dimension + i) * num_modes + m];
      for (int j = 0; j < dimension; ++j) {
        const double strain = block[(dimension + symmetric_index(dimension, i, j)) * num_modes + m];
        square += strain * strain;
      }
    }
    density += material.lambda / 2 * trace * trace + material.mu * square;
  }
  return density * simulation.mesh.cell_measure(cell);
}

/// Outward unit normal times the measure of a boundary facet, D = 1 and 2.
Point facet_vector(const SpaceMesh& mesh, int cell, int facet) {
  const Point opposite = mesh.corner_position(cell, facet);
  const Point first = mesh.corner_position(cell, facet == 0 ? 1 : 0);
  if (mesh.dimension == 1) return {first[0] > opposite[0] ? 1.0 : -1.0, 0, 0};
  const Point second = mesh.corner_position(cell, facet == 2 ? 1 : 2);
  Point normal{second[1] - first[1], first[0] - second[0], 0};
  const double inward = normal[0] * (opposite[0] - first[0]) + normal[1] * (opposite[1] - first[1]);
  if (inward > 0) normal = {-normal[0], -normal[1], 0};
  return normal;
}

/// Z v^2 or s^2 / Z of one component of a load, and (s + Z v)^2 / 4 Z of a far field, which is what its wave brings.
double power(BoundaryKind kind, double value, double velocity, double impedance) {
  if (kind == BoundaryKind::velocity) return impedance * value * value;
  if (kind == BoundaryKind::traction) return value * value / impedance;
  const double amplitude = value + impedance * velocity;
  return amplitude * amplitude / (4 * impedance);
}

struct Parts {
  double along, across;  ///< component along a normal, length of what is left
};

Parts parts(const Point& vector, const Point& normal) {
  const double along = dot(vector, normal);
  return {along, std::sqrt(std::max(0.0, dot(vector, vector) - along * along))};
}

/// Estimated work on one boundary facet [J].
double boundary_work(const Simulation& simulation, BoundaryCondition& condition, int cell, int facet) {
  const SpaceMesh& mesh = simulation.mesh;
  const double unit = simulation.scaling.length;
  const Material& material = simulation.materials[mesh.cell_region[cell]];
  Point normal = facet_vector(mesh, cell, facet), middle{};
  const double measure = std::sqrt(dot(normal, normal));
  for (double& component : normal) component /= measure;
  for (int corner = 0; corner <= mesh.dimension; ++corner)
    if (corner != facet)
      for (int axis = 0; axis < mesh.dimension; ++axis)
        middle[axis] += mesh.corner_position(cell, corner)[axis] * unit / mesh.dimension;
  const double step = simulation.settings.end_time / num_time_samples;
  double work = 0;
  for (int sample = 0; sample < num_time_samples; ++sample) {
    const double time = (sample + 0.5) * step;
    const Parts value = parts(condition.value(middle, time, normal), normal),
                velocity = parts(condition.far_field_velocity(middle, time), normal);
    work +=
        step *
        (power(condition.normal_kind(), value.along, velocity.along, material.density * material.dilatational_speed()) +
         power(condition.tangential_kind(), value.across, velocity.across, material.density * material.shear_speed()));
  }
  return work * measure * std::pow(unit, mesh.dimension - 1);
}

/// Kinetic energy that the body force alone would give the cell until the end [J].
double body_force_energy(const Simulation& simulation, VectorExpression& body_force, int cell) {
  const SpaceMesh& mesh = simulation.mesh;
  const double end = simulation.settings.end_time, unit = simulation.scaling.length;
  Point middle{};
  for (int corner = 0; corner <= mesh.dimension; ++corner)
    for (int axis = 0; axis < mesh.dimension; ++axis)
      middle[axis] += mesh.corner_position(cell, corner)[axis] * unit / (mesh.dimension + 1);
  const Point acceleration = body_force.evaluate(middle, end / 2);
  return simulation.materials[mesh.cell_region[cell]].density / 2 * dot(acceleration, acceleration) * end * end *
         mesh.cell_measure(cell) * std::pow(unit, mesh.dimension);
}

}  // namespace

double reference_energy(const Simulation& simulation) {
  const double unit = simulation.scaling.energy();
  const Case& settings = simulation.settings;
  if (settings.adaptivity.reference_energy) return *settings.adaptivity.reference_energy / unit;
  const SpaceMesh& mesh = simulation.mesh;
  PrescribedData data(simulation);
  std::vector<BoundaryCondition> conditions = simulation.conditions;
  VectorExpression body_force = settings.body_force;
  double energy = 0;
  for (int cell = 0; cell < mesh.num_cells(); ++cell) {
    energy += initial_energy(simulation, data, cell);
    if (!body_force.is_zero()) energy += body_force_energy(simulation, body_force, cell) / unit;
    for (int facet = 0; facet <= mesh.dimension; ++facet) {
      const int boundary = mesh.facet_boundary[cell][facet];
      if (boundary != none && !conditions[boundary].is_zero())
        energy += boundary_work(simulation, conditions[boundary], cell, facet) / unit;
    }
  }
  return std::max(energy, std::numeric_limits<double>::min());
}

}  // namespace tentpole
