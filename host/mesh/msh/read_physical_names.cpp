#include <algorithm>

#include "host/mesh/msh/sections.hpp"
#include "host/mesh/msh/utf8.hpp"

namespace tentpole {

namespace {

/// The characters between the first and the last quotation mark of the rest of the line.
std::string quoted_name(ByteSource& source) {
  const std::string_view line = source.rest_of_line();
  const std::size_t last = line.rfind('"');
  if (line.empty() || line.front() != '"' || last == 0)
    source.fail(quoted_for_message(line) + " stands where the name of a physical group, in quotation marks, must be. " +
                "Correct it, or save the mesh anew from Gmsh.");
  const std::string_view name = line.substr(1, last - 1);
  const auto is_control = [](char character) { return (character >= 0 && character < ' ') || character == 0x7f; };
  if (std::any_of(name.begin(), name.end(), is_control))
    source.fail("the name " + quoted_for_message(name) +
                " of a physical group holds a control character. Rename the group.");
  return as_utf8(name);
}

}  // namespace

void read_physical_names(ByteSource& source, MshContents& contents) {
  const std::size_t num_names = source.text_count("the number of physical names", {2, 4});
  for (std::size_t i = 0; i < num_names; ++i) {
    std::int64_t dimension = none, group = source.text_integer("the dimension of a physical group");
    if (source.next_character() != '"') {  // version 2.0 gives no dimension
      dimension = group;
      group = source.text_integer("the number of a physical group");
    }
    if (dimension < none || dimension > max_dimension)
      source.fail("physical group " + std::to_string(group) + " has the dimension " + std::to_string(dimension) +
                  ", but must have 0 to 3. Correct it, or save the mesh anew from Gmsh.");
    const std::string name = quoted_name(source);
    if (!name.empty()) contents.group_name[{static_cast<int>(dimension), group}] = name;
  }
}

}  // namespace tentpole
