#include "host/mesh/msh/sections.hpp"
#include "host/mesh/printed_number.hpp"

namespace tentpole {

namespace {

/// 2 or 4, of a version that is read.
int checked_version(ByteSource& source) {
  const double version = source.text_number("the version of the format");
  for (const double known : {2.0, 2.1, 2.2})
    if (version == known) return 2;
  if (version == 4.1) return 4;
  source.fail("the version of the format is " + printed(version) +
              "; only 2.2 and 4.1 are read. Save the mesh as one of these (in Gmsh: Mesh.MshFileVersion = 4.1).");
}

/// A binary file holds the number 1, which shows the byte order.
void read_byte_order(ByteSource& source, MshEncoding encoding) {
  if (!source.rest_of_line().empty()) source.fail("more than version, kind and size stand in the line of the format.");
  source.set_encoding(encoding);
  const auto one = static_cast<std::uint32_t>(source.integer("the mark of the byte order"));
  constexpr std::uint32_t swapped_one = 0x01000000;
  if (one != 1 && one != swapped_one)
    source.fail("the mark of the byte order is " + std::to_string(one) + ", but must be 1 in this or the other byte " +
                "order. The file is damaged: save it anew from Gmsh.");
  encoding.swaps_bytes = one != 1;
  source.set_encoding(encoding);
}

}  // namespace

int read_msh_format(ByteSource& source) {
  const int version = checked_version(source);
  const std::int64_t kind = source.text_integer("0 for text or 1 for binary");
  const std::int64_t size = source.text_integer("the size of numbers");
  if (kind != 0 && kind != 1)
    source.fail("the file is neither text (0) nor binary (1), but " + std::to_string(kind) +
                ". Save it anew from Gmsh.");
  if (kind == 0) {
    source.rest_of_line();
    return version;
  }
  // In version 2 this is the size of a double and labels have 4 bytes, in version 4 the size of a label.
  if (version == 2 ? size != 8 : size != 4 && size != 8)
    source.fail("numbers of " + std::to_string(size) + " bytes cannot be read. Save the mesh as text, or from a " +
                "64-bit program.");
  read_byte_order(source, {true, false, version == 2 ? 4 : static_cast<int>(size)});
  return version;
}

}  // namespace tentpole
