#pragma once

#include <cstdint>

/// The C interface of the module that reads .msh files. It is the only code linked with the Gmsh library and is loaded
/// when a .msh file is named, because that library brings a BLAS and an OpenMP runtime of its own into the process.
extern "C" {

/// Elements of one type on one elementary entity.
struct TentpoleGmshBlock {
  int dimension;
  int is_linear_simplex;  ///< 2-node line, 3-node triangle, 4-node tetrahedron or point
  const char* type_name;  ///< as Gmsh calls it, "Quadrilateral 4"
  int num_corners;        ///< nodes per element
  std::int64_t num_elements;
  const std::int64_t* number;     ///< [num_elements] as in the file
  const std::int64_t* corner;     ///< [num_elements][num_corners] vertex numbers as in the file
  int num_groups;                 ///< physical groups of the entity
  const char* const* group_name;  ///< [num_groups]; the group's number where it has no name
};

/// Everything the file says; owned by the module.
struct TentpoleGmshMesh {
  const char* error;  ///< why it could not be read, or null
  std::int64_t num_vertices;
  const std::int64_t* vertex_number;  ///< [num_vertices] as in the file
  const double* position;             ///< [num_vertices][3]
  int num_blocks;
  const TentpoleGmshBlock* block;
  void* owner;
};

/// Reads MSH 2.2 or 4.1, ASCII or binary. Never throws; look at `error`. Release it with tentpole_gmsh_release.
TentpoleGmshMesh tentpole_gmsh_read(const char* path);
void tentpole_gmsh_release(TentpoleGmshMesh mesh);

}  // extern "C"
