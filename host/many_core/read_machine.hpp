#pragma once

#include <filesystem>

#include "host/many_core/machine.hpp"

namespace tentpole {

/// Reads a machine file. Throws InputError with all its faults, each with line, key, value and the way out.
Machine read_machine(const std::filesystem::path& path);

}  // namespace tentpole
