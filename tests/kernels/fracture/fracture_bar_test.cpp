#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "tests/kernels/cracked_tents.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

/// A state of uniaxial strain; density and wave speed 1.
struct State {
  double velocity, stress;
};

/// A bar of two cells with the vertices 0, 1, 2 at -0.5, 0, 0.5 and a crack at vertex 1, advanced tent by tent. Both
/// ends absorb and let in the waves of given far fields, so that the bar is as good as endless.
class CrackedBar {
 public:
  CrackedBar(int degree, const FractureLaw& law, State left, State right, const CrackState& crack = {})
      : crack_(crack) {
    batch_.dimension = 1;
    batch_.degree = degree;
    batch_.materials = {{1, 0.4, 0.3}};
    batch_.fracture_law = law;
    far_[0] = left, far_[1] = right;
    for (int cell = 0; cell < 2; ++cell) slot_[cell] = none;
  }

  double time() const { return time_[1]; }
  double damage() const { return crack_.damage; }
  double gap() const { return crack_.gap; }
  const FractureRecord& last() const { return batch_.fracture_records[0]; }
  double worst_closure() const { return worst_closure_; }
  /// The wave that comes in through an end from now on.
  void set_far_field(int end, State far) { far_[end] = far; }

  /// Raises the ends, then the crack, all to `time`.
  void advance(double time) {
    for (const int vertex : {0, 2, 1}) raise(vertex, time);
  }

 private:
  /// Offset of an initial data block of a constant state on a cell that starts at `origin`.
  int constant_block(State state, double origin) {
    const int offset = static_cast<int>(batch_.prescribed.size()), modes = num_polynomials(1, batch_.degree - 1);
    for (const double value : {state.velocity, state.stress}) {
      batch_.prescribed.push_back(value);
      batch_.prescribed.resize(batch_.prescribed.size() + modes - 1, 0.0);
    }
    // u = stress (x - x_1), continuous at the crack: its mean over the cell, then its slope mode, sqrt(3) (2 x - 1).
    batch_.prescribed.push_back(state.stress * (origin + 0.25));
    batch_.prescribed.push_back(state.stress * 0.25 / std::sqrt(3.0));
    return offset;
  }

  int far_block(int end) {
    const int offset = static_cast<int>(batch_.prescribed.size());
    const double sign = end == 0 ? -1 : 1;  // traction on the outward normal plus Z velocity
    batch_.prescribed.push_back(sign * far_[end].stress + far_[end].velocity);
    batch_.prescribed.resize(offset + num_polynomials(1, batch_.degree - 1), 0.0);
    return offset;
  }

  ElementDescriptor element_over(int cell, int vertex, double top) {
    ElementDescriptor element{};
    for (int corner = 0; corner < 2; ++corner) {
      element.corner[corner][0] = 0.5 * (cell + corner) - 0.5;
      element.corner[corner][1] = time_[cell + corner];
    }
    element.pole = vertex - cell;
    element.corner[2][0] = element.corner[element.pole][0];
    element.corner[2][1] = top;
    element.body_force_data = none;
    for (int facet = 0; facet < 3; ++facet) {
      element.neighbor[facet] = element.source_slot[facet] = element.facet_data[facet] = none;
      element.facet_kind[facet] = FacetKind::boundary;
      element.normal_kind[facet] = element.tangential_kind[facet] = BoundaryKind::absorbing;
    }
    element.facet_kind[2] = FacetKind::inflow;
    element.facet_kind[element.pole] = FacetKind::outflow;
    element.source_slot[2] = slot_[cell];
    element.source_facet[2] = static_cast<std::uint8_t>(code_[cell]);
    if (slot_[cell] == none) element.facet_data[2] = constant_block(far_[cell], cell == 0 ? -0.5 : 0.0);
    element.result_slot = batch_.num_slots();
    batch_.coefficients.resize(batch_.coefficients.size() + batch_.num_unknowns());
    batch_.inverse_jacobians.resize(batch_.inverse_jacobians.size() + 4);
    slot_[cell] = element.result_slot;
    code_[cell] = facet_table(element, 1, element.pole);
    return element;
  }

  void raise(int vertex, double top) {
    batch_.elements.clear();
    batch_.fracture_facets.clear();
    batch_.fracture_records.clear();
    for (int cell = std::max(vertex - 1, 0); cell <= std::min(vertex, 1); ++cell)
      batch_.elements.push_back(element_over(cell, vertex, top));
    batch_.patches = {{0, static_cast<std::int32_t>(batch_.elements.size())}};
    batch_.records.assign(batch_.elements.size(), {});
    if (vertex == 1) {
      batch_.elements[0].neighbor[0] = 1, batch_.elements[1].neighbor[1] = 0;
      batch_.elements[0].neighbor_facet[0] = 1, batch_.elements[1].neighbor_facet[1] = 0;
      batch_.elements[0].facet_kind[0] = batch_.elements[1].facet_kind[1] = FacetKind::interior;
      std::mt19937 generator(1);
      crack_tents(batch_, crack_, generator);
    } else {
      const int facet = vertex == 0 ? 1 : 0;
      batch_.elements[0].facet_data[facet] = far_block(vertex / 2);
    }
    batch_ = solved(std::move(batch_));
    for (const ElementRecord& record : batch_.records)
      ASSERT_EQ(record.status, int(Status::ok)) << status_name(Status(record.status)) << " at time " << time_[1];
    const CrackedBalance balance = balance_with_cracks(batch_, batch_.patches[0]);
    worst_closure_ = std::max(worst_closure_, std::abs(balance.closure) / balance.largest);
    if (vertex == 1) crack_ = {last().damage[0], last().gap[0]};
    time_[vertex] = top;
  }

  TentBatch batch_;
  CrackState crack_;
  State far_[2];
  double time_[3] = {0, 0, 0};
  int slot_[2], code_[2] = {0, 0};
  double worst_closure_ = 0;
};

/// Tension `stress` on either side and the sides pulled apart: the intact traction at the crack is twice as large and
/// constant, whatever the crack does.
CrackedBar pulled_bar(int degree, const FractureLaw& law, double stress, const CrackState& crack = {}) {
  return CrackedBar(degree, law, {-stress, stress}, {stress, stress}, crack);
}

/// k = 1 has constant states in an element, so the waves that come in stay exactly constant.
TEST(FractureBar, DamageUnderAConstantWaveFollowsTheClosedForm) {
  const FractureLaw law{0.3, 0.4, 2, 10, 1, 0.3};
  for (const double stress : {0.17, 0.185, 0.25})
    for (const double step : {0.04, 0.2, 0.45}) {
      CrackedBar bar = pulled_bar(1, law, stress);
      const double target = target_damage(law, 2 * stress);
      for (int n = 1; n <= 12; ++n) {
        bar.advance(n * step);
        EXPECT_NEAR(bar.damage(), relaxed_damage(law, target, 0, n * step), 1e-12) << stress << " step " << step;
        EXPECT_NEAR(bar.last().largest_effective_traction, 2 * stress, 1e-13);
      }
      EXPECT_LT(bar.worst_closure(), 1e-12);
    }
}

/// The opening follows from the damage: v*_plus - v*_minus = 2 D s0 / Z.
TEST(FractureBar, TheGapIsTheIntegralOfTheOpening) {
  const FractureLaw law{0.3, 0.4, 2, 10, 1, 0.3};
  CrackedBar bar = pulled_bar(1, law, 0.25);
  double opening = 0;
  for (int n = 1; n <= 20; ++n) {
    bar.advance(0.2 * n);
    constexpr int fine = 2000;
    for (int i = 0; i < fine; ++i)
      opening += 0.2 / fine * relaxed_damage(law, 1, 0, 0.2 * (n - 1 + (i + 0.5) / fine)) * 2 * 0.5;
    EXPECT_NEAR(bar.gap(), opening, 2e-5);
  }
}

/// The closed form is exact for k = 1 alone: at higher degrees u_t and u_x share their coefficients and a step in the
/// traction leaves some overshoot, the smaller the tents the shorter.
TEST(FractureBar, HigherDegreesFollowTheClosedFormClosely) {
  const FractureLaw law{0.3, 0.4, 2, 10, 1, 0.3};
  for (const int degree : {2, 3}) {
    CrackedBar bar = pulled_bar(degree, law, 0.25);
    for (int n = 1; n <= 40; ++n) bar.advance(0.1 * n);
    EXPECT_NEAR(bar.damage(), relaxed_damage(law, 1, 0, 4), 5e-3) << "degree " << degree;
    EXPECT_LT(bar.worst_closure(), 1e-12);
  }
}

/// A debonded bar under pressure stays closed whatever the degree: the pressure passes, no work is done.
TEST(FractureBar, AClosedCrackLetsPressurePass) {
  const FractureLaw law{0.3, 0.4, 2, 10, 1, 0.3};
  for (const int degree : {1, 2, 3}) {
    CrackedBar bar(degree, law, {0.2, -0.2}, {0, 0}, {1, 0});
    for (int n = 1; n <= 20; ++n) {
      bar.advance(0.2 * n);
      EXPECT_EQ(bar.last().mode_points[2], 0);
      EXPECT_EQ(bar.gap(), 0) << "degree " << degree << " time " << bar.time();
      EXPECT_NEAR(bar.last().fracture_work, 0, 1e-15);
    }
    EXPECT_LT(bar.worst_closure(), 1e-12);
  }
}

/// A step of pressure comes through elements that overshoot (k >= 2); the debonded crack stays closed.
TEST(FractureBar, APressureStepDoesNotOpenAClosedCrack) {
  const FractureLaw law{0.3, 0.4, 2, 10, 1, 0.3};
  for (const int degree : {1, 2, 3, 4})
    for (const double step : {0.1, 0.4}) {
      CrackedBar bar(degree, law, {0, 0}, {0, 0}, {1, 0});
      bar.set_far_field(0, {0.2, -0.2});
      double widest = 0;
      for (int n = 1; n * step <= 4; ++n) {
        bar.advance(n * step);
        widest = std::max(widest, bar.gap());
      }
      EXPECT_LT(widest, 1e-6) << "degree " << degree << " step " << step;
      EXPECT_LT(bar.worst_closure(), 1e-12);
    }
}

/// However weak the tension is compared with the strength, a debonded crack opens.
TEST(FractureBar, WeakTensionOpensADebondedCrack) {
  const FractureLaw law{0.3, 0.4, 2, 10, 1, 0.3};
  for (const int degree : {1, 2, 3}) {
    CrackedBar bar = pulled_bar(degree, law, 1e-9, {1, 0});
    for (int n = 1; n <= 10; ++n) bar.advance(0.2 * n);
    EXPECT_NEAR(bar.gap(), 8e-9, 1e-10) << "degree " << degree;
  }
}

/// Tension opens a debonded crack; then pressure from both ends closes it, and new tension opens it again. While open
/// the sides move at v = -+2 s / Z, so the times are known.
TEST(FractureBar, ACrackOpensClosesAndOpensAgain) {
  const FractureLaw law{0.3, 0.4, 2, 10, 1, 0.3};
  for (const int degree : {1, 2, 3}) {
    CrackedBar bar = pulled_bar(degree, law, 0.1, {1, 0});
    const double step = 0.05;
    int n = 0;
    const auto advance_to = [&](double time) {
      while (n * step < time - 1e-9) bar.advance(++n * step);
    };
    advance_to(1);
    EXPECT_NEAR(bar.gap(), 4 * 0.1, 2e-3) << "degree " << degree;
    // Pressure twice as large arrives about half a unit later and closes the gap in half the time it took to open.
    bar.set_far_field(0, {0.2, -0.2});
    bar.set_far_field(1, {-0.2, -0.2});
    advance_to(1.5);
    const double widest = bar.gap();
    EXPECT_GT(widest, 0.3);
    advance_to(1.5 + widest / 0.8 + 0.5);
    EXPECT_LT(bar.gap(), 2e-3) << "degree " << degree;
    EXPECT_GE(bar.gap(), 0);
    EXPECT_EQ(bar.last().mode_points[0], 0);
    const double closed_at = n * step;
    bar.set_far_field(0, {-0.1, 0.1});
    bar.set_far_field(1, {0.1, 0.1});
    advance_to(closed_at + 1.5);
    EXPECT_NEAR(bar.gap(), 4 * 0.1, 0.2) << "degree " << degree;
    EXPECT_LT(bar.worst_closure(), 1e-12);
  }
}

}  // namespace
}  // namespace tentpole
