#include "tests/kernels/tent_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/reference/point_state.reference.hpp"

namespace tentpole {
namespace {

using namespace reference;

/// Physical point with these barycentric coordinates on the facet with these corners.
SpacetimePoint facet_point(const ElementDescriptor& element, const std::vector<int>& corners, const Row& barycentric) {
  SpacetimePoint point{};
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (std::size_t j = 0; j < point.size(); ++j) point[j] += barycentric[c] * element.corner[corners[c]][j];
  return point;
}

SpacetimePoint volume_point(const ElementDescriptor& element, int dimension, const Row& xi) {
  SpacetimePoint point{};
  for (int j = 0; j <= dimension; ++j) {
    point[j] = element.corner[0][j];
    for (int l = 0; l <= dimension; ++l) point[j] += xi[l] * (element.corner[l + 1][j] - element.corner[0][j]);
  }
  return point;
}

/// Coefficients of the projection of f(point) onto the first num_modes functions of the element basis.
template <typename Function>
Row project_on_element(const Discretization& disc, const ElementDescriptor& element, int num_modes, Function f) {
  const Quadrature& rule = disc.volume_rule;
  Row result(num_modes, 0.0), value(disc.basis.size());
  for (int q = 0; q < rule.num_points(); ++q) {
    const double* begin = &rule.points[q * rule.dimension];
    const Row xi(begin, begin + rule.dimension);
    disc.basis.values(xi, value);
    const double sample = rule.weights[q] * f(volume_point(element, disc.dimension, xi));
    for (int a = 0; a < num_modes; ++a) result[a] += sample * value[a];
  }
  return result;
}

/// Appends to `prescribed` the projection of f(point) onto facet modes whose squares have mean 1.
template <typename Function>
void append_facet_modes(TentBatch& batch, const Discretization& disc, const OrthonormalBasis& modes,
                        const ElementDescriptor& element, const std::vector<int>& corners, Function f) {
  Row result(modes.size(), 0.0), value(modes.size());
  const double normalization = 1 / std::sqrt(std::tgamma(disc.dimension + 1.0));
  for (int q = 0; q < disc.facet_rule.num_points(); ++q) {
    const Row barycentric = facet_barycentric(disc, q);
    modes.values({&barycentric[1], barycentric.size() - 1}, value);
    const double sample = disc.facet_rule.weights[q] * normalization * f(facet_point(element, corners, barycentric));
    for (int m = 0; m < modes.size(); ++m) result[m] += sample * value[m];
  }
  batch.prescribed.insert(batch.prescribed.end(), result.begin(), result.end());
}

/// Builds one element after the other of a patch.
class PatchAppender {
 public:
  PatchAppender(TentBatch& batch, const PatchGeometry& patch, const TentData& data, std::mt19937& generator)
      : batch_(batch),
        patch_(patch),
        data_(data),
        generator_(generator),
        disc_(batch.dimension, batch.degree),
        D_(batch.dimension),
        first_element_(static_cast<int>(batch.elements.size())) {}

  void append_element(int index, int material, const PolynomialField& field) {
    ElementDescriptor element = bare_element(index);
    element.material = material;
    connect(element, index);
    element.result_slot = append_slot(Row(batch_.num_unknowns(), std::numeric_limits<double>::quiet_NaN()), nullptr);
    for (int facet = 0; facet <= D_ + 1; ++facet) {
      if (element.facet_kind[facet] != FacetKind::inflow) continue;
      if (std::bernoulli_distribution(data_.source_fraction)(generator_))
        append_source(element, facet, field);
      else
        append_initial_data(element, facet, field);
    }
    for (int facet = 0; facet <= D_ + 1; ++facet)
      if (element.facet_kind[facet] == FacetKind::boundary) append_boundary(element, facet, field);
    append_body_force(element, field);
    const Row exact = coefficients_of(element, field);
    batch_.exact.insert(batch_.exact.end(), exact.begin(), exact.end());
    batch_.elements.push_back(element);
  }

 private:
  /// Corners and pole; no neighbours, no data.
  ElementDescriptor bare_element(int index) const {
    ElementDescriptor element{};
    element.pole = patch_.elements[index].pole;
    element.body_force_data = none;
    for (int c = 0; c <= D_ + 1; ++c) {
      const int vertex = patch_.elements[index].corners[c];
      for (int j = 0; j < D_; ++j) element.corner[c][j] = patch_.position[vertex][j];
      element.corner[c][D_] = patch_.time[vertex];
      element.neighbor[c] = element.source_slot[c] = element.facet_data[c] = none;
    }
    return element;
  }

  /// Vertices of an element without one corner, ascending.
  std::vector<int> facet_vertices(int index, int opposite) const {
    std::vector<int> vertices;
    for (int c = 0; c <= D_ + 1; ++c)
      if (c != opposite) vertices.push_back(patch_.elements[index].corners[c]);
    return vertices;
  }

  /// Facets that two elements share are interior; the others follow from their normals.
  void connect(ElementDescriptor& element, int index) const {
    const Geometry geometry = element_geometry(element, D_);
    for (int facet = 0; facet <= D_ + 1; ++facet) {
      const Vector covector = facet_covector(geometry, D_, facet);
      double space = 0;
      for (int j = 0; j < D_; ++j) space += covector[j] * covector[j];
      const bool vertical = std::abs(covector[D_]) < 1e-9 * std::sqrt(space);
      element.facet_kind[facet] =
          vertical ? FacetKind::boundary : (covector[D_] < 0 ? FacetKind::inflow : FacetKind::outflow);
      for (int other = 0; other < static_cast<int>(patch_.elements.size()); ++other)
        for (int other_facet = 0; other_facet <= D_ + 1 && other != index; ++other_facet)
          if (facet_vertices(index, facet) == facet_vertices(other, other_facet)) {
            element.facet_kind[facet] = FacetKind::interior;
            element.neighbor[facet] = first_element_ + other;
            element.neighbor_facet[facet] = static_cast<std::uint8_t>(other_facet);
          }
    }
  }

  /// A slot with these coefficients and the inverse Jacobian of an element (NaN where there is none).
  int append_slot(const Row& coefficients, const ElementDescriptor* element) {
    const int slot = batch_.num_slots();
    batch_.coefficients.insert(batch_.coefficients.end(), coefficients.begin(), coefficients.end());
    const Matrix inverse = element ? element_geometry(*element, D_).inverse : Matrix{};
    for (int l = 0; l <= D_; ++l)
      for (int j = 0; j <= D_; ++j)
        batch_.inverse_jacobians.push_back(element ? inverse[l][j] : std::numeric_limits<double>::quiet_NaN());
    return slot;
  }

  Row coefficients_of(const ElementDescriptor& element, const PolynomialField& field) const {
    Row result;
    for (int i = 0; i < D_; ++i) {
      const Row component = project_on_element(disc_, element, disc_.basis.size(),
                                               [&](const auto& point) { return field.displacement(i, point); });
      result.insert(result.end(), component.begin(), component.end());
    }
    return result;
  }

  /// An element of an earlier patch below the facet: one of a tent around a random vertex whose top is now on the
  /// front or, below general patches, as often a general element.
  void append_source(ElementDescriptor& element, int facet, const PolynomialField& field) {
    const bool is_tent = !patch_.is_general() || std::bernoulli_distribution(0.5)(generator_);
    const ElementBelow below = is_tent ? tent_below(element, facet) : general_element_below(element, facet);
    element.source_facet[facet] = static_cast<std::uint8_t>(below.facet);
    element.source_slot[facet] = append_slot(coefficients_of(below.element, field), &below.element);
  }

  struct ElementBelow {
    ElementDescriptor element;  ///< corners only
    int facet;                  ///< facet_table of its outflow facet
  };
  ElementBelow tent_below(const ElementDescriptor& element, int facet) {
    ElementDescriptor source{};
    const std::vector<int> corners = facet_corners(D_, facet);
    for (int c = 0; c <= D_; ++c) std::copy_n(element.corner[corners[c]], D_ + 1, source.corner[c]);
    source.pole = std::uniform_int_distribution<int>(0, D_)(generator_);
    std::copy_n(source.corner[source.pole], D_ + 1, source.corner[D_ + 1]);
    source.corner[source.pole][D_] -= std::uniform_real_distribution<double>(0.1, 0.4)(generator_);
    return {source, facet_table(source, D_, source.pole)};
  }

  /// Its additional corner lies below the middle of the facet and takes any place among the ascending corners.
  ElementBelow general_element_below(const ElementDescriptor& element, int facet) {
    ElementDescriptor source{};
    const std::vector<int> corners = facet_corners(D_, facet);
    const int place = std::uniform_int_distribution<int>(0, D_ + 1)(generator_);
    double* below = source.corner[place];
    for (int c = 0; c <= D_; ++c) {
      const double* corner = element.corner[corners[c]];
      std::copy_n(corner, D_ + 1, source.corner[c < place ? c : c + 1]);
      for (int j = 0; j <= D_; ++j) below[j] += corner[j] / (D_ + 1);
    }
    below[D_] -= std::uniform_real_distribution<double>(0.1, 0.4)(generator_);
    return {source, place};
  }

  int data_offset() const { return static_cast<int>(batch_.prescribed.size()); }

  void append_initial_data(ElementDescriptor& element, int facet, const PolynomialField& field) {
    element.facet_data[facet] = data_offset();
    const std::vector<int> corners = facet_corners(D_, facet);
    for (int i = 0; i < D_; ++i)
      append_facet_modes(batch_, disc_, disc_.facet_basis, element, corners,
                         [&](const auto& point) { return field.velocity(i, point); });
    static constexpr int tensor_index[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
    static constexpr int plane_index[3][2] = {{0, 0}, {1, 1}, {0, 1}};
    for (int s = 0; s < num_symmetric(D_); ++s) {
      const auto& index = D_ == 3 ? tensor_index[s] : plane_index[s];
      append_facet_modes(batch_, disc_, disc_.facet_basis, element, corners,
                         [&](const auto& point) { return field.strain(index[0], index[1], point); });
    }
    for (int i = 0; i < D_; ++i)
      append_facet_modes(batch_, disc_, disc_.linear_facet_basis, element, corners,
                         [&](const auto& point) { return field.displacement(i, point); });
  }

  BoundaryKind random_kind() { return static_cast<BoundaryKind>(std::uniform_int_distribution<int>(0, 2)(generator_)); }

  void append_boundary(ElementDescriptor& element, int facet, const PolynomialField& field) {
    element.normal_kind[facet] = data_.normal_kind ? *data_.normal_kind : random_kind();
    element.tangential_kind[facet] = data_.tangential_kind ? *data_.tangential_kind : random_kind();
    if (data_.homogeneous) return;
    const Material& material = batch_.materials[element.material];
    const Vector covector = facet_covector(element_geometry(element, D_), D_, facet);
    double area = 0;
    for (int j = 0; j < D_; ++j) area += covector[j] * covector[j];
    const auto normal = [&](int j) { return covector[j] / std::sqrt(area); };

    // Component i of what `kind` prescribes, before it is split into its normal and tangential parts.
    const auto prescribed = [&](BoundaryKind kind, double impedance, int i, const SpacetimePoint& point) {
      double traction = 0;
      for (int j = 0; j < D_; ++j) traction += field.stress(i, j, material, point) * normal(j);
      const double velocity = field.velocity(i, point);
      if (kind == BoundaryKind::velocity) return velocity;
      return kind == BoundaryKind::traction ? traction : traction + impedance * velocity;
    };
    element.facet_data[facet] = data_offset();
    for (int i = 0; i < D_; ++i)
      append_facet_modes(batch_, disc_, disc_.facet_basis, element, facet_corners(D_, facet), [&](const auto& point) {
        const double shear_impedance = material.density * material.shear_speed();
        double value = prescribed(element.tangential_kind[facet], shear_impedance, i, point);
        for (int j = 0; j < D_; ++j)
          value += normal(i) * normal(j) *
                   (prescribed(element.normal_kind[facet], material.density * material.dilatational_speed(), j, point) -
                    prescribed(element.tangential_kind[facet], shear_impedance, j, point));
        return value;
      });
  }

  void append_body_force(ElementDescriptor& element, const PolynomialField& field) {
    if (data_.homogeneous) return;
    element.body_force_data = data_offset();
    const Material& material = batch_.materials[element.material];
    for (int i = 0; i < D_; ++i) {
      const Row modes = project_on_element(disc_, element, num_polynomials(D_ + 1, batch_.degree - 1),
                                           [&](const auto& point) { return field.body_force(i, material, point); });
      batch_.prescribed.insert(batch_.prescribed.end(), modes.begin(), modes.end());
    }
  }

  TentBatch& batch_;
  const PatchGeometry& patch_;
  const TentData& data_;
  std::mt19937& generator_;
  Discretization disc_;
  int D_;
  int first_element_;
};

}  // namespace

PatchBatch TentBatch::view() {
  PatchBatch batch{};
  batch.num_patches = static_cast<int>(patches.size());
  batch.num_elements = static_cast<int>(elements.size());
  batch.patches = patches.data();
  batch.elements = elements.data();
  batch.prescribed = prescribed.data();
  batch.materials = materials.data();
  batch.coefficients = coefficients.data();
  batch.inverse_jacobians = inverse_jacobians.data();
  batch.records = records.data();
  batch.fracture_law = fracture_law;
  batch.fracture_facets = fracture_facets.data();
  batch.fracture_records = fracture_records.data();
  return batch;
}

void append_patch(TentBatch& batch, const PatchGeometry& patch, const std::vector<int>& material,
                  const std::vector<PolynomialField>& fields, const TentData& data, std::mt19937& generator) {
  const int num_elements = static_cast<int>(patch.elements.size());
  PatchDescriptor descriptor{};
  descriptor.first_element = static_cast<int>(batch.elements.size());
  descriptor.num_elements = num_elements;
  descriptor.is_general = patch.is_general();
  batch.patches.push_back(descriptor);
  PatchAppender appender(batch, patch, data, generator);
  for (int e = 0; e < num_elements; ++e) appender.append_element(e, material[e], fields[material[e]]);
  batch.records.resize(batch.elements.size());
}

void append_tent(TentBatch& batch, const TentGeometry& tent, const std::vector<int>& material,
                 const std::vector<PolynomialField>& fields, const TentData& data, std::mt19937& generator) {
  append_patch(batch, tent_patch(tent), material, fields, data, generator);
}

Material random_material(std::mt19937& generator) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  const double density = uniform(0.5, 2), dilatational = uniform(0.7, 1.4), shear = dilatational * uniform(0.3, 0.65);
  const double mu = density * shear * shear;
  return {density, density * dilatational * dilatational - 2 * mu, mu};
}

TentBatch random_tents(int dimension, int degree, const TentOptions& options, std::uint32_t seed) {
  std::mt19937 generator(seed);
  TentBatch batch;
  batch.dimension = dimension;
  batch.degree = degree;
  for (int material = 0; material < options.num_materials; ++material)
    batch.materials.push_back(random_material(generator));
  const PolynomialField field = options.num_materials > 1
                                    ? PolynomialField::random_translation(dimension, degree, generator)
                                    : PolynomialField::random(dimension, degree, generator);
  const std::vector<PolynomialField> fields(options.num_materials, field);
  std::uniform_int_distribution<int> any_material(0, options.num_materials - 1);
  for (int patch = 0; patch < options.num_patches; ++patch) {
    const bool at_boundary = std::bernoulli_distribution(options.boundary_fraction)(generator);
    TentGeometry tent = random_star(dimension, at_boundary, options.shape, generator);
    std::vector<int> material;
    std::vector<double> wave_speed;
    for (std::size_t cell = 0; cell < tent.cells.size(); ++cell) {
      material.push_back(any_material(generator));
      wave_speed.push_back(batch.materials[material.back()].dilatational_speed());
    }
    raise_tent(tent, wave_speed, options.front_steepness, options.height_fraction, generator);
    append_tent(batch, tent, material, fields, options.data, generator);
  }
  return batch;
}

}  // namespace tentpole
