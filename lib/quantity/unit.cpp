#include "lib/quantity/unit.hpp"

#include "lib/quantity/number/cursor.hpp"
#include "lib/quantity/number/power_of_ten.hpp"
#include "lib/quantity/unit_hint.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace loadpath {
namespace {

constexpr std::array<std::string_view, 4> product_signs = {"*", "·", "⋅", "∙"};
constexpr std::array<std::string_view, 8> not_letters = {"·", "⋅", "∙", "×", "−", "\u00A0", "\u2009", "\u202F"};
constexpr int largest_power = 12, largest_ten = 300;
constexpr int largest_exponent = 30 * Dimension::one;

struct Power {
  int top = 1;
  int bottom = 1;
  [[nodiscard]] bool is_one() const { return top == bottom; }
};

bool raise(ParsedUnit& unit, const Power& power) {
  if (power.is_one()) return true;
  for (const int e : unit.dimension.twelfths)
    if (e * power.top % power.bottom != 0 || std::abs(e * power.top / power.bottom) > largest_exponent) return false;
  unit.dimension = unit.dimension.power(power.top, power.bottom);
  if (unit.ten * power.top % power.bottom != 0)
    unit.factor = times_power_of_ten(unit.factor, std::exchange(unit.ten, 0));
  unit.ten = unit.ten * power.top / power.bottom;
  if (unit.factor != 1.0) unit.factor = std::pow(unit.factor, static_cast<double>(power.top) / power.bottom);
  return std::abs(unit.ten) <= largest_ten && std::isnormal(unit.factor);
}

bool join(ParsedUnit& product, const ParsedUnit& unit, bool divide) {
  product.dimension = divide ? product.dimension / unit.dimension : product.dimension * unit.dimension;
  product.factor = divide ? product.factor / unit.factor : product.factor * unit.factor;
  product.ten += divide ? -unit.ten : unit.ten;
  product.offset = unit.offset;
  product.names += unit.names;
  product.marks |= unit.marks;
  for (const int e : product.dimension.twelfths)
    if (std::abs(e) > largest_exponent) return false;
  return std::abs(product.ten) <= largest_ten && std::isnormal(product.factor);
}

class UnitReader {
 public:
  UnitReader(std::string_view text, std::size_t at) : in_{text, at} {}

  Outcome<ParsedUnit> read() {
    const std::size_t from = in_.at;
    ParsedUnit unit;
    if (!product(unit)) return *std::move(fault_);
    if (!in_.done() && !unexpected()) return *std::move(fault_);
    const bool lone = unit.names == 1 && unit.dimension == Dimension::of(0, 0, 0, 1);
    if (unit.has(Mark::scale) && !lone && !scale_in_product(from)) return *std::move(fault_);
    return unit;
  }

 private:
  bool fail(std::size_t at, std::size_t length, Message message, Message hint = {}) {
    fault_ = Fault{at, length, std::move(message), std::move(hint)};
    return false;
  }
  [[nodiscard]] std::string_view since(std::size_t from) const { return in_.text.substr(from, in_.at - from); }
  bool too_large(std::size_t from) {
    return fail(from, in_.at - from, say("'{1}' is too large a power for a unit", since(from)));
  }

  bool scale_in_product(std::size_t from) {
    return fail(from, in_.at - from,
                say("'{1}': a point on a temperature scale cannot be used in a product", since(from)),
                say("write the temperature difference in K"));
  }

  bool unexpected() {
    if (in_.done()) return fail(in_.at, 1, say("a unit is missing at the end"));
    if (in_.peek() == ')') return fail(in_.at, 1, say("this ')' has no '('"));
    if (in_.digit()) return second_number();
    const std::string_view character = in_.text.substr(in_.at, in_.character());
    return fail(in_.at, character.size(), say("'{1}' does not belong in a unit", character));
  }

  bool second_number() {
    const std::size_t from = in_.at;
    while (in_.digit() || ((in_.peek() == '.' || in_.peek() == ',') && in_.digit(1))) ++in_.at;
    return fail(
        from, in_.at - from, say("a second number '{1}'", since(from)),
        say("write one number and one unit; digits are grouped by exactly three; an expression begins with '='"));
  }

  /// The operator here: '*', '/', or '\0' where the product ends.
  char operation() {
    const std::size_t from = in_.at;
    in_.skip_spaces();
    const bool spaced = in_.at > from;
    if (in_.done() || in_.peek() == ')') return '\0';
    if (in_.take("/")) return '/';
    if (!in_.take_any(product_signs).empty() || in_.take(".")) return '*';
    if (in_.peek() == '-' && !in_.digit(1)) return ++in_.at, '*';
    return spaced || in_.peek() == '(' ? '*' : '\0';
  }

  bool product(ParsedUnit& out) {
    const std::size_t from = in_.at;
    if (!leading_slash() && !factor(out, false)) return false;
    std::size_t slash = std::string_view::npos;
    while (true) {
      const std::size_t before = in_.at;
      const char sign = operation();
      if (sign == '\0') return true;
      if (slash != std::string_view::npos) return second_operator(from, slash, before, sign);
      if (sign == '/') slash = in_.at - 1;
      if (!factor(out, sign == '/')) return false;
    }
  }

  /// Leaves the slash of `/K` and `1/K` to be read as an operator.
  bool leading_slash() {
    Cursor ahead = in_;
    ahead.skip_spaces();
    if (ahead.take("1")) ahead.skip_spaces();
    if (ahead.peek() != '/') return false;
    in_ = ahead;
    return true;
  }

  bool second_operator(std::size_t from, std::size_t slash, std::size_t before, char sign) {
    const std::size_t after = in_.at;
    const Message hint = one_division(in_.text.substr(from, slash - from),
                                      in_.text.substr(slash + 1, before - slash - 1), sign, in_.text.substr(after));
    return fail(before, std::max<std::size_t>(after - before, 1),
                say("use parentheses after '/' to show what is divided"), hint);
  }

  bool factor(ParsedUnit& out, bool divide) {
    in_.skip_spaces();
    const std::size_t from = in_.at;
    ParsedUnit one;
    if (!(in_.peek() == '(' ? group(one) : named(one))) return false;
    return join(out, one, divide) || too_large(from);
  }

  bool group(ParsedUnit& out) {
    const std::size_t from = in_.at++;
    if (!product(out)) return false;
    in_.skip_spaces();
    if (!in_.take(")")) return in_.done() ? fail(from, 1, say("this '(' is not closed")) : unexpected();
    Power power;
    return exponent(power) && (raise(out, power) || too_large(from));
  }

  bool named(ParsedUnit& out) {
    const std::size_t from = in_.at;
    const std::string_view name = letters();
    if (name.empty()) return unexpected();
    const FoundUnit found = find_unit(name);
    if (found.row == nullptr) return fail(from, name.size(), unknown_unit(name), unknown_unit_hint(name));
    const UnitRow& row = *found.row;
    out = {row.factor, row.ten + found.ten, row.offset, row.dimension, 1, static_cast<unsigned>(row.mark)};
    const std::size_t end = in_.at;
    Power power;
    if (!exponent(power)) return false;
    if (row.mark == Mark::run_together && !power.is_one())
      return fail(from, in_.at - from, say("'{1}' is ambiguous", since(from)),
                  say("write '{1}'", split(name) + std::string(in_.text.substr(end, in_.at - end))));
    return raise(out, power) || too_large(from);
  }

  std::string_view letters() {
    const std::size_t from = in_.at;
    for (; !in_.done(); in_.at += in_.character()) {
      const char c = in_.peek();
      const bool ascii_letter = is_latin(c) || c == '%' || c == '_';
      if (is_ascii(c) ? !ascii_letter : !letter_beyond_ascii()) break;
    }
    const std::string_view name = since(from);
    if (name == "л" || name == "к") take_points_of_horsepower();
    return since(from);
  }

  /// Whether a name continues: neither an operator nor a space nor a superscript follows (these start with C2, C3,
  /// E2).
  bool letter_beyond_ascii() {
    const char lead = in_.peek();
    if (lead != '\xC2' && lead != '\xC3' && lead != '\xE2') return true;
    Cursor ahead = in_;
    return ahead.take_any(not_letters).empty() && !in_.starts("⁻") && ahead.superscript().empty();
  }

  /// л.с. and к.с. are the only names with points in them.
  void take_points_of_horsepower() {
    if (!in_.take(".с.")) in_.take(". с.");
  }

  bool exponent(Power& power) {
    const std::size_t from = in_.at;
    const bool caret = in_.take("^");
    const bool open = caret && in_.take("(");
    std::string top = caret ? std::string() : in_.superscript();
    if (top.empty() && (caret || in_.peek() != '+')) top = in_.signed_integer();
    if (top.empty()) return !caret || fail(from, in_.at - from, say("an integer must follow '^'"));
    std::string bottom;
    if (open && in_.take("/")) bottom = in_.digits();
    if (caret && in_.peek() == '.' && in_.digit(1)) bottom = decimals(top);
    if (open && !in_.take(")")) return fail(from, in_.at - from, say("the '(' of the exponent is not closed"));
    return set(power, top, bottom, from);
  }

  /// Appends the decimals of an exponent to its digits; returns the divisor.
  std::string decimals(std::string& top) {
    ++in_.at;
    const std::string_view part = in_.digits();
    top += part;
    return "1" + std::string(part.size(), '0');
  }

  bool set(Power& power, const std::string& top, const std::string& bottom, std::size_t from) {
    const auto whole = [](const std::string& digits, int& number) {
      return digits.size() <= 5 &&
             std::from_chars(digits.data(), digits.data() + digits.size(), number).ec == std::errc{};
    };
    Power read;
    const bool small = whole(top, read.top) && (bottom.empty() || whole(bottom, read.bottom)) && read.bottom != 0;
    if (!small || std::abs(read.top) > largest_power * read.bottom) return too_large(from);
    if (read.top == 0) return fail(from, in_.at - from, say("an exponent of 0 leaves no unit"));
    const int common = std::gcd(read.top, read.bottom);
    power = {read.top / common, read.bottom / common};
    return Dimension::one % power.bottom == 0 ||
           fail(from, in_.at - from, say("'{1}' is not a valid exponent of a unit", since(from)));
  }

  Cursor in_;
  std::optional<Fault> fault_;
};

}  // namespace

double ParsedUnit::to_si(double value) const { return times_power_of_ten(value * factor, ten) + offset; }
double ParsedUnit::from_si(double si) const { return times_power_of_ten((si - offset) / factor, -ten); }

Outcome<ParsedUnit> read_unit(std::string_view text, std::size_t at) { return UnitReader(text, at).read(); }

}  // namespace loadpath
