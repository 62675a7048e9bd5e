#include "kernels/launch/slice_energies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "kernels/reference/point_state.reference.hpp"
#include "tests/device/tested_device.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

/// Puts the element's inverse Jacobian into the store, as a solver would.
void store_geometry(TentBatch& batch, const ElementDescriptor& element) {
  const int d = batch.dimension + 1;
  const reference::Geometry geometry = reference::element_geometry(element, batch.dimension);
  for (int entry = 0; entry < d * d; ++entry)
    batch.inverse_jacobians[element.result_slot * d * d + entry] = geometry.inverse[entry / d][entry % d];
}

/// Stores u_x = 3 x + 2 t: v_x = 2 and E_xx = 3.
void store_linear_field(TentBatch& batch, const ElementDescriptor& element) {
  const int dimension = batch.dimension;
  const OrthonormalBasis basis(dimension + 1, batch.degree);
  const Quadrature rule = simplex_quadrature(dimension + 1, 2 * batch.degree);
  store_geometry(batch, element);
  double* coefficients = &batch.coefficients[element.result_slot * batch.num_unknowns()];
  std::fill_n(coefficients, batch.num_unknowns(), 0.0);
  std::vector<double> value(basis.size());
  for (int q = 0; q < rule.num_points(); ++q) {
    const double* xi = &rule.points[q * (dimension + 1)];
    double x = element.corner[0][0], t = element.corner[0][dimension];
    for (int l = 0; l <= dimension; ++l) {
      x += xi[l] * (element.corner[l + 1][0] - element.corner[0][0]);
      t += xi[l] * (element.corner[l + 1][dimension] - element.corner[0][dimension]);
    }
    basis.values({xi, std::size_t(dimension + 1)}, value);
    for (int a = 0; a < basis.size(); ++a) coefficients[a] += rule.weights[q] * value[a] * (3 * x + 2 * t);
  }
}

/// Tents whose elements hold random polynomials, as if they were solved.
TentBatch random_fields(int dimension, int degree, int num_patches, std::uint32_t seed) {
  TentOptions options;
  options.num_patches = num_patches;
  options.num_materials = 2;
  TentBatch batch = random_tents(dimension, degree, options, seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const ElementDescriptor& element : batch.elements) {
    store_geometry(batch, element);
    for (int n = 0; n < batch.num_unknowns(); ++n)
      batch.coefficients[element.result_slot * batch.num_unknowns() + n] = uniform(generator);
  }
  return batch;
}

/// Energies [request][2] computed on a device.
std::vector<double> energies_of(const TentBatch& batch, const std::vector<SliceRequest>& requests,
                                const Device& device = host_device(), int workers = 1) {
  DeviceTents tents(batch, device);
  const SliceTables tables(batch.dimension, batch.degree);
  DeviceBuffer<double> table_block(device, tents.traffic(), std::ssize(tables.block()));
  DeviceBuffer<SliceRequest> device_requests(device, tents.traffic(), std::ssize(requests));
  DeviceBuffer<double> energies(device, tents.traffic(), 2 * std::ssize(requests));
  table_block.upload(tables.block());
  if (!requests.empty()) device_requests.upload(requests);
  SliceEnergyTask task{};
  task.batch = tents.view();
  task.tables = tents.tables();
  task.slice_tables = tables.view(table_block.pointer());
  task.num_requests = static_cast<int>(requests.size());
  task.requests = device_requests.pointer();
  task.energies = energies.pointer();
  task.shape = {workers, device.is_host ? 1 : tested_lanes(device)};
  device.is_host ? slice_energies_host(task) : slice_energies_device(task, device.number);
  std::vector<double> result(2 * requests.size(), std::numeric_limits<double>::quiet_NaN());
  if (!result.empty()) energies.download(result);
  return result;
}

std::vector<double> sorted_corner_times(const ElementDescriptor& element, int dimension) {
  std::vector<double> times;
  for (int corner = 0; corner < dimension + 2; ++corner) times.push_back(element.corner[corner][dimension]);
  std::sort(times.begin(), times.end());
  return times;
}

/// Requests at Gauss points between successive corner times, where the energies are polynomials of degree 2 k - 2 + D
/// in time.
struct TimeRule {
  std::vector<SliceRequest> requests;
  std::vector<double> weights;
};

TimeRule time_rule(const TentBatch& batch) {
  TimeRule rule;
  const Quadrature gauss = gauss_jacobi((2 * batch.degree - 2 + batch.dimension) / 2 + 1, 0);
  for (int e = 0; e < int(batch.elements.size()); ++e) {
    const std::vector<double> times = sorted_corner_times(batch.elements[e], batch.dimension);
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
      for (int q = 0; q < gauss.num_points(); ++q) {
        const double length = times[i + 1] - times[i];
        if (!(length > 0)) continue;
        rule.requests.push_back({e, times[i] + gauss.points[q] * length});
        rule.weights.push_back(gauss.weights[q] * length);
      }
  }
  return rule;
}

/// int over the element of the two energy densities, by point evaluation of the definitions.
std::array<double, 2> spacetime_energies(const TentBatch& batch, const reference::Discretization& disc, int e) {
  const ElementDescriptor& element = batch.elements[e];
  const Material& material = batch.materials[element.material];
  const reference::Geometry geometry = reference::element_geometry(element, batch.dimension);
  std::array<double, 2> sum{};
  for (int q = 0; q < disc.volume_rule.num_points(); ++q) {
    const double* point = &disc.volume_rule.points[q * (batch.dimension + 1)];
    const reference::PointState state = reference::evaluate(
        reference::point_state(disc, geometry.inverse, material, reference::Row(point, point + batch.dimension + 1)),
        &batch.coefficients[element.result_slot * batch.num_unknowns()]);
    const double weight = disc.volume_rule.weights[q] * geometry.determinant;
    for (int i = 0; i < batch.dimension; ++i)
      sum[0] += weight * 0.5 * material.density * state.velocity[i][0] * state.velocity[i][0];
    for (int i = 0; i < batch.dimension * batch.dimension; ++i)
      sum[1] += weight * 0.5 * state.stress[i][0] * state.strain[i][0];
  }
  return sum;
}

class SliceEnergiesOfDimension : public testing::TestWithParam<int> {};

TEST_P(SliceEnergiesOfDimension, IntegrateOverTimeToTheSpacetimeIntegral) {
  const int dimension = GetParam();
  for (int degree = 1; degree <= (dimension == 3 ? 3 : max_degree); ++degree) {
    const TentBatch batch = random_fields(dimension, degree, dimension == 3 ? 1 : 3, 40 + degree);
    const TimeRule rule = time_rule(batch);
    const std::vector<double> energies = energies_of(batch, rule.requests);
    const reference::Discretization disc(dimension, degree);
    for (std::size_t first = 0; first < rule.requests.size();) {
      const int e = rule.requests[first].element;
      double kinetic = 0, strain = 0;
      for (; first < rule.requests.size() && rule.requests[first].element == e; ++first) {
        kinetic += rule.weights[first] * energies[2 * first];
        strain += rule.weights[first] * energies[2 * first + 1];
      }
      const auto expected = spacetime_energies(batch, disc, e);
      EXPECT_NEAR(kinetic / expected[0], 1, 1e-12) << "degree " << degree;
      EXPECT_NEAR(strain / expected[1], 1, 1e-12) << "degree " << degree;
    }
  }
}

/// A flat front raised at one vertex: at the fraction s of its height the tent covers its star shrunk by 1 - s.
TEST_P(SliceEnergiesOfDimension, OfAUniformStateAddUpToTheCoveredPartOfThePlane) {
  const int dimension = GetParam();
  TentOptions options;
  options.front_steepness = 0;
  TentBatch batch = random_tents(dimension, 2, options, 5);
  const Material material = batch.materials[0];
  const double bottom = batch.elements[0].corner[batch.elements[0].pole][dimension];
  const double top = batch.elements[0].corner[dimension + 1][dimension];
  double star = 0;
  for (const ElementDescriptor& element : batch.elements) {
    store_linear_field(batch, element);
    // |Q| = |cell| height / (D + 1) and |det J| = (D + 1)! |Q|
    star +=
        reference::element_geometry(element, dimension).determinant / (top - bottom) / (dimension == 3 ? 6 : dimension);
  }
  for (const double s : {0.0, 0.25, 0.75, 1.0}) {
    std::vector<SliceRequest> requests;
    for (int e = 0; e < int(batch.elements.size()); ++e)
      requests.push_back({e, s == 1.0 ? top : bottom + s * (top - bottom)});
    const std::vector<double> energies = energies_of(batch, requests);
    double kinetic = 0, strain = 0;
    for (std::size_t r = 0; r < requests.size(); ++r) kinetic += energies[2 * r], strain += energies[2 * r + 1];
    const double covered = star * std::pow(1 - s, dimension);
    EXPECT_NEAR(kinetic, 0.5 * material.density * 4 * covered, 1e-12 * star) << "at " << s;
    EXPECT_NEAR(strain, 0.5 * (material.lambda + 2 * material.mu) * 9 * covered, 1e-12 * star) << "at " << s;
  }
}

TEST_P(SliceEnergiesOfDimension, AreZeroOutsideTheElement) {
  const TentBatch batch = random_fields(GetParam(), 2, 1, 3);
  const std::vector<double> times = sorted_corner_times(batch.elements[0], GetParam());
  for (const double energy : energies_of(batch, {{0, times.front() - 0.1}, {0, times.back() + 0.1}}))
    EXPECT_EQ(energy, 0);
}

TEST_P(SliceEnergiesOfDimension, AreContinuousWhereTheSlicePassesACorner) {
  const TentBatch batch = random_fields(GetParam(), 2, 1, 9);
  for (int e = 0; e < int(batch.elements.size()); ++e)
    for (const double time : sorted_corner_times(batch.elements[e], GetParam())) {
      const double step = 1e-13;
      const std::vector<double> energies = energies_of(batch, {{e, time - step}, {e, time}, {e, time + step}});
      double largest = 1;
      for (const double energy : energies) largest = std::max(largest, energy);
      for (int which = 0; which < 2; ++which) EXPECT_NEAR(energies[which], energies[2 + which], 1e-7 * largest);
    }
}

TEST_P(SliceEnergiesOfDimension, DoNotDependOnOtherRequestsNorOnTheNumberOfThreads) {
  const TentBatch batch = random_fields(GetParam(), 2, 20, 8);
  const TimeRule rule = time_rule(batch);
  const std::vector<double> together = energies_of(batch, rule.requests, host_device(), 3);
  for (std::size_t r = 0; r < rule.requests.size(); r += 401) {
    const std::vector<double> alone = energies_of(batch, {rule.requests[r]});
    EXPECT_EQ(alone[0], together[2 * r]);
    EXPECT_EQ(alone[1], together[2 * r + 1]);
  }
}

TEST_P(SliceEnergiesOfDimension, AreTheSameOnADeviceForAnyNumberOfRequests) {
  const std::optional<Device> device = tested_device();
  if (!device) GTEST_SKIP() << "no device in this build";
  const TentBatch batch = random_fields(GetParam(), 2, GetParam() == 1 ? 100 : 30, 6);
  const TimeRule rule = time_rule(batch);
  const std::vector<double> here = energies_of(batch, rule.requests);
  for (const std::size_t count : tested_counts(*device)) {
    std::vector<SliceRequest> requests;
    for (std::size_t i = 0; i < count; ++i) requests.push_back(rule.requests[i % rule.requests.size()]);
    for (const int workers : tested_workers(*device)) {
      const std::vector<double> there = energies_of(batch, requests, *device, workers);
      ASSERT_EQ(there.size(), 2 * count);
      for (std::size_t i = 0; i < there.size(); ++i) {
        const double expected = here[i % here.size()];
        ASSERT_NEAR(there[i], expected, 1e-13 * expected) << "request " << i / 2 << " of " << count;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SliceEnergiesOfDimension, testing::Values(1, 2, 3));

/// Corners (0,0), (1,0) at t = 0 and (0,1), (0,0) at t = 1: the slice t = 1/2 is a square of side 1/2.
TEST(SliceEnergies, OfASquareSliceHaveTheKnownValue) {
  TentBatch batch = random_fields(2, 1, 1, 1);
  ElementDescriptor& element = batch.elements[0];
  const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, 0, 1}};
  for (int corner = 0; corner < 4; ++corner) std::copy_n(corners[corner], 3, element.corner[corner]);
  batch.materials[element.material] = {2, 5, 7};
  store_linear_field(batch, element);
  const std::vector<double> energies = energies_of(batch, {{0, 0.5}});
  EXPECT_NEAR(energies[0], 0.5 * 2 * 4 * 0.25, 1e-14);
  EXPECT_NEAR(energies[1], 0.5 * (5 + 2 * 7) * 9 * 0.25, 1e-13);
}

}  // namespace
}  // namespace tentpole
