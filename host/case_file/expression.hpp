#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/case_file/input_error.hpp"

namespace tentpole {

/// Named numbers of the case's [constants].
using Constants = std::map<std::string, double>;

/// A function of space and time written by the user: text in x, y, z, t, pi and the case's constants, with the
/// operators and functions of muParser (+ - * / ^, comparisons, && ||, a ? b : c, sin, exp, ln, sqrt, abs, min, max,
/// ...). Evaluation writes the parser's variables, hence it is not const: give each thread its own copy.
class Expression {
 public:
  /// The constant zero.
  Expression();
  explicit Expression(double value);
  /// Throws InputError with the location and the offending character if the text is no expression, and if it does not
  /// depend on x, y, z, t and is not finite.
  Expression(const std::string& text, const Constants& constants, const SourceLocation& location);
  Expression(const Expression& other);
  Expression(Expression&& other) noexcept;
  Expression& operator=(Expression other) noexcept;
  ~Expression();

  /// Value at the point [m] and time [s]; coordinates that the dimension does not have are 0.
  /// Throws InputError that names the key, the point and the time if the value is not finite.
  double evaluate(const std::array<double, 3>& point, double time);

  /// True if the text does not depend on x, y, z, t.
  bool is_constant() const { return compiled_ == nullptr; }
  /// True if it is the constant 0 (also for text such as "0*V").
  bool is_zero() const { return is_constant() && constant_ == 0; }
  /// As written; a number as the shortest text that gives it back.
  const std::string& text() const { return text_; }

 private:
  struct Compiled;
  std::string text_;
  SourceLocation location_;
  double constant_ = 0;
  std::unique_ptr<Compiled> compiled_;  ///< null: the constant
};

/// One expression per component in global axes; as many as the domain has dimensions.
class VectorExpression {
 public:
  VectorExpression() = default;
  explicit VectorExpression(std::vector<Expression> components) : components_(std::move(components)) {}

  /// Components 0..D-1; the others are 0. Throws as Expression::evaluate.
  std::array<double, 3> evaluate(const std::array<double, 3>& point, double time);
  /// True if every component is the constant 0 or there is none.
  bool is_zero() const;
  const std::vector<Expression>& components() const { return components_; }

 private:
  std::vector<Expression> components_;
};

/// The names in an expression in the order of their letters, each once: coordinates, constants, functions, and whatever
/// else looks like one. O(length).
std::vector<std::string> names_in(const std::string& text);

/// True for x, y, z, t, pi and the names of functions: names that no constant may have.
bool is_reserved_name(const std::string& name);

}  // namespace tentpole
