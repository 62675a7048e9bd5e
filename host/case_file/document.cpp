#include "host/case_file/document.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "host/case_file/number_text.hpp"
#include "host/case_file/toml_text.hpp"
#include "host/mesh/toml_name.hpp"

// toml++ 3.3.0 takes for granted that a key follows "[", so "[#" is undefined behaviour in an optimised build
// (2026-11). Its assumptions throw here instead. No other file may include toml++, or two versions of it would be
// linked.
namespace tentpole {
struct TomlAssumptionFailed {};
[[noreturn]] static void refuse_toml() {
  throw TomlAssumptionFailed();
}
}  // namespace tentpole
// clang-format off: the order of these includes matters
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(condition) ((condition) ? void() : ::tentpole::refuse_toml())
#define TOML_ASSERT_ASSUME(condition) TOML_ASSERT(condition)
#include <toml++/toml.h>
// clang-format on

namespace tentpole {
namespace {

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 70;  // keep a message on a line
  return text.size() <= longest ? text : text.substr(0, longest - 3) + "...";
}

Node::Kind kind_of(const toml::node& source) {
  switch (source.type()) {
    case toml::node_type::table:
      return Node::Kind::table;
    case toml::node_type::array:
      return Node::Kind::array;
    case toml::node_type::string:
      return Node::Kind::text;
    case toml::node_type::integer:
      return Node::Kind::integer;
    case toml::node_type::floating_point:
      return Node::Kind::number;
    case toml::node_type::boolean:
      return Node::Kind::boolean;
    default:
      return Node::Kind::date;
  }
}

/// A float of the file: 2.0 stays apart from the integer 2.
std::string float_text(double value) {
  const std::string text = number_text(value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

/// Copies the value of a scalar and returns it as written in messages.
std::string convert_scalar(const toml::node& source, Node& node) {
  switch (node.kind) {
    case Node::Kind::boolean:
      node.boolean = **source.as_boolean();
      return node.boolean ? "true" : "false";
    case Node::Kind::integer:
      node.integer = **source.as_integer();
      node.number = static_cast<double>(node.integer);
      return std::to_string(node.integer);
    case Node::Kind::number:
      node.number = **source.as_floating_point();
      return float_text(node.number);
    case Node::Kind::text:
      node.text = **source.as_string();
      return "\"" + node.text + "\"";
    default:
      return "a date or time";
  }
}

/// Copies a toml++ tree; `location` names the file and the full key of the node.
Node convert(const toml::node& source, std::string name, SourceLocation location) {
  Node node;
  node.kind = kind_of(source);
  node.name = std::move(name);
  if (!location.is_override()) location.line = static_cast<int>(source.source().begin.line);
  const SourceLocation parent{location.file, 0, 0, location.key, ""};
  std::string elements;
  if (const toml::table* table = source.as_table()) {
    for (const auto& [key, child] : *table) {
      SourceLocation place = parent;
      place.key += (place.key.empty() ? "" : ".") + toml_key(std::string(key.str()));
      node.children.push_back(convert(child, std::string(key.str()), place));
    }
  } else if (const toml::array* array = source.as_array()) {
    for (const toml::node& child : *array) {
      SourceLocation place = parent;
      place.key += "[" + std::to_string(node.children.size() + 1) + "]";
      node.children.push_back(convert(child, "", place));
      elements += (elements.empty() ? "" : ", ") + node.children.back().location.value;
    }
    location.value = shortened("[" + elements + "]");
  } else {
    location.value = shortened(convert_scalar(source, node));
  }
  if (location.line == 0 && !node.children.empty()) location.line = node.children.front().location.line;
  node.location = std::move(location);
  return node;
}

/// The value of an override: TOML if it reads as one value, else the text itself.
Node override_value(const std::string& text, const std::string& name, const std::string& key) {
  const SourceLocation location{"--set", 0, 0, key, ""};
  const std::string line = "value = " + text;
  if (text.find('\n') == std::string::npos && !find_toml_text_fault(line)) {
    try {
      const toml::table table = toml::parse(line);
      if (table.size() == 1 && table.contains("value")) return convert(*table.get("value"), name, location);
    } catch (const toml::parse_error&) {
      // not TOML: an expression such as 2*V, taken as a string
    } catch (const TomlAssumptionFailed&) {
    }
  }
  const toml::value<std::string> string(text);
  return convert(string, name, location);
}

Node& child_or_new(Node& table, const std::string& name, const std::string& key) {
  for (Node& child : table.children)
    if (child.name == name) return child;
  Node& child = table.children.emplace_back();
  child.name = name;
  child.location = {"--set", 0, 0, key, ""};
  return child;
}

/// Place of the first line that opens a table without a name: "[" and something that begins no key.
SourceLocation nameless_header(const std::string& text, const std::string& file) {
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    const auto bracket = line.find_first_not_of(" \t");
    if (bracket == std::string::npos || line[bracket] != '[') continue;
    const auto name = line.find_first_not_of(" \t[", bracket);
    if (name == std::string::npos) continue;
    const char first = line[name];
    if (!std::isalnum(static_cast<unsigned char>(first)) && std::string("_-\"']").find(first) == std::string::npos)
      return {file, number, static_cast<int>(name) + 1, "", ""};
  }
  return {file, 0, 0, "", ""};
}

/// Where the first "=" outside quotation marks stands.
std::size_t find_equals(const std::string& text) {
  bool is_quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"') is_quoted = !is_quoted;
    if (text[at] == '=' && !is_quoted) return at;
  }
  return text.find('=');
}

/// The names of a dotted key, which may be quoted as in TOML; none if it is no key.
std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> names;
  if (key.find('"') == std::string::npos) {
    std::istringstream path(key);
    for (std::string name; std::getline(path, name, '.');) names.push_back(name);
    const bool is_key = !key.empty() && key.back() != '.' && std::ranges::count(names, "") == 0;
    return is_key && names.size() <= deepest_toml_nesting ? names : std::vector<std::string>{};
  }
  if (find_toml_text_fault(key)) return names;
  try {
    const toml::table parsed = toml::parse(key + " = 0");
    for (const toml::table* table = &parsed; table && table->size() == 1; table = table->begin()->second.as_table())
      names.emplace_back(table->begin()->first.str());
  } catch (const toml::parse_error&) {
    names.clear();
  } catch (const TomlAssumptionFailed&) {
    names.clear();
  }
  return names;
}

/// Replaces or adds the value that "section.key=value" names.
void apply_override(Node& root, const std::string& text, std::vector<Problem>& problems) {
  const auto equals = find_equals(text);
  const std::string key = text.substr(0, equals);
  const std::vector<std::string> names = split_key(key);
  const SourceLocation place{"--set", 0, 0, text, ""};
  if (equals == std::string::npos || names.empty()) {
    problems.push_back({place, "is no override. Write --set section.key=value, e.g. --set time.end=1e-6."});
    return;
  }
  std::string prefix;
  Node* node = &root;
  for (const std::string& name : names) {
    if (node->kind != Node::Kind::table) {
      problems.push_back({place, prefix + " is " + kind_name(node->kind) +
                                     ", not a table, so nothing inside it can be set. Change it in the file."});
      return;
    }
    prefix += (prefix.empty() ? "" : ".") + toml_key(name);
    node = &child_or_new(*node, name, prefix);
  }
  *node = override_value(text.substr(equals + 1), names.back(), key);
}

/// The whole file; throws if there is no text in it or too much.
std::string read_text(const SourceLocation& file, const std::filesystem::path& path, std::vector<Problem>& problems) {
  std::error_code ignored;  // what is wrong with the path is all one here
  std::string text;
  std::ifstream stream(path, std::ios::binary);
  if (stream && std::filesystem::is_regular_file(path, ignored)) {
    // Block by block: the limit is far beyond what a case takes.
    for (char block[1 << 14]; stream && text.size() <= largest_toml_file;) {
      stream.read(block, sizeof block);
      text.append(block, static_cast<std::size_t>(stream.gcount()));
    }
  }
  if (text.empty()) problems.push_back({file, "is not a readable file with text in it. Give the path of a TOML file."});
  if (text.size() > largest_toml_file)
    problems.push_back({file, "has more than " + std::to_string(largest_toml_file / 1'000'000) +
                                  " MB, so it is no case. Give the path of a TOML file."});
  if (!problems.empty()) throw InputError(problems);
  return text;
}

}  // namespace

const Node* Node::find(const std::string& key) const {
  for (const Node& child : children)
    if (child.name == key) return &child;
  return nullptr;
}

const char* kind_name(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::boolean:
      return "a boolean";
    case Node::Kind::integer:
      return "an integer";
    case Node::Kind::number:
      return "a number";
    case Node::Kind::text:
      return "a string";
    case Node::Kind::date:
      return "a date or time";
    case Node::Kind::array:
      return "an array";
    case Node::Kind::table:
      return "a table";
  }
  return "an unknown kind";
}

Node read_document(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                   std::vector<Problem>& problems) {
  const SourceLocation file{path.string(), 0, 0, "", ""};
  const std::string text = read_text(file, path, problems);
  if (const auto fault = find_toml_text_fault(text)) {
    problems.push_back({{file.file, fault->line, fault->column, "", ""}, "this is not TOML: " + fault->reason});
    throw InputError(problems);
  }
  try {
    Node root = convert(toml::parse(text), "", file);
    root.location = file;
    for (const std::string& item : overrides) apply_override(root, item, problems);
    return root;
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    problems.push_back({{file.file, static_cast<int>(begin.line), static_cast<int>(begin.column), "", ""},
                        "this is not TOML: " + std::string(error.description()) +
                            ". Correct the text there; texts need quotes, tables [brackets]."});
  } catch (const TomlAssumptionFailed&) {
    problems.push_back({nameless_header(text, file.file),
                        "this is not TOML: a name must follow the bracket. Write a table as [name]."});
  }
  throw InputError(problems);
}

}  // namespace tentpole
