#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/case_file/case.hpp"
#include "host/case_file/table_reader.hpp"

namespace tentpole {

/// What the readers of the sections share. Faults go to `problems`; what a faulty key leaves behind is never used.
struct SectionContext {
  const Node& root;
  std::vector<Problem>& problems;
  std::vector<std::string>& warnings;
  Constants constants{};
  DomainSettings domain{};  ///< dimension 0: unknown, because it is faulty itself
  double end_time = 0;      ///< [s]; 0: unknown
  bool has_fracture = false;

  TableReader section(const std::string& name) const { return TableReader::section(root, name, problems); }
};

/// [constants]: numbers, or expressions of other constants.
Constants read_constants(const SectionContext& context);
/// [domain]
DomainSettings read_domain(const SectionContext& context, const std::filesystem::path& case_folder);
/// Reports a box whose cells cannot be numbered.
void check_mesh_is_numbered(const SectionContext& context);
/// [material.REGION]
std::map<std::string, MaterialProperties> read_materials(const SectionContext& context);
/// [boundary.SIDE]; a box must have all its sides, of which a periodic one may stand for its partner too.
std::map<std::string, BoundaryCondition> read_boundaries(const SectionContext& context);
/// [output] and [[output.probe]]
OutputSettings read_output(const SectionContext& context);
/// [adaptivity]
AdaptivitySettings read_adaptivity(const SectionContext& context);
/// [fracture] with the two below.
FractureSettings read_fracture(const SectionContext& context);
/// [fracture.nucleation]
NucleationSettings read_nucleation(const TableReader& nucleation);
/// [[fracture.crack]]
std::vector<CrackSettings> read_cracks(const TableReader& fracture, const SectionContext& context);
/// Faults of adaptive meshes and fracture that concern several sections, and warnings. Reads the whole case but output.
void check_adaptive_run(const SectionContext& context, const Case& settings);

/// True if the point lies in the closed box of the domain; true for a mesh file, whose extent is not known yet.
bool lies_in_domain(const DomainSettings& domain, const std::vector<double>& point);

}  // namespace tentpole
