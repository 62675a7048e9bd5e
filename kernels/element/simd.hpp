#pragma once

namespace tentpole {

/// Four doubles in a register (two registers, or scalars, where the machine has no wider ones). Loads and stores need
/// no alignment.
typedef double Vector4 __attribute__((vector_size(32)));
typedef double UnalignedVector4 __attribute__((vector_size(32), aligned(8), may_alias));

#ifdef TENTPOLE_THREAD_SANITIZER
// The sanitizer overlooks accesses of more than 16 bytes, so it is shown every number.
inline Vector4 load4(const double* from) {
  return {from[0], from[1], from[2], from[3]};
}
inline void store4(double* to, Vector4 value) {
  for (int i = 0; i < 4; ++i) to[i] = value[i];
}
#else
inline Vector4 load4(const double* from) {
  return *reinterpret_cast<const UnalignedVector4*>(from);
}
inline void store4(double* to, Vector4 value) {
  *reinterpret_cast<UnalignedVector4*>(to) = value;
}
#endif
inline Vector4 broadcast4(double value) {
  return Vector4{value, value, value, value};
}

/// Scalar product of two rows; the order of the sum is fixed by n alone.
inline double dot(const double* left, const double* right, int n) {
  Vector4 first{}, second{};
  int i = 0;
  for (; i + 8 <= n; i += 8) {
    first += load4(left + i) * load4(right + i);
    second += load4(left + i + 4) * load4(right + i + 4);
  }
  for (; i + 4 <= n; i += 4) first += load4(left + i) * load4(right + i);
  first += second;
  double sum = (first[0] + first[1]) + (first[2] + first[3]);
  for (; i < n; ++i) sum += left[i] * right[i];
  return sum;
}

}  // namespace tentpole
