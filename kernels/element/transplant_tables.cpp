#include "kernels/element/transplant_tables.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "common/simplex.hpp"
#include "kernels/element/orthonormal_basis.hpp"
#include "kernels/element/quadrature.hpp"

namespace tentpole {

TransplantTables::TransplantTables(int dimension, int degree) : dimension_(dimension), degree_(degree) {
  if (dimension < 1 || dimension > max_dimension || degree < 1 || degree > max_degree)
    throw std::invalid_argument("transplant tables: dimension " + std::to_string(dimension) + ", degree " +
                                std::to_string(degree) + ": dimension must be 1..3 and degree 1..7");
  constexpr int width = TransplantTablesView::block;
  const std::size_t d = dimension + 1;
  const OrthonormalBasis basis(dimension + 1, degree);
  const Quadrature rule = simplex_quadrature(dimension + 1, 2 * degree);
  num_basis_ = basis.size();
  num_blocks_ = (rule.num_points() + width - 1) / width;
  const std::size_t num_entries = d + num_basis_;
  block_.assign(num_blocks_ * num_entries * width, 0.0);
  std::vector<double> value(num_basis_);
  for (int point = 0; point < num_blocks_ * width; ++point) {
    const int actual = std::min(point, rule.num_points() - 1);
    const double weight = point == actual ? rule.weights[actual] : 0.0;
    const std::span<const double> eta(&rule.points[actual * d], d);
    basis.values(eta, value);
    double* entries = &block_[point / width * num_entries * width + point % width];
    for (std::size_t l = 0; l < d; ++l) entries[l * width] = eta[l];
    for (int a = 0; a < num_basis_; ++a) entries[(d + a) * width] = weight * value[a];
  }
  recurrence_offset_ = block_.size();
  block_.insert(block_.end(), basis.recurrence_rows().begin(), basis.recurrence_rows().end());
}

TransplantTablesView TransplantTables::view(const double* base) const {
  return {dimension_, num_basis_, num_blocks_, base, {degree_, base + recurrence_offset_}};
}

}  // namespace tentpole
