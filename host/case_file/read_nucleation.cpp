#include "host/case_file/number_text.hpp"
#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

constexpr double densest = 1e24;  // beyond this, cells of the defect field would be smaller than atoms

/// Value of a faulty or absent key, for checks that compare: it compares false with everything.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

void report_foreign(const TableReader& reader, std::initializer_list<const char*> keys,
                    const std::string& distribution) {
  for (const char* key : keys)
    if (reader.has(key))
      reader.report(key, "is of the " + distribution +
                             " distribution, which is not the one that is given. Remove it, " +
                             "or set distribution = \"" + distribution + "\".");
}

void read_normal(const TableReader& reader, NucleationSettings& nucleation) {
  report_foreign(reader, {"weibull_modulus", "weibull_scale"}, "weibull");
  const auto required = Presence::required;
  const double mean =
      reader.number("mean", required, positive("Give the mean strength of the defects in Pa.")).value_or(unknown);
  const double tail =
      reader
          .number("tail_strength", required, positive("Give a strength in Pa below the mean, e.g. fracture.strength."))
          .value_or(unknown);
  const auto probability = reader.number("tail_probability", required,
                                         between(0, 0.5, "Give the part of the defects weaker than tail_strength."));
  if (nucleation.minimum >= mean)
    reader.report("mean", "must exceed minimum = " + number_text(nucleation.minimum) +
                              ". Give a larger mean or a smaller minimum.");
  if (nucleation.maximum <= mean)
    reader.report("maximum", "must exceed mean = " + number_text(mean) +
                                 ". Give a larger maximum, or leave it out for no upper bound.");
  if (tail >= mean)
    reader.report("tail_strength", "must be smaller than mean = " + number_text(mean) +
                                       ", because less than half of the defects are weaker. Give a smaller strength.");
  nucleation.mean = mean;
  nucleation.tail_strength = tail;
  nucleation.tail_probability = probability.value_or(unknown);
}

void read_weibull(const TableReader& reader, NucleationSettings& nucleation) {
  report_foreign(reader, {"mean", "tail_strength", "tail_probability"}, "normal");
  nucleation.weibull_modulus =
      reader
          .number("weibull_modulus", Presence::required,
                  between(0, 1000, "Give the shape m of 1 - exp(-((s - minimum) / weibull_scale)^m)."))
          .value_or(unknown);
  nucleation.weibull_scale =
      reader.number("weibull_scale", Presence::required, positive("Give the scale in Pa.")).value_or(unknown);
  if (nucleation.maximum <= nucleation.minimum)
    reader.report("maximum", "must exceed minimum = " + number_text(nucleation.minimum) +
                                 ". Give a larger maximum, or leave it out for no upper bound.");
}

}  // namespace

NucleationSettings read_nucleation(const TableReader& reader) {
  NucleationSettings nucleation;
  reader.allow_only({"model", "distribution", "mean", "minimum", "maximum", "tail_strength", "tail_probability",
                     "weibull_modulus", "weibull_scale", "density", "seed"});
  const auto model = reader.choice("model", Presence::required, {"field", "sampled", "none"});
  constexpr NucleationModel models[] = {NucleationModel::field, NucleationModel::sampled, NucleationModel::nowhere};
  if (model) nucleation.model = models[*model];
  if (const auto seed = reader.integer("seed", Presence::optional, not_negative("Give 0, 1, 2, ...")))
    nucleation.seed = static_cast<std::uint64_t>(*seed);
  const auto distribution = reader.choice("distribution", Presence::optional, {"normal", "weibull"});
  if (!model || nucleation.model == NucleationModel::nowhere) return nucleation;
  nucleation.distribution = distribution.value_or(0) == 0 ? StrengthLaw::normal : StrengthLaw::weibull;
  nucleation.minimum =
      reader.number("minimum", Presence::required, not_negative("Give the smallest strength of the defects in Pa."))
          .value_or(unknown);
  nucleation.maximum =
      reader
          .number("maximum", Presence::optional, positive("Give a strength in Pa, or leave it out for no upper bound."))
          .value_or(nucleation.maximum);
  nucleation.density = reader
                           .number("density", Presence::required,
                                   from_to(0, densest, "Give the number of defects per m^2 (D = 1: per m)."))
                           .value_or(unknown);
  if (nucleation.distribution == StrengthLaw::normal)
    read_normal(reader, nucleation);
  else
    read_weibull(reader, nucleation);
  return nucleation;
}

}  // namespace tentpole
