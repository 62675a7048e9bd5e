#include "host/output/fields.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/case_file/field_names.hpp"

namespace tentpole {
namespace {

template <auto Member>
void append_member(const SpacetimeElement&, const PointFields& at_point, std::vector<double>& values) {
  const auto& array = at_point.*Member;
  values.insert(values.end(), array.begin(), array.end());
}

constexpr OutputField table[] = {
    {"displacement", 3, FieldPlace::point, append_member<&PointFields::displacement>},
    {"velocity", 3, FieldPlace::point, append_member<&PointFields::velocity>},
    {"stress", 6, FieldPlace::point, append_member<&PointFields::stress>},
    {"strain_energy_density", 1, FieldPlace::point,
     [](const SpacetimeElement&, const PointFields& at_point, std::vector<double>& values) {
       values.push_back(at_point.strain_energy_density);
     }},
    {"damage", 1, FieldPlace::cell,
     [](const SpacetimeElement& element, const PointFields&, std::vector<double>& values) {
       values.push_back(element.damage);
     }},
};
static_assert(std::ranges::equal(table, field_names, {}, &OutputField::name), "every name of the case file has a row");

}  // namespace

std::vector<const OutputField*> output_fields(const std::vector<std::string>& names) {
  std::vector<const OutputField*> fields;
  for (const std::string& name : names) {
    const auto row = std::ranges::find(table, name, &OutputField::name);
    if (row == std::end(table)) throw std::invalid_argument("output field \"" + name + "\" is unknown");
    if (std::ranges::find(fields, row) != fields.end())
      throw std::invalid_argument("output field \"" + name + "\" is named twice; name it once");
    fields.push_back(row);
  }
  return fields;
}

}  // namespace tentpole
