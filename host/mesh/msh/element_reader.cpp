#include "host/mesh/msh/element_reader.hpp"

#include <limits>

#include "host/mesh/printed_number.hpp"

namespace tentpole {

namespace {

std::string printed_position(const Point& point) {
  return "(" + printed(point[0]) + ", " + printed(point[1]) + ", " + printed(point[2]) + ")";
}

}  // namespace

ElementReader::ElementReader(ByteSource& source, MshContents& contents)
    : source_(source), contents_(contents), index_(contents.node_label) {
  if (contents.node_label.size() > std::numeric_limits<std::int32_t>::max())
    source_.fail("there are " + std::to_string(contents.node_label.size()) +
                 " nodes; at most 2147483647 are possible.");
  if (const auto same = index_.duplicate()) {
    source_.enter("node", contents.node_label[same->first]);
    source_.fail("is given twice, at " + printed_position(contents.node_position[same->first]) + " and at " +
                 printed_position(contents.node_position[same->second]) + ". Number the nodes anew, each once.");
  }
}

void ElementReader::begin_block(const MshElementType& type, MshTag entity, std::int64_t group) {
  if (!contents_.blocks.empty()) {
    const MshBlock& last = contents_.blocks.back();
    if (last.type == &type && last.entity == entity && last.group == group) return;
  }
  contents_.blocks.push_back({&type, entity, group, contents_.element_label.size(), contents_.element_node.size(), 0});
}

void ElementReader::read_element(std::int64_t label) {
  MshBlock& block = contents_.blocks.back();
  for (int i = 0; i < block.type->num_nodes; ++i) {
    const std::int64_t node = source_.label("a node of the element");
    const std::int32_t index = index_.find(node);
    if (index == none)
      source_.fail("its node " + std::to_string(node) + " is not among the " +
                   std::to_string(contents_.node_label.size()) + " nodes given before. Save the mesh anew from Gmsh.");
    contents_.element_node.push_back(index);
  }
  contents_.element_label.push_back(label);
  ++block.num_elements;
}

const MshElementType& read_element_type(ByteSource& source) {
  const int number = source.integer("the type of an element");
  const MshElementType* type = find_msh_element_type(number);
  if (type == nullptr)
    source.fail("its type " + std::to_string(number) + " is none of the format. Save the mesh anew from Gmsh.");
  if (type->num_nodes == 0)
    source.fail("is a " + type->name() +
                ", whose number of nodes varies; only lines, triangles and tetrahedra of order 1 are supported. Mesh "
                "with simplices.");
  return *type;
}

Point read_position(ByteSource& source) {
  Point position;
  for (double& coordinate : position) coordinate = source.number("a coordinate");
  return position;
}

}  // namespace tentpole
