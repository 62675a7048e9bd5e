#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kernels/dense_coupling.hpp"

namespace tentpole {
namespace {

/// A ring, or a chain: port 1 of every element meets port 0 of the next.
Coupling random_ring(int num_elements, int per_port, double radius, std::uint32_t seed, bool closed = true) {
  Coupling ring(num_elements, 2, per_port);
  ring.set_random_responses(radius, seed);
  for (int e = 0; e + (closed ? 0 : 1) < num_elements; ++e) ring.join({e, 1}, {(e + 1) % num_elements, 0});
  return ring;
}

/// Elements of three ports, joined at random, as the cells around a vertex in space are; every third facet may be a
/// fracture.
Coupling random_patch(int num_elements, int per_port, bool with_fractures, std::uint32_t seed) {
  std::mt19937 generator(seed);
  Coupling patch(num_elements, 3, per_port);
  patch.set_random_responses(0.9, seed);
  const auto any_port = [&] { return Port{int(generator() % num_elements), int(generator() % 3)}; };
  for (int facet = 0; facet < 6 * num_elements; ++facet) {
    const Port left = any_port(), right = any_port();
    if (left.element == right.element || !patch.is_free(left) || !patch.is_free(right)) continue;
    if (with_fractures && facet % 3 == 0)
      patch.join_by_fracture(left, right, 1 + 0.1 * facet, 2, facet);
    else
      patch.join(left, right);
  }
  return patch;
}

Vector sample_waves(const Coupling& coupling) {
  Vector t(coupling.size());
  for (int i = 0; i < coupling.size(); ++i) t[i] = i % 5 - 2.0;
  return t;
}

/// Compares with the dense solution of the whole system for one and several lanes.
void expect_dense_solution(Coupling& coupling, const std::string& what) {
  const Vector t = sample_waves(coupling), expected = coupling.dense_solution(t);
  for (const int lanes : {1, 2, 3}) {
    Vector x;
    const int count = coupling.solve(t, x, lanes);
    EXPECT_GT(count, 0) << what;
    EXPECT_LT(count, 40) << what;
    for (int i = 0; i < coupling.size(); ++i)
      ASSERT_NEAR(x[i], expected[i], 2e-13 * coupling.size()) << what << ", lanes " << lanes;
  }
}

/// Two elements that face each other: x_0 = t_1 + x_1 / 4 and x_1 = t_0 + x_0 / 2 with t = (1, 2).
TEST(AmplitudeCoupling, OfTwoElementsHasTheSolutionFoundByHand) {
  Coupling pair(2, 2, 1);
  pair.join({0, 1}, {1, 0});
  pair.set(0, 1, 1, 0.5);
  pair.set(1, 0, 0, 0.25);
  Vector x;
  EXPECT_GT(pair.solve({0, 1, 2, 0}, x), 0);
  EXPECT_NEAR(x[1], 2.25 / 0.875, 1e-14);
  EXPECT_NEAR(x[2], 1 + 0.5 * 2.25 / 0.875, 1e-14);
  EXPECT_EQ(x[0], 0);
  EXPECT_EQ(x[3], 0);
}

/// One product folds the right-hand side and recovers the amplitudes that are no unknowns.
TEST(AmplitudeCoupling, WithoutWavesTakesNoStep) {
  Coupling ring = random_ring(4, 3, 0.9, 1);
  Vector x;
  EXPECT_EQ(ring.solve(Vector(ring.size(), 0.0), x), 1);
  for (const double amplitude : x) EXPECT_EQ(amplitude, 0);
}

/// An element alone: nothing comes in, and nothing is unknown.
TEST(AmplitudeCoupling, OfOneElementIsEmpty) {
  Coupling alone(1, 2, 3);
  alone.set_random_responses(0.9, 1);
  Vector x;
  EXPECT_EQ(alone.solve(sample_waves(alone), x), 1);
  for (const double amplitude : x) EXPECT_EQ(amplitude, 0);
}

TEST(AmplitudeCoupling, EqualsTheDenseSolutionOnRingsAndChains) {
  for (int num_elements = 2; num_elements <= 8; ++num_elements)
    for (const bool closed : {true, false})
      for (const int per_port : {1, 3, 12})
        for (const double radius : {0.3, 0.95, 2.0}) {
          Coupling ring = random_ring(num_elements, per_port, radius, num_elements, closed);
          expect_dense_solution(ring, (closed ? "ring of " : "chain of ") + std::to_string(num_elements) +
                                          ", per port " + std::to_string(per_port) + ", radius " +
                                          std::to_string(radius));
        }
}

TEST(AmplitudeCoupling, EqualsTheDenseSolutionOnRandomPatches) {
  for (const bool with_fractures : {false, true})
    for (const int num_elements : {3, 7, 20})
      for (const int per_port : {2, 5}) {
        Coupling patch = random_patch(num_elements, per_port, with_fractures, num_elements);
        expect_dense_solution(patch,
                              std::to_string(num_elements) + " elements" + (with_fractures ? " with fractures" : ""));
      }
}

/// Every element of the ring touches the fracture facets, or none does.
TEST(AmplitudeCoupling, EqualsTheDenseSolutionWithFracturesBetweenAllElements) {
  for (const int per_port : {1, 6}) {
    Coupling ring(4, 2, per_port);
    ring.set_random_responses(0.9, 5);
    for (int e = 0; e < 4; ++e) {
      if (e % 2 == 0) ring.join_by_fracture({e, 1}, {e + 1, 0}, 1, 3, e + 1);
      if (e % 2 == 1) ring.join({e, 1}, {(e + 1) % 4, 0});
    }
    expect_dense_solution(ring, "four fractured elements");
  }
}

/// On even rings two steps are one. Before elements were eliminated, GMRES on all amplitudes took these numbers of
/// products, folding and recovery none.
TEST(AmplitudeCoupling, TakesAboutHalfTheProductsOnEvenRings) {
  struct Case {
    int num_elements;
    double radius;
    int products_with_all_unknowns;
  };
  for (const Case& one : {Case{4, 0.95, 15}, Case{4, 2.0, 22}, Case{6, 0.95, 15}, Case{6, 2.0, 22}, Case{8, 0.95, 15},
                          Case{8, 2.0, 22}}) {
    Coupling ring = random_ring(one.num_elements, 12, one.radius, 7);
    Vector x;
    const int count = ring.solve(sample_waves(ring), x);
    EXPECT_GT(count, 1);
    EXPECT_LE(count, 0.6 * one.products_with_all_unknowns) << one.num_elements << " elements, radius " << one.radius;
  }
}

/// x_0 = 1 + x_1 and x_1 = 1 + x_0 contradict each other.
TEST(AmplitudeCoupling, ReportsASystemWithoutSolution) {
  Coupling pair(2, 2, 1);
  pair.join({0, 1}, {1, 0});
  pair.set(0, 1, 1, 1);
  pair.set(1, 0, 0, 1);
  Vector x;
  EXPECT_EQ(pair.solve({0, 1, 1, 0}, x), -1);
}

TEST(AmplitudeCoupling, ReportsAmplitudesThatAreNotFinite) {
  Coupling ring = random_ring(4, 3, 0.9, 1);
  for (const int entry : {0, 5, 7, 23}) {
    Vector t(ring.size(), 1.0), x;
    t[entry] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ring.solve(t, x), -1);
  }
}

}  // namespace
}  // namespace tentpole
