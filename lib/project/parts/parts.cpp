#include "lib/project/parts/parts.hpp"

#include "lib/project/accept.hpp"
#include "lib/project/because.hpp"
#include "lib/project/parts/examples.hpp"
#include "lib/project/parts/other_calculator.hpp"
#include "lib/project/parts/template_names.hpp"
#include "lib/project/read/errors.hpp"
#include "lib/project/read/read_record.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <array>

namespace loadpath::project {

namespace {

using toml::Tree;

constexpr std::array reserved{"project", "values", "tables", "expect"};
const std::vector<std::string> step_keys{"calculator", "template", "title",   "note",
                                         "display",    "accept",   "because", "body"};

/// "calculater" of a step; null if no key resembles `calculator`.
const Tree::Entry* misspelt_calculator(const Tree& step) {
  const auto found = std::find_if(step.entries.begin(), step.entries.end(), [](const Tree::Entry& entry) {
    return entry.value.type == Tree::Type::text && !nearest(entry.key, {"calculator"}).empty();
  });
  return found == step.entries.end() ? nullptr : &*found;
}

const CatalogueEntry* entry_of_step(const Tree::Entry& entry, Catalogue catalogue, std::vector<Issue>& issues) {
  const auto* id = entry.value.find("calculator");
  if (id == nullptr) {
    if (const Tree::Entry* const meant = misspelt_calculator(entry.value)) {
      add_error(issues, meant->place, entry.key + "." + meant->key, say("'{1}' is not a valid key here", meant->key),
                say("did you mean 'calculator'?"));
      return nullptr;
    }
    add_error(issues, entry.place, entry.key, say("the step '{1}' has no calculator", entry.key),
              did_you_mean(entry.key, {reserved.begin(), reserved.end()},
                           say("write calculator = \"{1}\"; `loadpath list` shows all",
                               calculator_with(entry.value, catalogue))));
    return nullptr;
  }
  const std::string text = text_of(*id, entry.key + ".calculator", issues);
  const CatalogueEntry* found = find_entry(catalogue, text);
  if (found == nullptr && !text.empty()) {
    std::vector<std::string> ids;
    for (const CatalogueEntry& known : catalogue) ids.emplace_back(known.calculator->id);
    Message as_template = template_meant(text, catalogue);
    add_error(issues, id->value.place, entry.key + ".calculator", say("unknown calculator '{1}'", text),
              as_template.empty() ? calculator_meant(text, ids) : std::move(as_template));
  }
  return found;
}

/// The template that a step names, if any; false if there is no such.
bool read_template(const Tree& table, StepInput& input, std::vector<Issue>& issues) {
  const auto* named = table.find("template");
  if (named == nullptr) return true;
  const std::string key = input.name + ".template";
  if (input.calculator->templates.empty()) {
    add_error(issues, named->place, key, say("'{1}' has no templates", input.calculator->id));
    return false;
  }
  const std::size_t before = issues.size();
  const std::string id = text_of(*named, key, issues);
  input.from = find_template(*input.calculator, id);
  if (input.from != nullptr || issues.size() != before) return input.from != nullptr;
  std::vector<std::string> ids;
  for (const Template* t : input.calculator->templates) ids.emplace_back(t->id);
  add_error(issues, place_in(named->value.place, id, 0, id.size()), key, say("unknown template '{1}'", id),
            template_near(id, ids));
  return false;
}

/// The rows that a step takes one after another: material = ["C45E", "42CrMo4"], section = { each = "ipe" }.
void read_rows_in_turn(const Tree::Entry& row, StepInput& input, std::vector<Issue>& issues) {
  const std::string key = input.name + "." + row.key;
  input.rows[row.key] = {"", row.value.place};  // given, valid or not
  Varied varied{.path = row.key, .leaf = {}, .place = row.value.place, .shared = row.value.shared};
  for (const Tree& item : row.value.items) {
    const auto found = item.type == Tree::Type::text ? input.tables->find_row(row.key, item.text)
                                                     : Outcome<table::Entry>(Fault{0, 1, say("a row is a text"), {}});
    if (!found)
      return add_error(issues, place_in(item.place, item.text, found.fault().at, found.fault().length), key,
                       found.fault().message, found.fault().hint);
    varied.words.push_back(item.text);
  }
  if (const auto* each = row.value.find("each")) {
    for (const table::Entry& found : input.tables->ordered_rows(row.key, each->value.text))
      varied.words.push_back(found.row->name);
    if (varied.words.empty())
      return add_error(issues, each->value.place, key,
                       say("unknown table or kind of {1} '{2}'", row.key, each->value.text),
                       did_you_mean(each->value.text, input.tables->names_of(row.key)));
  }
  if (varied.words.empty()) return add_error(issues, row.value.place, key, say("a list of rows needs at least one"));
  input.reading.varied.push_back(std::move(varied));
}

/// The sizes of a stock that an input goes through, between its ends.
void fill_stocks(StepInput& input, std::vector<Issue>& issues) {
  for (Varied& varied : input.reading.varied) {
    if (varied.stock.empty()) continue;
    const std::string key = input.name + "." + varied.path;
    const auto series = input.tables->find_series(varied.stock);
    if (!series) {
      add_error(issues, varied.place, key, say("unknown stock '{1}'", varied.stock),
                did_you_mean(varied.stock, input.tables->series_names()));
      continue;
    }
    std::vector<double> sizes = table::members_in_si(**series);
    std::erase_if(sizes, [&](double si) {
      return !(varied.from <= si && si <= varied.to) || !varied.leaf.field->bounds.holds(si);
    });
    if (sizes.empty()) {
      add_error(issues, varied.place, key, say("the stock '{1}' has no size between these ends", varied.stock));
      continue;
    }
    varied.leaf.set(sizes.front());
    varied.axis = *sweep::Axis::list(std::move(sizes));
  }
}

/// The first row that passes, of one table or kind, and of those whose values hold a condition:
/// bearing = { stock = "bearing/62", where = "d = 40 mm" }.
void read_row_search(const Tree::Entry& row, StepInput& input, std::vector<Issue>& issues) {
  const std::string key = input.name + "." + row.key;
  Search search{.path = row.key, .leaf = {}, .stock = {}, .place = row.value.place};
  for (const Tree::Entry& entry : row.value.entries) {
    if (entry.key == "stock") {
      search.stock = text_of(entry, key, issues);
      search.place = entry.value.place;
    } else if (entry.key == "where") {
      search.where = text_of(entry, key, issues);
    } else {
      add_error(issues, entry.place, key, say("'{1}' is not a valid key here", entry.key),
                say("give only `stock`, the table or kind, and `where`, a condition on its columns"));
    }
  }
  input.rows[row.key] = {"", search.place};
  input.reading.searches.push_back(std::move(search));
}

/// The row of one table: by its name, of another step, or the first that passes.
void read_row(const Tree::Entry& row, StepInput& input, std::vector<Issue>& issues) {
  const std::string key = input.name + "." + row.key;
  if (row.value.type == Tree::Type::array || row.value.find("each") != nullptr)
    return read_rows_in_turn(row, input, issues);
  if (row.value.find("stock") != nullptr || row.value.find("where") != nullptr)
    return read_row_search(row, input, issues);
  const std::string text = text_of(row, key, issues);
  Place start = row.value.place;
  input.rows[row.key] = {"", start};  // known only when the project is solved
  if (text == "?") {
    input.reading.searches.push_back({row.key, {}, "", start});
  } else if (text.starts_with('=')) {
    ++start.column;
    const auto source = lone_reference(row.value);
    if (!source)
      return add_error(issues, place_in(start, text, 0, text.size() - 1), key,
                       say("'{1}' takes the name of a row", row.key),
                       say("refer to one that another step has: {1} = \"=step.{1}\"", row.key));
    input.reading.taken.push_back({row.key, nullptr, *source, start});
  } else {
    input.rows[row.key].text = text;
  }
}

/// "give R_e_1 (yield strength of the shaft), ...": the strengths that are inputs of their own; empty if there are
/// none.
Message strengths_of(const Calculator& calculator) {
  std::string names;
  for (const FieldInfo& field : calculator.input->fields) {
    const bool is_strength = std::string_view(field.key).starts_with("R_") && std::string_view(field.unit) == "MPa";
    if (is_strength) names += (names.empty() ? "" : ", ") + std::string(field.key) + " (" + field.doc + ")";
  }
  return names.empty() ? Message{} : say("give {1}", names);
}

/// Rows that a step names for the tables its providers read: material = "C45E". A material is known to every step.
void read_rows(const Tree& table, StepInput& input, std::vector<Issue>& issues) {
  for (const std::string& group : table_groups(*input.calculator)) {
    if (const auto* row = table.find(group)) read_row(*row, input, issues);
  }
  const auto* material = table.find("material");
  if (material == nullptr || input.rows.count("material") != 0) return;
  add_error(issues, material->place, input.name + ".material",
            say("'{1}' takes nothing from a material", input.calculator->id), strengths_of(*input.calculator));
}

/// The keys of a step that are not fields of its calculator.
std::vector<std::string> general_keys_of(const Calculator& calculator) {
  std::vector<std::string> keys = step_keys;
  keys.emplace_back("material");
  for (const std::string& group : table_groups(calculator)) {
    if (group != "material") keys.push_back(group);
  }
  return keys;
}

void read_display(const Tree& table, StepInput& input, std::vector<Issue>& issues) {
  const auto* display = table.find("display");
  if (display == nullptr) return;
  if (display->value.type != Tree::Type::table) {
    return add_error(issues, display->value.place, input.name + ".display",
                     say("'{1}' is a table of units, not {2}", "display", toml::word_for(display->value.type)),
                     say("name the results: display = { d = \"in\" }"));
  }
  if (input.calculator->result == nullptr) {
    return add_error(issues, display->place, input.name + ".display",
                     say("'{1}' shows its results in readable units of its own", input.calculator->id),
                     say("leave out 'display'; the JSON output is in SI units"));
  }
  for (const Tree::Entry& entry : display->value.entries) {
    const std::string key = input.name + ".display." + entry.key;
    const std::size_t before = issues.size();
    const std::string unit = text_of(entry, key, issues);
    if (issues.size() != before) continue;
    const auto fields = input.calculator->result->fields;
    const FieldInfo* field = find_field(fields, entry.key);
    if (field == nullptr || field->type != FieldInfo::Type::quantity) {
      std::vector<std::string> results;
      for (const FieldInfo& f : fields) results.emplace_back(f.key);
      add_error(issues, entry.place, key, say("'{1}' has no result '{2}'", input.name, entry.key),
                did_you_mean(entry.key, results, there_is(results)));
      continue;
    }
    const auto parsed = parse_unit(unit);
    if (!parsed) {
      add_error(issues, place_in(entry.value.place, unit, parsed.fault().at, parsed.fault().length), key,
                parsed.fault().message, parsed.fault().hint);
    } else if (parsed->dimension != field->dimension) {
      add_error(issues, entry.value.place, key,
                say("'{1}' is shown in a unit like {2}, not in {3}", entry.key, field->unit, unit));
    } else {
      input.display[entry.key] = unit;
    }
  }
}

bool name_is_free(const Tree::Entry& entry, std::vector<Issue>& issues) {
  if (!is_name(entry.key)) {
    add_error(issues, entry.place, entry.key, say("'{1}' is not a valid name of a step", entry.key),
              say("a name has Latin letters, digits and '_', and does not start with a digit"));
  } else if (is_reserved(entry.key)) {
    add_error(issues, entry.place, entry.key, say("'{1}' is a reserved name and cannot name a step", entry.key),
              say("call it '{1}_1', or by the part that it describes", entry.key));
  } else if (entry.value.type == Tree::Type::array && !entry.value.items.empty() &&
             entry.value.items.front().type == Tree::Type::table) {
    add_error(issues, entry.place, entry.key, say("'{1}' is a list of tables, and a step is one", entry.key),
              say("write one pair of brackets: [{1}]", entry.key));
  } else if (entry.value.type != Tree::Type::table) {
    add_error(issues, entry.place, entry.key, say("'{1}' is outside a step", entry.key),
              say("a project file consists of tables: [crankshaft]"));
  } else {
    return true;
  }
  return false;
}

}  // namespace

std::span<const char* const> reserved_names() { return reserved; }

bool is_reserved(std::string_view name) { return std::find(reserved.begin(), reserved.end(), name) != reserved.end(); }

/// A key that is not an input may be a result, as the centre distance of gears: it is computed, and cannot be given.
void name_results(const StepInput& input, std::size_t before, std::vector<Issue>& issues) {
  if (input.calculator->result == nullptr) return;
  const std::string prefix = input.name + ".";
  for (auto issue = issues.begin() + static_cast<std::ptrdiff_t>(before); issue != issues.end(); ++issue) {
    if (issue->key_fault != KeyFault::unknown || !issue->key.starts_with(prefix)) continue;
    const std::string key = issue->key.substr(prefix.size());
    const FieldInfo* const result = find_field(input.calculator->result->fields, key);
    if (result == nullptr) continue;
    issue->message = say("'{1}' is a result of {2}, not an input: {3}", key, input.calculator->id, result->doc);
    if (issue->hint.id.starts_with("available")) issue->hint = say("leave it out, and choose the inputs that give it");
  }
}

std::unique_ptr<Step> read_step(const Tree::Entry& entry, const Project& project, Catalogue catalogue,
                                std::vector<Issue>& issues) {
  if (!name_is_free(entry, issues)) return nullptr;
  StepInput input;
  input.name = entry.key;
  input.place = entry.place;
  input.tables = project.tables;
  const CatalogueEntry* const known = entry_of_step(entry, catalogue, issues);
  if (known == nullptr) return nullptr;
  input.calculator = known->calculator;
  if (!read_template(entry.value, input, issues)) return nullptr;
  if (const auto* title = entry.value.find("title")) input.title = text_of(*title, entry.key + ".title", issues);
  if (const auto* note = entry.value.find("note")) input.note = text_of(*note, entry.key + ".note", issues);
  if (const auto* body = entry.value.find("body"))
    input.body = {text_of(*body, entry.key + ".body", issues), body->value.place};
  read_display(entry.value, input, issues);
  read_accepted(entry.value, input, issues);
  read_because(entry.value, input, issues);
  const std::size_t before = issues.size();
  input.reading = read_record(entry.value, *input.calculator->input, input.from, entry.key + ".",
                              general_keys_of(*input.calculator), issues);
  name_results(input, before, issues);
  name_templates(input, before, issues);
  name_calculator(entry.value, input, catalogue, before, issues);
  if (input.from == nullptr) show_missing(*input.calculator, input.name, before, issues);
  read_rows(entry.value, input, issues);
  fill_stocks(input, issues);
  return known->make_step(std::move(input));
}

}  // namespace loadpath::project
