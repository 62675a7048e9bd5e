#pragma once

#include <string>

namespace tentpole {

/// A type of element of the .msh format.
struct MshElementType {
  const char* shape = nullptr;  ///< as Gmsh calls it, "Triangle"; nullptr: the number means nothing
  int dimension = 0;
  int num_nodes = 0;  ///< corners first; 0: varies from element to element
  bool is_linear_simplex = false;

  std::string name() const;  ///< with the number of nodes, "Triangle 6"
};

/// The type with this number, or nullptr.
const MshElementType* find_msh_element_type(int number);

}  // namespace tentpole
