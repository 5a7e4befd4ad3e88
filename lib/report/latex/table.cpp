#include "lib/formula/formula.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/latex/tex.hpp"
#include "lib/report/latex/widths.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/latex.hpp"

#include <algorithm>

namespace loadpath::report::tex {
namespace {

constexpr double sign_and_blank = 2.0;

/// A cell as it is read, to measure it.
struct Plain {
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const Message& message) const { return message.text(); }
  std::string operator()(const Quantity& q) const { return formula::quantity_plain(written(q)); }
  std::string operator()(const Symbol& s) const { return formula::symbol_plain(s.name); }
  std::string operator()(State s) const { return account::shown(s).text(); }
  std::string operator()(const Utilisation& u) const { return utilisation_text(u.value); }
  std::string operator()(const Sized& s) const { return s.text + "*" + s.behind(); }
};

/// The longest word between blanks; an underscore is a possible break too.
double longest_word(std::string_view text) {
  double longest = 0.0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" _"), text.size());
    longest = std::max(longest, letters_of(text.substr(0, end)) + 1.0);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return longest;
}

/// Counts the letters of one text after another in a column.
class Letters {
 public:
  void add(std::string_view text) {
    need_.all = std::max(need_.all, letters_of(text));
    need_.least = std::max(need_.least, longest_word(text));
  }
  void add_whole(double letters) {
    need_.all = std::max(need_.all, letters);
    need_.least = std::max(need_.least, letters);
  }
  [[nodiscard]] const Need& need() const { return need_; }

 private:
  Need need_;
};

void add_head(Letters& letters, const Message& head) {
  constexpr double symbol_share = 0.8;  // its subscript is small
  if (!is_symbol(head)) return letters.add(head.text());
  letters.add_whole(symbol_share * letters_of(formula::symbol_plain(head.args[0].text())));
}

/// `units`: units common to all numbers of a column are in the head.
Need need_of(const Table& table, const Column& column, bool units) {
  Letters letters;
  if (column.index < table.head.size()) add_head(letters, table.head[column.index]);
  for (const auto& row : table.rows) {
    if (column.index >= row.size()) continue;
    const Cell& of = row[column.index];
    const std::string text = std::visit(Plain{}, of);
    if (const auto* const q = std::get_if<Quantity>(&of)) {
      letters.add_whole(letters_of(units ? number_of(*q, column) : text));
    } else if (std::holds_alternative<State>(of)) {
      letters.add_whole(letters_of(text) + sign_and_blank);
    } else {
      letters.add(text);
    }
  }
  return letters.need();
}

/// A part of a table that is set at once.
class Grid {
 public:
  Grid(const Table& table, std::vector<Column> columns, bool units)
      : table_(table), columns_(std::move(columns)), units_(units), widths_(widths()) {}

  [[nodiscard]] std::string written(bool with_caption) const {
    const std::string head = heads();
    constexpr std::size_t many = 16;  // columns of short numbers, whose symbols need the room between them
    const std::string close = columns_.size() > many ? "\\setlength{\\tabcolsep}{3pt}" : "";
    std::string out = "{" + widths_.type + close + "\n\\begin{longtable}{@{}" + columns() + "@{}}\n";
    if (with_caption)
      out += "\\lpcaption{" + std::to_string(columns_.size()) + "}{" + latex_text(table_.caption.text()) + "}\n";
    out += "\\toprule\n" + head + "\\endfirsthead\n\\toprule\n" + head + "\\endhead\n\\bottomrule\n\\endfoot\n";
    for (const auto& row : table_.rows) out += line([&](const Column& c) { return cell_in(row, c); });
    return out + "\\end{longtable}}" + (with_caption ? "\n\n" : "\\lpuncounted\n\n");
  }

 private:
  [[nodiscard]] std::string cell_in(const std::vector<Cell>& row, const Column& column) const {
    if (column.index >= row.size()) return {};
    const auto* const q = std::get_if<Quantity>(&row[column.index]);
    return units_ && q != nullptr ? latex_text(number_of(*q, column)) : cell(row[column.index]);
  }
  [[nodiscard]] Widths widths() const {
    std::vector<Need> needs;
    for (const Column& column : columns_) needs.push_back(need_of(table_, column, units_));
    return widths_of(needs);
  }
  [[nodiscard]] std::string columns() const {
    std::string out;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const double share = widths_.shares[i];
      const bool right = columns_[i].numeric;
      out += share > 0.0 ? std::string(right ? "R" : "L") + "{" + format_number(share, 3) + "\\linewidth}"
                         : std::string(right ? "r" : "l");
    }
    return out;
  }
  [[nodiscard]] std::string heads() const {
    if (table_.head.empty()) return {};
    std::string out = line([&](const Column& c) {
      const Message& head = table_.head[c.index];
      return is_symbol(head) ? symbol(head.args[0].text()) : latex_text(head.text());
    });
    const auto has_unit = [](const Column& c) { return !c.unit.empty(); };
    if (units_ && std::any_of(columns_.begin(), columns_.end(), has_unit))
      out += line([](const Column& c) { return latex_text(c.unit); });
    return out + "\\midrule\n";
  }
  template <class Content>
  std::string line(const Content& content) const {
    std::string out;
    for (const Column& column : columns_) out += (&column == &columns_.front() ? "" : " & ") + content(column);
    return out + " \\\\\n";
  }

  const Table& table_;
  std::vector<Column> columns_;
  bool units_;
  Widths widths_;
};

std::size_t breadth(const Table& table) {
  std::size_t columns = table.head.size();
  for (const auto& row : table.rows) columns = std::max(columns, row.size());
  return columns;
}

/// An empty column is filled in by hand.
bool is_form(const Table& table) {
  const auto is_empty = [](const Cell& of) {
    const auto* const text = std::get_if<std::string>(&of);
    return text != nullptr && text->empty();
  };
  return !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
    return row.size() == table.head.size() && row.size() > 1 && is_empty(row.back());
  });
}

/// High rows with a line below each, on one page.
std::string form(const Table& table) {
  constexpr double first = 0.15, all = 0.93;  // shares of a line; the rest is the gaps between the columns
  const double share = (all - first) / static_cast<double>(table.head.size() - 1);
  std::string out = "\\begin{minipage}{\\linewidth}\\small\\renewcommand{\\arraystretch}{2}\n\\begin{tabular}{@{}L{" +
                    format_number(first, 3) + "\\linewidth}*{" + std::to_string(table.head.size() - 1) + "}{L{" +
                    format_number(share, 3) + "\\linewidth}}@{}}\n";
  for (std::size_t i = 0; i < table.head.size(); ++i) out += (i == 0 ? "" : " & ") + latex_text(table.head[i].text());
  out += " \\\\\n\\hline\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out += (i == 0 ? "" : " & ") + cell(row[i]);
    out += " \\\\\n\\hline\n";
  }
  return out + "\\end{tabular}\n\\end{minipage}\n\n";
}

std::vector<Column> all_columns(const std::vector<bool>& numeric) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < numeric.size(); ++i) columns.push_back({i, numeric[i]});
  return columns;
}

}  // namespace

std::string table(const Table& table) {
  std::vector<bool> numeric = numeric_columns(table);
  numeric.resize(breadth(table));
  if (numeric.empty() || table.rows.empty()) return {};
  const bool captioned = !table.caption.empty();
  if (!captioned && is_form(table)) return form(table);
  if (table.head.size() < many_columns) return Grid(table, all_columns(numeric), false).written(captioned);
  std::string out;
  std::vector<Column> columns;
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    columns.push_back(column_of(table, i, numeric[i]));
    columns.back().letters = comfortable(need_of(table, columns.back(), true));
  }
  for (const Part& part : parts_of(columns, letters_of_line - between_columns))
    out += Grid(table, part.columns, true).written(captioned && out.empty());
  return out;
}

}  // namespace loadpath::report::tex
