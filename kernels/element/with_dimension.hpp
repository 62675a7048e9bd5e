#pragma once

#include <type_traits>
#include <utility>

namespace tentpole {

/// function(D) with D a compile-time constant 1, 2 or 3: `with_dimension(dimension, [&](auto D) { f<D>(..); })`.
template <class Function>
decltype(auto) with_dimension(int dimension, Function&& function) {
  switch (dimension) {
    case 1:
      return std::forward<Function>(function)(std::integral_constant<int, 1>{});
    case 2:
      return std::forward<Function>(function)(std::integral_constant<int, 2>{});
    default:
      return std::forward<Function>(function)(std::integral_constant<int, 3>{});
  }
}

}  // namespace tentpole
