#include "bench/run_benchmarks.hpp"

#include <cstdio>
#include <string>
#include <string_view>

#include <benchmark/benchmark.h>

#include "bench/blas_threads.hpp"
#include "bench/machine_peaks.hpp"

namespace tentpole {
namespace {

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string device_name() {
  return available_devices().empty() ? "none" : select_device(std::nullopt).name;
}

std::string in_units_of_1e9(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", rate * 1e-9);
  return text;
}

void add_context() {
  const MachinePeaks one = machine_peaks(1), all = machine_peaks(num_cores());
  benchmark::AddCustomContext("compiler", compiler());
  benchmark::AddCustomContext("device", device_name());
  benchmark::AddCustomContext("commit", TENTPOLE_COMMIT);
  benchmark::AddCustomContext("cores", std::to_string(num_cores()));
  benchmark::AddCustomContext("dgemm_1_GF/s", in_units_of_1e9(one.dgemm));
  benchmark::AddCustomContext("dgemm_all_GF/s", in_units_of_1e9(all.dgemm));
  benchmark::AddCustomContext("copy_1_GB/s", in_units_of_1e9(one.copy));
  benchmark::AddCustomContext("copy_all_GB/s", in_units_of_1e9(all.copy));
}

bool only_lists(int argc, char** argv) {
  for (int argument = 1; argument < argc; ++argument) {
    const std::string_view text = argv[argument];
    if (text == "--benchmark_list_tests" || text == "--benchmark_list_tests=true") return true;
  }
  return false;
}

}  // namespace

int run_benchmarks(int argc, char** argv) {
  const bool needs_context = !only_lists(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  set_blas_threads(1);
  if (needs_context) add_context();
  const std::size_t num_run = benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return num_run > 0 ? 0 : 1;
}

std::optional<Device> benchmark_device(const char* driver) {
  if (available_devices().empty()) {
    std::fprintf(stderr, "%s: this build or machine has no device; the offload rungs are left out\n", driver);
    return std::nullopt;
  }
  return select_device(std::nullopt);
}

}  // namespace tentpole
