#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/case_file/document.hpp"
#include "host/case_file/expression.hpp"

namespace tentpole {

/// What a value must satisfy.
struct Rule {
  std::function<bool(double)> holds;
  std::string requirement;  ///< "must be positive"
  std::string advice;       ///< the way out: "Give the mass density in kg/m^3."
};

/// Numbers beyond these bounds have products that overflow, or are 0, so no key takes them, whatever its rule is.
bool has_usable_size(double value);

Rule positive(const std::string& advice);
Rule not_negative(const std::string& advice);
/// low < value < high.
Rule between(double low, double high, const std::string& advice);
/// low <= value <= high.
Rule from_to(double low, double high, const std::string& advice);

enum class Presence { required, optional };

/// Reads the keys of one table with their types and rules. Faults are added to the problems and reading goes on, so
/// that all of them are found; a faulty or absent value is nullopt.
class TableReader {
 public:
  TableReader(const Node& table, std::vector<Problem>& problems);
  /// The table `name` of the document's root; absent or no table, it reads as empty.
  static TableReader section(const Node& root, const std::string& name, std::vector<Problem>& problems);

  /// False if the table is absent or no table; then nothing in it is reported as missing.
  bool is_given() const { return table_ != nullptr; }
  bool has(const std::string& key) const { return find(key) != nullptr; }
  const Node* find(const std::string& key) const { return table_ ? table_->find(key) : nullptr; }
  /// The keys of the table that are tables themselves; others are problems. `example` is how to write one.
  std::vector<const Node*> tables(const std::string& example) const;
  /// The elements of the array of tables `key`.
  std::vector<const Node*> tables_in_array(const std::string& key) const;

  void allow_only(const std::vector<std::string>& keys) const;
  std::optional<double> number(const std::string& key, Presence presence, const Rule& rule) const;
  std::optional<std::int64_t> integer(const std::string& key, Presence presence, const Rule& rule) const;
  std::optional<bool> boolean(const std::string& key, Presence presence) const;
  std::optional<std::string> text(const std::string& key, Presence presence) const;
  /// Index of a text among the choices.
  std::optional<std::size_t> choice(const std::string& key, Presence presence,
                                    const std::vector<std::string>& choices) const;
  std::optional<std::vector<std::string>> texts(const std::string& key, Presence presence) const;
  /// Numbers of an array of the given size; size 0: any.
  std::optional<std::vector<double>> numbers(const std::string& key, Presence presence, int size,
                                             const Rule& rule) const;
  /// A text or number as an expression.
  std::optional<Expression> expression(const std::string& key, Presence presence, const Constants& constants) const;
  /// One expression per dimension, in an array.
  std::optional<VectorExpression> vector_expression(const std::string& key, Presence presence, int dimension,
                                                    const Constants& constants) const;

  /// Place of a key, given or not.
  SourceLocation location(const std::string& key) const;
  void report(const std::string& key, const std::string& reason) const;
  void report(const Node& node, const std::string& reason) const;

 private:
  TableReader(SourceLocation place, std::vector<Problem>& problems);

  /// The node of the key if it has one of the kinds; otherwise nullptr, with a problem unless absent and optional.
  /// `wanted` completes "Give "; `advice`, unless empty, is said instead where the key is missing.
  const Node* expect(const std::string& key, Presence presence, std::initializer_list<Node::Kind> kinds,
                     const std::string& wanted, const std::string& advice = "") const;
  bool obeys(const Node& node, const Rule& rule) const;
  std::optional<Expression> expression_of(const Node& node, const Constants& constants) const;

  const Node* table_ = nullptr;
  SourceLocation place_;  ///< of the table itself
  std::vector<Problem>* problems_;
  bool broken_ = false;  ///< given, but not as a table: reported once by read_case
};

}  // namespace tentpole
