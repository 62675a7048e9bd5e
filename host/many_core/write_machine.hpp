#pragma once

#include <string>

#include "host/many_core/machine.hpp"

namespace tentpole {

/// The text of a machine file with a comment on each parameter; `origin` says at its head where the numbers come from.
std::string machine_text(const Machine& machine, const std::string& origin);

}  // namespace tentpole
