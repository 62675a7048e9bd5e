#include "kernels/launch/transplant.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "device/device_buffer.hpp"
#include "kernels/reference/point_state.reference.hpp"
#include "tests/device/tested_device.hpp"

namespace tentpole {
namespace {

using namespace reference;

/// An element store in host memory, and where each of its elements lies.
struct Store {
  int dimension = 0, degree = 0;
  std::vector<double> coefficients;
  std::vector<double> inverse_jacobians;
  std::vector<ElementDescriptor> elements;  ///< [slot]: corners only

  int num_basis() const { return num_polynomials(dimension + 1, degree); }
  int num_unknowns() const { return dimension * num_basis(); }
  int num_slots() const { return static_cast<int>(elements.size()); }
};

double uniform(double low, double high, std::mt19937& generator) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

/// A slot for an element with these corners, its content not a number.
int append_slot(Store& store, const ElementDescriptor& element) {
  store.elements.push_back(element);
  const int d = store.dimension + 1;
  store.coefficients.resize(store.num_slots() * store.num_unknowns(), std::nan(""));
  store.inverse_jacobians.resize(store.num_slots() * d * d, std::nan(""));
  return store.num_slots() - 1;
}

/// One element with random corners (its facets far from degenerate) and a random polynomial.
Store random_store(int dimension, int degree, std::mt19937& generator) {
  Store store{dimension, degree, {}, {}, {}};
  ElementDescriptor element{};
  for (int corner = 0; corner <= dimension + 1; ++corner)
    for (int j = 0; j <= dimension; ++j)
      element.corner[corner][j] = (corner == j + 1 ? 1.0 : 0.0) + uniform(-0.15, 0.15, generator);
  append_slot(store, element);
  for (double& coefficient : store.coefficients) coefficient = uniform(-1, 1, generator);
  const Geometry geometry = element_geometry(element, dimension);
  for (int l = 0; l <= dimension; ++l)
    for (int j = 0; j <= dimension; ++j) store.inverse_jacobians[l * (dimension + 1) + j] = geometry.inverse[l][j];
  return store;
}

/// Both parts of a cell cut at the fraction of the way from vertex a to vertex b: the new vertex has the largest id.
CellPart cut(int dimension, int a, int b, double fraction, bool keeps_a) {
  CellPart part{};
  int vertex = 0;
  for (int i = 0; i <= dimension; ++i)
    if (i != (keeps_a ? b : a)) part[vertex++][i] = 1;
  part[vertex][a] = 1 - fraction;
  part[vertex][b] = fraction;
  return part;
}

/// Appends a slot for the part of the cell on the source's facet; returns the request that fills it.
TransplantRequest append_part(Store& store, int source, int source_facet, const CellPart& part) {
  const int D = store.dimension;
  TransplantRequest request = cell_part_request(D, source_facet, part);
  ElementDescriptor child{};
  const ElementDescriptor& parent = store.elements[source];
  for (int corner = 0; corner <= D + 1; ++corner)
    for (int j = 0; j <= D; ++j) {
      child.corner[corner][j] = parent.corner[0][j];
      for (int l = 0; l <= D; ++l)
        child.corner[corner][j] += request.corner[corner][l] * (parent.corner[l + 1][j] - parent.corner[0][j]);
    }
  request.source_slot = source;
  request.target_slot = append_slot(store, child);
  return request;
}

void transplant(Store& store, const std::vector<TransplantRequest>& requests, const Device& device = host_device(),
                LaunchShape shape = {1, 1}) {
  TrafficCounters traffic;
  const TransplantTables tables(store.dimension, store.degree);
  DeviceBuffer<double> table_block(device, traffic, std::ssize(tables.block())),
      coefficients(device, traffic, std::ssize(store.coefficients)),
      inverse_jacobians(device, traffic, std::ssize(store.inverse_jacobians));
  DeviceBuffer<TransplantRequest> device_requests(device, traffic, std::ssize(requests));
  table_block.upload(tables.block());
  coefficients.upload(store.coefficients);
  inverse_jacobians.upload(store.inverse_jacobians);
  if (!requests.empty()) device_requests.upload(requests);
  TransplantTask task{};
  task.tables = tables.view(table_block.pointer());
  task.num_requests = static_cast<int>(requests.size());
  task.requests = device_requests.pointer();
  task.coefficients = coefficients.pointer();
  task.inverse_jacobians = inverse_jacobians.pointer();
  task.shape = shape;
  device.is_host ? transplant_host(task) : transplant_device(task, device.number);
  coefficients.download(store.coefficients);
  inverse_jacobians.download(store.inverse_jacobians);
}

/// Values of the displacement of a slot at a spacetime point, by the J^-1 that the store holds.
Row displacement(const Store& store, const OrthonormalBasis& basis, int slot, const Row& point) {
  const int d = store.dimension + 1;
  Row xi(d, 0.0), value(basis.size()), result(store.dimension, 0.0);
  for (int l = 0; l < d; ++l)
    for (int j = 0; j < d; ++j)
      xi[l] += store.inverse_jacobians[(slot * d + l) * d + j] * (point[j] - store.elements[slot].corner[0][j]);
  basis.values(xi, value);
  for (int i = 0; i < store.dimension; ++i)
    for (int a = 0; a < basis.size(); ++a)
      result[i] += store.coefficients[(slot * store.dimension + i) * basis.size() + a] * value[a];
  return result;
}

Row random_point(const Store& store, int slot, std::mt19937& generator) {
  Row barycentric(store.dimension + 2), point(store.dimension + 1, 0.0);
  double sum = 0;
  for (double& coordinate : barycentric) sum += coordinate = uniform(0, 1, generator);
  for (int corner = 0; corner <= store.dimension + 1; ++corner)
    for (int j = 0; j <= store.dimension; ++j)
      point[j] += barycentric[corner] / sum * store.elements[slot].corner[corner][j];
  return point;
}

/// Largest difference of the target's and the source's displacement at random points of the target, relative to the
/// largest displacement in the source.
double difference_in_target(const Store& store, int source, int target, std::mt19937& generator) {
  const OrthonormalBasis basis(store.dimension + 1, store.degree);
  double difference = 0, scale = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Row point = random_point(store, target, generator);
    const Row expected = displacement(store, basis, source, point), found = displacement(store, basis, target, point);
    for (const double component : displacement(store, basis, source, random_point(store, source, generator)))
      scale = std::max(scale, std::abs(component));
    for (int i = 0; i < store.dimension; ++i) {
      if (std::isnan(found[i])) return found[i];
      difference = std::max(difference, std::abs(found[i] - expected[i]));
    }
  }
  return difference / scale;
}

class Transplant : public testing::TestWithParam<int> {};

TEST_P(Transplant, IsExactForAllFacetsEdgesAndFractions) {
  const int D = GetParam();
  std::mt19937 generator(D);
  for (int degree = 1; degree <= (D == 3 ? 3 : max_degree); ++degree) {
    Store store = random_store(D, degree, generator);
    std::vector<TransplantRequest> requests;
    for (int facet = 0; facet < num_facet_tables(D); ++facet)
      for (int a = 0; a <= D; ++a)
        for (int b = a + 1; b <= D; ++b)
          for (const double fraction : {0.5, 0.1, 0.83})
            for (const bool keeps_a : {true, false})
              requests.push_back(append_part(store, 0, facet, cut(D, a, b, fraction, keeps_a)));
    transplant(store, requests);
    for (const TransplantRequest& request : requests)
      ASSERT_LT(difference_in_target(store, 0, request.target_slot, generator), 1e-13) << "degree " << degree;
  }
}

TEST_P(Transplant, StaysExactInChainsOfSixSplits) {
  const int D = GetParam();
  std::mt19937 generator(10 + D);
  for (int degree = 1; degree <= (D == 3 ? 3 : max_degree); ++degree)
    for (int trial = 0; trial < 4; ++trial) {
      Store store = random_store(D, degree, generator);
      int source = 0, facet = std::uniform_int_distribution<int>(0, num_facet_tables(D) - 1)(generator);
      for (int split = 0; split < 6; ++split) {
        const int a = std::uniform_int_distribution<int>(0, D - 1)(generator);
        const int b = std::uniform_int_distribution<int>(a + 1, D)(generator);
        const double fraction = trial == 0 ? 0.5 : uniform(0.2, 0.8, generator);
        const TransplantRequest request =
            append_part(store, source, facet, cut(D, a, b, fraction, std::bernoulli_distribution()(generator)));
        transplant(store, {request});
        source = request.target_slot;
        facet = D + 1;
        ASSERT_LT(difference_in_target(store, 0, source, generator), 1e-13) << "degree " << degree;
      }
    }
}

TEST_P(Transplant, GivesTheInverseJacobianOfTheTarget) {
  const int D = GetParam(), d = D + 1;
  std::mt19937 generator(20 + D);
  Store store = random_store(D, 1, generator);
  const TransplantRequest request = append_part(store, 0, D + 2, cut(D, 0, D, 0.3, true));
  transplant(store, {request});
  const Geometry geometry = element_geometry(store.elements[request.target_slot], D);
  for (int l = 0; l < d; ++l)
    for (int j = 0; j < d; ++j)
      EXPECT_NEAR(store.inverse_jacobians[(request.target_slot * d + l) * d + j], geometry.inverse[l][j], 1e-12);
}

/// The vertices of the part lie where the parent's facet has them: vertex i of the cell is its i-th listed corner.
TEST_P(Transplant, PlacesThePartOnTheCell) {
  const int D = GetParam();
  CellPart whole{};
  for (int i = 0; i <= D; ++i) whole[i][i] = 1;
  for (int facet = 0; facet < num_facet_tables(D); ++facet) {
    const TransplantRequest request = cell_part_request(D, facet, whole);
    std::vector<int> corners = facet_corners(D, facet);
    corners.push_back(facet <= D + 1 ? facet : facet - D - 2);
    for (int vertex = 0; vertex <= D + 1; ++vertex)
      for (int l = 0; l <= D; ++l) EXPECT_EQ(request.corner[vertex][l], corners[vertex] == l + 1 ? 1.0 : 0.0);
  }
}

TEST_P(Transplant, LeavesOtherSlotsUntouchedAndDoesNotDependOnTheNumberOfThreads) {
  const int D = GetParam();
  std::mt19937 generator(30 + D);
  Store store = random_store(D, 2, generator);
  std::vector<TransplantRequest> requests;
  for (int i = 0; i < 40; ++i)
    requests.push_back(append_part(store, 0, D + 1, cut(D, 0, D, uniform(0.1, 0.9, generator), i % 2)));
  const int bystander = append_slot(store, store.elements[0]);
  const Store before = store;
  Store together = store;
  transplant(store, requests);
  transplant(together, requests, host_device(), {3, 1});
  const auto same = [](const std::vector<double>& a, const std::vector<double>& b, std::size_t first,
                       std::size_t count) { return std::memcmp(&a[first], &b[first], count * sizeof(double)) == 0; };
  EXPECT_TRUE(same(store.coefficients, together.coefficients, 0, store.coefficients.size()));
  const std::size_t n = store.num_unknowns();
  for (const int slot : {0, bystander}) EXPECT_TRUE(same(store.coefficients, before.coefficients, slot * n, n));
}

TEST_P(Transplant, IsTheSameOnADeviceForAnyNumberOfRequests) {
  const std::optional<Device> device = tested_device();
  if (!device) GTEST_SKIP() << "no device in this build";
  const int D = GetParam();
  std::mt19937 generator(40 + D);
  for (const int count : tested_counts(*device)) {
    Store here = random_store(D, 3, generator);
    std::vector<TransplantRequest> requests;
    for (int i = 0; i < count; ++i)
      requests.push_back(
          append_part(here, 0, i % num_facet_tables(D), cut(D, 0, D, uniform(0.1, 0.9, generator), i % 2)));
    const Store before = here;
    transplant(here, requests);
    for (const int workers : tested_workers(*device)) {
      Store there = before;
      transplant(there, requests, *device, {workers, tested_lanes(*device)});
      for (std::size_t i = 0; i < here.coefficients.size(); ++i)
        ASSERT_NEAR(there.coefficients[i], here.coefficients[i], 1e-13);
      for (std::size_t i = 0; i < here.inverse_jacobians.size(); ++i)
        ASSERT_NEAR(there.inverse_jacobians[i], here.inverse_jacobians[i], 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Transplant, testing::Values(1, 2, 3));

}  // namespace
}  // namespace tentpole
