#include "host/mesh/msh/element_reader.hpp"
#include "host/mesh/msh/sections.hpp"

namespace tentpole {

namespace {

int read_dimension(ByteSource& source) {
  const int dimension = source.integer("the dimension of an entity");
  if (dimension < 0 || dimension > max_dimension)
    source.fail("the dimension of an entity is " + std::to_string(dimension) + ", but must be 0 to 3. Save the mesh " +
                "anew from Gmsh.");
  return dimension;
}

MshTag read_entity(ByteSource& source) {
  const int dimension = read_dimension(source);
  return {dimension, source.integer("the number of an entity")};
}

/// Least bytes of a label and of some numbers behind it.
std::size_t label_and(ByteSource& source, std::size_t bytes) {
  return static_cast<std::size_t>(source.encoding().label_bytes) + bytes;
}

/// A list of numbers behind its length.
std::vector<std::int64_t> read_integers(ByteSource& source, const char* count, const char* what) {
  std::vector<std::int64_t> list(source.count(count, {1, 4}));
  for (std::int64_t& item : list) item = source.integer(what);
  return list;
}

/// The numbers of points, curves, surfaces and volumes.
std::array<std::size_t, 4> read_entity_counts(ByteSource& source) {
  std::array<std::size_t, 4> counts;
  for (std::size_t& count : counts) count = source.count("a number of entities", {5, 4});
  return counts;
}

/// What both sections of entities end with: extent, physical groups (the sign tells an orientation) and what bounds the
/// entity.
std::vector<std::int64_t> read_groups(ByteSource& source, int dimension) {
  source.skip_numbers(dimension == 0 ? 3 : 6, "a coordinate of an entity");
  std::vector<std::int64_t> groups = read_integers(source, "the number of physical groups", "a physical group");
  for (std::int64_t& group : groups) group = std::abs(group);
  if (dimension > 0) read_integers(source, "the number of bounding entities", "a bounding entity");
  return groups;
}

constexpr const char* entity_kinds[] = {"point", "curve", "surface", "volume"};

}  // namespace

void read_msh4_entities(ByteSource& source, MshContents& contents) {
  const std::array<std::size_t, 4> counts = read_entity_counts(source);
  for (int dimension = 0; dimension <= max_dimension; ++dimension)
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      const int entity = source.integer("the number of an entity");
      source.enter(entity_kinds[dimension], entity);
      contents.groups[{dimension, entity}] = read_groups(source, dimension);
    }
}

void read_msh4_partitioned_entities(ByteSource& source, MshContents& contents) {
  source.label("the number of partitions");
  const std::size_t num_ghosts = source.count("the number of ghost entities", {2, 8});
  source.skip_integers(2 * num_ghosts, "a ghost entity");
  const std::array<std::size_t, 4> counts = read_entity_counts(source);
  for (int dimension = 0; dimension <= max_dimension; ++dimension)
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      const int entity = source.integer("the number of an entity");
      source.enter(entity_kinds[dimension], entity);
      source.skip_integers(2, "the entity that was partitioned");
      read_integers(source, "the number of partitions", "a partition");
      contents.groups[{dimension, entity}] = read_groups(source, dimension);
    }
}

void read_msh4_nodes(ByteSource& source, MshContents& contents) {
  const std::size_t num_blocks = source.count("the number of blocks", {4, 12});
  // How many nodes there are follows from the blocks alone.
  for (const char* what : {"the number of nodes", "the least number of a node", "the largest number of a node"})
    source.label(what);
  for (std::size_t block = 0; block < num_blocks; ++block) {
    source.enter("$Nodes");
    const auto [dimension, entity] = read_entity(source);
    const bool is_parametric = source.integer("1 where nodes are parametric, else 0") != 0;
    const std::size_t num_parameters = is_parametric ? static_cast<std::size_t>(dimension) : 0;
    const std::size_t num_nodes = source.count("the number of nodes of a block",
                                               {4 + num_parameters, label_and(source, 8 * (3 + num_parameters))});
    const std::size_t first = contents.node_label.size();
    for (std::size_t i = 0; i < num_nodes; ++i) contents.node_label.push_back(source.label("the number of a node"));
    for (std::size_t i = 0; i < num_nodes; ++i) {
      source.enter("node", contents.node_label[first + i]);
      contents.node_position.push_back(read_position(source));
      source.skip_numbers(num_parameters, "a parametric coordinate");
    }
  }
}

void read_msh4_elements(ByteSource& source, MshContents& contents) {
  const std::size_t num_blocks = source.count("the number of blocks", {4, 12});
  for (const char* what :
       {"the number of elements", "the least number of an element", "the largest number of an element"})
    source.label(what);
  ElementReader reader(source, contents);
  for (std::size_t block = 0; block < num_blocks; ++block) {
    source.enter("$Elements");
    const MshTag entity = read_entity(source);
    const MshElementType& type = read_element_type(source);
    const auto num_nodes = static_cast<std::size_t>(type.num_nodes);
    const std::size_t num_elements =
        source.count("the number of elements of a block", {1 + num_nodes, label_and(source, 0) * (1 + num_nodes)});
    reader.begin_block(type, entity, 0);
    for (std::size_t i = 0; i < num_elements; ++i) {
      const std::int64_t label = source.label("the number of an element");
      source.enter("element", label);
      reader.read_element(label);
    }
  }
}

}  // namespace tentpole
