#include <algorithm>
#include <tuple>
#include <utility>

#include "common/simplex.hpp"
#include "host/case_file/case.hpp"
#include "host/case_file/sections.hpp"
#include "host/mesh/toml_name.hpp"

namespace tentpole {
namespace {

VectorExpression zero_vector(int dimension) {
  return VectorExpression(std::vector<Expression>(static_cast<std::size_t>(dimension)));
}

/// A vector field of an optional section, e.g. velocity of [initial].
std::optional<VectorExpression> read_field(const SectionContext& context, const std::string& section,
                                           const std::string& key, Presence presence) {
  const TableReader reader = context.section(section);
  if (!reader.is_given() || context.domain.dimension == 0) return std::nullopt;
  return reader.vector_expression(key, presence, context.domain.dimension, context.constants);
}

void read_fields(const SectionContext& context, Case& result) {
  context.section("initial").allow_only({"displacement", "velocity"});
  context.section("body_force").allow_only({"acceleration"});
  context.section("exact").allow_only({"displacement"});
  const VectorExpression zero = zero_vector(context.domain.dimension);
  result.initial_displacement = read_field(context, "initial", "displacement", Presence::optional).value_or(zero);
  result.initial_velocity = read_field(context, "initial", "velocity", Presence::optional).value_or(zero);
  result.body_force = read_field(context, "body_force", "acceleration", Presence::required).value_or(zero);
  result.exact_displacement = read_field(context, "exact", "displacement", Presence::required);
}

double read_end_time(const SectionContext& context) {
  const TableReader reader = context.section("time");
  reader.allow_only({"end"});
  return reader.number("end", Presence::required, positive("Give the end of the run in s.")).value_or(0);
}

int read_degree(const SectionContext& context) {
  const TableReader reader = context.section("discretization");
  reader.allow_only({"formulation", "degree"});
  reader.choice("formulation", Presence::optional, {"one-field"});
  const auto degree =
      reader.integer("degree", Presence::required, from_to(1, max_degree, "Give the degree in spacetime."));
  if (degree == 1)
    context.warnings.push_back(to_string(reader.location("degree")) +
                               ": degree 1 converges with order 1 only and is very dissipative. Use degree 2 or more.");
  return static_cast<int>(degree.value_or(1));
}

FrontSettings read_front(const SectionContext& context) {
  FrontSettings front;
  const TableReader reader = context.section("front");
  reader.allow_only({"causality", "smoothing"});
  const Rule rule = between(0, 1, "Give a factor below 1; the usual value is 0.95.");
  front.causality = reader.number("causality", Presence::optional, rule).value_or(front.causality);
  front.smoothing = reader.boolean("smoothing", Presence::optional).value_or(front.smoothing);
  return front;
}

void read_run_control(const SectionContext& context, Case& result) {
  const TableReader checkpoint = context.section("checkpoint");
  checkpoint.allow_only({"interval_minutes"});
  result.checkpoint_minutes =
      checkpoint.number("interval_minutes", checkpoint.is_given() ? Presence::required : Presence::optional,
                        positive("Give the wall-clock time between two checkpoints in minutes."));
  const TableReader run = context.section("run");
  run.allow_only({"batch_size"});
  result.batch_size = static_cast<int>(
      run.integer("batch_size", Presence::optional, from_to(1, 1e7, "Give the number of patches per batch."))
          .value_or(0));
}

std::string read_title(const SectionContext& context, const std::filesystem::path& path) {
  const TableReader root(context.root, context.problems);
  return root.text("title", Presence::optional).value_or(path.stem().string());
}

/// Everything but the title is a section.
void check_sections(const SectionContext& context) {
  const std::vector<std::string> sections{"constants",  "domain",   "material", "boundary",       "initial",
                                          "body_force", "exact",    "time",     "discretization", "front",
                                          "adaptivity", "fracture", "output",   "checkpoint",     "run"};
  std::vector<std::string> keys = sections;
  keys.insert(keys.begin(), "title");
  const TableReader root(context.root, context.problems);
  root.allow_only(keys);
  for (const std::string& section : sections)
    if (const Node* node = root.find(section); node && node->kind != Node::Kind::table)
      root.report(*node,
                  std::string("is ") + kind_name(node->kind) + ", but must be a table. Write [" + section + "].");
}

/// File problems by line, then those of overrides.
void sort_by_place(std::vector<Problem>& problems) {
  const auto place = [](const Problem& problem) {
    return std::tuple(problem.location.is_override(), problem.location.line, to_string(problem));
  };
  std::sort(problems.begin(), problems.end(), [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
}

}  // namespace

Material Case::material(const std::string& region) const {
  auto found = materials.find(region);
  if (found == materials.end() && materials.size() == 1) found = materials.find("all");
  if (found != materials.end()) return elastic_material(found->second, domain.dimension);
  std::string given;
  for (const auto& [name, properties] : materials) given += (given.empty() ? "" : ", ") + toml_key(name);
  throw InputError(path.string() + ": region " + toml_string(region) + " of the mesh has no material. Give [material." +
                   toml_key(region) + "]; given: " + given + ".");
}

double Case::process_zone_size() const {
  double fastest = 0;
  for (const auto& [region, properties] : materials)
    fastest = std::max(fastest, elastic_material(properties, domain.dimension).dilatational_speed());
  return fracture.process_zone_size.value_or(fastest * fracture.relaxation_time);
}

void set_seed(Case& settings, std::uint64_t seed) {
  NucleationSettings& nucleation = settings.fracture.nucleation;
  if (!settings.domain.is_box() && nucleation.model == NucleationModel::nowhere)
    throw InputError(
        "--seed " + std::to_string(seed) + ": nothing in " + settings.path.string() +
        " is drawn at random: the mesh is a file and there is no [fracture.nucleation]. Leave --seed out.");
  settings.domain.seed = seed;
  nucleation.seed = seed;
}

Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  std::vector<Problem> problems;
  const Node root = read_document(path, overrides, problems);
  Case result;
  result.path = path;
  SectionContext context{root, problems, result.warnings};
  check_sections(context);
  result.title = read_title(context, path);
  result.constants = context.constants = read_constants(context);
  result.domain = context.domain = read_domain(context, path.parent_path());
  result.end_time = context.end_time = read_end_time(context);
  result.degree = read_degree(context);
  check_mesh_is_numbered(context);
  result.materials = read_materials(context);
  result.boundaries = read_boundaries(context);
  read_fields(context, result);
  result.front = read_front(context);
  result.adaptivity = read_adaptivity(context);
  result.fracture = read_fracture(context);
  context.has_fracture = result.fracture.enabled;
  result.output = read_output(context);
  read_run_control(context, result);
  check_adaptive_run(context, result);
  if (problems.empty()) return result;
  sort_by_place(problems);
  throw InputError(std::move(problems));
}

}  // namespace tentpole
