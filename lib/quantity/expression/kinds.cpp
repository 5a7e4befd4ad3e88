// The kind of an expression's value (lib/quantity/kinds.hpp): sums, choices and multiples keep it.
#include "lib/quantity/expression/conversions.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <numbers>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;
using expression::Rule;

constexpr Dimension per_time = Dimension::of(0, 0, -1), of_speed = Dimension::of(1, 0, -1);
constexpr Dimension of_power = Dimension::of(2, 1, -3), of_work = Dimension::of(2, 1, -2);

bool holds_pi(const Node& node) {
  const bool is_pi = node.operation == Operation::literal && node.si == std::numbers::pi && node.dimension.is_number();
  return is_pi || std::any_of(node.kids.begin(), node.kids.end(), holds_pi);
}

/// Of a product: "30/pi" has -1.
int power_of_pi(const Node& node) {
  if (node.operation == Operation::literal) return node.si == std::numbers::pi && node.dimension.is_number() ? 1 : 0;
  if (node.operation == Operation::negate) return power_of_pi(node.kids[0]);
  const int sign = node.operation == Operation::multiply ? 1 : node.operation == Operation::divide ? -1 : 0;
  return sign == 0 ? 0 : power_of_pi(node.kids[0]) + sign * power_of_pi(node.kids[1]);
}

bool is_shear(Meant kind) { return kind == Meant::shear_stress; }
bool is_in_one_direction(Meant kind) {
  return kind == Meant::normal_stress || kind == Meant::equivalent_stress || kind == Meant::uniaxial_stress;
}

/// Whether two kinds in one sum belong to one quantity and yet cannot be added.
bool clash(Meant a, Meant b) {
  const auto either = [&](Meant x, Meant y) { return (a == x && b == y) || (a == y && b == x); };
  return (is_shear(a) && is_in_one_direction(b)) || (is_shear(b) && is_in_one_direction(a)) ||
         either(Meant::frequency, Meant::angular_speed) || either(Meant::frequency, Meant::rate) ||
         either(Meant::work, Meant::torque);
}

class KindWalk {
 public:
  KindWalk(const expression::Tree& tree, const Expression::KindOf& of, const Expression::Declared& declared)
      : tree_(tree), of_(of), declared_(declared) {}

  Outcome<Meant> run() {
    const Meant kind = of_node(tree_.root);
    if (fault_.message.empty()) return kind;
    return fault_;
  }

 private:
  Meant of_node(const Node& node) {
    switch (node.operation) {
      case Operation::literal:
        return node.kind;
      case Operation::reference:
        return of_(node.path);
      case Operation::negate:
        return of_node(node.kids[0]);
      case Operation::add:
      case Operation::subtract:
        return sum(node);
      case Operation::multiply:
        return product(node);
      case Operation::divide:
        return quotient(node);
      case Operation::power:
        of_node(node.kids[0]);
        return root_of_rate(node);
      case Operation::call:
        break;
    }
    return of_call(node);
  }

  Meant of_call(const Node& node) {
    switch (node.function->rule) {
      case Rule::place:
        return of_node(node.kids[0]);
      case Rule::reduction:
      case Rule::cycle_reduction:
      case Rule::selection:
      case Rule::same:
        return alike(node);
      case Rule::stresses:
        return stresses(node);
      default:
        for (const Node& kid : node.kids) of_node(kid);
        return root_of_rate(node);
    }
  }

  /// The root of a stiffness over a mass: radians per time.
  Meant root_of_rate(const Node& node) {
    return is(node, per_time) && !is(node.kids[0], per_time) && !is_time(node.kids[0]) ? Meant::rate : Meant::nothing;
  }

  Meant stresses(const Node& node) {
    const Meant sigma = of_node(node.kids[0]), tau = of_node(node.kids[1]);
    if (is_shear(sigma) || is_in_one_direction(tau))
      refuse(node, say("'{1}' takes a normal stress first, then a shear stress", node.function->name),
             say("write {1}", node.function->form));
    return Meant::uniaxial_stress;
  }

  Meant sum(const Node& node) {
    const Meant kind = alike(node);
    const bool differs = node.operation == Operation::subtract && kind == Meant::temperature;
    return differs && is_temperature(node.kids[1]) ? Meant::difference : kind;
  }

  /// What is subtracted from a temperature: "293.15 K" is another one, "60 K" a difference.
  bool is_temperature(const Node& node) {
    constexpr double least = 200.0;  // K
    const bool is_absolute = is_constant(node) && constant(node) >= least;
    return is_absolute || of_node(node) == Meant::temperature;
  }

  /// The kind common to all known operands; nothing if they differ.
  Meant alike(const Node& node) {
    Meant kind = Meant::nothing;
    bool differ = false;
    for (const Node& kid : node.kids) {
      const Meant next = of_node(kid);
      if (clash(kind, next))
        refuse(node, say("{1} and {2} cannot be taken together", name_of(kind), name_of(next)), remedy(kind, next));
      differ = differ || (kind != Meant::nothing && next != Meant::nothing && kind != next);
      if (kind == Meant::nothing || next == Meant::temperature) kind = next;
    }
    return differ && kind != Meant::temperature ? Meant::nothing : kind;
  }

  static Message remedy(Meant a, Meant b) {
    if (is_shear(a) || is_shear(b)) return say("write mises(sigma, tau)");
    if (a == Meant::work || b == Meant::work) return say("divide the energy by the angle, as in E/(2*pi rad)");
    return say("write rev*f for a frequency of turns");
  }

  /// Whether a product is the stress 16 T/(pi d^3) of a shaft.
  [[nodiscard]] bool is_of_torsion(const Node& node) const {
    return is(node, Dimension::of(-1, 1, -2)) &&
           expression::conversions::Product(tree_, of_, declared_).is_stress_of_torsion(node);
  }

  Meant product(const Node& node) {
    const Meant a = of_node(node.kids[0]), b = of_node(node.kids[1]);
    if ((a == Meant::torque && b == Meant::frequency) || (a == Meant::frequency && b == Meant::torque))
      refuse(node, say("torque times frequency is not power; use rev*f (2 pi rad per revolution)"),
             say("write rev*f for f"));
    if (is_of_torsion(node)) return Meant::shear_stress;
    if (is_number(node.kids[0])) return multiple(b, node.kids[0]);
    return is_number(node.kids[1]) ? multiple(a, node.kids[1]) : Meant::nothing;
  }

  Meant quotient(const Node& node) {
    const Meant a = of_node(node.kids[0]), b = of_node(node.kids[1]);
    if (is_of_torsion(node)) return Meant::shear_stress;
    if (is_number(node.kids[1])) return multiple(a, node.kids[1], -1);
    const bool of_turns = holds_pi(node.kids[1]);
    if (is(node.kids[0], of_speed) && is(node.kids[1], Dimension::of(1, 0, 0)))
      return of_turns ? Meant::frequency : Meant::rate;
    if (is(node.kids[0], of_power) && is(node.kids[1], of_work))
      return b == Meant::work ? Meant::frequency : Meant::rate;
    if (is(node.kids[0], of_power) && is(node.kids[1], per_time))
      return b == Meant::rate || of_turns || holds_pi(node.kids[0]) ? Meant::nothing : Meant::work;
    return Meant::nothing;
  }

  /// A multiple keeps its kind; but 2*pi*f is radians per time, and an energy over 2*pi a moment.
  static Meant multiple(Meant kind, const Node& by, int sign = 1) {
    if (!holds_pi(by)) return kind;
    if (kind == Meant::angular_speed) return sign * power_of_pi(by) < 0 ? Meant::frequency : kind;
    if (kind == Meant::frequency) return Meant::rate;
    return kind == Meant::rate                            ? Meant::frequency
           : kind == Meant::work || kind == Meant::torque ? Meant::nothing
                                                          : kind;
  }

  [[nodiscard]] bool is(const Node& node, const Dimension& dimension) const {
    const auto signature = check(tree_, node, declared_);
    return signature && signature->dimension == dimension;
  }
  [[nodiscard]] bool is_number(const Node& node) const { return is(node, {}); }
  [[nodiscard]] bool is_time(const Node& node) const { return is(node, Dimension::of(0, 0, 1)); }

  void refuse(const Node& node, Message message, Message hint) {
    if (fault_.message.empty()) fault_ = {node.at, node.length, std::move(message), std::move(hint)};
  }

  const expression::Tree& tree_;
  const Expression::KindOf& of_;
  const Expression::Declared& declared_;
  Fault fault_;
};

}  // namespace

Outcome<Meant> Expression::kind(const KindOf& of, const Declared& declared) const {
  Fault fault = expression::conversions::wrong_conversion(*tree_, of, declared);
  if (!fault.message.empty()) return fault;
  return KindWalk(*tree_, of, declared).run();
}

bool Expression::holds_pi() const { return loadpath::holds_pi(tree_->root); }

}  // namespace loadpath
