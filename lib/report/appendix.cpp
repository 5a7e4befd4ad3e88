#include "lib/report/appendix.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/repeated.hpp"
#include "lib/report/why.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace loadpath::report {

namespace {

using account::Account;
using account::Entry;
using project::Project;
using project::Step;
using Lines = std::vector<account::Derived>;

bool is_list_path(const std::string& path) { return path.find_first_of("[.") != std::string::npos; }

Cell symbol_cell(const Entry& entry) { return is_list_path(entry.path) ? Cell(entry.path) : Cell(Symbol{entry.path}); }

/// The origin of a value, with the keys of its sources; a recalled value is marked.
Cell origin_cell(const account::Origin& origin) {
  std::string text = origin.text.text();
  for (const std::string& key : origin.sources) text += " [" + key + "]";
  if (origin.recalled) return say("{1}; not checked against the source", text);
  return text;
}

/// Whether a line of the calculation ends with this result, by a formula and with words that say what it is.
bool is_calculated(const Entry& entry, const Lines& lines) {
  if (!entry.word.empty() || entry.values().is_series() || entry.values().si.empty()) return false;
  return std::ranges::any_of(lines, [&](const account::Derived& line) {
    const bool is_explained = !line.step.formula.empty() && !line.step.why.empty();
    return is_explained && line.scope.empty() && line.step.symbol == entry.path && line.step.value.unit == entry.unit &&
           line.step.value.si == entry.values().si.front();
  });
}

/// The results that the calculation in front of it does not end with: those are printed there.
Table result_table(const Account& account, const Lines& lines) {
  Table table{say("Results"), {say("symbol"), say("meaning"), say("value")}, {}};
  for (const Entry& e : account.results) {
    const bool lists = is_list_path(e.path), judged = e.role != Role::result;
    if (lists || judged || is_open(e)) continue;
    if (is_calculated(e, lines)) {
      table.caption = say("Further results");
    } else {
      table.rows.push_back({Symbol{e.path}, say("{1}", e.doc), cell_of(e)});
    }
  }
  return table;
}

/// "segments[2].tau" or "torques.M1.x" in its parts; nothing if the path is none of an element.
struct ElementPath {
  std::string_view list, element, field;
};
std::optional<ElementPath> element_path(std::string_view path) {
  const std::size_t last = path.rfind('.');
  if (last == std::string_view::npos) return std::nullopt;
  const std::size_t first = path.find_first_of("[.");
  if (last == first) return std::nullopt;
  const bool numbered = path[first] == '[';
  return ElementPath{path.substr(0, first), path.substr(first + 1, last - first - (numbered ? 2 : 1)),
                     path.substr(last + 1)};
}

/// A list and a field of its elements: "segments", "tau".
using Fields = std::set<std::pair<std::string_view, std::string_view>>;
bool contains(const Fields& fields, const ElementPath& path) { return fields.contains({path.list, path.field}); }

/// Fields of a list's elements that have a value in one of them at least. A name is the row's own.
Fields available_fields(const std::vector<const Entry*>& entries) {
  Fields fields;
  for (const Entry* e : entries) {
    const auto path = element_path(e->path);
    if (path && is_available(*e) && path->field != "name") fields.emplace(path->list, path->field);
  }
  return fields;
}

Table input_table(const Account& account) {
  Table table{say("Input data"), {say("symbol"), say("meaning"), say("value"), say("source")}, {}};
  for (const Entry& e : account.inputs) {
    if (element_path(e.path)) continue;
    table.rows.push_back({symbol_cell(e), say("{1}", e.doc), cell_of(e), origin_cell(e.origin)});
  }
  return table;
}

/// Whether a default says that something is absent: no teeth, a choice for parts that there are not.
bool says_nothing(const Entry& entry, const FieldInfo* field) {
  if (!entry.origin.assumed || entry.values().is_series()) return false;
  if (entry.word.empty()) return entry.values().si.empty() || entry.values().si.front() == 0.0;
  return field != nullptr && field->optional;
}

/// The inputs without fields of lists that no element uses, as those of planetary sets in a train of gears.
std::vector<const Entry*> used_inputs(const Step& step) {
  Fields used;
  const auto& fields = step.input().calculator->input->fields;
  for (const Entry& e : step.account().inputs) {
    const auto path = element_path(e.path);
    if (path && !contains(used, *path) && !says_nothing(e, find_field_at(fields, e.path)))
      used.emplace(path->list, path->field);
  }
  std::vector<const Entry*> inputs;
  for (const Entry& e : step.account().inputs) {
    const auto path = element_path(e.path);
    if (!path || contains(used, *path)) inputs.push_back(&e);
  }
  return inputs;
}

template <class Items>
void append(std::vector<Block>& blocks, const Items& items) {
  for (const auto& item : items) blocks.emplace_back(item);
}

/// The verdicts already show the limits.
std::vector<const Entry*> without_limits(const std::vector<Entry>& entries) {
  std::vector<const Entry*> others = pointers_to(entries);
  std::erase_if(others, [](const Entry* e) { return e->role == Role::limit; });
  return others;
}

/// One paragraph, for each is a few words.
void add_remarks(const std::vector<Message>& remarks, std::vector<Block>& blocks) {
  if (remarks.empty()) return;
  Message all = remarks.front();
  for (std::size_t i = 1; i < remarks.size(); ++i) all = say("{1}; {2}", all, remarks[i]);
  blocks.emplace_back(Paragraph{all, Paragraph::Tone::note});
}

std::string title_of(const Step& step) { return step.input().title.empty() ? step.name() : step.input().title; }

/// Title of the part, warnings, notes.
void add_head(const Step& step, std::vector<Block>& blocks) {
  const auto& input = step.input();
  blocks.emplace_back(Heading{2, title_of(step), step.name()});
  blocks.emplace_back(
      Paragraph{say("{1} ({2}). {3}", input.calculator->title, input.calculator->id, input.calculator->scope),
                Paragraph::Tone::note});
  for (const Message& warning : step.account().warnings)
    blocks.emplace_back(Paragraph{warning, Paragraph::Tone::warning});
  if (!input.note.empty()) blocks.emplace_back(Paragraph{say("{1}", input.note)});
}

/// Adds steps one after the other.
class Appendix {
 public:
  Appendix(Detail detail, const ShownFigures& shown) : detail_(detail), shown_(shown) {}

  void add(const Step& step);
  [[nodiscard]] std::vector<Block>& blocks() { return blocks_; }

 private:
  void add_figures(const Account& account);
  void add_inputs(const Step& step);
  void add_calculation(const Step& step, const Lines& lines);
  void add_results(const Step& step, const Lines& lines);

  Detail detail_;
  const ShownFigures& shown_;
  PrintedFormulas printed_;
  std::vector<Block> blocks_;
};

void Appendix::add_figures(const Account& account) {
  for (const figure::Figure& figure : account.figures) {
    if (!shown_.contains(&figure)) blocks_.emplace_back(figure);
  }
}

/// A number or a word; empty for a list, a series, or an input that is not given.
std::string justified_value(const Step& step, const std::string& input) {
  const auto& entries = step.account().inputs;
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.path == input; });
  if (entry == entries.end()) return "";
  if (!entry->word.empty()) return entry->word;
  const bool is_number = entry->values().si.size() == 1 && std::isfinite(entry->values().si.front());
  return is_number ? format_quantity(entry->values().si.front(), entry->unit, 5) : "";
}

/// Reasons for values, also for those that only other steps or [values] contradict.
void add_reasons(const Step& step, std::vector<Block>& blocks) {
  Table table{say("Justified values"), {say("input"), say("reason")}, {}};
  for (const Justified& value : justified_values(step)) table.rows.push_back({value.name(), value.reason});
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
}

void Appendix::add_inputs(const Step& step) {
  const Account& account = step.account();
  if (account.input_blocks.empty()) {
    blocks_.emplace_back(input_table(account));
    append(blocks_, list_tables(used_inputs(step)));
  }
  append(blocks_, account.input_blocks);
  add_reasons(step, blocks_);
  add_remarks(step.remarks(), blocks_);
}

void Appendix::add_calculation(const Step& step, const Lines& lines) {
  const Account& account = step.account();
  if (account.derivation.empty()) return;
  blocks_.emplace_back(Heading{3, "Calculation", step.name() + "-calculation"});
  if (!account.governing.empty()) blocks_.emplace_back(Paragraph{say("Calculated {1}.", account.governing)});
  if (lines.size() < account.derivation.size())
    blocks_.emplace_back(
        Paragraph{say("For lists, the governing element is shown in full; the tables contain the others."),
                  Paragraph::Tone::note});
  append(blocks_, printed_.blocks(step.input().calculator->id, title_of(step), lines));
}

void Appendix::add_results(const Step& step, const Lines& lines) {
  const Account& account = step.account();
  blocks_.emplace_back(Heading{3, "Results", step.name() + "-results"});
  if (account.blocks.empty()) {
    Table results = result_table(account, lines);
    if (!results.rows.empty()) blocks_.emplace_back(std::move(results));
    append(blocks_, list_tables(without_limits(account.results)));
  }
  append(blocks_, account.blocks);
  if (!account.blocks.empty()) add_figures(account);
  if (!account.verdicts.empty())
    blocks_.emplace_back(Verdicts{account.blocks.empty() ? folded(account.verdicts) : account.verdicts});
}

void Appendix::add(const Step& step) {
  add_head(step, blocks_);
  if (step.account().blocks.empty()) add_figures(step.account());
  add_inputs(step);
  const Account& account = step.account();
  const Lines lines = detail_ == Detail::full ? account.derivation : deciding_lines(account);
  add_calculation(step, lines);
  add_results(step, lines);
}

/// Factors that raise a load or lower a strength, each where it is applied: once.
void add_factors(const Project& project, std::vector<Block>& blocks) {
  Table table{say("Load factors (each applied once)"), {say("step"), say("factor"), say("meaning"), say("value")}, {}};
  for (const auto& [step, entry] : applied_factors(project))
    table.rows.push_back({step->name(), Symbol{entry->path}, say("{1}", entry->doc), cell_of(*entry)});
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
}

void add_sources(const Project& project, std::vector<Block>& blocks) {
  std::set<std::string> keys;
  for (const auto& step : project.steps) {
    keys.merge(keys_in(step->input().calculator->source));
    keys.insert(step->account().sources.begin(), step->account().sources.end());
    for (const auto& line : step->account().derivation) keys.merge(keys_in(line.step.why.text()));
    for (const Entry& e : step->account().inputs) keys.insert(e.origin.sources.begin(), e.origin.sources.end());
  }
  Table sources = citations(keys);
  if (sources.rows.empty()) return;
  blocks.emplace_back(Heading{2, "References", "sources"});
  blocks.emplace_back(std::move(sources));
}

}  // namespace

std::set<std::string> keys_in(std::string_view text) {
  std::set<std::string> keys;
  for (std::size_t open = text.find('['); open != std::string_view::npos; open = text.find('[', open + 1)) {
    const std::size_t close = text.find(']', open);
    if (close != std::string_view::npos) keys.emplace(text.substr(open + 1, close - open - 1));
  }
  return keys;
}

std::vector<const Entry*> pointers_to(const std::vector<Entry>& entries) {
  std::vector<const Entry*> pointers;
  pointers.reserve(entries.size());
  for (const Entry& e : entries) pointers.push_back(&e);
  return pointers;
}

std::vector<Table> list_tables(const std::vector<const Entry*>& entries) {
  std::vector<Table> tables;
  const auto available = available_fields(entries);
  std::vector<std::string_view> columns;
  std::string_view list, element;
  for (const Entry* e : entries) {
    const auto path = element_path(e->path);
    if (!path || e->handed_over || !contains(available, *path)) continue;
    if (path->list != list) {
      tables.push_back({say("{1}", path->list), {say("no.")}, {}});
      columns.clear();
    }
    Table& table = tables.back();
    if (path->list != list || path->element != element) table.rows.push_back({std::string(path->element)});
    auto column = std::find(columns.begin(), columns.end(), path->field);
    if (column == columns.end()) {
      table.head.push_back(say("{1}", path->field));
      column = columns.insert(columns.end(), path->field);
    }
    auto& row = table.rows.back();
    const auto place = static_cast<std::size_t>(column - columns.begin()) + 1;
    row.resize(std::max(row.size(), place + 1), std::string());
    row[place] = cell_of(*e);
    list = path->list;
    element = path->element;
  }
  for (Table& table : tables) {
    for (auto& row : table.rows) row.resize(table.head.size(), std::string());
  }
  return tables;
}

std::vector<Justified> justified_values(const project::Step& step) {
  std::vector<Justified> all;
  for (const auto& [input, reason] : step.input().because)
    all.push_back({input, justified_value(step, input), reason.text});
  return all;
}

std::vector<AppliedFactor> applied_factors(const Project& project) {
  std::vector<AppliedFactor> factors;
  for (const auto& step : project.steps) {
    const auto& inputs = step->account().inputs;
    if (std::none_of(inputs.begin(), inputs.end(), [](const Entry& e) { return e.is_factor; })) continue;
    const auto is_assumed = [](const Entry& e) { return e.is_factor && e.origin.assumed; };
    const std::vector<const Entry*> deciding =
        std::ranges::any_of(inputs, is_assumed) ? deciding_inputs(step->account()) : std::vector<const Entry*>();
    for (const Entry& e : inputs) {
      const bool of_another =
          e.origin.assumed && !deciding.empty() && std::ranges::find(deciding, &e) == deciding.end();
      if (e.is_factor && !of_another) factors.push_back({step.get(), &e});
    }
  }
  return factors;
}

bool is_safety(const Entry& entry) {
  const std::string_view symbol = std::string_view(entry.path).substr(entry.path.rfind('.') + 1);
  return entry.role == Role::result && entry.unit == "-" && !symbol.starts_with("u_") &&
         entry.doc.find("safety") != std::string::npos;
}

Cell cell_of(const Entry& entry) {
  constexpr double most_safety = 1000.0;  // above, the value says only that the stress is small
  if (!entry.word.empty()) return entry.origin.sources.empty() ? spoken(entry.word) : entry.word;
  if (!entry.values().is_series()) {
    const double si = entry.values().si.empty() ? NAN : entry.values().si[0];
    if (std::isnan(si) && !entry.missing.empty()) return say("not available: {1}", entry.missing);
    if (std::isfinite(si) && si > most_safety && is_safety(entry)) return safety_number(si);
    return Quantity{si, entry.unit};
  }
  if (is_constant(entry.values())) return Quantity{entry.values().si.front(), entry.unit};
  const double low = minimum(entry.values()).value, high = maximum(entry.values()).value;
  return say("{1} to {2}", format_quantity(low, entry.unit, 5), format_quantity(high, entry.unit, 5));
}

bool is_available(const Entry& e) {
  return !e.word.empty() || (!e.values().si.empty() && !std::isnan(e.values().si[0]));
}

Table citations(const std::set<std::string>& keys) {
  Table sources{say("References"), {}, {}};
  for (const std::string& key : keys) {
    const std::string citation = table::citation(key);
    if (!citation.empty()) sources.rows.push_back({"[" + key + "]", citation});
  }
  return sources;
}

std::vector<Block> appendix_blocks(const Project& project, Detail detail, const ShownFigures& shown) {
  Appendix appendix(detail, shown);
  add_factors(project, appendix.blocks());
  for (const auto& step : project.steps) appendix.add(*step);
  add_sources(project, appendix.blocks());
  return std::move(appendix.blocks());
}

}  // namespace loadpath::report
