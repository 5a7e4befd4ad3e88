#include "lib/quantity/expression/expression.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <limits>

namespace loadpath {

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

Outcome<Signature> Expression::check(const Declared& declared) const { return expression::check(*tree_, declared); }

Value Expression::evaluate(const Known& known) const {
  const auto signature =
      check([&known](const std::string& path) -> Outcome<Signature> { return known(path).signature; });
  if (!signature) return {{}, {std::numeric_limits<double>::quiet_NaN()}};
  Value value = expression::numbers(tree_->root, known);
  value.signature = *signature;
  return value;
}

}  // namespace loadpath
