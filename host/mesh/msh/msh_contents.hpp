#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/mesh/msh/element_type.hpp"
#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Dimension and number of an elementary entity or of a physical group.
using MshTag = std::pair<int, std::int64_t>;

/// Consecutive elements of one type in the same groups.
struct MshBlock {
  const MshElementType* type;
  MshTag entity;             ///< version 4: whose groups they have
  std::int64_t group;        ///< version 2: their physical group, 0 for none
  std::size_t first;         ///< index into element_label
  std::size_t first_corner;  ///< index into element_node
  std::size_t num_elements;
};

/// What a .msh file says, as far as it can matter here.
struct MshContents {
  bool has_entities = false;                           ///< version 4; in version 2 groups stand with the elements
  std::map<MshTag, std::string> group_name;            ///< dimension none: of any dimension (version 2.0)
  std::map<MshTag, std::vector<std::int64_t>> groups;  ///< of an entity, in the order of the file
  std::vector<std::int64_t> node_label;                ///< [node]
  std::vector<Point> node_position;                    ///< [node]
  std::vector<std::int64_t> element_label;             ///< [element]
  std::vector<std::int32_t> element_node;              ///< nodes of all elements, corners first
  std::vector<MshBlock> blocks;

  /// The name of a physical group, or its number where it has none.
  std::string name_of(int dimension, std::int64_t group) const;
};

}  // namespace tentpole
