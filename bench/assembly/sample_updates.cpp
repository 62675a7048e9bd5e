#include "bench/assembly/sample_updates.hpp"

#include <memory>

#include <cblas.h>

#include "bench/assembly/assembly_cost.hpp"
#include "bench/sample_patches.hpp"

namespace tentpole {
namespace {

/// The element's updates of vertical facets: D terms that are the same for all components of the test.
std::vector<int> vertical_updates(const ElementUpdates& updates) {
  std::vector<double> scratch(updates.scratch_size());
  std::vector<int> indices;
  for (int update = 0; update < updates.size(); ++update) {
    const UpdateRows rows = updates.form(update, scratch.data());
    if (rows.component_stride == 0 && rows.num_terms == updates.tables().dimension) indices.push_back(update);
  }
  return indices;
}

}  // namespace

SampleUpdates::SampleUpdates(int space_dimension, int degree, int count)
    : batch_(sample_patches(space_dimension, degree, 1, 1)),
      tables_(space_dimension, degree),
      updates_(tables_, batch_.view(), 0, false),
      expected_(static_cast<std::size_t>(tables_.num_unknowns) * tables_.num_unknowns, 0.0) {
  const int n = tables_.num_unknowns;
  const std::vector<int> vertical = vertical_updates(updates_);
  for (int update = 0; update < count; ++update) {
    indices_.push_back(vertical[update % vertical.size()]);
    memory_.emplace_back(updates_.scratch_size());
    const UpdateRows& rows = rows_.emplace_back(updates_.form(indices_.back(), memory_.back().data()));
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, rows.num_terms, rows.weight, rows.test, n, rows.trial, n,
                1.0, expected_.data(), n);
  }
}

const SampleUpdates& sample_updates(int degree, int count) {
  static std::unique_ptr<SampleUpdates> current;
  static int current_degree = 0;
  if (current_degree != degree || current->size() != count) current = std::make_unique<SampleUpdates>(3, degree, count);
  current_degree = degree;
  return *current;
}

double SampleUpdates::flops() const {
  double flops = 0;
  for (const UpdateRows& rows : rows_) flops += update_flops(rows);
  return flops;
}

}  // namespace tentpole
