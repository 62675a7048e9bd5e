#pragma once

#include <cstdint>

#include "host/mesh/msh/byte_source.hpp"
#include "host/mesh/msh/msh_contents.hpp"
#include "host/mesh/msh/node_index.hpp"

namespace tentpole {

/// Reads elements one by one into the contents, their nodes as indices. Made after the nodes have been read.
class ElementReader {
 public:
  /// Throws MeshError if two nodes have the same label.
  ElementReader(ByteSource& source, MshContents& contents);

  /// The elements that follow have this type and these groups; the present block goes on if it has the same.
  void begin_block(const MshElementType& type, MshTag entity, std::int64_t group);

  /// Reads the nodes of an element of the block. Throws MeshError for a node that is not there.
  void read_element(std::int64_t label);

 private:
  ByteSource& source_;
  MshContents& contents_;
  NodeIndex index_;
};

/// Reads the number of a type. Throws MeshError for one that is unknown or has a varying number of nodes.
const MshElementType& read_element_type(ByteSource& source);

/// Three coordinates.
Point read_position(ByteSource& source);

}  // namespace tentpole
