#include "host/case_file/number_text.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

void read_law(const TableReader& reader, Presence presence, FractureSettings& fracture) {
  const auto optional = Presence::optional;
  fracture.threshold = reader.number("threshold", presence, positive("Give a traction in Pa.")).value_or(0);
  fracture.strength = reader.number("strength", presence, positive("Give a traction in Pa.")).value_or(0);
  if (fracture.threshold > 0 && fracture.strength > 0 && !(fracture.threshold < fracture.strength))
    reader.report("strength", "must exceed threshold = " + number_text(fracture.threshold) +
                                  ". Give a larger strength or a smaller threshold.");
  fracture.relaxation_time = reader.number("relaxation_time", presence, positive("Give a time in s.")).value_or(0);
  fracture.delay_exponent =
      reader.number("delay_exponent", optional, positive("The usual value is 10.")).value_or(fracture.delay_exponent);
  fracture.shear_factor =
      reader.number("shear_factor", optional, not_negative("The usual value is 1.")).value_or(fracture.shear_factor);
  fracture.friction = reader.number("friction", optional, not_negative("Give the coefficient of friction."))
                          .value_or(fracture.friction);
}

void read_resolution(const TableReader& reader, FractureSettings& fracture) {
  fracture.max_damage_step =
      reader.number("max_damage_step", Presence::optional, from_to(1e-6, 1, "The usual value is 0.2."))
          .value_or(fracture.max_damage_step);
  fracture.process_zone_size =
      reader.number("process_zone_size", Presence::optional,
                    positive("Give a length in m, or leave it out for wave speed times relaxation_time."));
  fracture.growth_length =
      reader.number("growth_length", Presence::optional,
                    positive("Give a length in m, or leave it out for a quarter of process_zone_size."));
}

/// A surface that appears under more than the threshold has missed part of its damage.
void warn_of_strong_defects(const TableReader& reader, const SectionContext& context,
                            const FractureSettings& fracture) {
  const NucleationSettings& nucleation = fracture.nucleation;
  if (nucleation.model == NucleationModel::nowhere || fracture.threshold == 0) return;
  if (nucleation.minimum >= fracture.threshold)
    context.warnings.push_back(to_string(reader.location("minimum")) +
                               ": no defect is weaker than fracture.threshold = " + number_text(fracture.threshold) +
                               ", so every new surface bears more than the threshold when it appears. "
                               "Give a smaller minimum.");
}

}  // namespace

FractureSettings read_fracture(const SectionContext& context) {
  FractureSettings fracture;
  const TableReader reader = context.section("fracture");
  if (!reader.is_given()) return fracture;
  reader.allow_only({"enabled", "threshold", "strength", "relaxation_time", "delay_exponent", "shear_factor",
                     "friction", "max_damage_step", "process_zone_size", "growth_length", "nucleation", "crack"});
  fracture.enabled = reader.boolean("enabled", Presence::required).value_or(false);
  read_law(reader, fracture.enabled ? Presence::required : Presence::optional, fracture);
  read_resolution(reader, fracture);
  if (const Node* table = reader.find("nucleation")) {
    if (table->kind == Node::Kind::table) {
      const TableReader nucleation(*table, context.problems);
      fracture.nucleation = read_nucleation(nucleation);
      warn_of_strong_defects(nucleation, context, fracture);
    } else {
      reader.report(*table, "must be a table. Write [fracture.nucleation].");
    }
  }
  fracture.cracks = read_cracks(reader, context);
  return fracture;
}

}  // namespace tentpole
