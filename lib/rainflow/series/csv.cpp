#include "lib/rainflow/series/csv.hpp"

#include "lib/rainflow/series/lines.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::rainflow {

namespace {

constexpr std::size_t values_at_once = 4096;
constexpr char blanks = ' ';  // as a separator: any number of blanks and tabs

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

/// Takes the first field off a line; a separator within "" is none.
std::string_view take_field(std::string_view& line, char separator) {
  if (separator == blanks) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  }
  const std::size_t quoted = !line.empty() && line.front() == '"' ? line.find('"', 1) : 0;
  const std::size_t from = quoted == std::string_view::npos ? 0 : quoted;
  std::size_t end = from;
  if (separator == blanks) {
    while (end < line.size() && !is_blank(line[end])) ++end;
  } else {
    end = std::min(line.find(separator, from), line.size());
  }
  const std::string_view field = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return trimmed(field);
}

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  const bool ends_open = separator != blanks && !line.empty() && line.back() == separator;
  if (separator == blanks) {
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  }
  while (!line.empty()) fields.emplace_back(take_field(line, separator));
  if (ends_open) fields.emplace_back();
  return fields;
}

char separator_of(std::string_view line) {
  for (const char candidate : {'\t', ';', ','}) {
    if (line.find(candidate) != std::string_view::npos) return candidate;
  }
  return blanks;
}

/// What std::from_chars gives for up to 15 digits with a point and no exponent: both whole numbers are doubles, and
/// their quotient is rounded once. None of any other text.
std::optional<double> short_number(std::string_view text) {
  constexpr std::array<double, 16> tens{1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() >= tens.size() || text.front() == '.') return std::nullopt;
  std::uint64_t digits = 0;
  std::size_t decimals = 0, point = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto digit = static_cast<unsigned>(text[i] - '0');
    if (digit <= 9) {
      digits = 10 * digits + digit;
    } else if (text[i] == '.' && point == text.size()) {
      point = i, decimals = text.size() - i - 1;
    } else {
      return std::nullopt;
    }
  }
  const double size = static_cast<double>(digits) / tens[decimals];
  return negative ? -size : size;
}

/// All of the text as a finite number.
std::optional<double> number_of(std::string_view text) {
  if (const auto value = short_number(text)) return value;
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double x = 0.0;
  const auto [behind, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (behind != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    x = std::strtod(std::string(text).c_str(), nullptr);  // tells 0 from inf
  else if (error != std::errc{})
    return std::nullopt;
  return std::isfinite(x) ? std::optional(x) : std::nullopt;
}

/// A text for a message: short, and without what a terminal would obey.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string out(text.substr(0, longest));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
  return text.size() > longest ? out + "..." : out;
}

class CsvReader final : public Reader {
 public:
  CsvReader(std::unique_ptr<Source> source, Form form) : lines_(std::move(source)), form_(std::move(form)) {}

  /// Finds the column.
  std::optional<Fault> start();
  Outcome<std::span<const double>> next() override;

 private:
  std::optional<std::string_view> content();
  std::optional<Fault> find_column(const std::vector<std::string>& fields);
  std::optional<Fault> find_name(const std::vector<std::string>& fields);
  [[nodiscard]] std::string_view field_of(std::string_view line) const;
  [[nodiscard]] Fault not_a_number(std::string_view line) const;
  [[nodiscard]] bool runs_over(std::string_view line) const;
  [[nodiscard]] Fault too_many(std::string_view line) const;
  [[nodiscard]] Fault at_line(Message message, Message hint = {}) const {
    return {lines_.number(), 1, std::move(message), std::move(hint)};
  }

  Lines lines_;
  Form form_;
  char separator_ = ',';
  std::size_t column_ = 0;   // counted from 0
  std::size_t columns_ = 0;  // of the first line
  bool by_name_ = false;
  std::vector<double> values_;
};

/// The next line that is neither empty nor a comment.
std::optional<std::string_view> CsvReader::content() {
  while (auto line = lines_.next()) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (lines_.number() == 1 && line->starts_with(mark)) line->remove_prefix(mark.size());
    std::size_t first = 0;
    while (first < line->size() && is_blank((*line)[first])) ++first;
    if (first < line->size() && (*line)[first] != form_.comment) return line;
  }
  return std::nullopt;
}

std::optional<Fault> CsvReader::find_name(const std::vector<std::string>& fields) {
  const auto found = std::find(fields.begin(), fields.end(), form_.column);
  if (found == fields.end())
    return at_line(say("line {1}: unknown column '{2}'", std::to_string(lines_.number()), shown(form_.column)),
                   did_you_mean(form_.column, fields, there_is(fields)));
  if (std::find(found + 1, fields.end(), form_.column) != fields.end())
    return at_line(say("line {1}: two columns are called '{2}'", std::to_string(lines_.number()), shown(form_.column)),
                   say("name it by its number, counted from 1"));
  column_ = static_cast<std::size_t>(found - fields.begin());
  by_name_ = true;
  return std::nullopt;
}

std::optional<Fault> CsvReader::find_column(const std::vector<std::string>& fields) {
  const std::string line = std::to_string(lines_.number()), count = std::to_string(fields.size());
  if (form_.column.empty()) {
    if (fields.size() == 1) return std::nullopt;
    return at_line(say("line {1} has {2} columns: say which, by its name or its number from 1", line, count),
                   separator_ == ',' ? say("a decimal sign is a point, not a comma") : Message{});
  }
  std::size_t number = 0;
  const char* const end = form_.column.data() + form_.column.size();
  const auto [behind, error] = std::from_chars(form_.column.data(), end, number);
  if (error != std::errc{} || behind != end) return find_name(fields);
  if (number < 1 || number > fields.size())
    return at_line(say("line {1} has {2} columns, and no column {3}", line, count, form_.column));
  column_ = number - 1;
  return std::nullopt;
}

std::optional<Fault> CsvReader::start() {
  values_.reserve(values_at_once);
  const auto line = content();
  if (!line) return lines_.fault();
  separator_ = form_.separator.value_or(separator_of(*line));
  const auto fields = fields_of(*line, separator_);
  columns_ = fields.size();
  if (auto fault = find_column(fields)) return fault;
  const bool is_header = by_name_ || std::none_of(fields.begin(), fields.end(), [](const std::string& field) {
                           return field.empty() || number_of(field) || field.find_first_of("0123456789") == 0;
                         });
  if (!is_header) lines_.again();
  return std::nullopt;
}

/// The field of the column; without data where the line has not so many.
std::string_view CsvReader::field_of(std::string_view line) const {
  for (std::size_t i = 0; i < column_; ++i) {
    if (line.empty()) return {};
    take_field(line, separator_);
  }
  return line.empty() ? std::string_view{} : take_field(line, separator_);
}

/// Whether a line has more fields than the first: a decimal comma, a unit behind a number. One empty field more ends
/// it.
bool CsvReader::runs_over(std::string_view line) const {
  for (std::size_t i = 0; i < columns_ && !line.empty(); ++i) take_field(line, separator_);
  return !line.empty() && (separator_ == ' ' || !take_field(line, separator_).empty() || !line.empty());
}

Fault CsvReader::too_many(std::string_view line) const {
  const std::string count = std::to_string(fields_of(line, separator_).size());
  return at_line(say("line {1} has {2} columns, and the first one has {3}", std::to_string(lines_.number()), count,
                     std::to_string(columns_)),
                 separator_ == ',' ? say("a decimal sign is a point, not a comma") : Message{});
}

Fault CsvReader::not_a_number(std::string_view line) const {
  const std::string number = std::to_string(lines_.number()), column = std::to_string(column_ + 1);
  const std::string_view field = field_of(line);
  if (field.empty()) return at_line(say("line {1} has no number in column {2}", number, column));
  const bool has_comma = field.find(',') != std::string_view::npos;
  return at_line(say("line {1}: '{2}' in column {3} is not a finite number", number, shown(field), column),
                 has_comma ? say("a decimal sign is a point, not a comma") : Message{});
}

Outcome<std::span<const double>> CsvReader::next() {
  values_.clear();
  while (values_.size() < values_at_once) {
    const auto line = content();
    if (!line) break;
    const auto value = number_of(field_of(*line));
    if (!value) return not_a_number(*line);
    if (runs_over(*line)) return too_many(*line);
    values_.push_back(*value);
  }
  if (values_.empty() && lines_.fault()) return *lines_.fault();
  return std::span<const double>(values_);
}

}  // namespace

Outcome<std::unique_ptr<Reader>> read_csv(std::unique_ptr<Source> source, const Form& form) {
  auto reader = std::make_unique<CsvReader>(std::move(source), form);
  if (auto fault = reader->start()) return *fault;
  return std::unique_ptr<Reader>(std::move(reader));
}

}  // namespace loadpath::rainflow
