// Which factors the value of an expression contains.
#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <optional>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;

/// Nothing: of a literal, which goes with any.
using Held = std::optional<Factors>;

class Walk {
 public:
  Walk(const expression::Tree& tree, const FactorsOf& of) : tree_(tree), of_(of) {}

  Outcome<Factors> run() {
    Held held = of_node(tree_.root);
    if (fault_) return *fault_;
    return held.value_or(Factors{});
  }

 private:
  Held of_node(const Node& node) {
    switch (node.operation) {
      case Operation::literal:
        return std::nullopt;
      case Operation::reference:
        return of_(node.path);
      case Operation::multiply:
        return product(node);
      case Operation::divide:
        return quotient(node);
      case Operation::negate:
      case Operation::power:
        return of_node(node.kids[0]);
      case Operation::add:
      case Operation::subtract:
      case Operation::call:
        return alike(node);
    }
    return std::nullopt;
  }

  /// What both hold; a factor that stands in both would count twice.
  Held product(const Node& node) {
    Held a = of_node(node.kids[0]);
    const Held b = of_node(node.kids[1]);
    if (!a || !b) return a ? a : b;
    for (const std::string& factor : *b) {
      const std::string twin = same_key(*a, factor);
      if (!twin.empty()) refuse(node, say("{1} would count twice: '{2}' holds {3}", key_of(factor), of(node, 0), twin));
    }
    a->insert(b->begin(), b->end());
    return a;
  }

  Held quotient(const Node& node) {
    Held a = of_node(node.kids[0]);
    const Held b = of_node(node.kids[1]);
    for (const std::string& factor : b.value_or(Factors{})) {
      if (a) a->erase(same_key(*a, factor));
    }
    return a;
  }

  /// Of a sum, a difference, a choice: what all hold alike.
  Held alike(const Node& node) {
    Held held;
    for (std::size_t i = 0; i < node.kids.size(); ++i) {
      const Held next = of_node(node.kids[i]);
      if (held && next && keys_of(*held) != keys_of(*next)) refuse(node, unlike(node, i, *held, *next));
      if (!held) held = next;
    }
    return held;
  }

  Message unlike(const Node& node, std::size_t i, const Factors& before, const Factors& here) const {
    const bool first = here.size() < before.size();
    const Factors& more = first ? before : here;
    return say("'{1}' holds {2}, and '{3}' does not", of(node, first ? i - 1 : i), *more.begin(),
               of(node, first ? i : i - 1));
  }

  void refuse(const Node& node, Message message) {
    if (!fault_) fault_ = Fault{node.at, node.length, std::move(message), say("take both with it, or both without")};
  }
  [[nodiscard]] std::string of(const Node& node, std::size_t i) const { return tree_.written(node.kids[i]); }

  const expression::Tree& tree_;
  const FactorsOf& of_;
  std::optional<Fault> fault_;
};

}  // namespace

std::string key_of(const std::string& factor) { return factor.substr(factor.rfind('.') + 1); }

Factors keys_of(const Factors& factors) {
  Factors keys;
  for (const std::string& factor : factors) keys.insert(key_of(factor));
  return keys;
}

std::string same_key(const Factors& factors, const std::string& factor) {
  const auto same =
      std::find_if(factors.begin(), factors.end(), [&](const auto& f) { return key_of(f) == key_of(factor); });
  return same == factors.end() ? "" : *same;
}

Outcome<Factors> Expression::factors(const FactorsOf& of) const { return Walk(*tree_, of).run(); }

}  // namespace loadpath
