#include "lib/formula/formula.hpp"

#include <algorithm>
#include <array>

namespace loadpath::formula {
namespace {

constexpr int deepest = 100;           // nesting of parentheses, calls and signs
constexpr std::size_t longest = 4096;  // characters

using Tree = std::optional<Node>;

struct Function {
  std::string_view name;
  std::size_t arguments;
};
constexpr std::array functions = {
    Function{"sqrt", 1}, Function{"cbrt", 1}, Function{"abs", 1},  Function{"sin", 1},
    Function{"cos", 1},  Function{"tan", 1},  Function{"asin", 1}, Function{"acos", 1},
    Function{"atan", 1}, Function{"exp", 1},  Function{"log", 1},  Function{"static_cast<double>", 1},
    Function{"pow", 2},  Function{"min", 2},  Function{"max", 2},  Function{"is_set", 1}};

bool is_function(std::string_view name) {
  return std::any_of(functions.begin(), functions.end(), [&](const Function& f) { return f.name == name; });
}

bool is_in_language(const Node& call) {
  if (call.text.starts_with("pow<") || call.text.starts_with("root<")) return call.kids.size() == 1;
  return std::any_of(functions.begin(), functions.end(),
                     [&](const Function& f) { return f.name == call.text && f.arguments == call.kids.size(); });
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Operators from the weakest to the strongest; a comparison does not chain.
using Level = std::array<std::string_view, 6>;
constexpr std::array<Level, 5> levels = {Level{"||"}, Level{"&&"}, Level{"<=", ">=", "==", "!=", "<", ">"},
                                         Level{"+", "-"}, Level{"*", "/"}};
constexpr std::size_t comparison = 2;

class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  Tree whole() {
    Tree tree = choice();
    skip_blanks();
    return rest_.empty() ? tree : std::nullopt;
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n' || rest_.front() == '\t')) {
      rest_.remove_prefix(1);
    }
  }
  bool take(std::string_view token) {
    skip_blanks();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  std::string take_while(bool (*belongs)(char)) {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), belongs);
    const auto length = static_cast<std::size_t>(end - rest_.begin());
    std::string taken(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return taken;
  }

  Tree choice() {
    Tree condition = infix(0);
    if (!condition || !take("?")) return condition;
    Tree yes = nested(&Parser::choice);
    if (!yes || !take(":")) return std::nullopt;
    Tree no = nested(&Parser::choice);
    if (!no) return std::nullopt;
    return Node{Kind::choose, "?:", {std::move(*condition), std::move(*yes), std::move(*no)}};
  }

  Tree infix(std::size_t level) {
    if (level == levels.size()) return unary();
    Tree left = infix(level + 1);
    for (bool again = true; left && again; again = level != comparison) {
      const std::string_view found = take_operator(levels[level]);
      if (found.empty()) break;
      Tree right = infix(level + 1);
      if (!right) return std::nullopt;
      left = Node{Kind::binary, std::string(found), {std::move(*left), std::move(*right)}};
    }
    return left;
  }
  std::string_view take_operator(const Level& level) {
    skip_blanks();
    for (const std::string_view op : level) {
      if (op.empty() || !rest_.starts_with(op)) continue;
      if (op == "-" && rest_.starts_with("--")) return {};  // C++ reads -- as one operator
      rest_.remove_prefix(op.size());
      return op;
    }
    return {};
  }

  Tree unary() {
    if (!take("-")) return primary();
    if (rest_.starts_with("-")) return std::nullopt;
    Tree operand = nested(&Parser::unary);
    if (!operand) return std::nullopt;
    return Node{Kind::negate, "-", {std::move(*operand)}};
  }

  Tree primary() {
    if (take("(")) {
      Tree inner = nested(&Parser::choice);
      return take(")") ? inner : std::nullopt;
    }
    if (rest_.empty()) return std::nullopt;
    return is_digit(rest_.front()) || rest_.front() == '.' ? number() : name();
  }

  Tree number() {
    std::string text = take_while(is_digit);
    const bool octal = text.size() > 1 && text.front() == '0';
    if (rest_.starts_with('.')) {
      rest_.remove_prefix(1);
      text += '.' + take_while(is_digit);
    }
    if (text == "." || octal || !take_exponent(text)) return std::nullopt;
    const bool ends = rest_.empty() || !(is_letter(rest_.front()) || rest_.front() == '.' || rest_.front() == '\'');
    return ends ? Tree(Node{Kind::number, text, {}}) : std::nullopt;
  }
  bool take_exponent(std::string& number) {
    if (!rest_.starts_with('e') && !rest_.starts_with('E')) return true;
    rest_.remove_prefix(1);
    const bool negative = rest_.starts_with('-');
    if (negative || rest_.starts_with('+')) rest_.remove_prefix(1);
    const std::string digits = take_while(is_digit);
    number += (negative ? "e-" : "e") + digits;
    return !digits.empty();
  }

  Tree name() {
    if (!is_letter(rest_.front())) return std::nullopt;
    std::string text = take_while([](char c) { return is_letter(c) || is_digit(c); });
    if (text == "pow" || text == "root" || text == "static_cast") text += template_argument(text);
    if (take("(")) return call(std::move(text));
    const bool reserved = is_function(text) || text.ends_with('>') || text == "static_cast";
    return reserved ? std::nullopt : Tree(Node{Kind::symbol, text, {}});
  }
  /// "<3>", "<double>", or nothing: then the text is read on as a plain name.
  std::string template_argument(std::string_view function) {
    const std::string_view before = rest_;
    if (take("<")) {
      if (function == "static_cast" && take("double") && take(">")) return "<double>";
      const bool negative = function == "pow" && take("-");
      skip_blanks();
      const std::string exponent = take_while(is_digit);
      const bool counts = function != "static_cast" && !exponent.empty() && exponent.size() < 3 && exponent[0] != '0';
      if (counts && take(">")) return (negative ? "<-" : "<") + exponent + ">";
    }
    rest_ = before;
    return {};
  }

  Tree call(std::string function) {
    Node node{Kind::call, std::move(function), {}};
    do {
      Tree argument = nested(&Parser::choice);
      if (!argument) return std::nullopt;
      node.kids.push_back(std::move(*argument));
    } while (take(","));
    return take(")") && is_in_language(node) ? Tree(std::move(node)) : std::nullopt;
  }

  Tree nested(Tree (Parser::*read)()) {
    if (++depth_ > deepest) return std::nullopt;
    Tree tree = (this->*read)();
    --depth_;
    return tree;
  }

  std::string_view rest_;
  int depth_ = 0;
};

}  // namespace

std::optional<Node> parse(std::string_view cpp) { return cpp.size() > longest ? std::nullopt : Parser(cpp).whole(); }

}  // namespace loadpath::formula
