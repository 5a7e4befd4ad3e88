#include "lib/quantity/expression/tree.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::expression {
namespace {

using Signatures = std::vector<Signature>;

// Far beyond engineering, and a sum of two still fits Dimension's integers.
constexpr int largest_exponent = 100;

Fault fault(const Node& node, Message message, Message hint) {
  return {node.at, node.length, std::move(message), std::move(hint)};
}

bool alike(const Signature& a, const Signature& b) {
  return a.dimension.without_angle() == b.dimension.without_angle();
}

bool reduces(const Node& node) {
  const Rule rule = node.function->rule;
  return rule == Rule::reduction || rule == Rule::cycle_reduction || rule == Rule::place ||
         (rule == Rule::selection && node.kids.size() == 1);
}

/// The dimension to a real power; nothing if an exponent would not be a multiple of 1/12.
std::optional<Dimension> raised(const Dimension& dimension, double exponent) {
  Dimension result;
  for (std::size_t i = 0; i < Dimension::count; ++i) {
    const double twelfths = dimension.twelfths[i] * exponent;
    const double whole = std::round(twelfths);
    if (!(std::abs(twelfths - whole) <= 1e-9) || std::abs(whole) > largest_exponent * Dimension::one) return {};
    result.twelfths[i] = static_cast<std::int16_t>(whole);
  }
  return result;
}

class Check {
 public:
  Check(const Tree& tree, const Declared& declared) : tree_{tree}, declared_{declared} {}

  [[nodiscard]] Outcome<Signature> of(const Node& node) const {
    if (node.operation == Operation::literal) return within_bounds(node, {node.dimension});
    if (node.operation == Operation::reference) return reference(node);
    Signatures kids;
    for (const Node& kid : node.kids) {
      const auto signature = of(kid);
      if (!signature) return signature;
      kids.push_back(*signature);
    }
    if (node.operation == Operation::call && reduces(node)) return reduction(node, kids);
    return elementwise(node, kids);
  }

 private:
  using Dimensioned = Outcome<Dimension>;

  [[nodiscard]] static Outcome<Signature> within_bounds(const Node& node, Signature signature) {
    const auto& twelfths = signature.dimension.twelfths;
    const bool within = std::all_of(twelfths.begin(), twelfths.end(),
                                    [](int e) { return std::abs(e) <= largest_exponent * Dimension::one; });
    if (within) return signature;
    return fault(node, say("the power of a unit exceeds {1} here", std::to_string(largest_exponent)),
                 say("check the exponents"));
  }

  [[nodiscard]] Outcome<Signature> reference(const Node& node) const {
    const auto signature = declared_(node.path);
    if (!signature) return fault(node, signature.fault().message, signature.fault().hint);
    return within_bounds(node, *signature);
  }

  [[nodiscard]] Outcome<Signature> elementwise(const Node& node, const Signatures& kids) const {
    const Axis* axis = nullptr;
    for (const Signature& kid : kids) {
      if (axis != nullptr && kid.axis != nullptr && axis != kid.axis) return unlike_axes(node, *axis, *kid.axis);
      if (kid.axis != nullptr) axis = kid.axis;
    }
    const auto dimension = dimension_of(node, kids);
    if (!dimension) return dimension.fault();
    return within_bounds(node, {*dimension, axis});
  }

  [[nodiscard]] static Fault unlike_axes(const Node& node, const Axis& a, const Axis& b) {
    return fault(node, say("series over different axes cannot be combined: '{1}' and '{2}'", a.name(), b.name()),
                 say("reduce one of them with peak, max, mean, at ..."));
  }

  [[nodiscard]] Dimensioned dimension_of(const Node& node, const Signatures& kids) const {
    const auto& first = kids.front().dimension;
    switch (node.operation) {
      case Operation::multiply:
        return first * kids[1].dimension;
      case Operation::divide:
        return first / kids[1].dimension;
      case Operation::power:
        return power(node, first, kids[1]);
      case Operation::call:
        return call(node, kids);
      case Operation::add:
        return node.function == nullptr ? like(node, kids, "{1} and {2} cannot be added") : components(node, kids);
      case Operation::subtract:
        return like(node, kids, "{2} cannot be subtracted from {1}");
      default:
        return first;
    }
  }

  /// The squares that a resultant adds; a message names what was squared.
  [[nodiscard]] static Dimensioned components(const Node& node, const Signatures& squares) {
    Signatures sides = squares;
    for (Signature& side : sides) side.dimension = raised(side.dimension, 0.5).value_or(side.dimension);
    const auto same = like(node, sides, "{1} and {2} cannot be components of one resultant");
    return same ? Dimensioned{squares.front().dimension} : same;
  }

  /// A power divided by an angular velocity has the dimension of a torsional stiffness, and is meant as a torque.
  [[nodiscard]] static std::string name_in_sum(const Dimension& dimension) {
    return dimension == Dimension::of(2, 1, -2, 0, -1) ? "torque" : std::string(name_of(dimension));
  }

  [[nodiscard]] static Dimensioned like(const Node& node, const Signatures& kids, std::string_view rule) {
    for (const Signature& kid : kids) {
      if (alike(kid, kids.front())) continue;
      const auto& a = kids.front().dimension;
      const auto& b = kid.dimension;
      const bool bare = a.is_number() || b.is_number();
      return fault(node, say(rule, name_in_sum(a), name_in_sum(b)),
                   bare ? say("give the number a unit") : say("both must have the same dimension"));
    }
    return kids.front().dimension;
  }

  [[nodiscard]] Dimensioned power(const Node& node, const Dimension& base, const Signature& exponent) const {
    const Node& written = node.kids[1];
    const double value = is_constant(written) ? constant(written) : std::nan("");
    if (!exponent.dimension.is_number() || std::isnan(value)) {
      return fault(written, say("an exponent must be a constant number, and '{1}' is not", tree_.written(written)),
                   say("write a number, as in ^2 or ^(1/3)"));
    }
    const auto dimension = raised(base, value);
    if (dimension) return *dimension;
    return fault(node, say("{1} cannot be raised to the power {2}", name_of(base), tree_.written(written)),
                 say("make it a number first: divide by 1 of its unit"));
  }

  [[nodiscard]] Dimensioned call(const Node& node, const Signatures& kids) const {
    const Function& f = *node.function;
    const auto& first = kids.front().dimension;
    switch (f.rule) {
      case Rule::root:
        return root(node, first);
      case Rule::trigonometric:
        return trigonometric(node, first);
      case Rule::number:
        return ratio(node, first, "'{1}' needs a number, not {2}", {});
      case Rule::inverse:
        return ratio(node, first, "'{1}' needs a number, not {2}", Dimension::of(0, 0, 0, 0, 1));
      case Rule::ratio: {
        const auto same = like(node, kids, "{1} and {2} cannot be the sides of one angle");
        return same ? Dimensioned{Dimension::of(0, 0, 0, 0, 1)} : same;
      }
      case Rule::selection:
        return like(node, kids, "{1} and {2} cannot be compared");
      case Rule::stresses:
        return stresses(node, kids);
      default:
        return first;
    }
  }

  [[nodiscard]] static Dimensioned root(const Node& node, const Dimension& radicand) {
    const auto dimension = raised(radicand, 1.0 / node.function->degree);
    if (dimension) return *dimension;
    return fault(node, say("'{1}' cannot be taken of {2}", node.function->name, name_of(radicand)),
                 say("make it a number first: divide by 1 of its unit"));
  }

  [[nodiscard]] Dimensioned stresses(const Node& node, const Signatures& kids) const {
    constexpr Dimension stress = Dimension::of(-1, 1, -2);
    for (std::size_t i = 0; i < kids.size(); ++i) {
      if (kids[i].dimension == stress) continue;
      return fault(node.kids[i], say("'{1}' needs stresses, not {2}", node.function->name, name_of(kids[i].dimension)),
                   say("write {1}: a normal stress, then a shear stress", node.function->form));
    }
    return stress;
  }

  /// A plain number is not an angle, as outside of expressions; with pi in it, it is one in radians.
  [[nodiscard]] Dimensioned trigonometric(const Node& node, const Dimension& given) const {
    const Node& angle = node.kids.front();
    const std::string written = tree_.written(angle);
    const Node& number = angle.operation == Operation::negate ? angle.kids.front() : angle;
    const bool literal = number.operation == Operation::literal && written.find("pi") == std::string::npos;
    if (literal && given.is_number() && number.si != 0.0) {
      return fault(angle, say("'{1}' needs an angle, and '{2}' is a bare number", node.function->name, written),
                   say("write {1}({2} deg), or {1}({2} rad)", node.function->name, written));
    }
    return ratio(node, given, "'{1}' needs an angle or a number, not {2}", {});
  }

  [[nodiscard]] static Dimensioned ratio(const Node& node, const Dimension& given, std::string_view rule,
                                         Dimension result) {
    if (given.is_angle_or_number()) return result;
    return fault(node.kids.front(), say(rule, node.function->name, name_of(given)),
                 say("divide by a quantity of the same kind"));
  }

  [[nodiscard]] Outcome<Signature> reduction(const Node& node, const Signatures& kids) const {
    const Function& f = *node.function;
    const Node& argument = node.kids.front();
    const Axis* axis = kids.front().axis;
    if (axis == nullptr) {
      return fault(argument, say("'{1}' needs a series; {2} is one value", f.name, tree_.written(argument)),
                   f.rule == Rule::selection ? say("give a series, or two values to compare: {1}(a, b)", f.name)
                                             : say("use the value as it is"));
    }
    if (f.rule == Rule::cycle_reduction && !axis->cyclic()) {
      return fault(node, say("'{1}' needs a closed cycle, and '{2}' is not one", f.name, axis->name()),
                   say("reduce the series with max, min or peak"));
    }
    if (f.rule == Rule::place) {
      if (auto wrong = wrong_place(node.kids[1], kids[1], *axis)) return *wrong;
    }
    return Signature{kids.front().dimension, nullptr};
  }

  [[nodiscard]] static std::optional<Fault> wrong_place(const Node& place, const Signature& given, const Axis& axis) {
    const auto unit = parse_unit(axis.unit);
    if (unit && given.dimension != unit->dimension) {
      return fault(place, say("the position must be on the axis '{1}', not {2}", axis.name(), name_of(given.dimension)),
                   say("write it in {1}, as in 60 {1}", axis.unit));
    }
    if (is_constant(place)) return {};
    return fault(place, say("the position must be a constant"), say("write it in {1}, as in 60 {1}", axis.unit));
  }

  const Tree& tree_;
  const Declared& declared_;
};

}  // namespace

Outcome<Signature> check(const Tree& tree, const Declared& declared) { return check(tree, tree.root, declared); }

Outcome<Signature> check(const Tree& tree, const Node& node, const Declared& declared) {
  return Check{tree, declared}.of(node);
}

}  // namespace loadpath::expression
