#pragma once

#include "host/mesh/msh/byte_source.hpp"
#include "host/mesh/msh/msh_contents.hpp"

// The readers of the sections. Each begins behind the line "$Section" and ends before "$EndSection".
namespace tentpole {

/// $MeshFormat, whose first line has been read: sets the encoding; the version, 2 or 4.
int read_msh_format(ByteSource& source);

/// $PhysicalNames
void read_physical_names(ByteSource& source, MshContents& contents);

// --- version 2
/// $Nodes, or $ParametricNodes.
void read_msh2_nodes(ByteSource& source, MshContents& contents, bool is_parametric);
/// $Elements
void read_msh2_elements(ByteSource& source, MshContents& contents);

// --- version 4.1
/// $Entities
void read_msh4_entities(ByteSource& source, MshContents& contents);
/// $PartitionedEntities: the entities that the elements of a partitioned mesh refer to. Ghost entities have no elements
/// of their own.
void read_msh4_partitioned_entities(ByteSource& source, MshContents& contents);
/// $Nodes
void read_msh4_nodes(ByteSource& source, MshContents& contents);
/// $Elements
void read_msh4_elements(ByteSource& source, MshContents& contents);

}  // namespace tentpole
