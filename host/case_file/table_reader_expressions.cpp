#include <cmath>

#include "host/case_file/table_reader.hpp"

namespace tentpole {

std::optional<Expression> TableReader::expression_of(const Node& node, const Constants& constants) const {
  switch (node.kind) {
    case Node::Kind::integer:
    case Node::Kind::number:
      if (std::isfinite(node.number)) return Expression(node.number);
      report(node, "must be finite. Give a finite number or an expression.");
      return std::nullopt;
    case Node::Kind::text:
      break;
    default:
      report(node, std::string("is ") + kind_name(node.kind) + ". Give a number or an expression in quotes.");
      return std::nullopt;
  }
  try {
    return Expression(node.text, constants, node.location);
  } catch (const InputError& error) {
    problems_->insert(problems_->end(), error.problems().begin(), error.problems().end());
    return std::nullopt;
  }
}

std::optional<Expression> TableReader::expression(const std::string& key, Presence presence,
                                                  const Constants& constants) const {
  const Node* node = expect(key, presence, {Node::Kind::text, Node::Kind::number, Node::Kind::integer},
                            "a number or an expression in quotes");
  if (!node) return std::nullopt;
  return expression_of(*node, constants);
}

std::optional<VectorExpression> TableReader::vector_expression(const std::string& key, Presence presence, int dimension,
                                                               const Constants& constants) const {
  const std::string wanted =
      "an array of " + std::to_string(dimension) + (dimension > 1 ? " expressions" : " expression");
  const Node* array = expect(key, presence, {Node::Kind::array}, wanted);
  if (!array) return std::nullopt;
  if (array->children.size() != static_cast<std::size_t>(dimension)) {
    report(*array, "has " + std::to_string(array->children.size()) +
                       " entries, but domain.dimension = " + std::to_string(dimension) + ". Give " + wanted + ".");
    return std::nullopt;
  }
  std::vector<Expression> components;
  for (const Node& child : array->children)
    if (auto component = expression_of(child, constants)) components.push_back(std::move(*component));
  if (components.size() != array->children.size()) return std::nullopt;
  return VectorExpression(std::move(components));
}

}  // namespace tentpole
