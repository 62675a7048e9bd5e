#pragma once

#include <optional>

#include "device/device.hpp"

namespace tentpole {

/// Main program of every driver, after its benchmarks are registered: takes the options of Google Benchmark
/// (--benchmark_filter, --benchmark_out, ...), puts on record where the figures come from (compiler, commit, device,
/// cores, dgemm and copy peaks measured in this run) and runs. Returns the exit code: 1 for an unknown option or a
/// filter that matches nothing.
int run_benchmarks(int argc, char** argv);

/// The device that offload rungs use (device/device.hpp, select_device), or nothing in a build or on a machine without
/// one: the driver then leaves those rungs out and says so on stderr.
std::optional<Device> benchmark_device(const char* driver);

}  // namespace tentpole
