#include "lib/project/references/titles/quantities.hpp"

#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

namespace loadpath::project {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Said> run() {
    while (at_ < text_.size()) {
      if (!is_digit(text_[at_])) {
        ++at_;
        continue;
      }
      const bool is_part = at_ > 0 && (is_of_word(text_[at_ - 1]) || text_[at_ - 1] == '.' || text_[at_ - 1] == ',');
      const std::string_view number = next_number();
      if (!is_part) read_quantity(number);
    }
    return std::move(found_);
  }

 private:
  std::string_view next_number() {
    const std::size_t start = at_;
    const auto skip_digits = [&] {
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    };
    skip_digits();
    if (at_ + 1 < text_.size() && text_[at_] == '.' && is_digit(text_[at_ + 1])) ++at_, skip_digits();
    return text_.substr(start, at_ - start);
  }

  /// The word after so many blanks or hyphens, without the mark of punctuation at its end.
  [[nodiscard]] std::string_view word_at(std::size_t start) const {
    std::size_t end = start;
    while (end < text_.size() && std::string_view(" ,;:()\"+").find(text_[end]) == std::string_view::npos) ++end;
    if (end > start && text_[end - 1] == '.') --end;
    return text_.substr(start, end - start);
  }

  void read_quantity(std::string_view number) {
    std::size_t start = at_;
    if (start < text_.size() && (text_[start] == ' ' || text_[start] == '-')) ++start;
    const std::string_view unit = word_at(start);
    if (unit.empty()) return;
    const std::string_view next = word_at(std::min(text_.size(), start + unit.size() + 1));
    if (is_of_strokes(unit)) return read_strokes(number, unit);
    const bool is_arm = next == "m" || next == "in" || next == "ft" || next == "mm";
    if (is_arm && unit.find('*') == std::string_view::npos &&
        add(number, std::string(unit) + "*" + std::string(next), stated::torque))
      return;
    add(number, std::string(unit));
  }

  static bool is_of_strokes(std::string_view unit) {
    constexpr std::array<std::string_view, 6> words{"strokes", "blows", "cycles", "lifts", "turns", "revolutions"};
    return std::ranges::find(words, unit.substr(0, unit.find('/'))) != words.end();
  }

  /// "strokes a minute", "strokes per minute", "strokes/min".
  void read_strokes(std::string_view number, std::string_view unit) {
    const std::string_view rest = text_.substr(at_, 40);
    const auto after = [&](std::string_view words) {
      const std::size_t place = rest.find(words);
      return place != std::string_view::npos && place <= unit.size() + 2;
    };
    if (after(" a minute") || after(" per minute") || after("/min")) add(number, "rpm");
  }

  /// False if it is no unit, or not of the required dimension.
  bool add(std::string_view number, const std::string& unit, const std::optional<Dimension>& required = {}) {
    const Outcome<Literal> read = parse_literal(std::string(number) + " " + unit);
    if (!read || (required && !(read->dimension == *required))) return false;
    const double value = std::stod(std::string(number));
    const std::size_t point = number.find('.');
    const std::size_t decimals = point == std::string_view::npos ? 0 : number.size() - point - 1;
    const double one = value > 0.0 ? std::abs(read->si) / value : 0.0;
    found_.push_back({std::string(number) + " " + unit, read->si, one * std::pow(10.0, -static_cast<double>(decimals)),
                      read->dimension.without_angle()});
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Said> found_;
};

}  // namespace

std::vector<Said> quantities_in(std::string_view text) { return Scanner(text).run(); }

}  // namespace loadpath::project
