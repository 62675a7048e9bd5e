#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "kernels/patch/dense_patch_solve.hpp"
#include "kernels/reference/patch_matrix.reference.hpp"
#include "kernels/reference/point_state.reference.hpp"
#include "tests/kernels/tent_samples.hpp"

namespace tentpole {
namespace {

std::vector<double> solve(TentBatch& batch, int patch, double kappa = 1) {
  const DensePatch system = reference_patch_system(batch.view(), batch.dimension, batch.degree, patch, kappa);
  std::vector<double> solution(system.size);
  double residual = 0;
  DenseSolveScratch scratch;
  EXPECT_EQ(solve_dense_patch(system.matrix, system.rhs, solution, residual, scratch), Status::ok);
  EXPECT_LT(residual, 1e-13);
  return solution;
}

/// Largest difference from `expected` relative to its largest entry.
double relative_error(const std::vector<double>& solution, const double* expected) {
  double error = 0, scale = 0;
  for (std::size_t a = 0; a < solution.size(); ++a) {
    error = std::max(error, std::abs(solution[a] - expected[a]));
    scale = std::max(scale, std::abs(expected[a]));
  }
  return error / scale;
}

/// Worst error of all patches of the batch against the exact coefficients.
double patch_test_error(TentBatch batch) {
  double worst = 0;
  for (int patch = 0; patch < static_cast<int>(batch.patches.size()); ++patch) {
    const int first = batch.patches[patch].first_element;
    worst = std::max(worst, relative_error(solve(batch, patch), &batch.exact[first * batch.num_unknowns()]));
  }
  return worst;
}

int highest_degree(int dimension) {
  return dimension == 3 ? 2 : 4;
}

TEST(ReferencePatchSystem, ReproducesRandomPolynomialsOnRandomTents) {
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (int degree = 1; degree <= highest_degree(dimension); ++degree) {
      TentOptions options;
      options.num_patches = dimension == 3 ? 3 : 8;
      EXPECT_LT(patch_test_error(random_tents(dimension, degree, options, 10 * dimension + degree)), 1e-11)
          << "dimension " << dimension << ", degree " << degree;
    }
}

TEST(ReferencePatchSystem, ReproducesPolynomialsOfHighDegree) {
  TentOptions options;
  options.boundary_fraction = 1;
  EXPECT_LT(patch_test_error(random_tents(3, 3, options, 4)), 1e-11);
  EXPECT_LT(patch_test_error(random_tents(3, 4, options, 4)), 1e-10);
  EXPECT_LT(patch_test_error(random_tents(1, 7, options, 1)), 1e-9);
  EXPECT_LT(patch_test_error(random_tents(2, 6, options, 2)), 1e-9);
}

TEST(ReferencePatchSystem, ReproducesPolynomialsWithEveryPairOfBoundaryKinds) {
  const BoundaryKind kinds[] = {BoundaryKind::traction, BoundaryKind::velocity, BoundaryKind::absorbing};
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (const BoundaryKind normal : kinds)
      for (const BoundaryKind tangential : kinds) {
        TentOptions options;
        options.boundary_fraction = 1;
        options.data.normal_kind = normal;
        options.data.tangential_kind = tangential;
        EXPECT_LT(patch_test_error(random_tents(dimension, dimension == 3 ? 1 : 2, options, 7)), 1e-11)
            << "dimension " << dimension << ", kinds " << int(normal) << " " << int(tangential);
      }
}

TEST(ReferencePatchSystem, ReproducesPolynomialsFromInitialDataAloneAndFromSourcesAlone) {
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (const double source_fraction : {0.0, 1.0}) {
      TentOptions options;
      options.data.source_fraction = source_fraction;
      EXPECT_LT(patch_test_error(random_tents(dimension, 2, options, 3)), 1e-11);
    }
}

TEST(ReferencePatchSystem, ReproducesTranslationsOfSeveralMaterials) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    TentOptions options;
    options.num_patches = 2;
    options.num_materials = 3;
    EXPECT_LT(patch_test_error(random_tents(dimension, 2, options, 5)), 1e-11);
  }
}

TEST(ReferencePatchSystem, ReproducesAKinkBetweenTwoMaterials) {
  // u = f(t) + p(x, t) / (lambda + 2 mu) with p(0, t) = 0: velocity and traction are continuous where the materials
  // meet.
  std::mt19937 generator(8);
  TentBatch batch;
  batch.dimension = 1;
  batch.degree = 3;
  std::vector<PolynomialField> fields;
  for (int side = 0; side < 2; ++side) {
    batch.materials.push_back(random_material(generator));
    const double modulus = batch.materials[side].lambda + 2 * batch.materials[side].mu;
    PolynomialField field(1, 3);
    for (int x = 0; x <= 3; ++x)
      for (int t = 0; x + t <= 3; ++t) field.coefficient(0, {x, t}) = (1 + x - 0.7 * t) / (x > 0 ? modulus : 1);
    fields.push_back(field);
  }
  TentGeometry tent = line_star(false, generator);
  raise_tent(tent, {1.4, 1.4}, 0.5, 0.9, generator);
  append_tent(batch, tent, {0, 1}, fields, {}, generator);
  EXPECT_LT(patch_test_error(batch), 1e-11);
}

TEST(ReferencePatchSystem, ReproducesPolynomialsOnSkewedAndLowTents) {
  TentOptions options;
  options.num_patches = 4;
  options.shape = {5, 150, 0.1};
  options.height_fraction = 0.05;
  EXPECT_LT(patch_test_error(random_tents(2, 2, options, 11)), 1e-9);
  options.num_patches = 1;
  EXPECT_LT(patch_test_error(random_tents(3, 1, options, 12)), 1e-9);
}

TEST(ReferencePatchSystem, SolutionDoesNotDependOnKappa) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    TentOptions options;
    options.data.homogeneous = true;  // not a polynomial of the space: the solution is a true approximation
    TentBatch batch = random_tents(dimension, 2, options, 21);
    const std::vector<double> expected = solve(batch, 0, 1);
    EXPECT_LT(relative_error(solve(batch, 0, 0.1), expected.data()), 1e-11);
    EXPECT_LT(relative_error(solve(batch, 0, 10), expected.data()), 1e-11);
  }
}

TEST(ReferencePatchSystem, SymmetricPartIsPositiveOnRandomVectors) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    TentOptions options;
    options.num_materials = 2;
    options.num_patches = 3;
    TentBatch batch = random_tents(dimension, 2, options, 31);
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int patch = 0; patch < 3; ++patch) {
      const DensePatch system = reference_patch_system(batch.view(), dimension, 2, patch);
      const std::size_t size = system.size;
      for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> x(size);
        for (double& entry : x) entry = uniform(generator);
        double form = 0;
        for (std::size_t a = 0; a < size; ++a)
          for (std::size_t b = 0; b < size; ++b) form += x[a] * system.matrix[a * size + b] * x[b];
        EXPECT_GT(form, 0);
      }
    }
  }
}

/// int 1/2 w^T A_N w over a front facet for the upward normal, at points where state_at(q) gives the fields.
template <typename StateAt>
double front_energy(const reference::Discretization& disc, reference::Vector upward, const Material& material,
                    StateAt state_at) {
  const int D = disc.dimension;
  double energy = 0;
  for (int q = 0; q < disc.facet_rule.num_points(); ++q) {
    const reference::PointState state = state_at(reference::facet_barycentric(disc, q));
    double density = 0;
    for (int i = 0; i < D; ++i) {
      density += 0.5 * upward[D] * material.density * state.velocity[i][0] * state.velocity[i][0];
      for (int j = 0; j < D; ++j) {
        density += 0.5 * upward[D] * state.strain[i * D + j][0] * state.stress[i * D + j][0];
        density -= state.velocity[i][0] * state.stress[i * D + j][0] * upward[j];
      }
    }
    energy += disc.facet_rule.weights[q] * density;
  }
  return energy;
}

struct PatchEnergy {
  double below = 0, above = 0;
};

PatchEnergy solved_patch_energy(TentBatch& batch, int patch) {
  const reference::Discretization disc(batch.dimension, batch.degree);
  const std::vector<double> solution = solve(batch, patch);
  const PatchBatch view = batch.view();
  const int D = batch.dimension, first = batch.patches[patch].first_element;
  PatchEnergy energy;
  for (int e = 0; e < batch.patches[patch].num_elements; ++e) {
    const ElementDescriptor& element = batch.elements[first + e];
    const Material& material = batch.materials[element.material];
    const reference::Geometry geometry = reference::element_geometry(element, D);
    reference::Vector below = reference::facet_covector(geometry, D, D + 1);
    for (double& component : below) component = -component;
    energy.below += front_energy(disc, below, material, [&](const reference::Row& barycentric) {
      return reference::state_below(disc, view, element, D + 1, barycentric);
    });
    const auto corners = reference::facet_corners(D, facet_table(element, D, element.pole));
    energy.above += front_energy(
        disc, reference::facet_covector(geometry, D, element.pole), material, [&](const reference::Row& barycentric) {
          const auto state =
              reference::point_state(disc, geometry.inverse, material, reference::element_point(barycentric, corners));
          return reference::evaluate(state, &solution[e * disc.num_unknowns]);
        });
  }
  return energy;
}

TEST(ReferencePatchSystem, EnergyOfHomogeneousDataDoesNotIncrease) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    TentOptions options;
    options.num_patches = 4;
    options.num_materials = 1;
    options.data.homogeneous = true;
    TentBatch batch = random_tents(dimension, 2, options, 41);
    for (int patch = 0; patch < options.num_patches; ++patch) {
      const PatchEnergy energy = solved_patch_energy(batch, patch);
      EXPECT_GT(energy.below, 0);
      EXPECT_GT(energy.above, 0);
      EXPECT_LE(energy.above, energy.below) << "dimension " << dimension << ", patch " << patch;
    }
  }
}

TEST(ReferencePatchSystem, LinearFieldsKeepTheirEnergyAcrossAClosedTent) {
  // Constant velocity and strain without body force: what enters an interior tent leaves it, and the jump terms vanish.
  TentOptions options;
  options.boundary_fraction = 0;
  for (int dimension = 1; dimension <= 3; ++dimension) {
    TentBatch batch = random_tents(dimension, 1, options, 51);
    const PatchEnergy energy = solved_patch_energy(batch, 0);
    EXPECT_NEAR(energy.above / energy.below, 1, 1e-11);
  }
}

}  // namespace
}  // namespace tentpole
