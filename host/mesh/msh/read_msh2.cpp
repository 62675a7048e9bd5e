#include "host/mesh/msh/element_reader.hpp"
#include "host/mesh/msh/sections.hpp"

namespace tentpole {

namespace {

/// What version 2 says before the nodes of an element.
struct ElementHead {
  const MshElementType* type;
  std::int64_t num_tags;
};

ElementHead read_head(ByteSource& source) {
  const MshElementType& type = read_element_type(source);
  return {&type, source.integer("the number of tags")};
}

/// The physical group, which is the first of the tags; the sign tells an orientation. Then entity and partitions.
std::int64_t read_tags(ByteSource& source, std::int64_t num_tags) {
  if (num_tags < 0) source.fail(std::to_string(num_tags) + " tags cannot be. Save the mesh anew from Gmsh.");
  if (num_tags == 0) return 0;
  const std::int64_t group = source.integer("a physical group");
  source.skip_integers(static_cast<std::size_t>(num_tags - 1), "a tag");
  return std::abs(group);
}

void read_text_elements(ElementReader& reader, ByteSource& source, std::size_t num_elements) {
  for (std::size_t i = 0; i < num_elements; ++i) {
    const std::int64_t label = source.label("the number of an element");
    source.enter("element", label);
    const ElementHead head = read_head(source);
    reader.begin_block(*head.type, {}, read_tags(source, head.num_tags));
    reader.read_element(label);
  }
}

/// Binary elements come in lists of one type and number of tags.
void read_binary_elements(ElementReader& reader, ByteSource& source, std::size_t num_elements) {
  for (std::size_t num_read = 0; num_read < num_elements;) {
    source.enter("$Elements");
    const MshElementType& type = read_element_type(source);
    const std::size_t size = source.count("the number of elements of a list", {1, 8});
    if (size == 0 || size > num_elements - num_read)
      source.fail("a list of " + std::to_string(size) + " elements stands where " +
                  std::to_string(num_elements - num_read) + " are left. Save the mesh anew from Gmsh.");
    const std::int64_t num_tags = source.integer("the number of tags");
    for (std::size_t i = 0; i < size; ++i) {
      const std::int64_t label = source.label("the number of an element");
      source.enter("element", label);
      reader.begin_block(type, {}, read_tags(source, num_tags));
      reader.read_element(label);
    }
    num_read += size;
  }
}

/// Dimension and number of the entity that a node lies on, and the coordinates there.
void skip_parameters(ByteSource& source) {
  const int dimension = source.integer("the dimension of the entity of a node");
  source.skip_integers(1, "the entity of a node");
  if (dimension == 1 || dimension == 2)
    source.skip_numbers(static_cast<std::size_t>(dimension), "a parametric coordinate");
}

}  // namespace

void read_msh2_nodes(ByteSource& source, MshContents& contents, bool is_parametric) {
  const std::size_t num_nodes = source.text_count("the number of nodes", {4, 28});
  if (source.encoding().is_binary) source.rest_of_line();
  contents.node_label.reserve(contents.node_label.size() + num_nodes);
  contents.node_position.reserve(contents.node_position.size() + num_nodes);
  for (std::size_t i = 0; i < num_nodes; ++i) {
    const std::int64_t label = source.label("the number of a node");
    source.enter("node", label);
    contents.node_label.push_back(label);
    contents.node_position.push_back(read_position(source));
    if (is_parametric) skip_parameters(source);
  }
}

void read_msh2_elements(ByteSource& source, MshContents& contents) {
  const std::size_t num_elements = source.text_count("the number of elements", {3, 4});
  if (source.encoding().is_binary) source.rest_of_line();
  ElementReader reader(source, contents);
  if (source.encoding().is_binary)
    read_binary_elements(reader, source, num_elements);
  else
    read_text_elements(reader, source, num_elements);
}

}  // namespace tentpole
