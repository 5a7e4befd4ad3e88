#include "lib/report/brief/results.hpp"

#include "lib/report/appendix.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/why.hpp"
#include "lib/report/worked.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace loadpath::report {

namespace {

using account::Entry;
using account::Mode;
using project::Project;
using project::Step;

/// "sections" of "sections.key_end.u_v" and "sections[2].u_v"; empty for a path of the step itself.
std::string list_of(const std::string& path) {
  const std::size_t end = path.find_first_of("[.");
  return end == std::string::npos || path.rfind('.') == std::string::npos ? std::string() : path.substr(0, end);
}

/// Lists whose elements govern, by falling utilisation.
std::vector<std::string> governing_lists(const Step& step, account::Modes modes) {
  std::erase_if(modes,
                [&](const Mode& mode) { return mode.step != step.name() || !is_told(mode) || !mode.utilisation; });
  std::ranges::stable_sort(modes, [](const Mode& a, const Mode& b) { return *a.utilisation > *b.utilisation; });
  std::vector<std::string> lists;
  for (const Mode& mode : modes) {
    std::string list = list_of(mode.governs);
    if (!list.empty() && std::ranges::find(lists, list) == lists.end()) lists.push_back(std::move(list));
  }
  return lists;
}

/// The names from which a symbol of the lines follows directly.
std::set<std::string> given_of(const Reasons& reasons, const std::set<std::string>& symbols) {
  std::set<std::string> names;
  for (const account::Derived& line : reasons.lines) {
    if (!symbols.contains(line.step.symbol)) continue;
    for (const account::Step::Given& given : line.step.given) names.insert(given.name);
  }
  return names;
}

/// The checks of a list, and the fields that they follow from over a few formulas.
std::set<std::string> deciding_fields(const Step& step, const account::Modes& modes, const std::string& list) {
  constexpr int most_formulas = 4;
  std::set<std::string> fields;
  for (const Mode& mode : modes) {
    if (mode.step != step.name() || list_of(mode.governs) != list || !is_told(mode)) continue;
    const Reasons reasons = reasons_of(step.account(), mode.governs);
    std::set<std::string> last{mode.governs.substr(mode.governs.rfind('.') + 1)};
    fields.insert(*last.begin());
    for (int i = 0; i < most_formulas; ++i) {
      last = given_of(reasons, last);
      fields.insert(last.begin(), last.end());
    }
  }
  return fields;
}

bool is_zero(const Cell& cell) {
  const auto* const q = std::get_if<Quantity>(&cell);
  return q != nullptr && q->si == 0.0;
}

bool has_unit(const Quantity& q) { return !q.unit.empty() && q.unit != "-"; }

/// Values far below the largest of their column are zeros, or rounding errors. A safety factor next to an infinite one
/// is not: numbers without a unit stay.
void drop_rounding(Table& table) {
  constexpr double of_largest = 1e-3;
  for (std::size_t i = 1; i < table.head.size(); ++i) {
    double largest = 0.0;
    for (const auto& row : table.rows) {
      const auto* const q = std::get_if<Quantity>(&row[i]);
      if (q != nullptr && has_unit(*q) && std::isfinite(q->si)) largest = std::max(largest, std::abs(q->si));
    }
    for (auto& row : table.rows) {
      auto* const q = std::get_if<Quantity>(&row[i]);
      if (q != nullptr && has_unit(*q) && std::abs(q->si) < of_largest * largest) q->si = 0.0;
    }
  }
}

/// The columns of these fields that hold more than zeros.
Table with_columns(const Table& table, const std::set<std::string>& fields) {
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < table.head.size(); ++i) {
    const bool is_empty = std::ranges::all_of(table.rows, [&](const auto& row) { return is_zero(row[i]); });
    if (fields.contains(table.head[i].text()) && !is_empty) kept.push_back(i);
  }
  Table part{table.caption, {}, {}};
  for (const std::size_t i : kept) part.head.push_back(table.head[i]);
  for (const auto& row : table.rows) {
    part.rows.emplace_back();
    for (const std::size_t i : kept) part.rows.back().push_back(row[i]);
  }
  return part;
}

std::vector<std::string> row_names(const Table& table) {
  std::vector<std::string> names;
  for (const auto& row : table.rows) names.push_back(std::get<std::string>(row.front()));
  return names;
}

/// Adds the columns of a table with the same rows.
void join(const Table& other, Table& table) {
  for (std::size_t i = 1; i < other.head.size(); ++i) {
    const std::string name = other.head[i].text();
    if (std::ranges::any_of(table.head, [&](const Message& head) { return head.text() == name; })) continue;
    table.head.push_back(other.head[i]);
    for (std::size_t k = 0; k < table.rows.size(); ++k) table.rows[k].push_back(other.rows[k][i]);
  }
}

constexpr double line = 126.0;  // letters

double width_of_row(const Table& table) {
  double sum = -between_columns;
  for (std::size_t i = 0; i < table.head.size(); ++i) sum += between_columns + column_of(table, i, i > 0).letters;
  return sum;
}

/// One table of two with the same rows, if its columns fit into a line.
bool join_in_line(Table& first, const Table& second) {
  Table joined = first;
  join(second, joined);
  if (width_of_row(joined) > line) return false;
  first = std::move(joined);
  return true;
}

/// Rows that are only numbered, where others have names: the ends of a shaft.
void drop_unnamed(Table& table) {
  const auto is_numbered = [](const auto& row) {
    const std::string& name = std::get<std::string>(row.front());
    return name.find_first_not_of("0123456789") == std::string::npos;
  };
  if (std::ranges::all_of(table.rows, is_numbered)) return;
  std::erase_if(table.rows, is_numbered);
}

const std::set<std::string> of_sections{"x", "d", "M", "T", "V", "N"};

/// The fields that govern, and where sections lie and what they carry.
std::set<std::string> indispensable_fields(const Step& step, const account::Modes& modes) {
  std::set<std::string> fields = of_sections;
  for (const Mode& mode : modes) {
    if (mode.step == step.name() && is_told(mode)) fields.insert(mode.governs.substr(mode.governs.rfind('.') + 1));
  }
  return fields;
}

/// Leaves out the last of the other columns until the rows fit into a line: the rest would be a table of its own.
void fit_into_line(Table& table, const std::set<std::string>& kept) {
  for (std::size_t i = table.head.size(); i-- > 1 && width_of_row(table) > line;) {
    if (kept.contains(table.head[i].text())) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    table.head.erase(table.head.begin() + at);
    for (auto& row : table.rows) row.erase(row.begin() + at);
  }
}

/// What becomes of lists of the same elements that do not fit into a line together.
enum class SameElements { apart, in_a_line };

/// Tables of the same rows are one table, or follow each other. Sections come first: where they lie comes before what
/// follows from it.
void add_to(std::vector<Table>& all, Table part, SameElements joining) {
  auto same = std::ranges::find_if(all, [&](const Table& t) { return row_names(t) == row_names(part); });
  if (same == all.end()) return all.push_back(std::move(part));
  if (part.caption.text() == "sections") std::swap(*same, part);
  if (joining == SameElements::in_a_line)
    join(part, *same);
  else if (!join_in_line(*same, part))
    all.insert(same + 1, std::move(part));
}

/// The tables of the lists that govern, by falling utilisation.
std::vector<Table> governing_tables(const Step& step, const account::Modes& modes) {
  std::vector<Table> tables = list_tables(pointers_to(step.account().results));
  for (Table& table : tables) drop_rounding(table);
  std::vector<Table> all;
  for (const std::string& list : governing_lists(step, modes)) {
    const auto table = std::ranges::find_if(tables, [&](const Table& t) { return t.caption.text() == list; });
    if (table == tables.end()) continue;
    std::set<std::string> fields = deciding_fields(step, modes, list);
    if (list == "sections") fields.insert(of_sections.begin(), of_sections.end());
    Table part = with_columns(*table, fields);
    drop_unnamed(part);
    all.push_back(std::move(part));
  }
  return all;
}

std::vector<Table> joined(const std::vector<Table>& lists, SameElements same) {
  constexpr std::size_t least_columns = 5;
  std::vector<Table> all;
  for (const Table& list : lists) add_to(all, list, same);
  std::erase_if(all, [](const Table& table) { return table.head.size() < least_columns; });
  return all;
}

bool is_leading(const Entry& entry) {
  return entry.brief && entry.role == Role::result && !entry.handed_over && is_available(entry) &&
         list_of(entry.path).empty();
}

/// A table with a column for each of the steps.
Table results_of(const std::vector<const Step*>& steps, std::size_t most) {
  Table table{{}, {say("Quantity"), say("Symbol")}, {}};
  for (const Step* step : steps) table.head.push_back(say("{1}", component_name(*step)));
  for (const Entry& entry : steps.front()->account().results) {
    if (!is_leading(entry) || table.rows.size() == most) continue;
    const std::string_view symbol = named_symbol(entry.path).symbol;
    std::vector<Cell> row{capitalised(short_name(entry)),
                          is_word(symbol) ? Cell(std::string()) : Cell(Symbol{std::string(symbol)})};
    for (const Step* step : steps) {
      const auto& results = step->account().results;
      const auto same = std::ranges::find(results, entry.path, &Entry::path);
      row.emplace_back(same == results.end() ? std::string() : short_value(*same));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Steps of one calculator together, in the order of the file.
std::vector<std::vector<const Step*>> grouped(const Project& project, const Step* main) {
  std::vector<std::vector<const Step*>> groups;
  for (const auto& step : project.steps) {
    if (step.get() == main || !step->account().blocks.empty()) continue;
    const auto same = std::ranges::find_if(
        groups, [&](const auto& group) { return group.front()->input().calculator == step->input().calculator; });
    constexpr std::size_t most_columns = 3;
    if (same != groups.end() && same->size() < most_columns)
      same->push_back(step.get());
    else
      groups.push_back({step.get()});
  }
  return groups;
}

/// The elements of a list; a series as its value of the largest magnitude.
std::vector<Entry> peaks_of(const std::vector<Entry>& entries, std::string_view list) {
  std::vector<Entry> peaks;
  for (const Entry& entry : entries) {
    if (!entry.path.starts_with(list)) continue;
    peaks.push_back(entry);
    if (!entry.values().is_series()) continue;
    const double peak = largest(entry.values()).value;
    peaks.back().series = nullptr;
    peaks.back().value.si = {peak};
    peaks.back().value.signature.axis = nullptr;
  }
  return peaks;
}

std::string step_names(const std::vector<const Step*>& steps) {
  std::string all;
  for (const Step* step : steps) all += (all.empty() ? "" : ", ") + component_name(*step);
  return capitalised(all);
}

/// "fatigue safety factors of the same sections".
std::string doc_of(const Step& step, const Table& list) {
  const FieldInfo* const field = find_field(step.input().calculator->result->fields, list.caption.text());
  return field == nullptr ? spoken(list.caption.text()) : field->doc;
}

bool is_utilisation(const Message& head) { return is_symbol(head) && head.args[0].text().starts_with("u_"); }

/// Utilisations with four decimals: "4.6e-05" of an unloaded end says no more than 0.
void round_utilisations(Table& table) {
  constexpr double decimals = 1e4;
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    if (!is_utilisation(table.head[i])) continue;
    for (auto& row : table.rows) {
      if (auto* const q = std::get_if<Quantity>(&row[i])) q->si = std::round(decimals * q->si) / decimals;
    }
  }
}

}  // namespace

namespace {

std::vector<Panel> panels_of(const Step& step, const account::Modes& modes, std::vector<Table> lists) {
  std::vector<Panel> panels;
  std::vector<std::string> rows;
  const std::set<std::string> kept = indispensable_fields(step, modes);
  for (Table& table : lists) {
    const bool is_further = std::exchange(rows, row_names(table)) == row_names(table);
    Message title = say("{1}", capitalised(is_further ? doc_of(step, table) : spoken(table.caption.text())));
    table.caption = {};
    table.head.front() = say("Name");
    for (auto& row : table.rows) row.front() = spoken(std::get<std::string>(row.front()));
    fit_into_line(table, kept);
    round_utilisations(table);
    panels.push_back({std::move(title), say("{1}", component_name(step)), {std::move(table)}});
  }
  return panels;
}

}  // namespace

ListPanels list_panels(const project::Step& step, const account::Modes& modes) {
  const std::vector<Table> lists = governing_tables(step, modes);
  return {panels_of(step, modes, joined(lists, SameElements::apart)),
          panels_of(step, modes, joined(lists, SameElements::in_a_line))};
}

Table most_utilised_rows(const Table& table, std::size_t most) {
  if (table.rows.size() <= most) return table;
  const auto utilisation = [&](const std::vector<Cell>& row) {
    double highest = -1.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto* const q = std::get_if<Quantity>(&row[i]);
      if (q != nullptr && is_utilisation(table.head[i])) highest = std::max(highest, q->si);
    }
    return highest;
  };
  std::vector<double> sorted;
  for (const auto& row : table.rows) sorted.push_back(utilisation(row));
  const std::size_t kept = most - 1;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(kept - 1), std::ranges::greater());
  const double least = sorted[kept - 1];
  Table part{table.caption, table.head, {}};
  for (const auto& row : table.rows) {
    if (part.rows.size() < kept && utilisation(row) >= least) part.rows.push_back(row);
  }
  part.rows.emplace_back(table.head.size(), Cell(std::string()));
  part.rows.back().front() = say("{1} more: appendix", std::to_string(table.rows.size() - kept)).text();
  return part;
}

std::vector<Panel> load_panels(const project::Step& step) {
  static const std::set<std::string> fields{"x",   "T",   "F_x", "F_y", "F_z",  "angle", "x_w",
                                            "R_x", "R_y", "F_r", "F_a", "F_r0", "F_a0",  "mass"};
  std::vector<Panel> panels;
  // The figure shows one position of a cycle, the tables the largest of all.
  const auto part_over = [&](const std::vector<Entry>& entries, std::string_view list) {
    const bool varies =
        std::ranges::any_of(entries, [&](const Entry& e) { return list_of(e.path) == list && e.value.is_series(); });
    return varies ? say("{1}, the largest of the cycle", component_name(step)) : say("{1}", component_name(step));
  };
  const auto add = [&](const std::vector<Entry>& entries, std::string_view list, Message title) {
    const std::vector<Entry> peaks = peaks_of(entries, list);
    for (const Table& all : list_tables(pointers_to(peaks))) {
      if (all.caption.text() != list) continue;
      Table table = with_columns(all, fields);
      table.caption = {};
      table.head.front() = say("Name");
      for (auto& row : table.rows) row.front() = spoken(std::get<std::string>(row.front()));
      if (table.head.size() > 2) panels.push_back({std::move(title), part_over(entries, list), {std::move(table)}});
      return;
    }
  };
  add(step.account().inputs, "seats", say("Loads of mounted components, as given"));
  add(step.account().results, "bearings", say("Bearing reactions"));
  return panels;
}

std::vector<Panel> result_panels(const Project& project, const Summary& summary, const project::Step* main,
                                 std::size_t most) {
  constexpr std::size_t most_of_one = 7, heading = 3;
  std::vector<Panel> panels;
  std::vector<std::vector<const project::Step*>> groups = grouped(project, main);
  const auto used = [&](const std::vector<const project::Step*>& group) {
    double most_used = -1.0;
    for (const Component& component : summary.components) {
      const bool is_of =
          std::ranges::any_of(group, [&](const project::Step* s) { return component_name(*s) == component.name; });
      if (is_of && component.utilisation() > most_used) most_used = component.utilisation();
    }
    return most_used;
  };
  std::ranges::stable_sort(groups, [&](const auto& a, const auto& b) { return used(a) > used(b); });
  std::size_t rows = 0;
  for (const auto& group : groups) {
    Table table = results_of(group, most_of_one);
    if (table.rows.empty() || rows + table.rows.size() + heading > most) continue;
    rows += table.rows.size() + heading;
    panels.push_back(
        {say("{1}", step_names(group)), say("{1}", group.front()->input().calculator->title), {std::move(table)}});
  }
  return panels;
}

}  // namespace loadpath::report
