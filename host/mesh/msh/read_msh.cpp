#include "host/mesh/msh/read_msh.hpp"

#include "host/mesh/msh/sections.hpp"

namespace tentpole {

namespace {

/// "$Nodes" of the line that opens a section; the place is then behind that line.
std::string_view open_section(ByteSource& source) {
  source.enter("");
  if (source.next_character() != '$') {
    const std::string_view line = source.rest_of_line();
    source.fail(quoted_for_message(line) + " stands between two sections, where only $ and a name may begin. " +
                "Remove it, or save the mesh anew from Gmsh.");
  }
  const std::string_view section = source.word("the name of a section");
  source.enter(section);
  source.rest_of_line();
  return section;
}

void close_section(ByteSource& source, std::string_view section) {
  const std::string end = "$End" + std::string(section.substr(1));
  source.enter(section);
  if (!source.has_more())
    source.fail("the file ends where " + end + " must be. It is cut short: save it anew from Gmsh.");
  const std::string_view found = source.word("the end of the section");
  if (found != end)
    source.fail(quoted_for_message(found) + " stands where " + end +
                " must be: the section has more or fewer entries than it announces. Save the mesh anew from Gmsh.");
  source.rest_of_line();
}

void skip_section(ByteSource& source, std::string_view section) {
  const std::string end = "$End" + std::string(section.substr(1));
  if (section.starts_with("$End")) source.fail("ends a section that was not begun. Save the mesh anew from Gmsh.");
  if (!source.skip_behind(end)) source.fail("is not closed by " + quoted_for_message(end) + ". Close the section.");
  source.rest_of_line();
}

using SectionReader = void (*)(ByteSource&, MshContents&);

struct NamedReader {
  std::string_view section;
  SectionReader read;
};

constexpr NamedReader version_2[] = {
    {"$PhysicalNames", read_physical_names},
    {"$Nodes", [](ByteSource& source, MshContents& contents) { read_msh2_nodes(source, contents, false); }},
    {"$ParametricNodes", [](ByteSource& source, MshContents& contents) { read_msh2_nodes(source, contents, true); }},
    {"$Elements", read_msh2_elements}};

constexpr NamedReader version_4[] = {{"$PhysicalNames", read_physical_names},
                                     {"$Entities", read_msh4_entities},
                                     {"$PartitionedEntities", read_msh4_partitioned_entities},
                                     {"$Nodes", read_msh4_nodes},
                                     {"$Elements", read_msh4_elements}};

/// The reader of a section, or nullptr for one that is passed over.
SectionReader find_reader(std::span<const NamedReader> readers, std::string_view section) {
  for (const NamedReader& reader : readers)
    if (reader.section == section) return reader.read;
  return nullptr;
}

}  // namespace

MshContents read_msh(const std::string& name, std::string_view bytes) {
  ByteSource source(name, bytes);
  const std::string_view first_line = source.rest_of_line();
  if (first_line != "$MeshFormat")
    source.fail("is " + quoted_for_message(first_line) +
                " where a Gmsh mesh has \"$MeshFormat\". Save it as .msh, in format 4.1 or 2.2.");
  source.enter("$MeshFormat");
  const int version = read_msh_format(source);
  close_section(source, "$MeshFormat");
  MshContents contents;
  contents.has_entities = version == 4;
  const std::span<const NamedReader> readers =
      version == 4 ? std::span(version_4) : std::span<const NamedReader>(version_2);
  while (source.has_more()) {
    const std::string_view section = open_section(source);
    if (const SectionReader read = find_reader(readers, section)) {
      read(source, contents);
      close_section(source, section);
    } else {
      skip_section(source, section);
    }
  }
  return contents;
}

}  // namespace tentpole
