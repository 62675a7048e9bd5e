#include "bench/machine_peaks.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <map>
#include <thread>
#include <vector>

#include <cblas.h>

#include "bench/blas_threads.hpp"

namespace tentpole {
namespace {

/// Shortest time of several calls after a warm-up [s].
template <class Work>
double shortest_time(int repetitions, Work work) {
  work();
  double shortest = 1e300;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    shortest = std::min(shortest, elapsed.count());
  }
  return shortest;
}

double dgemm_rate(int num_threads) {
  constexpr int n = 512;
  const std::vector<double> a(n * n, 1.0), b(n * n, 0.5);
  std::vector<double> c(n * n, 0.0);
  set_blas_threads(num_threads);
  const double seconds = shortest_time(5, [&] {
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, a.data(), n, b.data(), n, 0.0, c.data(), n);
  });
  set_blas_threads(1);
  return 2.0 * n * n * n / seconds;
}

double copy_rate(int num_threads) {
  constexpr std::ptrdiff_t size = std::ptrdiff_t{4} << 20;
  const std::vector<double> from(size, 1.0);
  std::vector<double> to(size, 0.0);
  const double* source = from.data();
  double* target = to.data();
  const double seconds = shortest_time(5, [&] {
#pragma omp parallel for simd num_threads(num_threads)
    for (std::ptrdiff_t entry = 0; entry < size; ++entry) target[entry] = source[entry];
  });
  return 2.0 * size * sizeof(double) / seconds;
}

}  // namespace

int num_cores() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

MachinePeaks machine_peaks(int num_threads) {
  static std::map<int, MachinePeaks> measured;
  const int threads = std::clamp(num_threads, 1, num_cores());
  const auto found = measured.find(threads);
  if (found != measured.end()) return found->second;
  return measured[threads] = {dgemm_rate(threads), copy_rate(threads)};
}

}  // namespace tentpole
