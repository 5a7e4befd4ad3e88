#include "lib/formula/tree.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::formula {
namespace {

constexpr int deepest = 100;           // nesting of parentheses, calls and signs
constexpr std::size_t longest = 4096;  // characters

using Tree = std::optional<Node>;

struct Function {
  std::string_view name;
  std::size_t arguments;
};
constexpr std::array functions = {Function{"sqrt", 1}, Function{"cbrt", 1}, Function{"abs", 1},   Function{"sin", 1},
                                  Function{"cos", 1},  Function{"tan", 1},  Function{"asin", 1},  Function{"acos", 1},
                                  Function{"atan", 1}, Function{"exp", 1},  Function{"log", 1},   Function{"pow", 2},
                                  Function{"min", 2},  Function{"max", 2},  Function{"is_set", 1}};

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
bool continues_word(char c) { return is_letter(c) || is_digit(c); }

/// The length of the sign between a name and its member, in.d or Kind::wide, that the text begins with; else 0.
std::size_t member_sign(std::string_view text) {
  const std::size_t sign = text.starts_with("::") ? 2 : text.starts_with('.') ? 1 : 0;
  return text.size() > sign && is_letter(text[sign]) ? sign : 0;
}

/// A comparison does not chain.
struct Operator {
  enum Strength { disjunction, conjunction, comparison, sum, product };
  std::string_view sign;
  int strength = 0;
};
constexpr std::array operators = {
    Operator{"*", Operator::product},     Operator{"/", Operator::product},      Operator{"+", Operator::sum},
    Operator{"-", Operator::sum},         Operator{"<=", Operator::comparison},  Operator{">=", Operator::comparison},
    Operator{"==", Operator::comparison}, Operator{"!=", Operator::comparison},  Operator{"<", Operator::comparison},
    Operator{">", Operator::comparison},  Operator{"&&", Operator::conjunction}, Operator{"||", Operator::disjunction}};

/// A node that takes its operands over: a list of them in braces would copy the trees.
Node node_of(Kind kind, std::string_view text, Node&& first, Node&& second) {
  Node node{kind, std::string(text), {}};
  node.kids.reserve(2);
  node.kids.push_back(std::move(first));
  node.kids.push_back(std::move(second));
  return node;
}

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
    Tree condition = infix(Operator::disjunction);
    if (!condition || !take("?")) return condition;
    Tree yes = nested(&Parser::choice);
    if (!yes || !take(":")) return std::nullopt;
    Tree no = nested(&Parser::choice);
    if (!no) return std::nullopt;
    Node node = node_of(Kind::choose, "?:", std::move(*condition), std::move(*yes));
    node.kids.push_back(std::move(*no));
    return node;
  }

  /// Operands between operators that are `weakest` or stronger; those of the right side of an operator are stronger
  /// than it is.
  Tree infix(int weakest) {
    Tree left = unary();
    for (int strongest = Operator::product; left;) {
      const Operator found = take_operator(weakest, strongest);
      if (found.sign.empty()) break;
      Tree right = infix(found.strength + 1);
      if (!right) return std::nullopt;
      if (found.strength == Operator::comparison) belong(*left, *right);
      left = node_of(Kind::binary, found.sign, std::move(*left), std::move(*right));
      strongest = found.strength == Operator::comparison ? Operator::conjunction : found.strength;
    }
    return left;
  }
  /// Completes Kind::wide compared with in.kind to in.kind::wide.
  static void belong(const Node& choice, Node& word) {
    const std::size_t type = word.text.rfind("::");
    if (type != std::string::npos) word.text.replace(0, type, choice.text);
  }
  Operator take_operator(int weakest, int strongest) {
    skip_blanks();
    if (rest_.starts_with("--")) return {};  // C++ reads -- as one operator
    const auto is_next = [&](const Operator& op) { return rest_.starts_with(op.sign); };
    const auto found = rest_.empty() ? operators.end() : std::find_if(operators.begin(), operators.end(), is_next);
    if (found == operators.end() || found->strength < weakest || found->strength > strongest) return {};
    rest_.remove_prefix(found->sign.size());
    return *found;
  }

  Tree unary() {
    if (!take("-")) return primary();
    if (rest_.starts_with("-")) return std::nullopt;
    Tree operand = nested(&Parser::unary);
    if (!operand) return std::nullopt;
    Node node{Kind::negate, "-", {}};
    node.kids.push_back(std::move(*operand));
    return node;
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
    std::string text = take_while(continues_word);
    if (member_sign(rest_) > 0) return member(std::move(text));
    if (text == "pow" || text == "root") text += template_argument(text);
    if (take("(")) return call(std::move(text));
    const bool reserved = is_function(text) || text.ends_with('>');
    return reserved ? std::nullopt : Tree(Node{Kind::symbol, text, {}});
  }
  /// in.d, Kind::wide.
  Tree member(std::string name) {
    for (std::size_t sign = member_sign(rest_); sign > 0; sign = member_sign(rest_)) {
      name += rest_.substr(0, sign);
      rest_.remove_prefix(sign);
      name += take_while(continues_word);
    }
    return take("(") ? std::nullopt : Tree(Node{Kind::symbol, std::move(name), {}});
  }
  /// "<3>", or nothing: then the text is read as a plain name.
  std::string template_argument(std::string_view function) {
    const std::string_view before = rest_;
    if (take("<")) {
      const bool negative = function == "pow" && take("-");
      skip_blanks();
      const std::string exponent = take_while(is_digit);
      const bool counts = !exponent.empty() && exponent.size() < 3 && exponent[0] != '0';
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

void collect(const Node& tree, std::vector<std::string>& names) {
  if (tree.kind == Kind::symbol && std::find(names.begin(), names.end(), tree.text) == names.end()) {
    names.push_back(tree.text);
  }
  for (const Node& kid : tree.kids) collect(kid, names);
}

}  // namespace

std::optional<Node> parse(std::string_view cpp) { return cpp.size() > longest ? std::nullopt : Parser(cpp).whole(); }

std::vector<std::string> names(const Node& tree) {
  std::vector<std::string> names;
  collect(tree, names);
  return names;
}

std::string_view symbol_of(std::string_view name) { return name.substr(name.find_last_of(".:") + 1); }

std::string shown(std::string_view cpp) {
  std::string text;
  while (!cpp.empty()) {
    const auto end = std::find_if_not(cpp.begin(), cpp.end(), continues_word);
    const std::string_view word = cpp.substr(0, std::max<std::size_t>(1, static_cast<std::size_t>(end - cpp.begin())));
    cpp.remove_prefix(word.size());
    const std::size_t sign = is_letter(word.front()) ? member_sign(cpp) : 0;
    if (sign == 0) text += word;
    cpp.remove_prefix(sign);
  }
  return text;
}

}  // namespace loadpath::formula
