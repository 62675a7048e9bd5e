#include "bench/assembly/device_rows.hpp"

#include <algorithm>

#include "common/simplex.hpp"

namespace tentpole {

DeviceRows::DeviceRows(const ElementUpdates& updates, const Device& device, TrafficCounters& traffic)
    : test_(device, traffic), trial_(device, traffic) {
  const long n = updates.tables().num_unknowns, D = updates.tables().dimension;
  const long most_terms = std::max<long>(D + 1, num_symmetric(static_cast<int>(D)));
  test_.resize_discarding(most_terms * n);
  trial_.resize_discarding(std::max(most_terms, D * (D + 1)) * n);
}

DeviceUpdate DeviceRows::upload(const UpdateRows& rows) {
  const std::size_t test_size = static_cast<std::size_t>(rows.num_terms) * rows.num_unknowns;
  const std::size_t num_components = rows.component_stride == 0 ? 1 : rows.num_unknowns / rows.num_basis;
  test_.upload({rows.test, test_size});
  trial_.upload({rows.trial, num_components * test_size});
  return {rows.num_basis,  rows.num_unknowns, rows.num_terms,        rows.weight,
          test_.pointer(), trial_.pointer(),  rows.component_stride, nullptr};
}

}  // namespace tentpole
