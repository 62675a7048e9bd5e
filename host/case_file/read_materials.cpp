#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

MaterialProperties read_material(const TableReader& reader, int dimension) {
  reader.allow_only({"density", "youngs_modulus", "poisson_ratio", "plane"});
  MaterialProperties material{};
  const auto density = reader.number("density", Presence::required, positive("Give the mass density in kg/m^3."));
  const auto modulus = reader.number("youngs_modulus", Presence::required, positive("Give the modulus in Pa."));
  const auto ratio = reader.number("poisson_ratio", Presence::required,
                                   between(-1, 0.5, "Give a ratio below 0.5; near 0.5 the solid is incompressible."));
  const auto plane = reader.choice("plane", Presence::optional, {"strain", "stress"});
  if (plane && dimension != 0 && dimension != 2)
    reader.report("plane", "is for domain.dimension = 2 only, which is " + std::to_string(dimension) +
                               ". Remove it; D = 1 means uniaxial strain.");
  material.density = density.value_or(1);
  material.youngs_modulus = modulus.value_or(1);
  material.poisson_ratio = ratio.value_or(0);
  material.plane = plane.value_or(0) == 0 ? Plane::strain : Plane::stress;
  return material;
}

}  // namespace

std::map<std::string, MaterialProperties> read_materials(const SectionContext& context) {
  std::map<std::string, MaterialProperties> materials;
  const TableReader reader = context.section("material");
  const std::vector<const Node*> regions = reader.tables("[material.all]");
  for (const Node* region : regions) {
    if (context.domain.is_box() && region->name != "all")
      reader.report(*region, "unknown region. The generated box has one region: write [material.all].");
    else
      materials[region->name] = read_material(TableReader(*region, context.problems), context.domain.dimension);
  }
  if (regions.empty())
    reader.report("all", "missing. Give [material.all] with density, youngs_modulus and poisson_ratio.");
  return materials;
}

}  // namespace tentpole
