#include "lib/formula/formula.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/html/html.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/markup.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace loadpath::report::page {
namespace {

constexpr double close_letters = 112.0, finer_letters = 128.0;  // letters per line: closer spacing, smaller type

/// The classes that say which columns are numbers, so that no cell needs one: one of the first, or all but the first
/// and the named ones. Empty for other tables.
std::string numbers_of(const std::vector<bool>& numeric) {
  constexpr std::array<std::string_view, 6> single{"", "n2", "n3", "n4", "n5", "n6"};
  constexpr std::size_t most = 24;  // of which the style sheet has a class for words
  const auto count = static_cast<std::size_t>(std::count(numeric.begin(), numeric.end(), true));
  if (count == 0 || numeric.front() || numeric.size() > most) return {};
  if (count == 1) {
    const auto at = static_cast<std::size_t>(std::find(numeric.begin(), numeric.end(), true) - numeric.begin());
    return at < single.size() ? std::string(single[at]) : std::string();
  }
  std::string names = "of-numbers";
  for (std::size_t i = 1; i < numeric.size(); ++i) names += numeric[i] ? "" : " w" + std::to_string(i + 1);
  return names;
}

/// ` class="dense of-numbers"`, nothing without a name.
std::string classes(std::initializer_list<std::string_view> names) {
  std::string all;
  for (const std::string_view name : names) {
    if (!name.empty()) all.append(all.empty() ? "" : " ").append(name);
  }
  return all.empty() ? all : " class=\"" + all + "\"";
}

std::string head_cell(const Message& head, bool marked, const std::string& unit) {
  std::string out = std::string("<th") + (marked ? " class=\"number\">" : ">");
  out += is_symbol(head) ? symbol(head.args[0].text()) : escaped(head.text());
  if (!unit.empty()) out += "<br><span class=\"unit\">" + quantity(unit) + "</span>";
  return out + "</th>";
}

/// A cell of a numeric column keeps its line together; its quantities need no element of their own.
void append_number(std::string& out, const Cell& of, const std::string& quantity, bool marked) {
  const std::string_view number = marked ? "number" : "";
  if (std::holds_alternative<Quantity>(of)) {
    (out += "<td").append(classes({number})).append(">").append(page::quantity(quantity)) += "</td>";
    return;
  }
  const std::string words = cell(of);
  out += "<td";
  if (!words.empty()) out += classes({number, "words"});
  ((out += '>') += words) += "</td>";
}

void append_close(std::string& out, const Cell& of, const std::string& quantity, bool is_numeric, bool marked) {
  if (is_numeric) return append_number(out, of, quantity, marked);
  out += "<td>";
  if (std::holds_alternative<Quantity>(of))
    (out += "<span class=\"quantity\">").append(page::quantity(quantity)) += "</span>";
  else
    out += cell(of);
  out += "</td>";
}

void append_wide(std::string& out, const Cell& of, bool numeric, bool marked) {
  const auto* const q = std::get_if<Quantity>(&of);
  if (numeric)
    append_number(out, of, q == nullptr ? std::string() : formula::quantity_plain(written(*q)), marked);
  else
    ((out += "<td>") += cell(of)) += "</td>";
}

std::string close_part(const Table& table, const Part& part) {
  const auto& columns = part.columns;
  std::vector<bool> numeric;
  numeric.reserve(columns.size());
  for (const Column& c : columns) numeric.push_back(c.numeric);
  const std::string numbers = numbers_of(numeric);
  const std::string_view finer = part.letters > close_letters ? "finer" : "";
  const bool marked = numbers.empty();
  std::string out = "<div class=\"scroll\"><table" + classes({"dense", finer, numbers}) + ">\n<thead><tr>";
  for (const Column& c : columns) out += head_cell(table.head[c.index], marked && c.numeric, c.unit);
  out += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    out += "<tr>";
    for (const Column& c : columns) {
      if (c.index < row.size())
        append_close(out, row[c.index], c.numbers[i], c.numeric, marked);
      else
        out += "<td></td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>";
}

/// Quantities with their values; symbols with their meanings, and maybe their sources: in print two columns of these
/// fit on a page.
std::string_view class_of(const Table& table) {
  if (table.head.empty()) return {};
  if (table.head[0].id == "Quantity") return "quantities";
  if (table.head[0].id != "symbol") return {};
  return table.head.size() == 3 ? "of-values" : table.head.size() == 4 ? "of-values with-source" : "";
}

/// Numbers and names that fill less than half of a line: such a table is placed next to the following one.
bool is_narrow(const Table& table, const std::vector<bool>& numeric) {
  constexpr double half = 45.0;  // letters
  const auto breaks = [](const Cell& of) {
    return !std::holds_alternative<Quantity>(of) && !std::holds_alternative<std::string>(of);
  };
  if (table.head.empty()) return false;
  const bool is_broken =
      std::ranges::any_of(table.rows, [&](const auto& row) { return std::ranges::any_of(row, breaks); });
  double letters = is_broken ? half + 1.0 : 0.0;
  for (std::size_t i = 0; i < table.head.size() && letters <= half; ++i)
    letters += between_columns + column_of(table, i, numeric[i]).letters;
  return letters <= half;
}

std::string wide(const Table& table, const std::vector<bool>& numeric) {
  const std::string numbers = numbers_of(numeric);
  const bool marked = numbers.empty();
  std::string out = "<div class=\"scroll\"><table" + classes({class_of(table), numbers}) + ">\n";
  if (!table.head.empty()) {
    out += "<thead><tr>";
    for (std::size_t i = 0; i < table.head.size(); ++i) out += head_cell(table.head[i], marked && numeric[i], {});
    out += "</tr></thead>\n";
  }
  out += "<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) append_wide(out, row[i], numeric[i], marked);
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>";
}

}  // namespace

std::string table(const Table& table, const std::string& caption) {
  const std::vector<bool> numeric = numeric_columns(table);
  const bool narrow = is_narrow(table, numeric);
  std::string out = (narrow ? "<div class=\"table half\">" : "<div class=\"table\">") + caption;
  if (!narrow && table.head.size() < many_columns) {
    out += wide(table, numeric);
  } else {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < table.head.size(); ++i) columns.push_back(column_of(table, i, numeric[i]));
    for (const Part& part : parts_of(columns, finer_letters)) out += close_part(table, part);
  }
  return out + "</div>\n";
}

}  // namespace loadpath::report::page
