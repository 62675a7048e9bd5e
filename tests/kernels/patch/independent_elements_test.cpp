#include "kernels/patch/independent_elements.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

/// Elements joined by facets.
class Joined {
 public:
  Joined(int num_elements, int max_ports) : max_ports_(max_ports), neighbor_(num_elements * max_ports, none) {}

  int num_elements() const { return static_cast<int>(neighbor_.size()) / max_ports_; }
  int free_port(int element) const {
    const auto first = neighbor_.begin() + element * max_ports_;
    const int port = static_cast<int>(std::find(first, first + max_ports_, none) - first);
    return port < max_ports_ ? port : none;
  }
  /// Joins two elements, or lets one reflect, where both have a port left.
  void join(int left, int right) {
    if (free_port(left) == none || free_port(right) == none) return;
    neighbor_[left * max_ports_ + free_port(left)] = right;
    if (left != right) neighbor_[right * max_ports_ + free_port(right)] = left;
  }
  ElementGraph graph() const { return {num_elements(), max_ports_, neighbor_.data()}; }
  std::vector<int> places() const {
    std::vector<int> place(num_elements());
    place_elements(graph(), place.data());
    return place;
  }
  int num_unknown() const {
    std::vector<int> place(num_elements());
    return place_elements(graph(), place.data());
  }

 private:
  int max_ports_;
  std::vector<int> neighbor_;
};

/// A ring whose elements are numbered in any order, or a chain.
Joined ring_of(int num_elements, bool closed, std::uint32_t seed) {
  std::vector<int> order(num_elements);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  Joined ring(num_elements, 2);
  for (int e = 0; e + (closed ? 0 : 1) < num_elements; ++e) ring.join(order[e], order[(e + 1) % num_elements]);
  return ring;
}

/// Elements of up to three or four ports, joined at random; some reflect.
Joined random_patch(std::uint32_t seed) {
  std::mt19937 generator(seed);
  const int num_elements = 1 + static_cast<int>(generator() % 30);
  Joined patch(num_elements, 3 + static_cast<int>(generator() % 2));
  for (int facet = 0; facet < 3 * num_elements; ++facet) {
    const int left = static_cast<int>(generator() % num_elements);
    const int right = static_cast<int>(generator() % num_elements);
    if (left != right || generator() % 2 == 0) patch.join(left, right);
  }
  return patch;
}

TEST(IndependentElements, AreHalfOfARingOrChainHoweverItIsNumbered) {
  for (int num_elements = 2; num_elements <= 9; ++num_elements)
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
      EXPECT_EQ(ring_of(num_elements, true, seed).num_unknown(), (num_elements + 1) / 2) << "ring " << num_elements;
      EXPECT_EQ(ring_of(num_elements, false, seed).num_unknown(), num_elements / 2) << "chain " << num_elements;
    }
}

TEST(IndependentElements, HaveNoNeighbourAmongThemAndNoFractureFacet) {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    const Joined patch = random_patch(seed);
    const ElementGraph graph = patch.graph();
    const std::vector<int> place = patch.places();
    const int num_unknown = patch.num_unknown();
    for (int element = 0; element < graph.num_elements; ++element)
      for (int port = 0; port < graph.max_ports; ++port) {
        const int other = graph.across(element, port);
        if (place[element] >= num_unknown && other != none) {
          EXPECT_LT(place[other], num_unknown) << "seed " << seed;
          EXPECT_FALSE(graph.reflects(element)) << "seed " << seed;
        }
      }
  }
}

/// No element could join the set: one that does not reflect has a neighbour in it.
TEST(IndependentElements, LeaveNoElementOutThatCouldJoin) {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    const Joined patch = random_patch(seed);
    const ElementGraph graph = patch.graph();
    const std::vector<int> place = patch.places();
    const int num_unknown = patch.num_unknown();
    for (int element = 0; element < graph.num_elements; ++element) {
      if (place[element] >= num_unknown || graph.reflects(element)) continue;
      int chosen_neighbors = 0;
      for (int port = 0; port < graph.max_ports; ++port) {
        const int other = graph.across(element, port);
        chosen_neighbors += other != none && place[other] >= num_unknown;
      }
      EXPECT_GT(chosen_neighbors, 0) << "seed " << seed << " element " << element;
    }
  }
}

TEST(IndependentElements, TakeTheLastPlacesInAscendingOrder) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    const Joined patch = random_patch(seed);
    const std::vector<int> place = patch.places();
    std::vector<int> element_at(place.size(), none);
    for (std::size_t element = 0; element < place.size(); ++element) element_at.at(place[element]) = int(element);
    EXPECT_EQ(std::count(element_at.begin(), element_at.end(), none), 0);
    const auto middle = element_at.begin() + patch.num_unknown();
    EXPECT_TRUE(std::is_sorted(element_at.begin(), middle));
    EXPECT_TRUE(std::is_sorted(middle, element_at.end()));
  }
}

TEST(IndependentElements, IncludeAnElementAloneUnlessItReflects) {
  Joined alone(1, 2);
  EXPECT_EQ(alone.num_unknown(), 0);
  alone.join(0, 0);
  EXPECT_EQ(alone.num_unknown(), 1);
}

}  // namespace
}  // namespace tentpole
