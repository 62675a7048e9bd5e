#pragma once

#include <string>
#include <string_view>

namespace tentpole {

/// Text that somebody else wrote (titles, names, paths, keys, values) as a terminal may show it, on one line: control
/// characters, among them line ends and those that start an escape sequence, marks that turn the direction of writing,
/// and bytes that are no UTF-8 appear as \n, \x1b or \u202e.
std::string printable(std::string_view text);

/// The same for whole messages, whose line ends stay.
std::string printable_lines(std::string_view text);

}  // namespace tentpole
