#pragma once

#include <string>
#include <string_view>

namespace tentpole {

/// The text itself if it is UTF-8, else the same letters read as Latin-1, which is how names from older Windows
/// programs are written: a case file, which is UTF-8, can then name them.
std::string as_utf8(std::string_view text);

}  // namespace tentpole
