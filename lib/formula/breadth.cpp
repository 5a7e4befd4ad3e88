#include "lib/formula/formula.hpp"
#include "lib/formula/print.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath::formula {
namespace {

std::size_t length(std::string_view text) { return code_points(text).size(); }
std::string letters(std::size_t count) { return std::string(count, 'x'); }
/// Scripts are set at about two thirds of the size.
std::string script(std::size_t count) { return letters((2 * count + 2) / 3); }

/// Prints a row of letters that is about as wide as the formula.
class Outline : public Notation {
 public:
  std::string words(std::string_view text) const override { return letters(length(text)); }
  std::string number(std::string_view digits) const override { return std::string(digits); }
  std::string symbol(const Symbol& s, std::string_view exponent) const override {
    std::size_t index = 0;
    for (const Word& word : s.subscripts) {
      for (const Glyphs& g : word) index += length(g.letters());
    }
    return letters(length(s.base.letters())) + script(std::max(index, exponent.size() + (s.star ? 1 : 0)));
  }
  std::string unit(std::string_view pretty) const override { return letters(length(pretty)); }
  std::string quantity(std::string_view number, std::string_view unit) const override {
    return std::string(number) + letters(length(unit));
  }
  std::string minus() const override { return letters(1); }
  std::string infix(std::string_view) const override { return letters(2); }
  std::string thin_space() const override { return {}; }
  std::string fraction(std::string_view over, std::string_view under) const override {
    return std::string(std::max(over, under, shorter));
  }
  std::string power(std::string_view base, std::string_view exponent, Level) const override {
    return std::string(base) + script(exponent.size());
  }
  std::string root(int, std::string_view radicand) const override { return letters(2) + std::string(radicand); }
  std::string fenced(std::string_view inner) const override { return letters(2) + std::string(inner); }
  std::string magnitude(std::string_view inner) const override { return fenced(inner); }
  std::string call(std::string_view function, const std::vector<std::string>& arguments) const override {
    std::string out = letters(function.size() + 1);
    for (const std::string& a : arguments) out += a + letters(1);
    return out;
  }
  std::string either(std::string_view condition, std::string_view yes, std::string_view no) const override {
    return letters(4) + std::string(std::max(yes, no, shorter)) + std::string(condition);
  }

 private:
  static bool shorter(std::string_view a, std::string_view b) { return a.size() < b.size(); }
};

const Outline outline;

}  // namespace

Extent extent(const Node& tree, const Substituted& substituted, const Known& known) {
  Extent all;
  for (const std::string& term : print_terms(outline, tree, substituted, known)) {
    ++all.terms;
    all.widest = std::max(all.widest, term.size());
  }
  return all;
}

}  // namespace loadpath::formula
