#pragma once

#include "host/case_file/case.hpp"
#include "host/mesh/name_use.hpp"
#include "host/mesh/space_mesh.hpp"

namespace tentpole {

/// Which names of a mesh the case uses: regions by [material.REGION], where "all" is no name but every region that has
/// no table of its own; sides by [boundary.SIDE].
NameUse name_use(const Case& settings);

/// Every name of the mesh needs an entry of the case, and every entry must exist in the mesh. Throws InputError with
/// all that do not.
void check_mesh_names(const Case& settings, const SpaceMesh& mesh);

}  // namespace tentpole
