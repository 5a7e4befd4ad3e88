// The remaining dependence of an expression's value on its series.
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/expression/tree.hpp"

#include <cmath>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;
using expression::Rule;
using Left = Reduced::Left;

bool is_series(const Reduced& r) { return r.left == Left::whole || r.left == Left::square; }

class Reductions {
 public:
  Reductions(const expression::Tree& tree, const ReducedOf& of) : tree_(tree), of_(of) {}

  [[nodiscard]] Reduced of_node(const Node& node) const {
    switch (node.operation) {
      case Operation::literal:
        return {.is_signed = node.si < 0.0};
      case Operation::reference:
        return of_(node.path);
      case Operation::negate:
        return negated(of_node(node.kids[0]));
      case Operation::add:
      case Operation::subtract:
        return sum(node);
      case Operation::multiply:
      case Operation::divide:
        return product(node);
      case Operation::power:
        return power(node, of_node(node.kids[0]), constant(node.kids[1]));
      case Operation::call:
        return call(node);
    }
    return {};
  }

 private:
  /// Numbers too: their sign changes.
  static Reduced negated(Reduced r) {
    if (r.left == Left::once) r.function = r.function == "max" ? "min" : r.function == "min" ? "max" : r.function;
    if (r.left == Left::square) r.left = Left::less;
    r.is_signed = is_series(r) || !r.is_signed;
    return r;
  }

  /// The first loss of information, in an operand or in the result.
  [[nodiscard]] Reduced less(const Node& node, const Reduced& a, const Reduced& b = {}) const {
    Reduced r;
    r.left = Left::less;
    r.of_load = a.of_load || b.of_load;
    for (const Reduced* part : {&a, &b}) {
      if (r.text.empty() && (part->left == Left::less || part->left == Left::once))
        r.text = part->text, r.function = part->function;
    }
    if (r.text.empty()) r.text = tree_.written(node);
    return r;
  }

  /// Loads that act together: entire series, or magnitudes that are not subtracted from one another.
  [[nodiscard]] Reduced sum(const Node& node) const {
    Reduced a = of_node(node.kids[0]), b = of_node(node.kids[1]);
    const bool subtracts = node.operation == Operation::subtract;
    if (a.left == Left::no_series && b.left == Left::no_series) {
      a.is_signed = a.is_signed || b.is_signed || subtracts;
      return a;
    }
    Reduced r = a;
    r.is_signed = a.is_signed || b.is_signed || subtracts;
    r.of_load = a.of_load || b.of_load;
    r.factor.clear();
    if (a.left == b.left && a.left == Left::whole) return r;
    if (a.left == b.left && a.left == Left::square && !subtracts) return r;
    const auto adds = [](const Reduced& x) {
      return x.left == Left::peak || (x.left == Left::no_series && !x.is_signed);
    };
    if (adds(a) && adds(b) && !a.is_signed && !b.is_signed && !subtracts) {
      r.left = Left::peak;
      return r;
    }
    return less(node, a, b);
  }

  [[nodiscard]] Reduced product(const Node& node) const {
    const Reduced a = of_node(node.kids[0]), b = of_node(node.kids[1]);
    const bool divides = node.operation == Operation::divide;
    const bool first = a.left != Left::no_series;
    if (!first && b.left == Left::no_series) return {.is_signed = a.is_signed != b.is_signed};
    if (first && b.left == Left::no_series) return scaled(a, b, node.kids[1], divides);
    if (!first && !divides) return scaled(b, a, node.kids[0], false);
    const bool itself = !divides && tree_.written(node.kids[0]) == tree_.written(node.kids[1]);
    if (itself) return power(node, a, 2.0);
    return less(node, a, b);
  }

  [[nodiscard]] Reduced scaled(Reduced r, const Reduced& by, const Node& factor, bool divides) const {
    if (is_constant(factor) && constant(factor) == 0.0) return less(factor, r);
    if (by.is_signed) r = negated(std::move(r));
    if (r.left == Left::whole && is_number(factor) && std::abs(constant(factor)) != 1.0)
      r.factor = (divides ? "1/" : "") + tree_.written(factor);
    return r;
  }

  static bool is_number(const Node& node) {
    if (node.operation == Operation::literal) return node.dimension.is_number();
    if (!is_constant(node)) return false;
    for (const Node& kid : node.kids) {
      if (!is_number(kid)) return false;
    }
    return true;
  }

  [[nodiscard]] Reduced power(const Node& node, Reduced base, double exponent) const {
    if (base.left == Left::no_series || exponent == 1.0) return base;
    const bool even = exponent == 2.0;
    if (base.left == Left::whole && even) {
      base.left = Left::square, base.is_signed = false;
      return base;
    }
    if (base.left == Left::peak && !base.is_signed && exponent > 0.0) return base;
    if (base.left == Left::square && exponent == 0.5) return root(std::move(base));
    return less(node, base);
  }

  static Reduced root(Reduced square) {
    square.left = Left::whole;
    return square;
  }

  [[nodiscard]] Reduced call(const Node& node) const {
    const expression::Function& f = *node.function;
    Reduced all = of_node(node.kids[0]);
    if (f.rule == Rule::place) return reduction(node, all);
    if (node.kids.size() > 1) return selection(node, std::move(all));
    if (f.reduce != nullptr) return reduction(node, all);
    if (all.left == Left::no_series) {
      if (f.is_magnitude) all.is_signed = false;
      return all;
    }
    if (f.name == "sqrt") return power(node, std::move(all), 0.5);
    if (f.name != "abs" || (all.left != Left::whole && all.left != Left::peak)) return less(node, all);
    all.is_signed = false;
    return all;
  }

  /// The largest of entire series at every position, or of magnitudes.
  [[nodiscard]] Reduced selection(const Node& node, Reduced all) const {
    const bool largest = node.function->name == "max";
    bool any = all.left != Left::no_series, alike = true;
    for (std::size_t k = 1; k < node.kids.size(); ++k) {
      const Reduced next = of_node(node.kids[k]);
      any = any || next.left != Left::no_series;
      const bool magnitudes = !all.is_signed && !next.is_signed && !is_series(all) && !is_series(next);
      const bool keeps =
          all.left == next.left || (magnitudes && (all.left == Left::no_series || next.left == Left::no_series));
      alike = alike && keeps && !all.is_signed && !next.is_signed && next.left != Left::once && next.left != Left::less;
      if (all.left == Left::no_series) all.left = next.left;
      if (all.text.empty()) all.text = next.text, all.function = next.function;
      all.of_load = all.of_load || next.of_load;
      all.is_signed = all.is_signed || next.is_signed;
    }
    if (!any) return all;
    return largest && alike && all.left != Left::once && all.left != Left::less ? all : less(node, all);
  }

  [[nodiscard]] Reduced reduction(const Node& node, const Reduced& of) const {
    const std::string_view name = node.function->name;
    if (of.left == Left::no_series || !is_series(of)) return of.left == Left::no_series ? Reduced{} : less(node, of);
    Reduced r;
    r.of_load = of.of_load;
    r.is_signed = !node.function->is_magnitude && of.is_signed;
    if (name == "peak" || (name == "max" && !of.is_signed)) {
      r.left = Left::peak;
      return r;
    }
    r.left = of.left == Left::whole ? Left::once : Left::less;
    r.function = name;
    r.argument = tree_.written(node.kids[0]);
    r.text = tree_.written(node);
    return r;
  }

  const expression::Tree& tree_;
  const ReducedOf& of_;
};

}  // namespace

Reduced Expression::reduced(const ReducedOf& of) const { return Reductions(*tree_, of).of_node(tree_->root); }

}  // namespace loadpath
