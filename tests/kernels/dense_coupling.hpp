#pragma once

#include <limits>
#include <list>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <lapacke.h>

#include "kernels/coupling/amplitude_coupling.hpp"
#include "kernels/patch/independent_elements.hpp"

namespace tentpole {

using Vector = std::vector<double>;

/// A port of an element.
struct Port {
  int element, port;
};

/// Elements with given response matrices T, joined port by port or through fracture facets. Amplitudes are those of
/// element, port, entry, in this order: places are hidden inside.
class Coupling {
 public:
  Coupling(int num_elements, int max_ports, int amplitudes_per_port)
      : num_elements_(num_elements),
        max_ports_(max_ports),
        per_port_(amplitudes_per_port),
        stride_((max_ports * amplitudes_per_port + 3) / 4 * 4),
        neighbor_(num_elements * max_ports, none),
        partner_(num_elements * max_ports, Port{none, none}),
        responses_(num_elements, Vector(stride_ * stride_, 0.0)),
        exchange_(size() * size(), 0.0) {}

  int size() const { return num_elements_ * per_element(); }
  int per_element() const { return max_ports_ * per_port_; }
  bool is_free(Port at) const { return neighbor_[link(at)] == none; }

  /// T_row,column of an element: outgoing row per incoming column.
  void set(int element, int row, int column, double value) { responses_[element][column * stride_ + row] = -value; }

  /// Every entry of T is at most radius over the length of its row.
  void set_random_responses(double radius, std::uint32_t seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int e = 0; e < num_elements_; ++e)
      for (int row = 0; row < per_element(); ++row)
        for (int column = 0; column < per_element(); ++column)
          set(e, row, column, radius * uniform(generator) / per_element());
  }

  void join(Port left, Port right) {
    neighbor_[link(left)] = right.element;
    neighbor_[link(right)] = left.element;
    partner_[link(left)] = right;
    partner_[link(right)] = left;
    for (int entry = 0; entry < per_port_; ++entry) {
      exchange_[(first(left) + entry) * size() + first(right) + entry] = 1;
      exchange_[(first(right) + entry) * size() + first(left) + entry] = 1;
    }
  }

  /// A fracture facet between two ports, of one component, with a random symmetric W.
  void join_by_fracture(Port left, Port right, double left_impedance, double right_impedance, std::uint32_t seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Fracture& fracture = fractures_.emplace_back(
        Fracture{{left, right}, {left_impedance, right_impedance}, Vector(per_port_ * per_port_), Vector(per_port_)});
    for (int row = 0; row < per_port_; ++row)
      for (int column = 0; column <= row; ++column)
        fracture.map[row * per_port_ + column] = fracture.map[column * per_port_ + row] =
            (row == column) * 0.5 + 0.3 * uniform(generator) / per_port_;
    neighbor_[link(left)] = left.element;
    neighbor_[link(right)] = right.element;
    expect_through(fracture);
  }

  /// Solution x of x = E (t + T x), and the number of products.
  int solve(const Vector& t, Vector& x, int lanes = 1) {
    place();
    Vector memory(CouplingScratch::size(size(), lanes)), placed_t = placed(t),
                                                         placed_x(size(), std::numeric_limits<double>::quiet_NaN());
    const CouplingScratch scratch = CouplingScratch::at(memory.data(), size());
    int count = 0;
    if (lanes == 1) {
      count = solve_coupling(system(), placed_t.data(), placed_x.data(), scratch, SerialLane{});
    } else {
#pragma omp parallel num_threads(lanes)
      {
        const int found = solve_coupling(system(), placed_t.data(), placed_x.data(), scratch,
                                         TeamLanes{omp_get_thread_num(), omp_get_num_threads()});
#pragma omp single
        count = found;
      }
    }
    x = unplaced(placed_x);
    return count;
  }

  /// The same by LU of the whole I - E T, built entry by entry.
  Vector dense_solution(const Vector& t) const {
    const int n = size();
    Vector matrix(n * n, 0.0), x(n, 0.0);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        x[i] += exchange_[i * n + j] * t[j];
        const int element = j / per_element();
        for (int row = 0; row < per_element(); ++row)
          matrix[i * n + j] +=
              exchange_[i * n + element * per_element() + row] * responses_[element][j % per_element() * stride_ + row];
      }
      matrix[i * n + i] += 1;
    }
    std::vector<lapack_int> pivots(n);
    EXPECT_EQ(LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, 1, matrix.data(), n, pivots.data(), x.data(), 1), 0);
    return x;
  }

 private:
  struct Fracture {
    Port side[2];
    double impedance[2];
    Vector map, intact;
  };

  int link(Port at) const {
    return at.element * max_ports_ + at.port;
  }
  int first(Port at) const {
    return link(at) * per_port_;
  }

  /// a_i = o_i + 2 s*_i with s*_0 = W s0_0 and s*_1 = -s*_0, all over sqrt(2 Z_i).
  void expect_through(const Fracture& fracture) {
    const double z0 = fracture.impedance[0], z1 = fracture.impedance[1];
    const double intact[2] = {-z1 * sqrt(2 * z0) / (z0 + z1), z0 * sqrt(2 * z1) / (z0 + z1)};
    for (int to = 0; to < 2; ++to)
      for (int row = 0; row < per_port_; ++row) {
        double* expected = &exchange_[(first(fracture.side[to]) + row) * size()];
        expected[first(fracture.side[to]) + row] += 1;
        for (int from = 0; from < 2; ++from)
          for (int column = 0; column < per_port_; ++column)
            expected[first(fracture.side[from]) + column] += (to == 0 ? 2 : -2) / sqrt(2 * fracture.impedance[to]) *
                                                             fracture.map[row * per_port_ + column] * intact[from];
      }
  }

  void place() {
    place_.resize(num_elements_);
    num_unknown_ = place_elements({num_elements_, max_ports_, neighbor_.data()}, place_.data());
    strides_.assign(num_elements_, stride_);
    num_amplitudes_.assign(num_elements_, per_element());
    pointers_.resize(num_elements_);
    source_.assign(num_elements_ * max_ports_, none);
    for (int e = 0; e < num_elements_; ++e) {
      pointers_[place_[e]] = responses_[e].data();
      for (int port = 0; port < max_ports_; ++port) {
        const Port partner = partner_[link({e, port})];
        if (partner.element != none) source_[place_[e] * max_ports_ + port] = placed_first(partner);
      }
    }
    links_.clear();
    for (Fracture& fracture : fractures_) {
      FractureLink& own = links_.emplace_back();
      own.num_components = 1;
      own.num_modes = per_port_;
      own.map = fracture.map.data();
      own.intact = fracture.intact.data();
      for (int side = 0; side < 2; ++side) {
        own.first[side] = placed_first(fracture.side[side]);
        own.impedance[side][0] = fracture.impedance[side];
      }
    }
  }
  int placed_first(Port at) const {
    return first({place_[at.element], at.port});
  }
  Vector placed(const Vector& by_element) const {
    Vector moved(size());
    for (int i = 0; i < size(); ++i)
      moved[place_[i / per_element()] * per_element() + i % per_element()] = by_element[i];
    return moved;
  }
  Vector unplaced(const Vector& by_place) const {
    Vector moved(size());
    for (int i = 0; i < size(); ++i) moved[i] = by_place[place_[i / per_element()] * per_element() + i % per_element()];
    return moved;
  }

  AmplitudeSystem system() const {
    AmplitudeSystem view{};
    view.num_elements = num_elements_;
    view.num_unknown_elements = num_unknown_;
    view.amplitudes_per_port = per_port_;
    view.max_amplitudes = per_element();
    view.place = place_.data();
    view.response = pointers_.data();
    view.response_stride = strides_.data();
    view.num_amplitudes = num_amplitudes_.data();
    view.source = source_.data();
    view.max_ports = max_ports_;
    view.num_fractures = static_cast<int>(links_.size());
    view.fractures = links_.data();
    return view;
  }

  int num_elements_, max_ports_, per_port_, stride_, num_unknown_ = 0;
  std::vector<int> neighbor_;
  std::vector<Port> partner_;
  std::vector<Vector> responses_;
  Vector exchange_;  ///< E, [to][from]
  std::list<Fracture> fractures_;
  std::vector<const double*> pointers_;
  std::vector<int> place_, strides_, num_amplitudes_, source_;
  std::vector<FractureLink> links_;
};

}  // namespace tentpole
