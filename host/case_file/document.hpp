#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/case_file/input_error.hpp"

namespace tentpole {

/// A value of a TOML document together with the place where it was written.
struct Node {
  enum class Kind { boolean, integer, number, text, date, array, table };

  Kind kind = Kind::table;
  std::string name;  ///< key within its table; empty in an array
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0;  ///< also set for an integer
  std::string text;
  std::vector<Node> children;  ///< of an array or a table
  SourceLocation location;

  /// Child of a table, or nullptr.
  const Node* find(const std::string& key) const;
};

/// "a number", "a table", ...: the kind with its article.
const char* kind_name(Node::Kind kind);

/// Reads the TOML file and applies the overrides "section.key=value". Faulty overrides are added to `problems`.
/// Throws InputError if the file cannot be read or is not TOML; the problems so far are part of it.
Node read_document(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                   std::vector<Problem>& problems);

}  // namespace tentpole
