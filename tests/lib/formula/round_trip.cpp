#include "lib/formula/formula.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace loadpath::formula;

namespace {

double known_value(char name) { return 0.7 + 0.31 * (name - 'a'); }
std::optional<double> known(std::string_view name) {
  return name.size() == 1 ? std::optional(known_value(name[0])) : std::nullopt;
}

class Trees {
 public:
  explicit Trees(unsigned seed) : random_(seed) {}

  /// A tree with the operators that a line of plain text can hold.
  Node algebra(int depth) {
    if (depth == 0 || below(6) == 0) return leaf();
    if (below(7) == 0) return {Kind::negate, "-", {algebra(depth - 1)}};
    static const std::vector<std::string> operators = {"+", "-", "*", "/"};
    return {Kind::binary, operators[below(4)], {algebra(depth - 1), algebra(depth - 1)}};
  }
  Node any(int depth) {
    static const std::vector<std::string> calls = {"sqrt",   "cbrt",    "abs", "sin",    "exp",
                                                   "pow<3>", "root<5>", "log", "pow<-2>"};
    static const std::vector<std::string> pairs = {"+", "-", "*", "/", "<", ">=", "==", "&&", "||"};
    if (depth == 0) return leaf();
    switch (below(6)) {
      case 0:
        return leaf();
      case 1:
        return {Kind::negate, "-", {any(depth - 1)}};
      case 2:
        return {Kind::call, calls[below(calls.size())], {any(depth - 1)}};
      case 3:
        return {Kind::call, below(2) == 0 ? "min" : "max", {any(depth - 1), any(depth - 1)}};
      case 4:
        return {Kind::choose, "?:", {any(depth - 1), any(depth - 1), any(depth - 1)}};
      default:
        return {Kind::binary, pairs[below(pairs.size())], {any(depth - 1), any(depth - 1)}};
    }
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  Node leaf() {
    if (below(2) == 0) return {Kind::number, std::to_string(below(9) + 1) + ".25", {}};
    return {Kind::symbol, std::string(1, static_cast<char>('a' + below(6))), {}};
  }
  std::mt19937 random_;
};

int strength(const Node& tree) {
  static const std::vector<std::vector<std::string>> levels = {
      {"||"}, {"&&"}, {"<", ">=", "=="}, {"+", "-"}, {"*", "/"}};
  if (tree.kind == Kind::choose) return 0;
  if (tree.kind == Kind::negate) return 6;
  if (tree.kind != Kind::binary) return 7;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (const auto& op : levels[i]) {
      if (op == tree.text) return static_cast<int>(i) + 1;
    }
  }
  return 0;
}

std::string cpp(const Node& tree);
std::string fenced_below(int needed, const Node& tree) {
  return strength(tree) < needed ? "(" + cpp(tree) + ")" : cpp(tree);
}
/// C++ with the parentheses that its grammar requires, and no more.
std::string cpp(const Node& tree) {
  if (tree.kids.empty()) return tree.text;
  if (tree.kind == Kind::negate) {
    return std::string(tree.kids[0].kind == Kind::negate ? "- " : "-") + fenced_below(6, tree.kids[0]);
  }
  if (tree.kind == Kind::choose) {
    return fenced_below(1, tree.kids[0]) + " ? " + cpp(tree.kids[1]) + " : " + cpp(tree.kids[2]);
  }
  if (tree.kind == Kind::call) {
    return tree.text + "(" + cpp(tree.kids[0]) + (tree.kids.size() > 1 ? ", " + cpp(tree.kids[1]) : "") + ")";
  }
  const int own = strength(tree);
  return fenced_below(own == 3 ? 4 : own, tree.kids[0]) + " " + tree.text + " " + fenced_below(own + 1, tree.kids[1]);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

bool same(double a, double b) { return (std::isnan(a) && std::isnan(b)) || a == b; }
bool close(double a, double b) {
  return !std::isfinite(a) || !std::isfinite(b) || std::fabs(a - b) <= 1e-9 * std::max(std::fabs(a), 1.0);
}

}  // namespace

TEST_SUITE("formula") {
  TEST_CASE("a random tree written as C++ is read back with the same value") {
    Trees trees(1);
    for (int i = 0; i < 3000; ++i) {
      const Node tree = trees.any(5);
      const std::string text = cpp(tree);
      CAPTURE(text);
      const auto read = parse(text);
      REQUIRE(read);
      CHECK(same(value(*read, known), value(tree, known)));
      CHECK(cpp(*read) == text);
    }
  }

  TEST_CASE("plain text of a random tree has the meaning of the tree") {
    Trees trees(2);
    for (int i = 0; i < 3000; ++i) {
      const Node tree = trees.algebra(5);
      std::string text = plain(tree);
      CAPTURE(text);
      for (const char name : std::string("abcdef")) {
        for (int power = 2; power < 10; ++power) {
          static const std::vector<std::string> raised = {"²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
          text = replaced(text, name + raised[static_cast<std::size_t>(power) - 2],
                          "pow<" + std::to_string(power) + ">(" + name + ")");
        }
      }
      const auto read = parse(replaced(replaced(text, "·", "*"), "−", "-"));
      REQUIRE(read);
      CHECK(close(value(*read, known), value(tree, known)));
    }
  }

  TEST_CASE("every random tree prints in HTML with elements that close") {
    Trees trees(3);
    for (int i = 0; i < 500; ++i) {
      const std::string markup = html(trees.any(5));
      std::vector<std::string> open;
      for (std::size_t at = 0; (at = markup.find('<', at)) != std::string::npos; ++at) {
        const std::size_t end = markup.find('>', at);
        REQUIRE(end != std::string::npos);
        const std::string tag = markup.substr(at + 1, markup.find_first_of(" >", at) - at - 1);
        if (tag[0] != '/') {
          open.push_back(tag);
          continue;
        }
        REQUIRE(!open.empty());
        CHECK("/" + open.back() == tag);
        open.pop_back();
      }
      CHECK(open.empty());
    }
  }
}
