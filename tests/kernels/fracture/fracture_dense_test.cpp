#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/status.hpp"
#include "kernels/element/quadrature.hpp"
#include "kernels/fracture/contact_mode.hpp"
#include "kernels/reference/point_state.reference.hpp"
#include "tests/kernels/cracked_tents.hpp"
#include "tests/kernels/dense_comparison.hpp"
#include "tests/kernels/device_tents.hpp"

namespace tentpole {
namespace {

using namespace reference;

/// Traction that the bonded facet would bear at a point, on the outward normal of side 0, in global axes.
struct IntactPoint {
  Row normal;    ///< [D]
  Row traction;  ///< [D]
};

/// One fracture facet of a solved batch, seen through the definitions alone: fields at points from the coefficients,
/// damage and contact along each line, M in global axes.
class FrozenView {
 public:
  FrozenView(TentBatch& batch, int index)
      : batch_(batch),
        disc_(batch.dimension, batch.degree),
        facet_(batch.fracture_facets[index]),
        D_(batch.dimension) {}

  FrozenFracture points() const {
    FrozenFracture points;
    const ElementDescriptor& element = batch_.elements[facet_.element[0]];
    const double height = element.corner[D_ + 1][D_] - element.corner[element.pole][D_];
    const Quadrature lines = gauss_jacobi(D_ == 1 ? 1 : batch_.degree + 1, 0);
    for (int line = 0; line < lines.num_points(); ++line) {
      const double position = lines.points[line], share = D_ == 1 ? 1 : (facet_.rising_end ? position : 1 - position);
      append_line(line, position, share, height, D_ == 1 ? 1 : 2 * share * lines.weights[line], points);
    }
    return points;
  }

 private:
  void append_line(int line, double position, double share, double height, double weight,
                   FrozenFracture& points) const {
    const FractureLaw& law = batch_.fracture_law;
    const Quadrature panel = gauss_jacobi(std::max(3, batch_.degree), 0);
    const int num_panels = std::clamp(static_cast<int>(std::ceil(share * height / (0.1 * law.relaxation_time))), 4, 16);
    const double duration = share * height / num_panels;
    double q = std::exp(-law.delay_exponent * facet_.damage[line]), gap = facet_.gap[line];
    std::vector<Row> barycentric;
    std::vector<IntactPoint> intact;
    double largest_normal = 0;
    for (int n = 0; n < num_panels; ++n)
      for (int p = 0; p < panel.num_points(); ++p) {
        const double rise = (n + panel.points[p]) / num_panels;
        if (D_ == 1)
          barycentric.push_back({1 - rise, rise});
        else if (facet_.rising_end)
          barycentric.push_back({1 - position, position * (1 - rise), position * rise});
        else
          barycentric.push_back({(1 - position) * (1 - rise), position, (1 - position) * rise});
        intact.push_back(intact_at(barycentric.back()));
        largest_normal = std::max(largest_normal, std::abs(normal_part(intact.back())));
      }
    const ContactTolerance tolerance = contact_tolerance(largest_normal, compliance(), share * height);
    for (int n = 0; n < num_panels; ++n) {
      const int first = n * panel.num_points();
      std::vector<double> target, damage(panel.num_points());
      for (int p = 0; p < panel.num_points(); ++p) {
        const IntactPoint& point = intact[first + p];
        target.push_back(target_damage(law, effective_traction(law, normal_part(point), tangential_length(point))));
      }
      q = integrate_damage_panel(law, duration, {panel.num_points(), panel.points.data(), panel.weights.data()},
                                 target.data(), q, damage.data());
      for (int p = 0; p < panel.num_points(); ++p) {
        const IntactPoint& point = intact[first + p];
        const double normal = normal_part(point);
        const ContactMode mode = contact_state(law, tolerance, gap, normal, tangential_length(point)).mode;
        points.push_back(
            {barycentric[first + p], weight * panel.weights[p] / num_panels, map_at(point, mode, damage[p])});
        if (mode == ContactMode::open) gap += duration * panel.weights[p] * compliance() * damage[p] * normal;
      }
      gap = std::max(gap, 0.0);
    }
  }

  static double normal_part(const IntactPoint& point) {
    double sum = 0;
    for (std::size_t i = 0; i < point.normal.size(); ++i) sum += point.normal[i] * point.traction[i];
    return sum;
  }
  Row tangential_part(const IntactPoint& point) const {
    Row part = point.traction;
    for (int i = 0; i < D_; ++i) part[i] -= normal_part(point) * point.normal[i];
    return part;
  }
  double tangential_length(const IntactPoint& point) const {
    double square = 0;
    for (const double component : tangential_part(point)) square += component * component;
    return std::sqrt(square);
  }

  /// Open (1 - D) I; stick I; slip n n^T + (1 - D)(I - n n^T) - D k_f dir n^T, k_f = 0 where nothing presses.
  Row map_at(const IntactPoint& point, ContactMode mode, double damage) const {
    const Row tangential = tangential_part(point);
    const double length = tangential_length(point);
    const double friction = normal_part(point) < 0 ? damage * batch_.fracture_law.friction : 0;
    Row map(D_ * D_);
    for (int i = 0; i < D_; ++i)
      for (int j = 0; j < D_; ++j) {
        const double unit = i == j, normals = point.normal[i] * point.normal[j];
        if (mode == ContactMode::open) map[i * D_ + j] = (1 - damage) * unit;
        if (mode == ContactMode::stick) map[i * D_ + j] = unit;
        if (mode == ContactMode::slip)
          map[i * D_ + j] =
              normals + (1 - damage) * (unit - normals) - friction * tangential[i] / length * point.normal[j];
      }
    return map;
  }

  const Material& material(int side) const { return batch_.materials[batch_.elements[facet_.element[side]].material]; }
  /// Z = rho c_p n n^T + rho c_s (I - n n^T) applied to a vector.
  Row weighed(int side, const Row& normal, const Row& vector) const {
    const double along = material(side).density * material(side).dilatational_speed(),
                 across = material(side).density * material(side).shear_speed();
    double component = 0;
    for (int i = 0; i < D_; ++i) component += normal[i] * vector[i];
    Row result(D_);
    for (int i = 0; i < D_; ++i) result[i] = across * vector[i] + (along - across) * component * normal[i];
    return result;
  }
  double compliance() const {
    double sum = 0;
    for (int side = 0; side < 2; ++side) sum += 1 / (material(side).density * material(side).dilatational_speed());
    return sum;
  }

  /// One material on both sides: s0 = (s_0 + s_1 + Z (v_1 - v_0)) / 2.
  IntactPoint intact_at(const Row& barycentric) const {
    IntactPoint point;
    Row velocity[2], traction[2];
    for (int side = 0; side < 2; ++side) {
      const ElementDescriptor& element = batch_.elements[facet_.element[side]];
      const Geometry geometry = element_geometry(element, D_);
      if (side == 0) {
        const Vector covector = facet_covector(geometry, D_, facet_.facet[0]);
        double area = 0;
        for (int j = 0; j < D_; ++j) area += covector[j] * covector[j];
        for (int j = 0; j < D_; ++j) point.normal.push_back(covector[j] / std::sqrt(area));
      }
      const PointState state = evaluate(point_state(disc_, geometry.inverse, material(side),
                                                    element_point(barycentric, facet_corners(D_, facet_.facet[side]))),
                                        &batch_.coefficients[element.result_slot * batch_.num_unknowns()]);
      for (int i = 0; i < D_; ++i) {
        velocity[side].push_back(state.velocity[i][0]);
        traction[side].push_back(0);
        for (int j = 0; j < D_; ++j) traction[side][i] += state.stress[i * D_ + j][0] * point.normal[j];
      }
    }
    Row jump(D_);
    for (int i = 0; i < D_; ++i) jump[i] = velocity[1][i] - velocity[0][i];
    const Row wave = weighed(0, point.normal, jump);
    for (int i = 0; i < D_; ++i) point.traction.push_back((traction[0][i] + traction[1][i] + wave[i]) / 2);
    return point;
  }

  TentBatch& batch_;
  Discretization disc_;
  FractureFacet facet_;
  int D_;
};

std::vector<FrozenFracture> frozen(TentBatch& batch) {
  std::vector<FrozenFracture> fractures;
  for (std::size_t f = 0; f < batch.fracture_facets.size(); ++f)
    fractures.push_back(FrozenView(batch, static_cast<int>(f)).points());
  return fractures;
}

/// Drops the patches with points whose mode flipped from round to round: those stayed in a mode that their tractions
/// contradict.
void keep_settled(TentBatch& batch) {
  std::erase_if(batch.patches, [&](const PatchDescriptor& patch) {
    return patch.num_fractures > 0 && batch.fracture_records[patch.first_fracture].rounds > 10;
  });
}

/// Dimension and degree.
class FractureDense : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  TentBatch tents(const CrackState& state, double pressure) const {
    const auto [dimension, degree] = GetParam();
    TentOptions options;
    options.num_patches = 4;
    return cracked_tents(dimension, degree, options, state, 90 + 10 * dimension + degree, pressure);
  }
};

/// Damage stays as given; the maps of open, sticking and sliding points are those of the reference.
TEST_P(FractureDense, CondensedEqualsDenseAtGivenDamage) {
  int modes[3] = {};
  std::size_t compared = 0;
  for (const double pressure : {-4.0, 0.5, 2.0})
    for (const CrackState state : {CrackState{0.4, 100}, CrackState{0.7, 0}}) {
      TentBatch batch = solved(tents(state, pressure));
      for (const ElementRecord& record : batch.records) ASSERT_EQ(record.status, int(Status::ok));
      for (const FractureRecord& record : batch.fracture_records)
        for (int mode = 0; mode < 3; ++mode) modes[mode] += record.mode_points[mode];
      keep_settled(batch);
      compared += batch.patches.size();
      if (batch.patches.empty()) continue;
      EXPECT_LT(compare_with_dense(batch, frozen(batch)).energy, 1e-11);
    }
  EXPECT_GE(compared, 20u);
  EXPECT_GT(modes[0], 0);
  EXPECT_GT(modes[1], 0);
  EXPECT_TRUE(std::get<0>(GetParam()) == 1 || modes[2] > 0);
}

/// The solution fits the damage that its own tractions cause, to the tolerance of the damage loop.
TEST_P(FractureDense, TheSolutionFitsTheDamageThatItCauses) {
  for (const double relaxation_time : {1.0, 0.2}) {
    TentBatch batch = tents({0.1, 0}, -4);
    batch.fracture_law = breaking_law(batch, relaxation_time);
    batch = solved(batch);
    double growth = 0;
    for (const FractureRecord& record : batch.fracture_records) {
      ASSERT_EQ(record.status, int(Status::ok));
      growth = std::max(growth, record.largest_damage_change);
    }
    EXPECT_GT(growth, 0.1);
    keep_settled(batch);
    ASSERT_FALSE(batch.patches.empty());
    EXPECT_LT(compare_with_dense(batch, frozen(batch)).energy, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(DimensionsAndDegrees, FractureDense,
                         testing::Combine(testing::Values(1, 2), testing::Values(1, 2, 3, 4)));

}  // namespace
}  // namespace tentpole
