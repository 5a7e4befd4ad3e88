// The factors that the value of an expression includes.
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;
using expression::Rule;

/// Kind and value: factors with the same ones are equal.
using Identity = std::pair<std::string, double>;
struct Raised {
  double power = 0.0;
  std::set<std::string> names;  // the inputs that it is: "chain.K_A"
};
using Powers = std::map<Identity, Raised>;
/// Nothing: for a literal, which goes with any.
using Held = std::optional<Powers>;

void multiply(Powers& powers, const Powers& by, double exponent) {
  for (const auto& [identity, raised] : by) {
    Raised& all = powers[identity];
    all.power += exponent * raised.power;
    all.names.insert(raised.names.begin(), raised.names.end());
  }
  std::erase_if(powers, [](const auto& entry) { return entry.second.power == 0.0; });
}

Held raised_to(const Held& base, double exponent) {
  if (!base) return base;
  Powers powers;
  multiply(powers, *base, exponent);
  return powers;
}

/// The kind that counts more than once; empty if none does.
std::string counted_twice(const Powers& powers) {
  std::map<std::string, double> sums;
  for (const auto& [identity, raised] : powers) sums[identity.first] += std::max(raised.power, 0.0);
  const auto most = std::find_if(sums.begin(), sums.end(), [](const auto& sum) { return sum.second > 1.0; });
  return most == sums.end() ? "" : most->first;
}

/// A factor of these that the others do not hold, or in another power; empty if they hold all.
std::string more_than(const Powers& others, const Powers& powers) {
  for (const auto& [identity, raised] : powers) {
    const auto other = others.find(identity);
    if (other == others.end() || other->second.power != raised.power) return *raised.names.begin();
  }
  return {};
}

std::string name_of_kind(const Powers& powers, const std::string& kind) {
  for (const auto& [identity, raised] : powers) {
    if (identity.first == kind) return *raised.names.begin();
  }
  return {};
}

class Walk {
 public:
  Walk(const expression::Tree& tree, const FactorsOf& of) : tree_(tree), of_(of) {}

  Outcome<Factors> run() {
    const Powers powers = of_node(tree_.root).value_or(Powers{});
    if (unlike_) return *unlike_;
    if (!counted_twice(powers).empty()) return *twice_;
    Factors factors;
    for (const auto& [identity, raised] : powers) {
      for (const std::string& name : raised.names) {
        if (raised.power > 0.0) factors[name] = identity.second;
      }
    }
    return factors;
  }

 private:
  Held of_node(const Node& node) {
    switch (node.operation) {
      case Operation::literal:
        return std::nullopt;
      case Operation::reference:
        return of_reference(node);
      case Operation::multiply:
        return product(node, 1.0);
      case Operation::divide:
        return product(node, -1.0);
      case Operation::negate:
        return of_node(node.kids[0]);
      case Operation::power:
        return watched(node, raised_to(of_node(node.kids[0]), constant(node.kids[1])));
      case Operation::add:
      case Operation::subtract:
        return alike(node);
      case Operation::call:
        return of_call(node);
    }
    return std::nullopt;
  }

  Powers of_reference(const Node& node) {
    Powers powers;
    for (const auto& [name, value] : of_(node.path)) {
      Raised& raised = powers[{kind_of(name), value}];
      raised.power = 1.0;
      raised.names.insert(name);
    }
    return powers;
  }

  /// Factors of both operands together; one included in both would be applied twice.
  Held product(const Node& node, double exponent) {
    const Held a = of_node(node.kids[0]);
    const Held b = of_node(node.kids[1]);
    if (!a && !b) return std::nullopt;
    Powers powers = a.value_or(Powers{});
    multiply(powers, b.value_or(Powers{}), exponent);
    return watched(node, std::move(powers));
  }

  /// Remembers the first place where a factor counts twice: the surrounding expression may still remove it.
  Held watched(const Node& node, Held held) {
    const std::string kind = held ? counted_twice(*held) : "";
    if (kind.empty() || twice_) return held;
    const std::string name = name_of_kind(*held, kind);
    twice_ = fault(node, say("{1} would be applied twice: '{2}' includes {3}", kind, of(node, 0), name),
                   say("take one of them without it"));
    return held;
  }

  Held of_call(const Node& node) {
    switch (node.function->rule) {
      case Rule::place:
        return of_node(node.kids[0]);
      case Rule::root:
        return raised_to(of_node(node.kids[0]), 1.0 / node.function->degree);
      case Rule::trigonometric:
      case Rule::number:
      case Rule::inverse:
      case Rule::ratio:
        alike(node);
        return Powers{};
      case Rule::reduction:
      case Rule::cycle_reduction:
      case Rule::selection:
      case Rule::same:
      case Rule::stresses:
        return alike(node);
    }
    return alike(node);
  }

  /// Factors common to all operands of a sum, a difference, a choice.
  Held alike(const Node& node) {
    Held held;
    std::size_t first = 0;
    for (std::size_t i = 0; i < node.kids.size(); ++i) {
      const Held next = of_node(node.kids[i]);
      if (!next) continue;
      if (!held) {
        held = next, first = i;
        continue;
      }
      compare(node, {*held, of(node, first)}, {*next, of(node, i)});
      for (const auto& [identity, raised] : *next)
        (*held)[identity].names.insert(raised.names.begin(), raised.names.end());
    }
    return held;
  }

  struct Term {
    const Powers& powers;
    std::string text;
  };
  void compare(const Node& node, const Term& a, const Term& b) {
    const std::string more_a = more_than(b.powers, a.powers), more_b = more_than(a.powers, b.powers);
    if (unlike_ || (more_a.empty() && more_b.empty())) return;
    const Term& with = more_a.empty() ? b : a;
    const Term& without = more_a.empty() ? a : b;
    const std::string more = more_a.empty() ? more_b : more_a;
    const std::string other = name_of_kind(without.powers, kind_of(more));
    unlike_ =
        fault(node,
              other.empty() ? say("'{1}' includes {2}, and '{3}' does not", with.text, more, without.text)
                            : say("'{1}' includes {2}, and '{3}' includes {4}", with.text, more, without.text, other),
              say("take both with it, or both without"));
  }

  static Fault fault(const Node& node, Message message, Message hint) {
    return Fault{node.at, node.length, std::move(message), std::move(hint)};
  }
  [[nodiscard]] std::string of(const Node& node, std::size_t i) const { return tree_.written(node.kids[i]); }

  const expression::Tree& tree_;
  const FactorsOf& of_;
  std::optional<Fault> unlike_, twice_;
};

}  // namespace

std::string kind_of(const std::string& factor) { return factor.substr(factor.rfind('.') + 1); }

std::string of_kind(const Factors& factors, const std::string& kind) {
  const auto same =
      std::find_if(factors.begin(), factors.end(), [&](const auto& factor) { return kind_of(factor.first) == kind; });
  return same == factors.end() ? "" : same->first;
}

std::string without_equal(const Factors& factors, const Factors& others) {
  const auto has_equal = [&](const auto& factor) {
    return std::any_of(others.begin(), others.end(), [&](const auto& other) {
      return kind_of(other.first) == kind_of(factor.first) && other.second == factor.second;
    });
  };
  const auto alone = std::find_if_not(factors.begin(), factors.end(), has_equal);
  return alone == factors.end() ? "" : alone->first;
}

Outcome<Factors> Expression::factors(const FactorsOf& of) const { return Walk(*tree_, of).run(); }

}  // namespace loadpath
