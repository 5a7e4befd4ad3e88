#include "lib/quantity/expression/expression.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;

/// What is never negative: a magnitude, or the larger of a value and a number that is not negative.
bool is_positive(const Node& call) {
  if (is_constant(call)) return false;
  return call.function->is_magnitude ||
         (call.function->name == "max" && std::any_of(call.kids.begin(), call.kids.end(), [](const Node& kid) {
            return is_constant(kid) && constant(kid) >= 0.0;
          }));
}

/// Through products and quotients with positive numbers; a sign, a signed factor, a sum or the choice of max and min
/// says what is meant, but a range or a mean square is never an extreme.
std::string_view unsigned_of(const Node& node, const Expression::Declared& declared) {
  if (node.operation == Operation::call && is_positive(node)) return node.function->name;
  if (node.operation == Operation::reference) {
    const auto signature = declared(node.path);
    return signature && signature->other_sign ? std::string_view(node.path) : std::string_view();
  }
  const bool product = node.operation == Operation::multiply || node.operation == Operation::divide;
  if (!product && node.operation != Operation::negate) return {};
  std::string_view name;
  bool sign = node.operation == Operation::negate;
  for (const Node& kid : node.kids) {
    const std::string_view of_kid = unsigned_of(kid, declared);
    if (!of_kid.empty()) name = of_kid;
    if (of_kid.empty() && !is_constant(kid)) return {};  // a signed factor
    if (is_constant(kid) && constant(kid) < 0.0) sign = true;
  }
  const bool is_extreme = name != "range" && name != "amplitude" && name != "rms";
  return sign && is_extreme ? std::string_view() : name;
}

bool holds(const Node& node, const Dimension& dimension, const Expression::Declared& declared) {
  if (node.operation == Operation::literal) return node.dimension == dimension;
  if (node.operation == Operation::reference) {
    const auto signature = declared(node.path);
    return signature && signature->dimension == dimension;
  }
  return std::any_of(node.kids.begin(), node.kids.end(),
                     [&](const Node& kid) { return holds(kid, dimension, declared); });
}

bool holds_pi(const Node& node) {
  const bool is_pi = node.operation == Operation::literal && node.si == std::numbers::pi && node.dimension.is_number();
  return is_pi || std::any_of(node.kids.begin(), node.kids.end(), holds_pi);
}

/// Null where there is none.
const Node* power_over_frequency(const expression::Tree& tree, const Node& node, const Expression::Declared& declared) {
  if (node.operation == Operation::divide) {
    const auto power = check(tree, node.kids[0], declared), frequency = check(tree, node.kids[1], declared);
    if (power && frequency && power->dimension == Dimension::of(2, 1, -3) &&
        frequency->dimension == Dimension::of(0, 0, -1))
      return &node;
  }
  for (const Node& kid : node.kids) {
    if (const Node* const found = power_over_frequency(tree, kid, declared)) return found;
  }
  return nullptr;
}

/// Whether a function gives one of what it is given.
bool keeps_quantity(expression::Rule rule) {
  using expression::Rule;
  return rule == Rule::reduction || rule == Rule::cycle_reduction || rule == Rule::place || rule == Rule::selection ||
         rule == Rule::same;
}

void add_handed_on(const Node& node, std::vector<Expression::Reference>& references) {
  if (node.operation == Operation::reference) references.push_back({node.path, node.at});
  const bool keeps = node.operation == Operation::negate || node.operation == Operation::add ||
                     node.operation == Operation::subtract ||
                     (node.operation == Operation::call && keeps_quantity(node.function->rule));
  if (!keeps) return;
  const bool is_place = node.operation == Operation::call && node.function->rule == expression::Rule::place;
  for (std::size_t kid = 0; kid < (is_place ? 1 : node.kids.size()); ++kid) add_handed_on(node.kids[kid], references);
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

std::vector<Expression::Reference> Expression::handed_on() const {
  std::vector<Reference> references;
  add_handed_on(tree_->root, references);
  return references;
}

Outcome<Signature> Expression::check(const Declared& declared) const { return expression::check(*tree_, declared); }

std::string_view Expression::unsigned_part(const Declared& declared) const {
  return unsigned_of(tree_->root, declared);
}

bool Expression::speaks_of(const Dimension& dimension, const Declared& declared) const {
  return holds(tree_->root, dimension, declared);
}

std::string Expression::work_of_cycle(const Declared& declared) const {
  const Node* const work = power_over_frequency(*tree_, tree_->root, declared);
  return work == nullptr || holds_pi(tree_->root) ? std::string() : tree_->written(*work);
}

Value Expression::evaluate(const Known& known) const {
  const auto signature =
      check([&known](const std::string& path) -> Outcome<Signature> { return known(path).signature; });
  if (!signature) return {{}, {std::numeric_limits<double>::quiet_NaN()}};
  Value value = expression::numbers(tree_->root, known);
  value.signature = *signature;
  return value;
}

bool Expression::evaluate(const Column& column, std::span<double> out) const {
  return expression::numbers(tree_->root, column, out);
}

}  // namespace loadpath
