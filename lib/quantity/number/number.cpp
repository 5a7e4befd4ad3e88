#include "lib/quantity/number/number.hpp"

#include "lib/quantity/number/cursor.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace loadpath {
namespace {

constexpr std::array<std::string_view, 8> group_marks = {" ", "'", "_", "\u00A0", "\u2009", "\u202F", "’", "\u2007"};
constexpr std::array<std::string_view, 7> times_signs = {"x", "×",      "·", "⋅",
                                                         "*", "\u0445", "∙"};  // U+0445: Cyrillic kha

bool is_mark(char c) { return c == '.' || c == ','; }
bool is_hex(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// "1,234.5" as "1234.5", "1,250,000" as "1250000"; empty unless the marks are at thousands.
std::string without_thousands(std::string_view written) {
  const std::size_t last = written.find_last_of(".,");
  const bool last_is_decimal = written.find(written[last]) == last;
  const std::string_view whole = last_is_decimal ? written.substr(0, last) : written;
  std::string plain;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const bool mark_is_due = (whole.size() - i) % 4 == 0;
    if (is_mark(whole[i]) != mark_is_due) return {};
    if (!mark_is_due) plain += whole[i];
  }
  return last_is_decimal ? plain + "." + std::string(written.substr(last + 1)) : plain;
}

class Reader {
 public:
  Reader(std::string_view text, std::size_t at) : in_{text, at}, start_(at) {}

  Outcome<Number> read() {
    if (!sign() || !mantissa() || !exponent()) return *std::move(fault_);
    if (plain_ && !fraction()) return *std::move(fault_);
    if (!value()) return *std::move(fault_);
    return Number{negative_ ? -value_ : value_, in_.at};
  }

 private:
  bool fail(std::size_t at, std::size_t length, Message message, Message hint = {}) {
    fault_ = Fault{at, length, std::move(message), std::move(hint)};
    return false;
  }
  [[nodiscard]] std::string since(std::size_t from) const { return std::string(in_.text.substr(from, in_.at - from)); }

  bool sign() {
    if (in_.starts("–") || in_.starts("—")) return fail(in_.at, 3, say("a dash is not a minus sign"), say("write '-'"));
    negative_ = in_.take("-") || in_.take("\u2212");
    if (!negative_) in_.take("+");
    return true;
  }

  bool mantissa() {
    const std::size_t from = in_.at;
    digits_ = in_.digits();
    if (digits_.empty() && !(is_mark(in_.peek()) && in_.digit(1))) return no_number();
    const bool hexadecimal = digits_ == "0" && (in_.peek() == 'x' || in_.peek() == 'X') && is_hex(in_.peek(1));
    if (hexadecimal)
      return fail(from, 2, say("hexadecimal numbers are not accepted"), say("write the number with decimal digits"));
    groups();
    return !is_mark(in_.peek()) || decimals(from);
  }

  bool no_number() {
    const std::size_t end = std::min(in_.text.find(' ', in_.at), in_.text.size());
    const std::string word(in_.text.substr(in_.at, end - in_.at));
    const std::size_t length = std::max<std::size_t>(word.size(), 1);
    const std::string lower = utf8_lower(word);
    const bool unusable = lower.starts_with("inf") || lower.starts_with("nan") || lower.starts_with("∞");
    if (unusable) return fail(in_.at, length, say("'{1}' is not a finite number", word));
    return fail(in_.at, length,
                word.empty() ? say("a number is missing") : say("a number must come first, not '{1}'", word));
  }

  static std::string utf8_lower(std::string_view word) {
    std::u32string points = code_points(word);
    for (char32_t& p : points) p = lower_case(p);
    return utf8(points);
  }

  /// Groups of exactly three digits, all set off by the same mark; `1 200/300` is left to `fraction`.
  void groups() {
    if (digits_.empty() || digits_.size() > 3 || digits_[0] == '0') return;
    Cursor ahead = in_;
    const std::string_view mark = ahead.take_any(group_marks);
    while (!mark.empty()) {
      ahead = in_;
      if (!ahead.take(mark)) return;
      const std::string_view group = ahead.digits();
      if (group.size() != 3 || (ahead.peek() == '/' && ahead.digit(1))) return;
      digits_ += group;
      plain_ = false;
      in_ = ahead;
    }
  }

  bool decimals(std::size_t from) {
    const std::string mark(1, in_.peek());
    if (!in_.digit(1)) return fail(in_.at, 1, say("a digit must follow the '{1}'", mark));
    const bool could_be_thousands =
        plain_ && mark == "," && digits_.size() <= 3 && !digits_.empty() && digits_[0] != '0';
    ++in_.at;
    const std::string whole = digits_, part(in_.digits());
    if (is_mark(in_.peek()) && in_.digit(1)) return two_marks(from);
    if (could_be_thousands && part.size() == 3)
      return fail(from, in_.at - from, say("'{1}' is ambiguous", since(from)),
                  say("write '{1}' or '{2}'", whole + "." + part, whole + part));
    digits_ += '.' + part;
    plain_ = false;
    return true;
  }

  bool two_marks(std::size_t from) {
    while (in_.digit() || (is_mark(in_.peek()) && in_.digit(1))) ++in_.at;
    const std::string written = since(from), plain = without_thousands(written);
    return fail(from, written.size(), say("'{1}' has more than one decimal mark", written),
                plain.empty() ? Message{} : say("write '{1}'", plain));
  }

  bool exponent() {
    if (in_.peek() == 'e' || in_.peek() == 'E') {
      Cursor ahead{in_.text, in_.at + 1};
      if (const std::string power = ahead.signed_integer(); !power.empty()) return raise(ahead, power);
    }
    return digits_ == "10" && plain_ ? power_of_ten() : times_power_of_ten();
  }

  bool raise(const Cursor& after, const std::string& power) {
    in_ = after;
    digits_ += 'e' + power;
    plain_ = false;
    return true;
  }

  /// The exponent of a 10 that has been read: ^6, ^(-6), ⁻⁶.
  static std::string power_after(Cursor& ahead) {
    if (!ahead.take("^")) return ahead.superscript();
    const bool open = ahead.take("(");
    std::string power = ahead.signed_integer();
    return open && !ahead.take(")") ? std::string() : power;
  }

  bool power_of_ten() {
    Cursor ahead = in_;
    const std::string power = power_after(ahead);
    if (power.empty()) return times_power_of_ten();
    digits_ = "1";
    return raise(ahead, power);
  }

  bool times_power_of_ten() {
    Cursor ahead = in_;
    ahead.skip_spaces();
    if (!ahead.take_any(times_signs).empty()) {
      ahead.skip_spaces();
      if (ahead.take("10"))
        if (const std::string power = power_after(ahead); !power.empty()) return raise(ahead, power);
    }
    const std::string power = in_.peek() == '^' ? "^" : Cursor(in_).superscript();
    if (power.empty()) return true;
    return fail(in_.at, in_.character(), say("only 10 with an integer exponent is read as a power"),
                say("write 2·10^6 or 2e6"));
  }

  /// 1/2, or after an integer 1 1/2 and 1-1/2; a unit that starts with 1/ is not a fraction.
  bool fraction() {
    const std::size_t from = in_.at;
    Cursor ahead = in_;
    const bool mixed = ahead.peek() != '/';
    if (mixed && !ahead.take("-")) ahead.skip_spaces();
    const std::string_view top = mixed ? ahead.digits() : std::string_view(digits_);
    if (top.empty() || (mixed && ahead.at == from + top.size()) || !ahead.take("/") || !ahead.digit()) return true;
    const std::string_view bottom = ahead.digits();
    in_ = ahead;
    if (is_mark(in_.peek()) && in_.digit(1)) return fail(in_.at, 1, say("a fraction consists of integers"));
    return divide(from, top, bottom, mixed);
  }

  bool divide(std::size_t from, std::string_view top, std::string_view bottom, bool mixed) {
    const double n = number(top), d = number(bottom);
    if (d == 0.0) return fail(in_.at - bottom.size(), bottom.size(), say("a fraction cannot have the denominator 0"));
    if (mixed && (top.size() > 2 || n >= d))
      return fail(from, in_.at - from, say("'{1}' is ambiguous", since(start_)),
                  say("write a decimal number, or an integer and a fraction less than 1"));
    ready_ = true;
    value_ = mixed ? number(digits_) + n / d : n / d;
    return true;
  }

  static double number(std::string_view digits) {
    double value = std::nan("");
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  }

  bool value() {
    const bool zero = digits_.find_first_of("123456789") >= digits_.find('e');
    if (!ready_) value_ = zero ? 0.0 : number(digits_);
    if (is_normal_or_zero(value_) && (zero || value_ != 0.0)) return true;
    return fail(start_, in_.at - start_, say("'{1}' is out of the range of numbers", since(start_)),
                say("magnitudes must be from 1e-300 to 1e300"));
  }

  Cursor in_;
  std::size_t start_;
  std::string digits_;  // as from_chars reads them
  bool plain_ = true;   // so far only a run of digits
  bool negative_ = false;
  bool ready_ = false;  // value_ is known from a fraction
  double value_ = 0.0;
  std::optional<Fault> fault_;
};

}  // namespace

bool is_normal_or_zero(double value) { return value == 0.0 || std::isnormal(value); }

Outcome<Number> read_number(std::string_view text, std::size_t at) { return Reader(text, at).read(); }

}  // namespace loadpath
