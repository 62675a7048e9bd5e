#include "host/fracture/defect_load.hpp"

#include "host/fracture/defect_field.hpp"

namespace tentpole {

double mean_defects_searched(int dimension, const NucleationSettings& nucleation, double measure, double strongest) {
  const auto distribution = StrengthDistribution::from_settings(nucleation);
  const DefectField field(dimension, nucleation.density, distribution, nucleation.seed);
  return nucleation.model == NucleationModel::field ? field.mean_number_searched(measure, strongest)
                                                    : field.mean_number(measure, strongest);
}

}  // namespace tentpole
