#include <cctype>
#include <cmath>
#include <optional>

#include "host/case_file/sections.hpp"

namespace tentpole {
namespace {

bool is_identifier(const std::string& name) {
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) return false;
  for (const char letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter)) && letter != '_') return false;
  return true;
}

bool is_valid_name(const TableReader& reader, const Node& node) {
  if (!is_identifier(node.name)) {
    reader.report(node, "is no name. Use letters, digits and _, and begin with a letter.");
    return false;
  }
  if (is_reserved_name(node.name)) {
    reader.report(node, "the name is taken by a coordinate, pi or a function. Choose another one.");
    return false;
  }
  return true;
}

/// Evaluates those of the pending constants that need known ones only; true if there was one.
bool resolve_some(std::vector<const Node*>& pending, Constants& constants, std::vector<Problem>& unresolved) {
  unresolved.clear();
  std::vector<const Node*> left;
  for (const Node* node : pending) {
    try {
      Expression expression(node->text, constants, node->location);
      if (expression.is_constant()) {
        constants[node->name] = expression.evaluate({}, 0);
        continue;
      }
      unresolved.push_back({node->location, "depends on x, y, z or t. A constant may use numbers and constants only."});
    } catch (const InputError& error) {
      unresolved.insert(unresolved.end(), error.problems().begin(), error.problems().end());
    }
    left.push_back(node);
  }
  const bool progress = left.size() < pending.size();
  pending = std::move(left);
  return progress;
}

}  // namespace

Constants read_constants(const SectionContext& context) {
  Constants constants;
  const TableReader reader = context.section("constants");
  if (!reader.is_given()) return constants;
  std::vector<const Node*> pending;
  for (const Node& node : context.root.find("constants")->children) {
    if (!is_valid_name(reader, node)) continue;
    if (node.kind == Node::Kind::text) {
      pending.push_back(&node);
      continue;
    }
    const bool is_number = node.kind == Node::Kind::number || node.kind == Node::Kind::integer;
    if (!is_number || !std::isfinite(node.number)) reader.report(node, "must be a finite number or an expression.");
    constants[node.name] = is_number && std::isfinite(node.number) ? node.number : 1;
  }
  std::vector<Problem> unresolved;
  while (!pending.empty() && resolve_some(pending, constants, unresolved)) {
  }
  context.problems.insert(context.problems.end(), unresolved.begin(), unresolved.end());
  // so that what uses a faulty constant is not reported as well
  for (const Node* node : pending) constants[node->name] = 1;
  return constants;
}

}  // namespace tentpole
