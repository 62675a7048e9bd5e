#include "kernels/reference/patch_matrix.reference.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "kernels/reference/facet_frame.reference.hpp"
#include "kernels/reference/inclined_facet.reference.hpp"
#include "kernels/reference/point_state.reference.hpp"
#include "kernels/reference/rigid_modes.reference.hpp"

namespace tentpole {
namespace {

using namespace reference;

/// scale_a a + scale_b b
Row sum(double scale_a, const Row& a, double scale_b, const Row& b) {
  Row result(a.size());
  for (std::size_t n = 0; n < a.size(); ++n) result[n] = scale_a * a[n] + scale_b * b[n];
  return result;
}

double dot(const Row& a, const double* b) {
  return std::inner_product(a.begin(), a.end(), b, 0.0);
}

/// Adds the terms of one element to the system of its patch.
class ElementTerms {
 public:
  ElementTerms(const Discretization& disc, const PatchBatch& batch, const PatchDescriptor& patch, int element,
               std::span<const FrozenFracture> fractures, DensePatch& system)
      : disc_(disc),
        D_(disc.dimension),
        batch_(batch),
        first_element_(patch.first_element),
        element_(batch.elements[element]),
        material_(batch.materials[element_.material]),
        geometry_(element_geometry(element_, disc.dimension)),
        offset_(offset_of(element)),
        fractures_(fractures),
        system_(system) {}

  void add_volume() {
    const Quadrature& rule = disc_.volume_rule;
    const int num_modes = num_polynomials(D_ + 1, disc_.basis.degree() - 1);
    for (int q = 0; q < rule.num_points(); ++q) {
      const Row xi(&rule.points[q * (D_ + 1)], &rule.points[q * (D_ + 1)] + D_ + 1);
      const double weight = rule.weights[q] * geometry_.determinant;
      const PointState test = point_state(disc_, geometry_.inverse, material_, xi);
      const Rows momentum = momentum_operator(disc_, geometry_.inverse, material_, xi);
      Row modes(disc_.basis.size());
      disc_.basis.values(xi, modes);
      modes.resize(num_modes);
      for (int i = 0; i < D_; ++i) {
        add_matrix(weight, test.velocity[i], momentum[i], offset_);
        if (element_.body_force_data != none)
          add_rhs(weight, test.velocity[i], dot(modes, batch_.prescribed + element_.body_force_data + i * num_modes));
      }
    }
  }

  void add_inflow() {
    for (int facet = 0; facet <= D_ + 1; ++facet) {
      if (element_.facet_kind[facet] != FacetKind::inflow) continue;
      const Vector covector = facet_covector(geometry_, D_, facet);
      for (int q = 0; q < disc_.facet_rule.num_points(); ++q)
        add_flux_jump(disc_.facet_rule.weights[q], covector, state_on(facet, q),
                      state_below(disc_, batch_, element_, facet, facet_barycentric(disc_, q)));
    }
  }

  /// kappa int uhat_0 . (u - u_ext) |N_t| over all facets through which displacement enters.
  void add_rigid(double kappa) {
    const std::vector<EntryFacet> entries = entry_facets(disc_, element_);
    const auto rigid = rigid_modes(disc_, element_, entries);
    for (const std::vector<Rows>& mode : rigid) {
      Row moments(disc_.num_unknowns, 0.0);
      for (std::size_t f = 0; f < entries.size(); ++f)
        add_moments(entries[f].weight, mode[f], moments, [&](int q) { return state_on(entries[f].facet, q); });
      add_matrix(kappa, moments, moments, offset_);
      for (std::size_t f = 0; f < entries.size(); ++f) {
        const int facet = entries[f].facet;
        if (element_.facet_kind[facet] == FacetKind::inflow) {
          Row below(1, 0.0);
          add_moments(entries[f].weight, mode[f], below,
                      [&](int q) { return state_below(disc_, batch_, element_, facet, facet_barycentric(disc_, q)); });
          add_rhs(kappa, moments, below[0]);
        } else {
          Row beyond(disc_.num_unknowns, 0.0);
          add_moments(entries[f].weight, mode[f], beyond, [&](int q) { return state_beyond(facet, q); });
          add_matrix(-kappa, moments, beyond, offset_of(element_.neighbor[facet]));
        }
      }
    }
  }

  void add_inner() {
    for (int facet = 0; facet <= D_ + 1; ++facet) {
      const FacetKind kind = element_.facet_kind[facet];
      if (kind == FacetKind::inflow || kind == FacetKind::outflow) continue;
      is_inclined(disc_, element_, facet) ? add_inclined(facet) : add_vertical(facet);
    }
  }

 private:
  int offset_of(int element) const { return (element - first_element_) * disc_.num_unknowns; }

  /// Fields of this element at point q of a facet that lists its corners ascending.
  PointState state_on(int facet, int q) const { return state_on(facet, facet_barycentric(disc_, q)); }
  PointState state_on(int facet, const Row& barycentric) const {
    return point_state(disc_, geometry_.inverse, material_, element_point(barycentric, facet_corners(D_, facet)));
  }
  /// Fields of the neighbour there.
  PointState state_beyond(int facet, int q) const { return state_beyond(facet, facet_barycentric(disc_, q)); }
  PointState state_beyond(int facet, const Row& barycentric) const {
    const ElementDescriptor& other = batch_.elements[element_.neighbor[facet]];
    return point_state(disc_, element_geometry(other, D_).inverse, batch_.materials[other.material],
                       element_point(barycentric, facet_corners(D_, element_.neighbor_facet[facet])));
  }

  /// moments += weight times the mean over the facet of mode . u.
  template <class StateAt>
  void add_moments(double weight, const Rows& mode, Row& moments, const StateAt& state_at) const {
    for (int q = 0; q < disc_.facet_rule.num_points(); ++q) {
      const PointState state = state_at(q);
      for (int i = 0; i < D_; ++i)
        for (std::size_t n = 0; n < moments.size(); ++n)
          moments[n] += weight * disc_.facet_rule.weights[q] * mode[q][i] * state.displacement[i][n];
    }
  }

  void add_vertical(int facet) {
    const Vector covector = facet_covector(geometry_, D_, facet);
    double area = 0;
    for (int j = 0; j < D_; ++j) area += covector[j] * covector[j];
    area = std::sqrt(area);
    const Rows frame = facet_frame(covector, area, D_);
    if (element_.facet_kind[facet] == FacetKind::fracture) return add_fracture(facet, area, frame);
    for (int q = 0; q < disc_.facet_rule.num_points(); ++q) {
      const double weight = area * disc_.facet_rule.weights[q];
      if (element_.facet_kind[facet] == FacetKind::boundary)
        add_boundary(weight, facet, frame, state_on(facet, q), facet_barycentric(disc_, q));
      else
        add_interior(weight, facet, frame, state_on(facet, q), state_beyond(facet, q));
    }
  }

  /// Inclined facet: own - w^T A_N^- w, cross + w^T A_N^- w_ext.
  void add_inclined(int facet) {
    const Rows flux = incoming_flux(facet_covector(geometry_, D_, facet), material_, D_);
    for (int q = 0; q < disc_.facet_rule.num_points(); ++q) {
      const double weight = disc_.facet_rule.weights[q];
      const Rows own = state_components(state_on(facet, q), D_), beyond = state_components(state_beyond(facet, q), D_);
      for (std::size_t r = 0; r < flux.size(); ++r)
        for (std::size_t s = 0; s < flux.size(); ++s) {
          add_matrix(-weight * flux[r][s], own[r], own[s], offset_);
          add_matrix(weight * flux[r][s], own[r], beyond[s], offset_of(element_.neighbor[facet]));
        }
    }
  }

  void add_matrix(double weight, const Row& test, const Row& trial, int column_offset) {
    for (int m = 0; m < disc_.num_unknowns; ++m)
      for (int n = 0; n < disc_.num_unknowns; ++n)
        system_.matrix[static_cast<std::size_t>(offset_ + m) * system_.size + column_offset + n] +=
            weight * test[m] * trial[n];
  }
  void add_rhs(double weight, const Row& test, double value) {
    for (int m = 0; m < disc_.num_unknowns; ++m) system_.rhs[offset_ + m] += weight * test[m] * value;
  }

  /// K -= w^T A_N w and b -= w^T A_N w_below with
  /// w^T A_N w = N_t (rho v^ . v + E^ : sigma) - v^ . sigma N_x - (sigma^ N_x) . v
  void add_flux_jump(double weight, const Vector& covector, const PointState& own, const PointState& below) {
    const int num_unknowns = disc_.num_unknowns;
    for (int i = 0; i < D_; ++i) {
      Row on_velocity(num_unknowns);
      for (int n = 0; n < num_unknowns; ++n) {
        on_velocity[n] = covector[D_] * material_.density * own.velocity[i][n];
        for (int j = 0; j < D_; ++j) on_velocity[n] -= own.stress[i * D_ + j][n] * covector[j];
      }
      add_matrix(-weight, on_velocity, own.velocity[i], offset_);
      add_rhs(-weight, on_velocity, below.velocity[i][0]);
      for (int j = 0; j < D_; ++j) {
        Row on_stress(num_unknowns);
        for (int n = 0; n < num_unknowns; ++n)
          on_stress[n] = covector[D_] * own.strain[i * D_ + j][n] - own.velocity[i][n] * covector[j];
        add_matrix(-weight, on_stress, own.stress[i * D_ + j], offset_);
        add_rhs(-weight, on_stress, below.stress[i * D_ + j][0]);
      }
    }
  }

  /// Boundary facet, component by component of the frame:
  /// s* - s = Z (vbar - v) velocity, sbar - s traction, 1/2 [gbar - (s + Z v)] absorbing.
  void add_boundary(double weight, int facet, const Rows& frame, const PointState& own, const Row& barycentric) {
    for (int c = 0; c < D_; ++c) {
      const BoundaryKind kind = c == 0 ? element_.normal_kind[facet] : element_.tangential_kind[facet];
      const double impedance = impedance_of(material_, c);
      const Row velocity = component(own.velocity, frame[c]), traction = component_of_traction(own, frame, c);
      const Row test = sum(1, velocity, 1 / impedance, traction);
      double prescribed = 0;
      if (element_.facet_data[facet] != none)
        for (int i = 0; i < D_; ++i)
          prescribed += frame[c][i] * facet_mode_sum(disc_.facet_basis, barycentric,
                                                     batch_.prescribed + element_.facet_data[facet], i);
      switch (kind) {
        case BoundaryKind::velocity:
          add_matrix(weight * impedance, test, velocity, offset_);
          add_rhs(weight * impedance, test, prescribed);
          break;
        case BoundaryKind::traction:
          add_matrix(weight, test, traction, offset_);
          add_rhs(weight, test, prescribed);
          break;
        case BoundaryKind::absorbing:
          add_matrix(weight / 2, test, sum(1, traction, impedance, velocity), offset_);
          add_rhs(weight / 2, test, prescribed);
          break;
      }
    }
  }

  /// Interior facet between any two materials (i own, e other, tractions on the own outward normal), in components:
  /// own (Z_i v^ + s^) (s_i + Z_e v_i) / (Z_i + Z_e), cross minus the same with (s_e + Z_e v_e).
  void add_interior(double weight, int facet, const Rows& frame, const PointState& own, const PointState& other) {
    const int neighbor = element_.neighbor[facet];
    const Material& other_material = batch_.materials[batch_.elements[neighbor].material];
    for (int c = 0; c < D_; ++c) {
      const double own_impedance = impedance_of(material_, c), other_impedance = impedance_of(other_material, c);
      const Row own_velocity = component(own.velocity, frame[c]), own_traction = component_of_traction(own, frame, c);
      const Row test = sum(own_impedance, own_velocity, 1, own_traction);
      const Row incoming =
          sum(1, component_of_traction(other, frame, c), other_impedance, component(other.velocity, frame[c]));
      const double factor = weight / (own_impedance + other_impedance);
      add_matrix(factor, test, sum(1, own_traction, other_impedance, own_velocity), offset_);
      add_matrix(-factor, test, incoming, offset_of(neighbor));
    }
  }

  /// Fracture facet: K -= (v^ + Z^-1 s^) . (M s0 - s) at its own points, with s0 = (Z_e s_i + Z_i s_e + Z_i Z_e (v_e -
  /// v_i)) / (Z_i + Z_e) in components, all tractions on the own outward normal.
  void add_fracture(int facet, double area, const Rows& frame) {
    const std::size_t index = element_.facet_data[facet];
    if (index >= fractures_.size()) throw std::invalid_argument("fracture facet without frozen damage");
    const int neighbor = element_.neighbor[facet];
    const Material& other_material = batch_.materials[batch_.elements[neighbor].material];
    for (const FrozenPoint& point : fractures_[index]) {
      const PointState own = state_on(facet, point.barycentric), other = state_beyond(facet, point.barycentric);
      for (int c = 0; c < D_; ++c) {
        const Row traction = component_of_traction(own, frame, c);
        const Row test = sum(1, component(own.velocity, frame[c]), 1 / impedance_of(material_, c), traction);
        add_matrix(area * point.weight, test, traction, offset_);
        for (int b = 0; b < D_; ++b) {
          const double z = impedance_of(material_, b), other_z = impedance_of(other_material, b);
          const double factor = -area * point.weight * map_component(point, frame[c], frame[b]) / (z + other_z);
          add_matrix(
              factor, test,
              sum(other_z, component_of_traction(own, frame, b), -z * other_z, component(own.velocity, frame[b])),
              offset_);
          add_matrix(factor, test,
                     sum(z, component_of_traction(other, frame, b), z * other_z, component(other.velocity, frame[b])),
                     offset_of(neighbor));
        }
      }
    }
  }

  /// left . M right
  double map_component(const FrozenPoint& point, const Row& left, const Row& right) const {
    double value = 0;
    for (int i = 0; i < D_; ++i)
      for (int j = 0; j < D_; ++j) value += left[i] * point.map[i * D_ + j] * right[j];
    return value;
  }

  /// Z = rho c_p along the normal, rho c_s across.
  static double impedance_of(const Material& material, int c) {
    return material.density * (c == 0 ? material.dilatational_speed() : material.shear_speed());
  }

  /// Component of a vector of rows along a direction.
  Row component(const Rows& vector, const Row& direction) const {
    Row result(disc_.num_unknowns, 0.0);
    for (int i = 0; i < D_; ++i)
      for (int n = 0; n < disc_.num_unknowns; ++n) result[n] += direction[i] * vector[i][n];
    return result;
  }

  /// frame_c . sigma frame_0
  Row component_of_traction(const PointState& state, const Rows& frame, int c) const {
    Row result(disc_.num_unknowns, 0.0);
    for (int i = 0; i < D_; ++i)
      for (int j = 0; j < D_; ++j)
        for (int n = 0; n < disc_.num_unknowns; ++n)
          result[n] += frame[c][i] * state.stress[i * D_ + j][n] * frame[0][j];
    return result;
  }

  const Discretization& disc_;
  int D_;
  const PatchBatch& batch_;
  int first_element_;
  const ElementDescriptor& element_;
  const Material& material_;
  Geometry geometry_;
  int offset_;
  std::span<const FrozenFracture> fractures_;
  DensePatch& system_;
};

}  // namespace

DensePatch reference_patch_system(const PatchBatch& batch, int dimension, int degree, int patch, double kappa,
                                  std::span<const FrozenFracture> fractures) {
  const Discretization disc(dimension, degree);
  const PatchDescriptor& descriptor = batch.patches[patch];
  DensePatch system;
  system.size = descriptor.num_elements * disc.num_unknowns;
  system.matrix.assign(static_cast<std::size_t>(system.size) * system.size, 0.0);
  system.rhs.assign(system.size, 0.0);
  for (int e = 0; e < descriptor.num_elements; ++e) {
    ElementTerms terms(disc, batch, descriptor, descriptor.first_element + e, fractures, system);
    terms.add_volume();
    terms.add_inflow();
    terms.add_rigid(kappa);
    terms.add_inner();
  }
  return system;
}

}  // namespace tentpole
