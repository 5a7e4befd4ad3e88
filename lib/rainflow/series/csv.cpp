#include "lib/rainflow/series/csv.hpp"

#include "lib/rainflow/series/cells.hpp"
#include "lib/rainflow/series/lines.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::rainflow {

namespace {

constexpr std::size_t values_at_once = 4096;
/// A text for a message: short, and without what a terminal would obey.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string out(text.substr(0, longest));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
  return text.size() > longest ? out + "..." : out;
}

/// The next line that is neither empty nor a comment.
std::optional<std::string_view> content_of(Lines& lines, char comment) {
  while (auto line = lines.next()) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (lines.number() == 1 && line->starts_with(mark)) line->remove_prefix(mark.size());
    std::size_t first = 0;
    while (first < line->size() && is_blank((*line)[first])) ++first;
    if (first < line->size() && (*line)[first] != comment) return line;
  }
  return std::nullopt;
}

/// The number that a column or a row is asked for by; none of a name.
std::optional<std::size_t> place_in_text(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && behind == end ? std::optional(number) : std::nullopt;
}

/// Whether a heading is called so, with its unit or without.
bool is_called(std::string_view heading, const std::string& name) {
  return heading == name || heading_of(heading).name == name;
}

class CsvReader final : public Reader {
 public:
  CsvReader(std::unique_ptr<Source> source, Form form) : lines_(std::move(source)), form_(std::move(form)) {}

  /// Finds the column.
  std::optional<Fault> start();
  Outcome<std::span<const double>> next() override;
  [[nodiscard]] std::string_view heading() const override { return heading_; }

 private:
  std::optional<std::string_view> content() { return content_of(lines_, form_.comment); }
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
  std::string heading_;
  std::vector<double> values_;
};

std::optional<Fault> CsvReader::find_name(const std::vector<std::string>& fields) {
  const auto is_it = [&](const std::string& field) { return is_called(field, form_.column); };
  auto found = std::find(fields.begin(), fields.end(), form_.column);
  const bool is_whole = found != fields.end();
  if (!is_whole) found = std::find_if(fields.begin(), fields.end(), is_it);
  if (found == fields.end())
    return at_line(say("line {1}: unknown column '{2}'", std::to_string(lines_.number()), shown(form_.column)),
                   did_you_mean(form_.column, fields, there_is(fields)));
  const auto again =
      is_whole ? std::find(found + 1, fields.end(), form_.column) : std::find_if(found + 1, fields.end(), is_it);
  if (again != fields.end())
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
    return at_line(say("line {1} has {2} columns: state which, by its name or its number from 1", line, count),
                   separator_ == ',' ? say("separate the columns with ';' if a comma is the decimal mark") : Message{});
  }
  const auto number = place_in_text(form_.column);
  if (!number) return find_name(fields);
  if (*number < 1 || *number > fields.size())
    return at_line(say("line {1} has {2} columns, and no column {3}", line, count, form_.column));
  column_ = *number - 1;
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
  const bool is_header =
      by_name_ || std::none_of(fields.begin(), fields.end(), [&](const std::string& field) {
        return field.empty() || number_of(field, separator_) || field.find_first_of("0123456789") == 0;
      });
  if (is_header)
    heading_ = fields[column_];
  else
    lines_.again();
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
  return at_line(say("line {1} has {2} columns, but the first line has {3}", std::to_string(lines_.number()), count,
                     std::to_string(columns_)),
                 separator_ == ',' ? say("separate the columns with ';' if a comma is the decimal mark") : Message{});
}

Fault CsvReader::not_a_number(std::string_view line) const {
  const std::string number = std::to_string(lines_.number()), column = std::to_string(column_ + 1);
  const std::string_view field = field_of(line);
  if (field.empty()) return at_line(say("line {1} has no number in column {2}", number, column));
  const bool has_comma = field.find(',') != std::string_view::npos;
  return at_line(say("line {1}: '{2}' in column {3} is not a finite number", number, shown(field), column),
                 has_comma ? say("the decimal mark is a point, not a comma") : Message{});
}

Outcome<std::span<const double>> CsvReader::next() {
  values_.clear();
  while (values_.size() < values_at_once) {
    const auto line = content();
    if (!line) break;
    const auto value = number_of(field_of(*line), separator_);
    if (!value) return not_a_number(*line);
    if (runs_over(*line)) return too_many(*line);
    values_.push_back(*value);
  }
  if (values_.empty() && lines_.fault()) return *lines_.fault();
  return std::span<const double>(values_);
}

/// A series along a line.
class RowReader final : public Reader {
 public:
  RowReader(std::unique_ptr<Source> source, Form form) : lines_(std::move(source)), form_(std::move(form)) {}

  /// Finds the line, and reads it.
  std::optional<Fault> start();
  Outcome<std::span<const double>> next() override {
    const std::span<const double> all = is_told_ ? std::span<const double>() : std::span<const double>(values_);
    is_told_ = true;
    return all;
  }
  [[nodiscard]] std::string_view heading() const override { return heading_; }

 private:
  std::optional<Fault> take(std::string_view line);

  Lines lines_;
  Form form_;
  std::string heading_;
  std::vector<double> values_;
  bool is_told_ = false;
};

std::optional<Fault> RowReader::take(std::string_view line) {
  const char separator = form_.separator.value_or(separator_of(line));
  const auto fields = fields_of(line, separator);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const auto value = number_of(fields[k], separator);
    if (value) {
      values_.push_back(*value);
    } else if (k == 0) {
      heading_ = fields[k];
    } else if (!fields[k].empty() || k + 1 < fields.size()) {
      return Fault{lines_.number(),
                   1,
                   say("line {1}: '{2}' in column {3} is not a finite number", std::to_string(lines_.number()),
                       shown(fields[k]), std::to_string(k + 1)),
                   {}};
    }
  }
  return std::nullopt;
}

std::optional<Fault> RowReader::start() {
  const auto number = place_in_text(form_.row);
  std::size_t count = 0;
  std::vector<std::string> names;
  while (const auto line = content_of(lines_, form_.comment)) {
    ++count;
    std::string_view rest = *line;
    std::string first(take_field(rest, form_.separator.value_or(separator_of(*line))));
    if (number ? count == *number : is_called(first, form_.row)) return take(*line);
    names.push_back(std::move(first));
  }
  if (lines_.fault()) return lines_.fault();
  if (number) return Fault{count, 1, say("there are {1} lines, and no line {2}", std::to_string(count), form_.row), {}};
  return Fault{1, 1, say("no line begins with '{1}'", shown(form_.row)), did_you_mean(form_.row, names)};
}

template <class Kind>
Outcome<std::unique_ptr<Reader>> started(std::unique_ptr<Source> source, const Form& form) {
  auto reader = std::make_unique<Kind>(std::move(source), form);
  if (auto fault = reader->start()) return *fault;
  return std::unique_ptr<Reader>(std::move(reader));
}

}  // namespace

Outcome<std::unique_ptr<Reader>> read_csv(std::unique_ptr<Source> source, const Form& form) {
  return form.row.empty() ? started<CsvReader>(std::move(source), form) : started<RowReader>(std::move(source), form);
}

}  // namespace loadpath::rainflow
