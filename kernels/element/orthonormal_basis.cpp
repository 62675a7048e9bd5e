#include "kernels/element/orthonormal_basis.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "common/simplex.hpp"

namespace tentpole {
namespace {

constexpr int max_basis_dimension = 4;

/// A number with its first and second derivatives with respect to the coordinates: forward-mode differentiation, exact
/// up to rounding. order 1 carries the gradient, order 2 also the second derivatives.
template <int dimension, int order>
struct Jet {
  double value = 0;
  std::array<double, dimension> gradient{};
  std::array<std::array<double, order == 2 ? dimension : 0>, order == 2 ? dimension : 0> hessian{};

  friend Jet operator+(Jet jet, double constant) {
    jet.value += constant;
    return jet;
  }
  friend Jet operator*(double scale, Jet jet) {
    jet.value *= scale;
    for (double& slope : jet.gradient) slope *= scale;
    for (auto& row : jet.hessian)
      for (double& curvature : row) curvature *= scale;
    return jet;
  }
  friend Jet operator+(Jet a, const Jet& b) {
    a.value += b.value;
    for (std::size_t l = 0; l < a.gradient.size(); ++l) a.gradient[l] += b.gradient[l];
    for (std::size_t l = 0; l < a.hessian.size(); ++l)
      for (std::size_t m = 0; m < a.hessian.size(); ++m) a.hessian[l][m] += b.hessian[l][m];
    return a;
  }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + -1.0 * b; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet result;
    result.value = a.value * b.value;
    for (std::size_t l = 0; l < a.gradient.size(); ++l)
      result.gradient[l] = a.gradient[l] * b.value + a.value * b.gradient[l];
    for (std::size_t l = 0; l < a.hessian.size(); ++l)
      for (std::size_t m = 0; m < a.hessian.size(); ++m)
        result.hessian[l][m] = a.hessian[l][m] * b.value + a.gradient[l] * b.gradient[m] +
                               a.gradient[m] * b.gradient[l] + a.value * b.hessian[l][m];
    return result;
  }
};

/// Calls visit(a, phi_a) for the functions at `coordinate` [dimension].
template <int dimension, class Value, class Visit>
void evaluate(const BasisRecurrence& recurrence, const Value* coordinate, const Visit& visit) {
  std::vector<Value> factors(dimension * recurrence.triangle_size());
  basis_factors<dimension>(recurrence, coordinate, factors.data());
  for_each_basis_function<dimension>(recurrence, factors.data(), visit);
}

template <int dimension, int order, class Visit>
void evaluate_jets(const BasisRecurrence& recurrence, std::span<const double> xi, const Visit& visit) {
  std::array<Jet<dimension, order>, dimension> coordinate;
  for (int j = 0; j < dimension; ++j) {
    coordinate[j].value = xi[j];
    coordinate[j].gradient[j] = 1;
  }
  evaluate<dimension>(recurrence, coordinate.data(), visit);
}

/// Calls work.template operator()<dimension>() for a dimension 1..4.
template <class Work>
void with_dimension(int dimension, const Work& work) {
  switch (dimension) {
    case 1:
      return work.template operator()<1>();
    case 2:
      return work.template operator()<2>();
    case 3:
      return work.template operator()<3>();
    case 4:
      return work.template operator()<4>();
  }
}

/// The recurrence of the Jacobi polynomials in y = 2 x - R, rewritten for x and for normalised functions.
void fill_row(int alpha, int degree, double* row) {
  const auto norm = [alpha](int n) { return std::sqrt(2.0 * n + alpha + 1); };
  row[0] = norm(0);
  for (int n = 0; n < degree; ++n) {
    const double s = 2.0 * n + alpha, scale = 2.0 * (n + 1) * (n + alpha + 1) * s;
    const double own = n == 0 ? alpha / 2.0 : (s + 1) * alpha * alpha / scale;
    const double linear = n == 0 ? (alpha + 2) / 2.0 : s * (s + 1) * (s + 2) / scale;
    const double backward = n == 0 ? 0.0 : 2.0 * (n + alpha) * n * (s + 2) / scale;
    double* step = row + 1 + 3 * n;
    step[0] = 2 * linear * norm(n + 1) / norm(n);
    step[1] = (own - linear) * norm(n + 1) / norm(n);
    step[2] = n == 0 ? 0.0 : backward * norm(n + 1) / norm(n - 1);
  }
}

}  // namespace

OrthonormalBasis::OrthonormalBasis(int dimension, int degree) : dimension_(dimension), degree_(degree) {
  if (dimension < 0 || dimension > max_basis_dimension || degree < 0)
    throw std::invalid_argument("OrthonormalBasis: needs 0 <= dimension <= 4 and degree >= 0, got " +
                                std::to_string(dimension) + " and " + std::to_string(degree));
  size_ = num_polynomials(dimension, degree);
  const int num_rows = 2 * degree + dimension, row_size = 1 + 3 * degree;
  recurrence_rows_.resize(num_rows * row_size);
  for (int alpha = 0; alpha < num_rows; ++alpha) fill_row(alpha, degree, &recurrence_rows_[alpha * row_size]);
}

void OrthonormalBasis::values(std::span<const double> xi, std::span<double> value) const {
  if (dimension_ == 0) value[0] = 1;
  with_dimension(dimension_, [&]<int dimension>() {
    evaluate<dimension>(recurrence(), xi.data(), [&](int a, double phi) { value[a] = phi; });
  });
}

void OrthonormalBasis::gradients(std::span<const double> xi, std::span<double> gradient) const {
  with_dimension(dimension_, [&]<int dimension>() {
    evaluate_jets<dimension, 1>(recurrence(), xi, [&](int a, const auto& phi) {
      for (int l = 0; l < dimension; ++l) gradient[a * dimension + l] = phi.gradient[l];
    });
  });
}

void OrthonormalBasis::hessians(std::span<const double> xi, std::span<double> hessian) const {
  with_dimension(dimension_, [&]<int dimension>() {
    evaluate_jets<dimension, 2>(recurrence(), xi, [&](int a, const auto& phi) {
      for (int l = 0; l < dimension; ++l)
        for (int m = 0; m < dimension; ++m) hessian[(a * dimension + l) * dimension + m] = phi.hessian[l][m];
    });
  });
}

}  // namespace tentpole
