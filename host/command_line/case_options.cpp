#include "host/command_line/case_options.hpp"

#include <iostream>
#include <stdexcept>
#include <utility>

#include <dlfcn.h>
#include <omp.h>

#include "host/mesh/printable.hpp"
#include "host/run/make_simulation.hpp"

namespace tentpole {
namespace {

void limit_threads(int threads) {
  omp_set_num_threads(threads);
  // Other implementations of BLAS have no such symbol, and need none.
  using SetNumThreads = void (*)(int);
  if (const auto set = reinterpret_cast<SetNumThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set(1);
}

}  // namespace

ThreadChoice choose_threads(const CaseOptions& options) {
  return choose_threads(thread_supply(), options.threads);
}

Simulation read_simulation(const CaseOptions& options) {
  const ThreadChoice choice = choose_threads(options);
  if (choice.threads < options.threads)
    std::cerr << "warning: --threads " << options.threads << ": only " << choice.threads << ", by " << choice.reason
              << "\n";
  limit_threads(choice.threads);
  Case settings = read_case(options.case_file, options.overrides);
  if (options.seed) set_seed(settings, *options.seed);
  Simulation simulation = make_simulation(std::move(settings));
  for (const std::string& warning : simulation.warnings) std::cerr << "warning: " << printable(warning) << "\n";
  return simulation;
}

Device choose_device(bool offload, std::optional<int> number) {
  if (!offload && !number) return host_device();
  try {
    const Device device = select_device(number);
    if (!number && device.kind != DeviceKind::gpu)
      for (const std::string& reason : unused_gpus()) std::cerr << "warning: " << reason << "\n";
    return device;
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
}

}  // namespace tentpole
