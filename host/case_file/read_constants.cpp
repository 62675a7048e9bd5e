#include <cctype>
#include <cmath>
#include <map>
#include <span>

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

/// Evaluates constants in an order in which each one comes after those that it needs (Kahn 1962).
class ConstantResolver {
 public:
  ConstantResolver(std::span<const Node* const> pending, Constants& constants) : constants_(constants) {
    for (const Node* node : pending) entries_[node->name].node = node;
    for (auto& [name, entry] : entries_)
      for (const std::string& needed : names_in(entry.node->text))
        if (const auto found = entries_.find(needed); found != entries_.end()) {
          found->second.users.push_back(&entry);
          ++entry.num_missing;
        }
  }

  /// Returns what is wrong with the constants that have no value; those that go round in a circle name each other.
  std::vector<Problem> resolve() {
    std::vector<Entry*> ready;
    for (auto& [name, entry] : entries_)
      if (entry.num_missing == 0) ready.push_back(&entry);
    while (!ready.empty()) {
      Entry& entry = *ready.back();
      ready.pop_back();
      if (!evaluate(entry)) continue;
      for (Entry* user : entry.users)
        if (--user->num_missing == 0) ready.push_back(user);
    }
    for (auto& [name, entry] : entries_)
      if (entry.num_missing > 0) evaluate(entry);
    return std::move(problems_);
  }

 private:
  struct Entry {
    const Node* node = nullptr;
    std::vector<Entry*> users{};
    int num_missing = 0;  ///< constants that it needs and that have no value yet
  };

  bool evaluate(const Entry& entry) {
    const Node& node = *entry.node;
    try {
      Expression expression(node.text, constants_, node.location);
      if (expression.is_constant()) {
        constants_[node.name] = expression.evaluate({}, 0);
        return true;
      }
      problems_.push_back({node.location, "depends on x, y, z or t. A constant may use numbers and constants only."});
    } catch (const InputError& error) {
      problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
    }
    return false;
  }

  Constants& constants_;
  std::map<std::string, Entry> entries_;
  std::vector<Problem> problems_;
};

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
  const std::vector<Problem> unresolved = ConstantResolver(pending, constants).resolve();
  context.problems.insert(context.problems.end(), unresolved.begin(), unresolved.end());
  // so that what uses a faulty constant is not reported as well
  for (const Node* node : pending) constants.emplace(node->name, 1);
  return constants;
}

}  // namespace tentpole
