#include <algorithm>

#include "host/case_file/number_text.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

/// Above this coefficient the equations of a sliding patch may have no solution (docs/case-file.md).
constexpr double largest_safe_friction = 0.6;
constexpr double cells_per_process_zone = 4;

void warn(const SectionContext& context, const std::string& section, const std::string& key, const std::string& text) {
  context.warnings.push_back(to_string(context.section(section).location(key)) + ": " + text);
}

/// What neither adaptive meshes nor fracture can have.
void check_feature(const SectionContext& context, const Case& settings, const std::string& section) {
  const TableReader reader = context.section(section);
  const int dimension = settings.domain.dimension;
  if (dimension > 2)
    reader.report("enabled",
                  "needs domain.dimension 1 or 2, which is " + std::to_string(dimension) + ". Set enabled = false.");
  for (const auto& [side, condition] : settings.boundaries)
    if (condition.is_periodic() && side < condition.periodic_partner())
      reader.report("enabled", "cannot be combined with periodic sides, which " + side + " and " +
                                   condition.periodic_partner() +
                                   " are. Give them other conditions, or set enabled = false.");
}

/// The longest interval of a generated box [m]; 0 for a mesh file.
double longest_interval(const DomainSettings& domain) {
  double longest = 0;
  for (int axis = 0; axis < domain.dimension && domain.is_box(); ++axis)
    longest = std::max(longest, (domain.max[axis] - domain.min[axis]) / domain.cells[axis]);
  return longest;
}

void warn_of_coarse_cracks(const SectionContext& context, const Case& settings) {
  if (!context.problems.empty()) return;  // materials may be among them
  const double wanted = settings.process_zone_size() / cells_per_process_zone;
  const std::string advice =
      "Damage needs cells of a quarter of the process zone, which is " + number_text(wanted) + " m. ";
  if (settings.adaptivity.enabled && settings.adaptivity.min_size > wanted)
    warn(context, "adaptivity", "min_size", "is too coarse for the cracks. " + advice + "Give a smaller min_size.");
  if (!settings.adaptivity.enabled && longest_interval(settings.domain) > wanted)
    warn(context, "fracture", "enabled",
         "the cells of [domain] are up to " + number_text(longest_interval(settings.domain)) + " m long. " + advice +
             "Switch on [adaptivity] or give more cells.");
}

}  // namespace

void check_adaptive_run(const SectionContext& context, const Case& settings) {
  const bool adaptivity = settings.adaptivity.enabled, fracture = settings.fracture.enabled;
  if (adaptivity) check_feature(context, settings, "adaptivity");
  if (fracture) check_feature(context, settings, "fracture");
  if (settings.front.smoothing && !adaptivity && !fracture)
    warn(context, "front", "smoothing", "has no effect on a fixed mesh. Switch on [adaptivity] or leave it out.");
  if (!fracture) return;
  if (settings.fracture.friction > largest_safe_friction)
    warn(context, "fracture", "friction",
         "with more friction than " + number_text(largest_safe_friction) +
             " a sliding crack may have no solution in a patch, which stops the run. Give a smaller value.");
  warn_of_coarse_cracks(context, settings);
}

}  // namespace tentpole
