#include "lib/formula/print.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>

namespace loadpath::formula {
namespace {

/// The neighbours decide on the sign between them: 2 d, 2 · 3, (2 mm) · (3 mm).
enum class Form { number, quantity, symbol, fraction, other };

struct Piece {
  std::string text;
  Level level = Level::atom;
  Form form = Form::other;
  bool minus = false;  // begins with a sign
};

bool is(const Node& tree, std::string_view op) { return tree.kind == Kind::binary && tree.text == op; }

/// A symbol that is multiplied with itself counts as a power.
struct Factor {
  const Node* node;
  int times = 1;
};

void collect(const Node& node, std::vector<Factor>& factors) {
  if (is(node, "*")) {
    for (const Node& kid : node.kids) collect(kid, factors);
  } else if (!factors.empty() && node.kind == Kind::symbol && node.text == factors.back().node->text) {
    ++factors.back().times;
  } else {
    factors.push_back({&node});
  }
}

/// 32.0 is printed as 32, 0.50 as 0.5.
std::string without_idle_zeros(std::string_view cpp) {
  const std::size_t e = std::min(cpp.find('e'), cpp.size());
  std::string number(cpp.substr(0, e));
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
  }
  if (number.empty() || number.front() == '.') number.insert(0, 1, '0');
  return number + std::string(cpp.substr(e));
}

class Printer {
 public:
  Printer(const Notation& notation, const Substituted& substituted, const Known& known)
      : to_(notation), substituted_(substituted), known_(known) {}

  [[nodiscard]] Piece piece(const Node& tree) const {
    switch (tree.kind) {
      case Kind::number:
        return written({without_idle_zeros(tree.text), {}});
      case Kind::symbol:
        return named(tree.text);
      case Kind::negate:
        return negated(tree.kids[0]);
      case Kind::binary:
        return tree.text == "*" ? product(tree) : tree.text == "/" ? fraction(tree) : infix(tree);
      case Kind::call:
        return call(tree);
      case Kind::choose:
        return choice(tree);
    }
    return {};
  }

  /// -1.5e-5 mm: sign, digits, power of ten and unit.
  [[nodiscard]] Piece written(const Written& value) const {
    std::string_view number = value.number;
    const bool minus = number.starts_with('-');
    if (minus) number.remove_prefix(1);
    if (number.empty() || number.front() < '0' || number.front() > '9') return {to_.words(value.number)};
    const std::size_t e = std::min(number.find('e'), number.size());
    const std::string_view digits = number.substr(0, e);
    const bool has_power = e < number.size(), is_power = has_power && digits == "1";  // 10⁷, not 1 · 10⁷
    std::string text = is_power ? power_of_ten(number.substr(e + 1)) : to_.number(digits);
    if (has_power && !is_power) text += to_.infix("*") + power_of_ten(number.substr(e + 1));
    if (!value.unit.empty()) text = to_.quantity(text, value.unit);
    const bool whole = !minus && value.unit.empty() && !has_power;
    return {(minus ? to_.minus() : "") + text, whole ? Level::atom : Level::product,
            value.unit.empty() ? Form::number : Form::quantity, minus};
  }

  [[nodiscard]] std::vector<std::string> terms(const Node& tree) const {
    const Node& node = chosen(tree);
    if (!is(node, "+") && !is(node, "-")) return {term(node).text};
    std::vector<std::string> list = terms_of_left(node.kids[0]);
    list.push_back(to_.infix(node.text) + right_term(node).text);
    return list;
  }

  /// A term that is a ratio of two values has a solidus: (12 N)/(3 mm).
  [[nodiscard]] Piece term(const Node& tree) const {
    const Node& node = chosen(tree);
    const auto is_name = [](const Node& kid) { return kid.kind == Kind::number || kid.kind == Kind::symbol; };
    const auto is_value = [](const Piece& p) {
      return !p.minus && (p.form == Form::number || p.form == Form::quantity);
    };
    if (!substituted_ || !to_.stacked() || !is(node, "/") || !is_name(node.kids[0]) || !is_name(node.kids[1]))
      return piece(node);
    const Piece over = piece(node.kids[0]), under = piece(node.kids[1]);
    if (!is_value(over) || !is_value(under)) return piece(node);
    return {at_least(Level::atom, over).text + to_.solidus() + at_least(Level::atom, under).text, Level::product,
            Form::fraction};
  }

 private:
  [[nodiscard]] Piece fence(const Piece& inner) const { return {to_.fenced(inner.text), Level::atom, inner.form}; }
  [[nodiscard]] Piece at_least(Level level, const Piece& piece) const {
    return piece.level < level ? fence(piece) : piece;
  }
  /// An operand preceded by something.
  [[nodiscard]] Piece inside(Level level, const Piece& piece) const {
    return piece.minus ? fence(piece) : at_least(level, piece);
  }

  [[nodiscard]] std::string power_of_ten(std::string_view exponent) const {
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    const Piece ten = written({std::string(exponent), {}});
    return to_.power(to_.number("10"), ten.text, Level::atom);
  }

  [[nodiscard]] Piece named(const std::string& name) const {
    if (const auto value = substituted_ ? substituted_(name) : std::nullopt) return written(*value);
    if (is_unit(name)) {
      const std::string unit = pretty_unit(unit_named(name));
      const bool simple = unit.find("·") == std::string::npos && unit.find('/') == std::string::npos;
      return {to_.unit(unit), simple ? Level::atom : Level::product, Form::symbol};
    }
    return {to_.symbol(symbol(name)), Level::atom, Form::symbol};
  }
  /// N and m are symbols too: they are units where the values of the symbols are known and they are not among them.
  [[nodiscard]] bool is_unit(const std::string& name) const {
    if (unit_named(name).empty()) return false;
    return known_ ? !known_(name).has_value() : name.size() > 1;
  }

  [[nodiscard]] Piece negated(const Node& operand) const {
    return {to_.minus() + inside(Level::product, piece(operand)).text, Level::product, Form::other, true};
  }

  [[nodiscard]] Piece infix(const Node& tree) const {
    if (tree.text == "+" || tree.text == "-") {
      const Piece left = at_least(Level::sum, term(tree.kids[0]));
      return {left.text + to_.infix(tree.text) + right_term(tree).text, Level::sum, Form::other, left.minus};
    }
    const Level level = tree.text == "||" ? Level::either : tree.text == "&&" ? Level::both : Level::comparison;
    const Level operand = level == Level::comparison ? Level::sum : level;
    return {at_least(operand, piece(tree.kids[0])).text + to_.infix(tree.text) +
                at_least(operand, piece(tree.kids[1])).text,
            level};
  }
  [[nodiscard]] Piece right_term(const Node& sum) const {
    return inside(sum.text == "-" ? Level::product : Level::sum, term(sum.kids[1]));
  }
  [[nodiscard]] std::vector<std::string> terms_of_left(const Node& tree) const {
    const Node& node = chosen(tree);
    if (is(node, "+") || is(node, "-")) return terms(node);
    return {at_least(Level::sum, term(node)).text};
  }

  [[nodiscard]] Piece product(const Node& tree) const {
    std::vector<Factor> factors;
    collect(tree, factors);
    std::vector<Piece> pieces;
    pieces.reserve(factors.size());
    for (const Factor& factor : factors) {
      pieces.push_back(factor.times == 1 ? piece(*factor.node) : power(*factor.node, std::to_string(factor.times)));
    }
    if (pieces.size() == 1) return pieces.front();
    const auto is_quantity = [](const Piece& p) { return p.form == Form::quantity && p.level < Level::power; };
    const auto quantities = std::count_if(pieces.begin(), pieces.end(), is_quantity);
    const bool bare = quantities == 1 && is_quantity(pieces.back()) && !pieces.back().minus;
    Piece all{{}, Level::product, Form::other, pieces.front().minus};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      Piece& next = pieces[i];
      const bool fenced = is_quantity(next) && !bare;
      next = fenced ? fence(next) : i == 0 ? at_least(Level::product, next) : inside(Level::product, next);
      if (i == 0) all.minus = next.minus;
      if (i > 0) all.text += between(pieces[i - 1], next);
      all.text += next.text;
    }
    return all;
  }
  [[nodiscard]] std::string between(const Piece& left, const Piece& right) const {
    const bool two_fractions = left.form == Form::fraction && right.form == Form::fraction;
    const bool after_value = substituted_ && right.form != Form::symbol;
    const bool dot =
        right.form == Form::number || right.form == Form::quantity || two_fractions || after_value || !to_.stacked();
    return dot ? to_.infix("*") : to_.thin_space();
  }

  /// a / b / c is one fraction.
  [[nodiscard]] Piece fraction(const Node& tree) const {
    const Node& over = tree.kids[0];
    if (is(over, "/")) {
      return fraction({Kind::binary, "/", {over.kids[0], {Kind::binary, "*", {over.kids[1], tree.kids[1]}}}});
    }
    const Piece top = piece(over), bottom = piece(tree.kids[1]);
    if (to_.stacked()) return {to_.fraction(top.text, bottom.text), Level::product, Form::fraction};
    const bool bare = bottom.form == Form::quantity && !bottom.minus;
    const Piece above = at_least(Level::product, top), below = bare ? bottom : inside(Level::power, bottom);
    const bool with_unit = above.form == Form::quantity || below.form == Form::quantity;
    return {to_.fraction(above.text, below.text), Level::product, with_unit ? Form::quantity : Form::fraction,
            above.minus};
  }

  [[nodiscard]] Piece power(const Node& base, const std::string& exponent) const {
    if (exponent == "1") return piece(base);
    const Piece raised = written({exponent, {}});
    return power(base, raised, exponent);
  }
  [[nodiscard]] Piece power(const Node& node, const Piece& raised, std::string_view digits = {}) const {
    const Piece under = at_least(Level::atom, piece(node));
    const Level level = digits.empty() ? raised.level : Level::atom;
    const bool letter = node.kind == Kind::symbol && !is_unit(node.text) && !(substituted_ && substituted_(node.text));
    if (letter) {
      const std::string exponent = to_.stacked() ? raised.text : to_.power({}, raised.text, level);
      return {to_.symbol(symbol(node.text), exponent), Level::power, Form::symbol};
    }
    return {to_.power(under.text, raised.text, level), Level::power, under.form};
  }

  [[nodiscard]] Piece call(const Node& tree) const {
    const std::string& f = tree.text;
    const Node& x = tree.kids[0];
    if (f == "sqrt" && x.kind == Kind::call && x.text == "sqrt") return root(4, x.kids[0]);
    if (f == "sqrt" || f == "cbrt") return root(f == "sqrt" ? 2 : 3, x);
    if (f.starts_with("root<")) return root(template_number(f), x);
    if (f.starts_with("pow<")) return power(x, std::to_string(template_number(f)));
    if (f == "pow") return power(x, piece(tree.kids[1]));
    if (f == "abs") return {to_.magnitude(piece(x).text)};
    if (f == "is_set") return {piece(x).text + to_.words(" is given"), Level::comparison};
    if (f == "exp" && to_.stacked()) return {to_.power(to_.unit("e"), piece(x).text, piece(x).level), Level::power};
    std::vector<std::string> arguments;
    for (const Node& kid : tree.kids) arguments.push_back(piece(kid).text);
    return {to_.call(f, arguments)};
  }
  [[nodiscard]] Piece root(int degree, const Node& x) const { return {to_.root(degree, piece(x).text)}; }

  /// The branch that the values take, where they are known.
  [[nodiscard]] const Node& chosen(const Node& tree) const { return known_ ? formula::chosen(tree, known_) : tree; }
  [[nodiscard]] Piece choice(const Node& tree) const {
    const Node& branch = chosen(tree);
    if (branch.kind != Kind::choose) return piece(branch);
    const auto text = [&](std::size_t i) { return at_least(Level::either, piece(branch.kids[i])).text; };
    return {to_.either(text(0), text(1), text(2)), Level::choice};
  }

  const Notation& to_;
  const Substituted& substituted_;
  const Known& known_;
};

}  // namespace

std::string print(const Notation& notation, const Node& tree, const Substituted& substituted, const Known& known) {
  return Printer(notation, substituted, known).term(tree).text;
}

std::vector<std::string> print_terms(const Notation& notation, const Node& tree, const Substituted& substituted,
                                     const Known& known) {
  return Printer(notation, substituted, known).terms(tree);
}

std::string print_quantity(const Notation& notation, const Written& value) {
  return Printer(notation, {}, {}).written(value).text;
}

}  // namespace loadpath::formula
