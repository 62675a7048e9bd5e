#include "host/case_file/table_reader.hpp"

#include <algorithm>
#include <cmath>

#include "host/case_file/nearest_name.hpp"
#include "host/case_file/number_text.hpp"

namespace tentpole {
namespace {

bool is_number(const Node& node) {
  return node.kind == Node::Kind::number || node.kind == Node::Kind::integer;
}

}  // namespace

bool has_usable_size(double value) {
  return value == 0 || (1e-100 <= std::abs(value) && std::abs(value) <= 1e100);
}

Rule positive(const std::string& advice) {
  return {[](double value) { return value > 0; }, "must be positive", advice};
}

Rule not_negative(const std::string& advice) {
  return {[](double value) { return value >= 0; }, "must not be negative", advice};
}

Rule between(double low, double high, const std::string& advice) {
  return {[=](double value) { return low < value && value < high; },
          "must lie in (" + number_text(low) + ", " + number_text(high) + ")", advice};
}

Rule from_to(double low, double high, const std::string& advice) {
  return {[=](double value) { return low <= value && value <= high; },
          "must lie in [" + number_text(low) + ", " + number_text(high) + "]", advice};
}

TableReader::TableReader(const Node& table, std::vector<Problem>& problems)
    : table_(&table), place_(table.location), problems_(&problems) {}

TableReader::TableReader(SourceLocation place, std::vector<Problem>& problems)
    : place_(std::move(place)), problems_(&problems) {}

TableReader TableReader::section(const Node& root, const std::string& name, std::vector<Problem>& problems) {
  const Node* table = root.find(name);
  if (table && table->kind == Node::Kind::table) return TableReader(*table, problems);
  TableReader reader(SourceLocation{root.location.file, 0, 0, name, ""}, problems);
  reader.broken_ = table != nullptr;
  return reader;
}

std::vector<const Node*> TableReader::tables(const std::string& example) const {
  std::vector<const Node*> result;
  if (!table_) return result;
  for (const Node& child : table_->children) {
    if (child.kind == Node::Kind::table)
      result.push_back(&child);
    else
      report(child, std::string("is ") + kind_name(child.kind) + ", but must be a table. Write " + example +
                        " with its keys below.");
  }
  return result;
}

std::vector<const Node*> TableReader::tables_in_array(const std::string& key) const {
  std::vector<const Node*> result;
  const Node* array =
      expect(key, Presence::optional, {Node::Kind::array}, "tables. Write [[" + location(key).key + "]]");
  if (!array) return result;
  for (const Node& child : array->children) {
    if (child.kind == Node::Kind::table)
      result.push_back(&child);
    else
      report(child, "must be a table. Write [[" + array->location.key + "]] with its keys below.");
  }
  return result;
}

void TableReader::allow_only(const std::vector<std::string>& keys) const {
  if (!table_) return;
  for (const Node& child : table_->children)
    if (std::find(keys.begin(), keys.end(), child.name) == keys.end())
      report(child, "unknown key. " + suggestion(child.name, keys));
}

const Node* TableReader::expect(const std::string& key, Presence presence, std::initializer_list<Node::Kind> kinds,
                                const std::string& wanted, const std::string& advice) const {
  const Node* node = find(key);
  if (!node) {
    if (presence == Presence::required && !broken_)
      report(key, "missing. " + (advice.empty() ? "Give " + wanted + "." : advice));
    return nullptr;
  }
  if (std::find(kinds.begin(), kinds.end(), node->kind) != kinds.end()) return node;
  report(*node, std::string("is ") + kind_name(node->kind) + ". Give " + wanted + ".");
  return nullptr;
}

bool TableReader::obeys(const Node& node, const Rule& rule) const {
  const bool is_usable = has_usable_size(node.number);
  if (is_usable && rule.holds(node.number)) return true;
  const std::string size = is_usable                    ? ""
                           : std::isfinite(node.number) ? "must be 0 or of a size from 1e-100 to 1e100, and "
                                                        : "must be finite and ";
  report(node, size + rule.requirement + ". " + rule.advice);
  return false;
}

std::optional<double> TableReader::number(const std::string& key, Presence presence, const Rule& rule) const {
  const Node* node = expect(key, presence, {Node::Kind::number, Node::Kind::integer}, "a number", rule.advice);
  if (!node || !obeys(*node, rule)) return std::nullopt;
  return node->number;
}

std::optional<std::int64_t> TableReader::integer(const std::string& key, Presence presence, const Rule& rule) const {
  const Node* node = expect(key, presence, {Node::Kind::integer}, "an integer", rule.advice);
  if (!node || !obeys(*node, rule)) return std::nullopt;
  return node->integer;
}

std::optional<bool> TableReader::boolean(const std::string& key, Presence presence) const {
  const Node* node = expect(key, presence, {Node::Kind::boolean}, "true or false");
  if (!node) return std::nullopt;
  return node->boolean;
}

std::optional<std::string> TableReader::text(const std::string& key, Presence presence) const {
  const Node* node = expect(key, presence, {Node::Kind::text}, "a string in quotes");
  if (!node) return std::nullopt;
  return node->text;
}

std::optional<std::size_t> TableReader::choice(const std::string& key, Presence presence,
                                               const std::vector<std::string>& choices) const {
  std::string wanted;
  for (const std::string& item : choices) wanted += (wanted.empty() ? "\"" : " or \"") + item + "\"";
  const Node* node = expect(key, presence, {Node::Kind::text}, wanted);
  if (!node) return std::nullopt;
  const auto found = std::find(choices.begin(), choices.end(), node->text);
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  report(*node, "unknown choice. Give " + wanted + ".");
  return std::nullopt;
}

std::optional<std::vector<std::string>> TableReader::texts(const std::string& key, Presence presence) const {
  const Node* array = expect(key, presence, {Node::Kind::array}, "an array of strings");
  if (!array) return std::nullopt;
  std::vector<std::string> result;
  for (const Node& child : array->children) {
    if (child.kind == Node::Kind::text)
      result.push_back(child.text);
    else
      report(child, std::string("is ") + kind_name(child.kind) + ". Give a string in quotes.");
  }
  return result;
}

std::optional<std::vector<double>> TableReader::numbers(const std::string& key, Presence presence, int size,
                                                        const Rule& rule) const {
  const std::string wanted = size > 0 ? "an array of " + std::to_string(size) + " number" + (size > 1 ? "s" : "")
                                      : std::string("an array of numbers");
  const Node* array = expect(key, presence, {Node::Kind::array}, wanted);
  if (!array) return std::nullopt;
  if (size > 0 && array->children.size() != static_cast<std::size_t>(size)) {
    report(*array, "has " + std::to_string(array->children.size()) + " entries. Give " + wanted + ".");
    return std::nullopt;
  }
  std::vector<double> result;
  for (const Node& child : array->children) {
    if (!is_number(child))
      report(child, std::string("is ") + kind_name(child.kind) + ". Give a number.");
    else if (obeys(child, rule))
      result.push_back(child.number);
  }
  if (result.size() != array->children.size()) return std::nullopt;
  return result;
}

SourceLocation TableReader::location(const std::string& key) const {
  if (const Node* node = find(key)) return node->location;
  SourceLocation place = place_;
  place.value.clear();
  place.key += (place.key.empty() ? "" : ".") + key;
  return place;
}

void TableReader::report(const std::string& key, const std::string& reason) const {
  problems_->push_back({location(key), reason});
}

void TableReader::report(const Node& node, const std::string& reason) const {
  problems_->push_back({node.location, reason});
}

}  // namespace tentpole
