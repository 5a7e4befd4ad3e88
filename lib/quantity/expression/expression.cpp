#include "lib/quantity/expression/expression.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <limits>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;

/// Through products and quotients with positive numbers; a sign, a signed factor, a sum or the choice of max and min
/// says what is meant, but a range or a mean square is never an extreme.
std::string_view magnitude_of(const Node& node) {
  if (node.operation == Operation::call && node.function->is_magnitude && !is_constant(node))
    return node.function->name;
  const bool product = node.operation == Operation::multiply || node.operation == Operation::divide;
  if (!product && node.operation != Operation::negate) return {};
  std::string_view name;
  bool sign = node.operation == Operation::negate;
  for (const Node& kid : node.kids) {
    const std::string_view of_kid = magnitude_of(kid);
    if (!of_kid.empty()) name = of_kid;
    if (of_kid.empty() && !is_constant(kid)) return {};  // a signed factor
    if (is_constant(kid) && constant(kid) < 0.0) sign = true;
  }
  return sign && (name == "peak" || name == "abs") ? std::string_view() : name;
}

}  // namespace

Expression::Expression() = default;
Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

Outcome<Expression> Expression::parse(std::string_view text) {
  auto parsed = expression::parse(text);
  if (!parsed) return parsed.fault();
  Expression result;
  result.tree_ = std::make_unique<const expression::Tree>(std::move(parsed->tree));
  result.references_ = std::move(parsed->references);
  return result;
}

const std::vector<Expression::Reference>& Expression::references() const { return references_; }

bool Expression::is_reference() const { return tree_->root.operation == Operation::reference; }

Outcome<Signature> Expression::check(const Declared& declared) const { return expression::check(*tree_, declared); }

std::string_view Expression::magnitude() const { return magnitude_of(tree_->root); }

Value Expression::evaluate(const Known& known) const {
  const auto signature =
      check([&known](const std::string& path) -> Outcome<Signature> { return known(path).signature; });
  if (!signature) return {{}, {std::numeric_limits<double>::quiet_NaN()}};
  Value value = expression::numbers(tree_->root, known);
  value.signature = *signature;
  return value;
}

}  // namespace loadpath
