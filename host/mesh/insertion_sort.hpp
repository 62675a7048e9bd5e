#pragma once

#include <functional>
#include <utility>

namespace tentpole {

/// Sorts the first `count` values of an array of a few, such as the corners of a cell. Faster there than std::sort,
/// about which g++ 12 also warns (false array bounds on arrays shorter than 16).
template <typename Array, typename Less = std::less<>>
void insertion_sort(Array& values, int count, Less less = {}) {
  for (int i = 1; i < count; ++i)
    for (int j = i; j > 0 && less(values[j], values[j - 1]); --j) std::swap(values[j], values[j - 1]);
}

}  // namespace tentpole
