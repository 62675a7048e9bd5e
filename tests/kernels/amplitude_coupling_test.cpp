#include "kernels/amplitude_coupling.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <lapacke.h>

#include "kernels/patch_batch.hpp"

namespace tentpole {
namespace {

/// A chain or ring of elements with two ports each and given response matrices T [element][R][R].
class Coupling {
 public:
  Coupling(int num_elements, int amplitudes_per_port, bool closed)
      : num_elements_(num_elements), per_port_(amplitudes_per_port), stride_((2 * amplitudes_per_port + 3) / 4 * 4) {
    responses_.assign(num_elements, std::vector<double>(stride_ * stride_, 0.0));
    for (int e = 0; e < num_elements; ++e) {
      strides_.push_back(stride_);
      num_amplitudes_.push_back(2 * per_port_);
      const bool first = e == 0 && !closed, last = e + 1 == num_elements && !closed;
      source_.push_back(first ? none : (e + num_elements - 1) % num_elements * 2 * per_port_ + per_port_);
      source_.push_back(last ? none : (e + 1) % num_elements * 2 * per_port_);
    }
    for (const auto& response : responses_) pointers_.push_back(response.data());
  }

  /// T_row,column of an element: outgoing row per incoming column.
  void set(int element, int row, int column, double value) { responses_[element][column * stride_ + row] = -value; }
  int size() const { return num_elements_ * 2 * per_port_; }

  /// exchange(t): what arrives at each port when the elements emit t.
  std::vector<double> exchange(const std::vector<double>& emitted) const {
    std::vector<double> incoming(size());
    exchange_amplitudes(system(), emitted.data(), incoming.data(), SerialLane{});
    return incoming;
  }

  /// Solution x of x = exchange(t) + exchange(T x), and the number of products.
  int solve(std::vector<double>& x, int lanes = 1) const {
    std::vector<double> memory(CouplingScratch::size(size(), lanes));
    const CouplingScratch scratch = CouplingScratch::at(memory.data(), size());
    if (lanes == 1) return solve_coupling(system(), x.data(), scratch, SerialLane{});
    int count = 0;
#pragma omp parallel num_threads(lanes)
    {
      const int found =
          solve_coupling(system(), x.data(), scratch, TeamLanes{omp_get_thread_num(), omp_get_num_threads()});
#pragma omp single
      count = found;
    }
    return count;
  }

  /// I - exchange T, dense.
  std::vector<double> matrix() const {
    std::vector<double> dense(size() * size(), 0.0), unit(size()), column(size()), product(size() + 4);
    for (int j = 0; j < size(); ++j) {
      std::fill(unit.begin(), unit.end(), 0.0);
      unit[j] = 1;
      apply_coupling(system(), unit.data(), product.data(), column.data(), SerialLane{});
      for (int i = 0; i < size(); ++i) dense[i * size() + j] = column[i];
    }
    return dense;
  }

 private:
  AmplitudeSystem system() const {
    AmplitudeSystem view{};
    view.num_elements = num_elements_;
    view.amplitudes_per_port = per_port_;
    view.max_amplitudes = 2 * per_port_;
    view.response = pointers_.data();
    view.response_stride = strides_.data();
    view.num_amplitudes = num_amplitudes_.data();
    view.source = source_.data();
    view.max_ports = 2;
    return view;
  }

  int num_elements_, per_port_, stride_;
  std::vector<std::vector<double>> responses_;
  std::vector<const double*> pointers_;
  std::vector<int> strides_, num_amplitudes_, source_;
};

/// A ring whose responses have norm below `radius`.
Coupling random_ring(int num_elements, int per_port, double radius, std::uint32_t seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Coupling ring(num_elements, per_port, true);
  for (int e = 0; e < num_elements; ++e)
    for (int row = 0; row < 2 * per_port; ++row)
      for (int column = 0; column < 2 * per_port; ++column)
        ring.set(e, row, column, radius * uniform(generator) / (2 * per_port));
  return ring;
}

/// Two elements that face each other: x_0 = t_1 + x_1 / 4 and x_1 = t_0 + x_0 / 2 with t = (1, 2).
TEST(AmplitudeCoupling, OfTwoElementsHasTheSolutionFoundByHand) {
  Coupling pair(2, 1, false);
  pair.set(0, 1, 1, 0.5);
  pair.set(1, 0, 0, 0.25);
  std::vector<double> x = pair.exchange({0, 1, 2, 0});
  ASSERT_EQ(x, (std::vector<double>{0, 2, 1, 0}));
  EXPECT_GT(pair.solve(x), 0);
  EXPECT_NEAR(x[1], 2.25 / 0.875, 1e-14);
  EXPECT_NEAR(x[2], 1 + 0.5 * 2.25 / 0.875, 1e-14);
  EXPECT_EQ(x[0], 0);
  EXPECT_EQ(x[3], 0);
}

TEST(AmplitudeCoupling, WithoutWavesNeedsNoProduct) {
  const Coupling ring = random_ring(4, 3, 0.9, 1);
  std::vector<double> x(ring.size(), 0.0);
  EXPECT_EQ(ring.solve(x), 0);
  for (const double amplitude : x) EXPECT_EQ(amplitude, 0);
}

TEST(AmplitudeCoupling, EqualsTheDenseSolutionForAnyNumberOfLanes) {
  for (const int per_port : {1, 12})
    for (const int lanes : {1, per_port == 1 ? 3 : 2}) {
      const Coupling ring = random_ring(6, per_port, 0.95, per_port);
      std::vector<double> x(ring.size());
      for (int i = 0; i < ring.size(); ++i) x[i] = i % 5 - 2.0;
      std::vector<double> expected = x, dense = ring.matrix();
      std::vector<lapack_int> pivots(ring.size());
      ASSERT_EQ(
          LAPACKE_dgesv(LAPACK_ROW_MAJOR, ring.size(), 1, dense.data(), ring.size(), pivots.data(), expected.data(), 1),
          0);
      const int count = ring.solve(x, lanes);
      EXPECT_GT(count, 0);
      EXPECT_LT(count, 60);
      for (int i = 0; i < ring.size(); ++i)
        EXPECT_NEAR(x[i], expected[i], 1e-12) << "per port " << per_port << " lanes " << lanes;
    }
}

/// x_0 = 1 + x_1 and x_1 = 1 + x_0 contradict each other.
TEST(AmplitudeCoupling, ReportsASystemWithoutSolution) {
  Coupling pair(2, 1, false);
  pair.set(0, 1, 1, 1);
  pair.set(1, 0, 0, 1);
  std::vector<double> x = {0, 1, 1, 0};
  EXPECT_EQ(pair.solve(x), -1);
}

TEST(AmplitudeCoupling, ReportsAmplitudesThatAreNotFinite) {
  const Coupling ring = random_ring(4, 3, 0.9, 1);
  std::vector<double> x(ring.size(), 1.0);
  x[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ring.solve(x), -1);
}

}  // namespace
}  // namespace tentpole
