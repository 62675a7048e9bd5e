#include "tests/kernels/general_patches.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "kernels/patch/dense_patch_solve.hpp"
#include "kernels/reference/inclined_facet.reference.hpp"
#include "kernels/reference/patch_matrix.reference.hpp"
#include "tests/device/tested_device.hpp"
#include "tests/kernels/dense_comparison.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

constexpr double smallest_energy = 1e-3;

int num_samples(GeneralKind kind) {
  return kind == GeneralKind::square ? 1 : 5;
}

/// Largest difference from the known polynomial, relative to the largest coefficient of the patch.
double error_against_polynomial(const TentBatch& batch) {
  double error = 0;
  const int n = batch.num_unknowns();
  for (const PatchDescriptor& patch : batch.patches) {
    double difference = 0, scale = 0;
    for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e)
      for (int i = 0; i < n; ++i) {
        const double found = batch.coefficients[batch.elements[e].result_slot * n + i], exact = batch.exact[e * n + i];
        if (std::isnan(found)) return found;
        difference = std::max(difference, std::abs(found - exact));
        scale = std::max(scale, std::abs(exact));
      }
    error = std::max(error, difference / scale);
  }
  return error;
}

void expect_solved(const TentBatch& batch, const char* name) {
  for (const ElementRecord& record : batch.records) {
    EXPECT_EQ(record.status, int(Status::ok)) << status_name(Status(record.status)) << ", " << name;
    EXPECT_LT(record.residual, 1e-12) << name;
  }
}

/// Facets of the batch that are inclined, and those of them that let displacement in.
struct InclinedCount {
  int facets = 0, entries = 0;
};
InclinedCount count_inclined(const TentBatch& batch) {
  const reference::Discretization disc(batch.dimension, 1);
  InclinedCount count;
  for (const ElementDescriptor& element : batch.elements)
    for (int facet = 0; facet <= batch.dimension + 1; ++facet) {
      if (!reference::is_inclined(disc, element, facet)) continue;
      const auto geometry = reference::element_geometry(element, batch.dimension);
      ++count.facets;
      count.entries += reference::facet_covector(geometry, batch.dimension, facet)[batch.dimension] < 0;
    }
  return count;
}

class GeneralPatches : public testing::TestWithParam<int> {};

/// One of the two sides of an inclined facet has N_t < 0.
TEST_P(GeneralPatches, AreWhatTheyAreCalled) {
  for (const GeneralKind kind : general_kinds(GetParam())) {
    const TentBatch batch = general_patches(GetParam(), 1, kind, num_samples(kind), {}, 1);
    const InclinedCount count = count_inclined(batch);
    EXPECT_EQ(count.facets, 2 * count.entries) << name_of(kind);
    const bool without =
        kind == GeneralKind::flip || kind == GeneralKind::square || (GetParam() == 1 && kind == GeneralKind::deletion);
    EXPECT_EQ(count.facets == 0, without) << name_of(kind);
    std::set<int> outflow_facets;
    for (const ElementDescriptor& element : batch.elements)
      for (int facet = 0; facet <= GetParam() + 1; ++facet)
        if (element.facet_kind[facet] == FacetKind::outflow) outflow_facets.insert(facet);
    EXPECT_GT(outflow_facets.size(), num_samples(kind) > 1 ? 1u : 0u) << name_of(kind);
    EXPECT_TRUE(std::all_of(batch.patches.begin(), batch.patches.end(),
                            [](const PatchDescriptor& patch) { return patch.is_general == 1; }));
  }
}

TEST_P(GeneralPatches, OfTheReferenceReproducePolynomials) {
  for (const GeneralKind kind : general_kinds(GetParam()))
    for (int degree = 1; degree <= 3; ++degree) {
      TentBatch batch = general_patches(GetParam(), degree, kind, 2, {}, 10 + degree);
      const int n = batch.num_unknowns();
      for (int p = 0; p < int(batch.patches.size()); ++p) {
        const DensePatch dense = reference_patch_system(batch.view(), GetParam(), degree, p);
        std::vector<double> solution(dense.size);
        double residual = 0;
        DenseSolveScratch scratch;
        ASSERT_EQ(solve_dense_patch(dense.matrix, dense.rhs, solution, residual, scratch), Status::ok);
        for (int i = 0; i < dense.size; ++i) {
          const int e = batch.patches[p].first_element + i / n;
          batch.coefficients[batch.elements[e].result_slot * n + i % n] = solution[i];
        }
      }
      EXPECT_LT(error_against_polynomial(batch), 1e-11) << name_of(kind) << ", degree " << degree;
    }
}

TEST_P(GeneralPatches, ReproducePolynomials) {
  for (const GeneralKind kind : general_kinds(GetParam()))
    for (int degree = 1; degree <= 4; ++degree) {
      const TentBatch batch = solved(general_patches(GetParam(), degree, kind, num_samples(kind), {}, 20 + degree));
      expect_solved(batch, name_of(kind));
      EXPECT_LT(error_against_polynomial(batch), 1e-11) << name_of(kind) << ", degree " << degree;
    }
}

/// Data below that are no polynomial of the space: every element of the patch jumps against its neighbours.
TentData rough_data() {
  TentData data;
  data.homogeneous = true;
  data.normal_kind = BoundaryKind::velocity;
  data.tangential_kind = BoundaryKind::traction;
  return data;
}

TentBatch rough_patches(int dimension, int degree, GeneralKind kind, std::uint32_t seed) {
  TentBatch batch = general_patches(dimension, degree, kind, num_samples(kind), rough_data(), seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (double& coefficient : batch.coefficients)
    if (!std::isnan(coefficient)) coefficient += uniform(generator);
  for (double& value : batch.prescribed) value += uniform(generator);
  return batch;
}

TEST_P(GeneralPatches, EqualTheDenseSolution) {
  for (const GeneralKind kind : general_kinds(GetParam()))
    for (int degree = 1; degree <= 3; ++degree) {
      TentBatch batch = solved(rough_patches(GetParam(), degree, kind, 30 + degree));
      expect_solved(batch, name_of(kind));
      const DenseComparison comparison = compare_with_dense(batch);
      EXPECT_LT(comparison.coefficients, 4 * 2.3e-16 * comparison.condition + 1e-14)
          << name_of(kind) << ", degree " << degree;
      EXPECT_LT(comparison.energy, 1e-12) << name_of(kind) << ", degree " << degree;
    }
}

TEST_P(GeneralPatches, BalanceTheirEnergyAndOnlyLoseIt) {
  for (const GeneralKind kind : general_kinds(GetParam()))
    for (int degree = 1; degree <= 4; ++degree) {
      const TentBatch batch = solved(rough_patches(GetParam(), degree, kind, 40 + degree));
      for (const PatchDescriptor& patch : batch.patches) {
        double change = 0, dissipation = 0, work = 0, largest = smallest_energy;
        for (int e = patch.first_element; e < patch.first_element + patch.num_elements; ++e) {
          const ElementRecord& record = batch.records[e];
          change += record.outflow_energy - record.inflow_energy;
          dissipation += record.dissipation;
          work += record.external_work;
          largest = std::max({largest, record.inflow_energy, record.outflow_energy});
          EXPECT_GE(record.dissipation, 0) << name_of(kind);
          EXPECT_GE(record.initial_energy, 0) << name_of(kind);
          EXPECT_LE(record.initial_energy, record.inflow_energy * (1 + 1e-14)) << name_of(kind);
        }
        EXPECT_NEAR((change + dissipation - work) / largest, 0, 1e-12) << name_of(kind) << ", degree " << degree;
        EXPECT_GT(dissipation, 1e-6 * largest) << name_of(kind) << ", degree " << degree;
      }
    }
}

TEST_P(GeneralPatches, AreTheSameOnADevice) {
  const std::optional<Device> device = tested_device();
  if (!device) GTEST_SKIP() << "no device in this build";
  for (const GeneralKind kind : general_kinds(GetParam()))
    for (int degree = 1; degree <= 3; ++degree) {
      const TentBatch batch = rough_patches(GetParam(), degree, kind, 50 + degree), here = solved(batch);
      for (const LaunchShape shape : {LaunchShape{2, tested_lanes(*device)}, LaunchShape{1, 4}}) {
        const TentBatch there = solved(batch, *device, shape);
        double scale = 0, difference = 0, energy = 0, energy_difference = 0;
        for (std::size_t i = 0; i < here.coefficients.size(); ++i) {
          scale = std::max(scale, std::abs(here.coefficients[i]));
          ASSERT_FALSE(std::isnan(there.coefficients[i]));
          difference = std::max(difference, std::abs(here.coefficients[i] - there.coefficients[i]));
        }
        for (std::size_t e = 0; e < here.records.size(); ++e) {
          const ElementRecord &a = here.records[e], &b = there.records[e];
          EXPECT_EQ(b.status, int(Status::ok)) << name_of(kind);
          energy = std::max(energy, a.inflow_energy);
          energy_difference =
              std::max({energy_difference, std::abs(a.outflow_energy - b.outflow_energy),
                        std::abs(a.dissipation - b.dissipation), std::abs(a.initial_energy - b.initial_energy)});
        }
        EXPECT_LT(difference, 1e-11 * scale) << name_of(kind) << ", degree " << degree << ", lanes " << shape.lanes;
        EXPECT_LT(energy_difference, 1e-11 * energy) << name_of(kind) << ", degree " << degree;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, GeneralPatches, testing::Values(1, 2));

}  // namespace
}  // namespace tentpole
