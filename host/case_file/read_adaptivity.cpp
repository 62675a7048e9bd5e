#include <algorithm>

#include "host/case_file/number_text.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

/// The shortest side of a generated box; 0 if unknown.
double smallest_extent(const DomainSettings& domain) {
  if (!domain.is_box() || domain.dimension == 0) return 0;
  double extent = domain.max[0] - domain.min[0];
  for (int axis = 1; axis < domain.dimension; ++axis) extent = std::min(extent, domain.max[axis] - domain.min[axis]);
  return extent;
}

void check_sizes(const TableReader& reader, const AdaptivitySettings& adaptivity, const DomainSettings& domain) {
  if (reader.has("min_size") && reader.has("max_size") && !(adaptivity.min_size < adaptivity.max_size))
    reader.report("max_size", "must exceed min_size = " + number_text(adaptivity.min_size) +
                                  ". Give a larger max_size or a smaller min_size.");
  const double extent = smallest_extent(domain);
  if (extent > 0 && adaptivity.min_size >= extent)
    reader.report("min_size", "must be smaller than the shortest side of the box, which is " + number_text(extent) +
                                  ". Give the length in m below which cells are not refined.");
}

}  // namespace

AdaptivitySettings read_adaptivity(const SectionContext& context) {
  AdaptivitySettings adaptivity;
  const TableReader reader = context.section("adaptivity");
  if (!reader.is_given()) return adaptivity;
  reader.allow_only({"enabled", "error_tolerance", "min_size", "max_size", "coarsening", "reference_energy"});
  adaptivity.enabled = reader.boolean("enabled", Presence::required).value_or(false);
  const Presence presence = adaptivity.enabled ? Presence::required : Presence::optional;
  const Rule part{[](double value) { return value >= 0 && value < 1; }, "must lie in [0, 1)",
                  "Give the part of error_tolerance below which elements may be coarsened, e.g. 0.05; 0 for never."};
  adaptivity.error_tolerance =
      reader
          .number("error_tolerance", presence,
                  positive("Give the dissipation that an element may have, over the reference energy."))
          .value_or(0);
  adaptivity.min_size = reader.number("min_size", presence, positive("Give a length in m.")).value_or(0);
  adaptivity.max_size = reader.number("max_size", Presence::optional, positive("Give a length in m."))
                            .value_or(AdaptivitySettings().max_size);
  adaptivity.coarsening = reader.number("coarsening", Presence::optional, part).value_or(adaptivity.coarsening);
  adaptivity.reference_energy = reader.number(
      "reference_energy", Presence::optional,
      positive("Give the energy in J that error_tolerance is a part of, or leave it out to have it estimated."));
  check_sizes(reader, adaptivity, context.domain);
  return adaptivity;
}

}  // namespace tentpole
