#pragma once

#include <string>

namespace tentpole {

/// The shortest decimal text that reads back as the same double, e.g. 0.7 or 2.6e+11.
std::string number_text(double value);

}  // namespace tentpole
