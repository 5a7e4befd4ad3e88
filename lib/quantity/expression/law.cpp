#include "lib/quantity/expression/law.hpp"

#include "lib/quantity/expression/interval_functions.hpp"
#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;

/// The first function in a tree that has kinks, or none that could be differentiated.
const Node* find_kink(const Node& node) {
  const bool reduces = node.operation == Operation::call && node.function->jet == nullptr;
  if (reduces && node.function->jet_of_two == nullptr) return &node;
  for (const Node& kid : node.kids) {
    if (const Node* const kink = find_kink(kid)) return kink;
  }
  return nullptr;
}

struct AtPlace {
  using Number = numerics::Jet;
  static numerics::Jet constant(double value) { return {value}; }
  static numerics::Jet of(const expression::Function& f, const numerics::Jet& a) { return f.jet(a); }
  static numerics::Jet of(const expression::Function& f, const numerics::Jet& a, const numerics::Jet& b) {
    return f.jet_of_two(a, b);
  }
};

struct Between {
  using Number = IntervalJet;
  static IntervalJet constant(double value) { return {{value, value}, {}, {}}; }
  static IntervalJet of(const expression::Function& f, const IntervalJet& a) { return f.bounds(a); }
  static IntervalJet of(const expression::Function& f, const IntervalJet& a, const IntervalJet& b) {
    return f.bounds_of_two(a, b);
  }
};

/// The same walk at a place and over an interval.
template <class How>
typename How::Number value_of(const Node& node, const typename How::Number& variable) {
  using expression::operator+, expression::operator-, expression::operator*, expression::operator/, expression::pow;
  const auto kid = [&](std::size_t k) { return value_of<How>(node.kids[k], variable); };
  switch (node.operation) {
    case Operation::literal:
      return How::constant(node.si);
    case Operation::reference:
      return variable;
    case Operation::negate:
      return -kid(0);
    case Operation::add:
      return kid(0) + kid(1);
    case Operation::subtract:
      return kid(0) - kid(1);
    case Operation::multiply:
      return kid(0) * kid(1);
    case Operation::divide:
      return kid(0) / kid(1);
    case Operation::power:  // the check has made sure that the exponent is constant
      return pow(kid(0), constant(node.kids[1]));
    case Operation::call:
      return node.function->jet != nullptr ? How::of(*node.function, kid(0)) : How::of(*node.function, kid(0), kid(1));
  }
  return {};
}

/// Narrows the bounds: the deviation from the tangent in the middle is limited by the derivatives.
void draw_closer(IntervalJet& bounds, const numerics::Jet& middle, const Interval& away) {
  const auto at = [](double x) { return Interval{x, x}; };
  const bool known = std::isfinite(middle.value) && std::isfinite(middle.first) && std::isfinite(middle.second);
  if (!known) return;
  if (bounds.second.is_bounded()) {
    const double half = away.high;
    const Interval bend = bounds.second * Interval{0.0, 0.5 * half * half};
    bounds.first = both(bounds.first, at(middle.first) + bounds.second * away);
    bounds.value = both(bounds.value, at(middle.value) + at(middle.first) * away + bend);
  }
  if (bounds.first.is_bounded()) bounds.value = both(bounds.value, at(middle.value) + bounds.first * away);
}

}  // namespace

Law::Law() = default;
Law::~Law() = default;
Law::Law(Law&&) noexcept = default;
Law& Law::operator=(Law&&) noexcept = default;

Outcome<Law> Law::parse(std::string_view text, const Variable& variable, const Dimension& result) {
  auto parsed = expression::parse(text, {&variable.name, 1});
  if (!parsed) return parsed.fault();
  const std::string name(variable.name);
  const auto declared = [&](const std::string& path) -> Outcome<Signature> {
    if (path == name) return Signature{variable.dimension, nullptr};
    return Fault{0, path.size(), say("'{1}' is not known here", path),
                 say("a law has numbers with units and the variable {1}", name)};
  };
  if (const Node* const kink = find_kink(parsed->tree.root)) {
    return Fault{kink->at, kink->length, say("'{1}' has kinks, or uses a series", kink->function->name),
                 say("a law of motion must be smooth: its speed and acceleration come from it")};
  }
  const auto signature = expression::check(parsed->tree, declared);
  if (!signature) return expression::with_variables(signature.fault(), parsed->tree, {&variable.name, 1});
  if (signature->dimension.without_angle() != result.without_angle()) {
    return expression::with_variables(
        {0,
         text.size(),
         say("the law gives the kind '{1}', and '{2}' is expected", name_of(signature->dimension), name_of(result)),
         {}},
        parsed->tree, {&variable.name, 1});
  }
  Law law;
  law.tree_ = std::make_unique<const expression::Tree>(std::move(parsed->tree));
  return law;
}

numerics::Jet Law::at(double variable) const { return value_of<AtPlace>(tree_->root, {variable, 1.0, 0.0}); }

IntervalJet Law::over(const Interval& places) const {
  IntervalJet bounds = value_of<Between>(tree_->root, {places, {1.0, 1.0}, {}});
  const double middle = 0.5 * (places.low + places.high);
  const double half = std::max(places.high - middle, middle - places.low);
  if (half > 0.0) draw_closer(bounds, at(middle), {-half, half});
  return bounds;
}

}  // namespace loadpath
