#include "cli/describe/field.hpp"

#include "cli/describe/example.hpp"
#include "cli/describe/full.hpp"
#include "cli/describe/lines.hpp"
#include "cli/describe/rows.hpp"
#include "cli/exit.hpp"
#include "cli/fields/words.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/table/tables.hpp"
#include "lib/text/meant.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace loadpath::cli {

namespace {

/// Rows of a name and a text, of which empty texts are left out.
class Facts {
 public:
  void add(const char* name, const std::string& text) {
    if (!text.empty()) rows_.push_back({std::string("  ") + name, text});
  }
  void show() const { std::cout << terminal::columns(rows_, screen_width); }

 private:
  Rows rows_;
};

/// A path without the brackets that stand for any element: "torques[].x" is "torques.x".
std::string plain_path(std::string path) {
  for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]")) path.erase(at, 2);
  return path;
}

/// A field and the aggregate that holds it, in a blank record to which elements are added.
Leaf find_declared(std::span<const FieldInfo> fields, void* owner, std::string_view path) {
  const std::size_t point = std::min(path.find('.'), path.size());
  const FieldInfo* const field = find_input(fields, path.substr(0, point));
  if (field == nullptr || point == path.size()) return {field, owner};
  if (!field->has_fields()) return {};
  void* const inner = field->type == FieldInfo::Type::list ? field->push(owner) : field->element(owner, 0);
  return find_declared(field->fields, inner, path.substr(point + 1));
}

void show_title(const Calculator& calculator, const std::string& path, const std::string& meaning) {
  std::cout << terminal::columns({{std::string(calculator.id) + "." + path, meaning}}, screen_width);
}

std::string range_of(const FieldInfo& field, const Range& usual) {
  if (!field.is_number() || (std::isinf(usual.low) && std::isinf(usual.high))) return "";
  const std::string unit = field.type == FieldInfo::Type::quantity ? field.unit : "-";
  if (std::isinf(usual.high)) return "from " + format_quantity(usual.low, unit);
  if (std::isinf(usual.low)) return "up to " + format_quantity(usual.high, unit);
  return format_quantity(usual.low, unit) + " to " + format_quantity(usual.high, unit);
}

/// "> 0 mm" of "must be > 0 mm".
std::string short_bounds(const FieldInfo& field) {
  constexpr std::string_view must = "must be ";
  const std::string rule = field.is_number() ? bounds_of(field) : "";
  return rule.starts_with(must) ? rule.substr(must.size()) : rule;
}

/// What fills an input that is not typed.
std::string filled_by(const FieldInfo& field) {
  const Provider& from = field.provider;
  if (from.kind == Provider::Kind::companion) return std::string("the source of ") + from.column;
  if (from.kind != Provider::Kind::table) return "";
  std::string text = std::string(from.table) + " = \"NAME\", column " + from.column;
  if (*from.size != '\0') text += std::string(" at the size of ") + from.size;
  return text + "; rows: loadpath tables";
}

std::string search_of(const FieldInfo& field) {
  if (*field.searched_in != '\0')
    return std::string(field.sought_unasked ? "\"?\" or omitted" : "\"?\"") + ": the smallest of " + field.searched_in +
           " that passes";
  return field.can_be_largest() ? "\"?\": the largest that passes" : "";
}

bool names(std::string_view list, std::string_view key) {
  for (const std::string& one : listed_keys(list)) {
    if (one == key) return true;
  }
  return false;
}

/// Checks that exist only where an input is given.
std::vector<std::string> checks_of(const Calculator& calculator, const std::string& input) {
  std::vector<std::string> checks;
  if (calculator.result == nullptr) return checks;
  for (const FieldInfo& field : calculator.result->fields) {
    if (names(field.asked_by, input)) checks.emplace_back(field.key);
  }
  return checks;
}

/// Failure modes that a check judges, or that an input would let be judged.
std::string modes_with(const Calculator& calculator, const std::string& key) {
  std::string titles;
  const auto checks = checks_of(calculator, key);
  for (const ModeInfo& mode : calculator.modes) {
    const bool by_check =
        std::any_of(checks.begin(), checks.end(), [&](const std::string& c) { return names(mode.checks, c); });
    if (!by_check && !names(mode.checks, key) && !names(mode.wants, key)) continue;
    titles += (titles.empty() ? "" : "; ") + std::string(mode.title) + " (" + mode.id + ")";
  }
  return titles;
}

void add_rules(const Calculator& calculator, const std::string& key, Facts& facts) {
  for (const RuleInfo& rule : calculator.rules) {
    if (names(rule.fields, key)) facts.add(rule.only_warns ? "warning" : "rule", rule.text);
  }
}

std::string choices_of(const FieldInfo& field) {
  std::string all;
  for (const ChoiceInfo& choice : field.choices) {
    const std::string doc = choice.doc;
    if (*choice.key == '\0' || doc.ends_with("(refused)")) continue;
    const std::string word = std::string(choice.key) + (*choice.also == '\0' ? "" : std::string(" or ") + choice.also);
    all += (all.empty() ? "" : "; ") + word + (doc.empty() ? "" : ": " + doc);
  }
  return all;
}

/// What a step of the example says at a path: of a list in its first element.
const toml::Tree* said_at(const toml::Tree& tree, std::string_view path) {
  if (tree.type == toml::Tree::Type::array) return tree.items.empty() ? nullptr : said_at(tree.items[0], path);
  const std::size_t point = std::min(path.find('.'), path.size());
  const toml::Tree::Entry* const entry = tree.find(path.substr(0, point));
  if (entry == nullptr || point == path.size()) return entry == nullptr ? nullptr : &entry->value;
  return said_at(entry->value, path.substr(point + 1));
}

/// The example's own value; of a choice else its first word.
std::string example_of(const Calculator& calculator, const FieldInfo& field, const std::string& path) {
  const toml::Tree step = example_step(calculator);
  const toml::Tree* const said = said_at(step, path);
  const std::string typed = said == nullptr ? "" : as_typed(*said), key = std::string(field.key) + " = ";
  if (!typed.empty()) return key + typed;
  const std::string words = field.type == FieldInfo::Type::choice ? words_of(field) : "";
  return words.empty() ? "" : key + "\"" + words.substr(0, words.find(' ')) + "\"";
}

/// "segments[1].tau": the path as an expression takes it, of lists the first element.
std::string reference_to(std::span<const FieldInfo> fields, std::string_view path) {
  const std::size_t point = std::min(path.find('.'), path.size());
  const std::string key(path.substr(0, point));
  const FieldInfo* const field = find_field(fields, key);
  if (field == nullptr || point == path.size()) return key;
  const std::string element = field->type == FieldInfo::Type::list ? "[1]" : "";
  return key + element + "." + reference_to(field->fields, path.substr(point + 1));
}

void show_input(const Calculator& calculator, const Leaf& leaf, const std::string& path) {
  const FieldInfo& field = *leaf.field;
  show_title(calculator, path, field.doc);
  Facts facts;
  const bool is_choice = field.type == FieldInfo::Type::choice;
  facts.add(field.type == FieldInfo::Type::quantity ? "unit" : "type", is_choice ? choices_of(field) : type_of(field));
  facts.add("or typed", field.also_called);
  facts.add("bounds", short_bounds(field));
  facts.add("default", field.is_leaf() ? default_of(field, leaf.owner) : "");
  facts.add("usual", range_of(field, field.plausible));
  facts.add("customary", range_of(field, field.customary));
  facts.add("filled by", filled_by(field));
  facts.add("search", search_of(field));
  facts.add("used by", modes_with(calculator, path));
  add_rules(calculator, path, facts);
  facts.add("example", example_of(calculator, field, path));
  facts.show();
  if (!field.has_fields()) return;
  Rows rows;
  void* const inner = field.type == FieldInfo::Type::list ? field.push(leaf.owner) : field.element(leaf.owner, 0);
  add_fields(field.fields, inner, path + (field.type == FieldInfo::Type::list ? "[]." : "."), rows);
  std::cout << terminal::columns(rows, screen_width);
}

/// How another step takes a result.
std::string taken_by(const std::string& path) { return "KEY = \"=STEP." + path + "\" in another step"; }

/// What a check or a limit decides by.
std::string criterion_of(const FieldInfo& field) {
  if (field.role == Role::check) return "passes up to 1";
  if (field.role != Role::limit) return "";
  return std::string(field.is_criterion ? "fails unless " : "the method is valid where ") + short_bounds(field);
}

void show_result(const Calculator& calculator, const FieldInfo& field, const std::string& path) {
  show_title(calculator, path, field.doc);
  Facts facts;
  facts.add(field.type == FieldInfo::Type::quantity ? "unit" : "type",
            field.type == FieldInfo::Type::choice ? choices_of(field) : type_of(field));
  facts.add("role", field.role == Role::result ? "result" : field.role == Role::check ? "check" : "limit");
  facts.add("criterion", criterion_of(field));
  facts.add("exists", *field.asked_by == '\0' ? "" : std::string("where ") + field.asked_by + " is given");
  facts.add("used by", modes_with(calculator, path));
  if (field.is_leaf()) facts.add("example", taken_by(reference_to(calculator.result->fields, path)));
  facts.show();
  if (!field.has_fields()) return;
  const Record blank(*calculator.result);
  const Leaf leaf = find_declared(calculator.result->fields, blank.data.get(), path);
  void* const inner = field.type == FieldInfo::Type::list ? field.push(leaf.owner) : field.element(leaf.owner, 0);
  Rows rows;
  add_fields(field.fields, inner, path + (field.type == FieldInfo::Type::list ? "[]." : "."), rows);
  std::cout << terminal::columns(rows, screen_width);
}

const char* kind_of(const ModeInfo& mode) {
  switch (mode.kind) {
    case ModeKind::strength:
      return "strength";
    case ModeKind::service:
      return "serviceability: open until its bound is given";
    case ModeKind::shape:
      return "shape";
    case ModeKind::special:
      return "special service: open until an input shows that service";
  }
  return "";
}

void show_mode(const Calculator& calculator, const ModeInfo& mode) {
  std::cout << terminal::paragraph(std::string(calculator.id) + ", failure mode " + mode.id + ": " + mode.title, 2,
                                   screen_width);
  Facts facts;
  facts.add("kind", kind_of(mode));
  facts.add("assessed by", assessor_of(mode));
  facts.add("needs", mode.wants);
  for (const std::string& check : listed_keys(mode.checks)) {
    const FieldInfo* const field =
        calculator.result == nullptr ? nullptr : find_field(calculator.result->fields, check);
    if (field == nullptr) continue;
    std::string text = check;
    text.append(": ").append(field->doc);
    if (*field->asked_by != '\0') text.append("; where ").append(field->asked_by).append(" is given");
    facts.add("check", text);
  }
  facts.add("accept", std::string("accept.") + mode.id + " = \"reason\"");
  facts.show();
}

bool show_pattern(const Calculator& calculator, const std::string& name) {
  for (const ResultPattern& pattern : calculator.patterns()) {
    if (pattern.path != name) continue;
    show_title(calculator, name, pattern.doc);
    Facts facts;
    facts.add("unit", pattern.unit);
    facts.add("exists", pattern.where);
    facts.add("example", taken_by(name));
    facts.show();
    return true;
  }
  return false;
}

/// A parameter of templates, once for all in which it means the same.
bool show_parameter(const Calculator& calculator, const std::string& name) {
  std::vector<std::pair<std::string, std::string>> meanings;  // with the templates
  for (const Template* t : calculator.templates) {
    const FieldInfo* const field = find_field(t->parameters->fields, name);
    if (field == nullptr) continue;
    const std::string bounds = short_bounds(*field);
    const std::string meaning =
        field->doc + std::string("; ") + type_of(*field) + (bounds.empty() ? "" : ", " + bounds);
    const auto is_same = [&](const auto& one) { return one.first == meaning; };
    const auto same = std::find_if(meanings.begin(), meanings.end(), is_same);
    if (same == meanings.end())
      meanings.emplace_back(meaning, t->id);
    else
      same->second += std::string(", ") + t->id;
  }
  Facts facts;
  for (const auto& one : meanings) facts.add("of", one.second + ": " + one.first);
  if (!meanings.empty()) std::cout << calculator.id << "." << name << ", parameter of templates\n";
  facts.show();
  return !meanings.empty();
}

/// The key of a step that names a row of a table: "material".
bool show_group(const Calculator& calculator, const std::string& name) {
  const auto groups = table_groups(calculator);
  if (std::find(groups.begin(), groups.end(), name) == groups.end()) return false;
  show_title(calculator, name, "row of a table, which fills inputs that are not typed");
  Facts facts;
  for (const FieldInfo& field : calculator.input->fields) {
    const bool is_filled = field.provider.kind == Provider::Kind::table && field.provider.table == name;
    if (is_filled) facts.add("fills", std::string(field.key) + ": " + field.doc);
  }
  facts.add("rows", "`loadpath tables`, or [tables." + name + "s] in the file");
  if (!table::order_of(name).empty()) facts.add("search", name + " = \"?\" finds the first row that passes");
  const toml::Tree step = example_step(calculator);
  const toml::Tree::Entry* const given = step.find(name);
  facts.add("example", given == nullptr ? "" : name + " = " + as_typed(given->value));
  facts.show();
  return true;
}

std::vector<Known> known_names(const Calculator& calculator) {
  std::vector<Known> known;
  for (const std::string& part : part_names()) known.push_back({part, ""});
  for (const FieldInfo& field : calculator.input->fields) known.push_back({field.key, field.doc});
  for (const ModeInfo& mode : calculator.modes) known.push_back({mode.id, mode.title});
  for (const std::string& group : table_groups(calculator)) known.push_back({group, "row of a table"});
  if (calculator.result == nullptr) return known;
  for (const FieldInfo& field : calculator.result->fields) known.push_back({field.key, field.doc});
  return known;
}

}  // namespace

bool show_field(const Calculator& calculator, const std::string& name) {
  const std::string path = plain_path(name);
  const Record input(*calculator.input);
  bool is_shown = false;
  const auto part = [&] {  // a blank line between what has the same name
    if (is_shown) std::cout << "\n";
    is_shown = true;
  };
  if (show_group(calculator, name)) is_shown = true;
  if (const Leaf leaf = find_declared(input.type->fields, input.data.get(), path))
    part(), show_input(calculator, leaf, path);
  if (calculator.result != nullptr) {
    const Record result(*calculator.result);
    if (const Leaf leaf = find_declared(result.type->fields, result.data.get(), path))
      part(), show_result(calculator, *leaf.field, path);
  }
  for (const ModeInfo& mode : calculator.modes) {
    if (mode.id == name) part(), show_mode(calculator, mode);
  }
  return is_shown || show_pattern(calculator, name) || show_parameter(calculator, path);
}

/// "seats.way" of "way": the first field of that key in a list or a group; empty if there is none.
static std::string nested_field(const Calculator& calculator, const std::string& name) {
  for (const FieldInfo& outer : calculator.input->fields) {
    if (outer.has_fields() && find_field(outer.fields, name) != nullptr) return std::string(outer.key) + "." + name;
  }
  return {};
}

int refuse_field(const Calculator& calculator, const std::string& name) {
  const std::string nested = nested_field(calculator, name);
  const Message hint = !nested.empty() ? say("did you mean '{1}'?", nested)
                                       : meant(name, known_names(calculator),
                                               say("`loadpath describe {1} --full` shows all", calculator.id));
  std::cerr << "loadpath: '" << calculator.id << "' has no input, result, failure mode or part '" << name
            << "'\n  = help: " << hint.text() << "\n";
  return wrong_input;
}

}  // namespace loadpath::cli
