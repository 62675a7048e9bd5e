#include "host/case_file/expression.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <muParser.h>

#include "host/case_file/number_text.hpp"

namespace tentpole {

/// muParser's byte code together with the variables it reads.
struct Expression::Compiled {
  Compiled(const std::string& text, const Constants& constants) {
    parser.ClearConst();  // muParser's own _pi and _e are not part of the language
    parser.DefineConst("pi", std::numbers::pi);
    for (const std::string& name : names_in(text))
      if (const auto found = constants.find(name); found != constants.end()) parser.DefineConst(name, found->second);
    bind();
    parser.SetExpr(text);
  }
  Compiled(const Compiled& other) : parser(other.parser) { bind(); }
  Compiled& operator=(const Compiled&) = delete;

  /// The parser keeps pointers to the variables, so a copy must point it to its own.
  void bind() {
    const char* const names[4] = {"x", "y", "z", "t"};
    for (int i = 0; i < 4; ++i) parser.DefineVar(names[i], &variables[i]);
  }

  std::array<double, 4> variables{};  ///< x, y, z, t
  mu::Parser parser;
};

namespace {

/// An assignment would silently write to a coordinate.
bool is_assignment(const std::string& text, std::size_t position) {
  if (text[position] != '=') return false;
  const char before = position > 0 ? text[position - 1] : ' ';
  const char after = position + 1 < text.size() ? text[position + 1] : ' ';
  return after != '=' && before != '=' && before != '<' && before != '>' && before != '!';
}

void refuse_assignment(const std::string& text, const SourceLocation& location) {
  for (std::size_t position = 0; position < text.size(); ++position)
    if (is_assignment(text, position))
      throw InputError(
          {{location, "character " + std::to_string(position + 1) +
                          ": assignments are not allowed. Compare with ==, or name numbers in [constants]."}});
}

std::string known_names(const Constants& constants) {
  std::string names = "x, y, z, t, pi";
  for (const auto& [name, value] : constants) names += ", " + name;
  return names;
}

Problem parser_problem(const mu::ParserError& error, const Constants& constants, const SourceLocation& location) {
  const std::string position = "character " + std::to_string(error.GetPos() + 1) + ": ";
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
    return {location, position + "unknown name or symbol \"" + error.GetToken() +
                          "\". Known names: " + known_names(constants) + ", and functions like sin, exp, sqrt, min."};
  std::string message = error.GetMsg();
  // muParser counts from 0 inside its message; the position is printed once, counted from 1
  if (const auto tail = message.find(" at position"); tail != std::string::npos) message.erase(tail);
  while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
  return {location, position + message + ". Correct the expression there."};
}

std::string point_text(const std::array<double, 3>& point, double time) {
  return "(x, y, z) = (" + number_text(point[0]) + ", " + number_text(point[1]) + ", " + number_text(point[2]) +
         ") m, t = " + number_text(time) + " s";
}

}  // namespace

Expression::Expression() : Expression(0.0) {}
Expression::Expression(double value) : text_(number_text(value)), constant_(value) {}

Expression::Expression(const std::string& text, const Constants& constants, const SourceLocation& location)
    : text_(text), location_(location) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError({{location, "the expression is empty. Write \"0\" for zero."}});
  refuse_assignment(text, location);
  try {
    compiled_ = std::make_unique<Compiled>(text, constants);
    int num_results = 0;
    const double* results = compiled_->parser.Eval(num_results);
    if (num_results != 1)
      throw InputError({{location, "has " + std::to_string(num_results) +
                                       " values separated by commas, but one is wanted. Use an array for a vector."}});
    constant_ = results[0];
    if (compiled_->parser.GetUsedVar().empty()) compiled_.reset();
  } catch (const mu::ParserError& error) {
    throw InputError({parser_problem(error, constants, location)});
  }
  if (is_constant() && !std::isfinite(constant_))
    throw InputError({{location, "is " + number_text(constant_) + ". Change the expression so that it is finite."}});
}

Expression::Expression(const Expression& other)
    : text_(other.text_),
      location_(other.location_),
      constant_(other.constant_),
      compiled_(other.compiled_ ? std::make_unique<Compiled>(*other.compiled_) : nullptr) {}

Expression::Expression(Expression&&) noexcept = default;

Expression& Expression::operator=(Expression other) noexcept {
  text_.swap(other.text_);
  std::swap(location_, other.location_);
  std::swap(constant_, other.constant_);
  compiled_.swap(other.compiled_);
  return *this;
}

Expression::~Expression() = default;

double Expression::evaluate(const std::array<double, 3>& point, double time) {
  if (is_constant()) return constant_;
  compiled_->variables = {point[0], point[1], point[2], time};
  const double value = compiled_->parser.Eval();
  if (!std::isfinite(value))
    throw InputError({{location_, "is " + number_text(value) + " at " + point_text(point, time) +
                                      ". Change the expression so that it is finite there."}});
  return value;
}

std::array<double, 3> VectorExpression::evaluate(const std::array<double, 3>& point, double time) {
  std::array<double, 3> value{};
  for (std::size_t i = 0; i < components_.size(); ++i) value[i] = components_[i].evaluate(point, time);
  return value;
}

bool VectorExpression::is_zero() const {
  for (const Expression& component : components_)
    if (!component.is_zero()) return false;
  return true;
}

std::vector<std::string> names_in(const std::string& text) {
  static const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", digits = "0123456789";
  std::vector<std::string> names;
  for (std::size_t start = 0; (start = text.find_first_of(letters + digits, start)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_not_of(letters + digits, start), text.size());
    // "1e5" and "1.e5" are numbers
    const bool is_number = digits.find(text[start]) != std::string::npos || (start > 0 && text[start - 1] == '.');
    if (!is_number) names.push_back(text.substr(start, end - start));
    start = end;
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

bool is_reserved_name(const std::string& name) {
  if (name == "x" || name == "y" || name == "z" || name == "t" || name == "pi") return true;
  static const mu::Parser parser;
  return parser.GetFunDef().contains(name);
}

}  // namespace tentpole
