#include "host/march/defect_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "host/fracture/defect_load.hpp"
#include "host/fracture/defect_tests.hpp"
#include "host/mesh/printed_number.hpp"

namespace tentpole {
namespace {

/// The stress inside a cell may exceed that at its corners; defects up to this multiple of it are looked at.
constexpr double overshoot = 1.25;

/// Barycentric coordinates of a point in a cell.
std::array<double, 3> barycentric_in(const FrontSimplex& cell, const Point& point) {
  const auto& p = cell.position;
  if (cell.dimension == 1) {
    const double share = (point[0] - p[0][0]) / (p[1][0] - p[0][0]);
    return {1 - share, share, 0};
  }
  const double ax = p[1][0] - p[0][0], ay = p[1][1] - p[0][1], bx = p[2][0] - p[0][0], by = p[2][1] - p[0][1];
  const double x = point[0] - p[0][0], y = point[1] - p[0][1], determinant = ax * by - bx * ay;
  const double first = (x * by - bx * y) / determinant, second = (ax * y - x * ay) / determinant;
  return {1 - first - second, first, second};
}

/// Reference coordinates in the element below a cell of the point with these barycentric coordinates in the cell.
std::array<double, 3> reference_point(int dimension, int facet, const std::array<double, 3>& barycentric) {
  std::array<double, 3> xi{};
  for (int corner = 0, listed = 0; corner <= dimension + 1; ++corner) {
    const bool tent_top = facet > dimension + 1;
    if (tent_top ? corner > dimension : corner == facet) continue;
    const int actual = tent_top && corner == facet - dimension - 2 ? dimension + 1 : corner;
    if (actual > 0) xi[actual - 1] = barycentric[listed];
    ++listed;
  }
  return xi;
}

}  // namespace

DefectSearch::DefectSearch(AdaptiveState& state)
    : state_(state),
      settings_(state.books.simulation.settings.fracture),
      basis_(state.books.simulation.dimension() + 1, state.books.simulation.degree()) {
  const NucleationSettings& nucleation = settings_.nucleation;
  if (!settings_.enabled || nucleation.model == NucleationModel::nowhere) return;
  distribution_ = StrengthDistribution::from_settings(nucleation);
  if (nucleation.model == NucleationModel::field)
    field_.emplace(state.books.simulation.dimension(), nucleation.density, *distribution_, nucleation.seed);
}

/// However strong the stress is, the search in one cell has an end.
void DefectSearch::refuse_crowd(std::span<const Point> corners, double strongest) const {
  const NucleationSettings& nucleation = settings_.nucleation;
  const int dimension = state_.front.mesh().dimension();
  FrontSimplex cell{.dimension = dimension};
  std::ranges::copy(corners, cell.position.begin());
  const double measure = std::abs(signed_measure(cell));
  const double mean = field_ ? field_->mean_number_searched(measure, strongest)
                             : nucleation.density * measure * distribution_->probability(strongest);
  if (mean <= most_defects_per_cell) return;
  throw std::runtime_error(
      "at (" + printed(corners[0][0]) + ", " + printed(corners[0][1]) + ") m a cell is to be searched through about " +
      printed(mean) + " defects for those weaker than " + printed(strongest) + " Pa; at most " +
      printed(most_defects_per_cell) + " are possible. Give a smaller fracture.nucleation.density or smaller cells.");
}

/// Defects of the field in a cell up to a strength; none is generated while the weakest is known to be stronger.
std::vector<Defect> DefectSearch::field_defects(std::int32_t cell, std::span<const Point> corners, double strongest) {
  if (cell >= std::ssize(memory_)) memory_.resize(state_.front.mesh().num_cell_slots());
  CellMemory& memory = memory_[cell];
  if (!std::equal(corners.begin(), corners.end(), memory.corners.begin())) {
    memory = {};
    std::ranges::copy(corners, memory.corners.begin());
  }
  if (strongest <= memory.searched && strongest < memory.weakest) return {};
  // Looking further than asked saves the next searches while the stress rises.
  memory.searched = std::max(memory.searched, 1.5 * strongest);
  refuse_crowd(corners, memory.searched);
  std::vector<Defect> defects = field_->in_simplex(corners, memory.searched);
  std::erase_if(defects, [&](const Defect& defect) { return state_.spent.contains(defect.id); });
  memory.weakest = std::numeric_limits<double>::infinity();
  for (const Defect& defect : defects) memory.weakest = std::min(memory.weakest, defect.strength);
  std::erase_if(defects, [&](const Defect& defect) { return defect.strength > strongest; });
  return defects;
}

std::optional<DefectSearch::Candidate> DefectSearch::candidate(const TestedCell& tested) {
  const Scaling& scaling = state_.books.simulation.scaling;
  const double strongest =
      std::min(overshoot * std::max(1.0, settings_.shear_factor) * tested.largest_stress * scaling.stress(),
               distribution_->maximum());
  if (!(strongest > distribution_->minimum())) return std::nullopt;
  const FrontSimplex simplex = state_.front.mesh().simplex(tested.cell);
  const int num_corners = simplex.dimension + 1;
  std::array<Point, 3> corners{};
  for (int corner = 0; corner < num_corners; ++corner)
    for (int axis = 0; axis < simplex.dimension; ++axis)
      corners[corner][axis] = simplex.position[corner][axis] * scaling.length;
  const std::span<const Point> cell_corners(corners.data(), num_corners);
  Candidate candidate{tested.cell, {}, {}};
  const auto add = [&](Point position, double strength, std::optional<DefectId> id) {
    for (double& coordinate : position) coordinate /= scaling.length;
    candidate.triggers.push_back({position, {}, 0, id});
    candidate.strength.push_back(strength);
  };
  if (field_) {
    for (const Defect& defect : field_defects(tested.cell, cell_corners, strongest))
      add(defect.position, defect.strength, defect.id);
  } else {
    const DefectTestKey key{settings_.nucleation.seed, state_.front.mesh().cell(tested.cell).serial,
                            state_.num_tested++};
    refuse_crowd(cell_corners, strongest);
    for (const DefectTest& test :
         draw_defect_tests(key, cell_corners, settings_.nucleation.density, *distribution_, strongest))
      add(test.position, test.strength, std::nullopt);
  }
  if (candidate.triggers.empty()) return std::nullopt;
  return candidate;
}

void DefectSearch::search(std::span<const TestedCell> cells) {
  if (!distribution_) return;
  std::vector<Candidate> candidates;
  std::vector<std::int32_t> slots;
  for (const TestedCell& cell : cells)
    if (std::optional<Candidate> found = candidate(cell)) {
      slots.push_back(state_.sources.slot[cell.cell]);
      candidates.push_back(std::move(*found));
    }
  if (slots.empty()) return;
  std::vector<double> coefficients, inverse_jacobians;
  state_.books.runner.read_slots(slots, coefficients, inverse_jacobians);
  const std::size_t n = coefficients.size() / slots.size(), d2 = inverse_jacobians.size() / slots.size();
  for (std::size_t i = 0; i < candidates.size(); ++i)
    test(candidates[i], &coefficients[i * n], &inverse_jacobians[i * d2]);
}

void DefectSearch::test(const Candidate& candidate, const double* coefficients, const double* inverse_jacobian) {
  for (std::size_t i = 0; i < candidate.triggers.size(); ++i) {
    DefectTrigger trigger = candidate.triggers[i];
    const PlaneStress stress = stress_at(candidate.cell, trigger.position, coefficients, inverse_jacobian);
    if (state_.front.mesh().dimension() == 1) {
      if (!(maximal_effective_traction(stress.xx) > candidate.strength[i])) continue;
    } else {
      const EffectiveTractionMaximum maximum = maximal_effective_traction(stress, settings_.shear_factor);
      if (!(maximum.effective_traction > candidate.strength[i])) continue;
      trigger.num_normals = maximum.num_orientations;
      for (int n = 0; n < maximum.num_orientations; ++n) trigger.normal[n] = maximum.normal[n];
    }
    if (trigger.defect) state_.spent.insert(*trigger.defect);
    state_.triggers.push_back(trigger);
  }
}

/// Stress [Pa] on the front at a point of the cell.
PlaneStress DefectSearch::stress_at(std::int32_t cell, const Point& position, const double* coefficients,
                                    const double* inverse_jacobian) const {
  const FrontMesh& mesh = state_.front.mesh();
  const int dimension = mesh.dimension(), d = dimension + 1, num_basis = basis_.size();
  const std::array<double, 3> xi =
      reference_point(dimension, state_.sources.facet[cell], barycentric_in(mesh.simplex(cell), position));
  std::vector<double> gradient(static_cast<std::size_t>(num_basis) * d);
  basis_.gradients({xi.data(), static_cast<std::size_t>(d)}, gradient);
  double displacement_gradient[2][2] = {};
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      for (int a = 0; a < num_basis; ++a)
        for (int l = 0; l < d; ++l)
          displacement_gradient[i][j] +=
              coefficients[i * num_basis + a] * gradient[a * d + l] * inverse_jacobian[l * d + j];
  const Material& material = state_.books.simulation.scaled_materials[mesh.cell(cell).region];
  const double trace = displacement_gradient[0][0] + displacement_gradient[1][1];
  const double unit = state_.books.simulation.scaling.stress();
  return {unit * (material.lambda * trace + 2 * material.mu * displacement_gradient[0][0]),
          unit * (material.lambda * trace + 2 * material.mu * displacement_gradient[1][1]),
          unit * material.mu * (displacement_gradient[0][1] + displacement_gradient[1][0])};
}

}  // namespace tentpole
