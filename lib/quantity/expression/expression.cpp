#include "lib/quantity/expression/expression.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;

/// Whether a call is never negative: a magnitude, or the larger of a value and a non-negative number.
bool is_positive(const Node& call) {
  if (is_constant(call)) return false;
  return call.function->is_magnitude ||
         (call.function->name == "max" && std::any_of(call.kids.begin(), call.kids.end(), [](const Node& kid) {
            return is_constant(kid) && constant(kid) >= 0.0;
          }));
}

/// Through products and quotients with positive numbers; a sign, a signed factor, a sum or the choice of max and min
/// expresses intent, but a range or a mean square is never an extreme.
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

constexpr std::size_t most_nodes = 4096;  // size limit of an expression with others written in

std::size_t count_nodes(const Node& node) {
  std::size_t count = 1;
  for (const Node& kid : node.kids) count += count_nodes(kid);
  return count;
}

void move_to(Node& node, std::size_t at, std::size_t length) {
  node.at = at, node.length = length;
  for (Node& kid : node.kids) move_to(kid, at, length);
}

void collect_references(const Node& node, std::vector<Expression::Reference>& references) {
  if (node.operation == Operation::reference) references.push_back({node.path, node.at});
  for (const Node& kid : node.kids) collect_references(kid, references);
}

/// Whether a function returns one of its arguments.
bool keeps_quantity(expression::Rule rule) {
  using expression::Rule;
  return rule == Rule::reduction || rule == Rule::cycle_reduction || rule == Rule::place || rule == Rule::selection ||
         rule == Rule::same;
}

double plain_number_of(const Node& node) {
  switch (node.operation) {
    case Operation::literal:
      return node.dimension.is_number() && node.si != std::numbers::pi ? node.si : std::nan("");
    case Operation::reference:
      return 1.0;
    case Operation::negate:
      return -plain_number_of(node.kids[0]);
    case Operation::multiply:
      return plain_number_of(node.kids[0]) * plain_number_of(node.kids[1]);
    case Operation::divide:
      return plain_number_of(node.kids[0]) / plain_number_of(node.kids[1]);
    default:
      return std::nan("");
  }
}

bool calls(const Node& node) {
  return node.operation == Operation::call || std::any_of(node.kids.begin(), node.kids.end(), calls);
}

/// The reference that is multiplied or divided only by a number, "1.2*shaft.tau_max"; null for anything else. A root
/// or a function changes its meaning: "sqrt(3)*shaft.tau_max".
const Node* multiple_of(const Node& node) {
  const auto is_number = [](const Node& kid) { return is_constant(kid) && !calls(kid); };
  if (node.operation == Operation::divide) return is_number(node.kids[1]) ? &node.kids[0] : nullptr;
  if (node.operation != Operation::multiply) return nullptr;
  if (is_number(node.kids[0])) return &node.kids[1];
  return is_number(node.kids[1]) ? &node.kids[0] : nullptr;
}

void add_handed_on(const Node& node, std::vector<Expression::Reference>& references) {
  if (node.operation == Operation::reference) references.push_back({node.path, node.at});
  if (const Node* const multiplied = multiple_of(node)) return add_handed_on(*multiplied, references);
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

double Expression::plain_number() const { return plain_number_of(tree_->root); }

std::vector<Expression::Reference> Expression::handed_on() const {
  std::vector<Reference> references;
  add_handed_on(tree_->root, references);
  return references;
}

Outcome<Signature> Expression::check(const Declared& declared) const { return expression::check(*tree_, declared); }

std::string_view Expression::unsigned_part(const Declared& declared) const {
  return unsigned_of(tree_->root, declared);
}

namespace {

/// False if it grows out of bounds.
bool write_into(Node& node, const std::function<const Node*(const std::string&)>& by, std::size_t& count) {
  const Node* const other = node.operation == Operation::reference ? by(node.path) : nullptr;
  if (other != nullptr) {
    count += count_nodes(*other);
    if (count > most_nodes) return false;
    Node written = *other;
    move_to(written, node.at, node.length);
    node = std::move(written);
    return true;
  }
  return std::all_of(node.kids.begin(), node.kids.end(), [&](Node& kid) { return write_into(kid, by, count); });
}

}  // namespace

bool Expression::write_out(const Written& by) {
  const auto root_of = [&](const std::string& path) -> const Node* {
    const Expression* const other = by(path);
    return other == nullptr ? nullptr : &other->tree_->root;
  };
  const bool any = std::any_of(references_.begin(), references_.end(),
                               [&](const Reference& reference) { return by(reference.path) != nullptr; });
  if (!any) return true;
  auto tree = std::make_unique<expression::Tree>(*tree_);
  std::size_t count = 0;
  if (!write_into(tree->root, root_of, count)) return false;
  references_.clear();
  collect_references(tree->root, references_);
  tree_ = std::move(tree);
  return true;
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
