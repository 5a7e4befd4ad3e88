#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/fields/words.hpp"
#include "lib/export/json_catalogue.hpp"
#include "lib/project/parts.hpp"
#include "lib/report/build.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <array>
#include <iostream>

namespace loadpath::cli {

namespace {

using report::keys_in;
using Type = FieldInfo::Type;
using Rows = std::vector<std::vector<std::string>>;

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

void add_fields(std::span<const FieldInfo> fields, void* owner, const std::string& prefix, Rows& rows) {
  for (const FieldInfo& f : fields) {
    const std::string key = "  " + prefix + f.key;
    if (f.type == Type::record) rows.push_back({key, "record", "optional", f.doc});
    if (f.type == Type::record) continue;
    if (f.is_leaf()) {
      const std::string rule = bounds_of(f);
      rows.push_back({key, type_of(f), f.role == Role::input ? default_of(f, owner) : "",
                      f.doc + (rule.empty() ? "" : " (" + rule + ")") + searched_of(f)});
      continue;
    }
    const bool list = f.type == Type::list;
    rows.push_back({key + (list ? "[]" : ""), list ? list_of(f) : "table",
                    f.role == Role::input && !f.optional ? "required" : "", f.doc});
    void* inner = list ? f.push(owner) : f.element(owner, 0);
    add_fields(f.fields, inner, prefix + f.key + (list ? "[]." : "."), rows);
  }
}

void show_type(const char* title, const RecordType& type) {
  Record blank(type);
  Rows rows;
  add_fields(type.fields, blank.data.get(), "", rows);
  std::cout << title << "\n" << terminal::columns(rows) << "\n";
}

/// Which inputs a row of a table fills: "E, R_e at the size of t".
std::string filled_by(const Calculator& calculator, std::string_view group) {
  std::string all;
  for (const FieldInfo& field : calculator.input->fields) {
    const Provider& from = field.provider;
    if (from.kind != Provider::Kind::table || from.table != group) continue;
    all += (all.empty() ? "" : ", ") + std::string(field.key);
    if (*from.size != '\0') all += std::string(" (at the size ") + from.size + ")";
  }
  return all;
}

/// The keys that a step has beside the fields of its calculator.
void show_keys(const Calculator& calculator) {
  Rows rows{{"  calculator", "word", "required", std::string(calculator.id)}};
  if (!calculator.templates.empty())
    rows.push_back({"  template", "word", "optional", "an input known in shape, by its parameters: see below"});
  for (const std::string& group : table_groups(calculator)) {
    rows.push_back({"  " + group, "name", "optional",
                    "a row of `loadpath tables`, or of [tables." + group + "s] in the file; fills what is missing of " +
                        filled_by(calculator, group)});
  }
  rows.push_back({"  title, note", "text", "optional", "for the report"});
  if (calculator.result != nullptr)
    rows.push_back({"  display", "table", "optional", "units of results: display = { KEY = \"in\" }"});
  if (!calculator.modes.empty())
    rows.push_back({"  accept", "table", "optional",
                    "failure modes accepted by the user: accept.MODE = \"reason\" (modes listed below)"});
  if (calculator.result != nullptr)
    rows.push_back({"  because", "table", "optional",
                    "reason for a typed value better than the given row or record: because.KEY = \"reason\""});
  std::cout << "Further keys of the step\n"
            << terminal::columns(rows)
            << terminal::paragraph("  The file itself may have [project] with " + joined(project::heading_keys()) +
                                       ", and [[expect]] with reference values.",
                                   2)
            << "\n";
}

/// Results whose paths come from the names in a project file.
void show_patterns(std::span<const ResultPattern> patterns) {
  Rows rows;
  for (const ResultPattern& p : patterns) {
    const std::string where = *p.where == '\0' ? "" : std::string(" (") + p.where + ")";
    rows.push_back({std::string("  ") + p.path, p.unit, p.doc + where});
  }
  std::cout << "Results, NAME as in the project file\n" << terminal::columns(rows) << "\n";
}

std::string assessor_of(const ModeInfo& mode) {
  if (*mode.checks != '\0') return mode.checks;
  if (*mode.judge != '\0') return std::string("add a step of ") + mode.judge;
  if (*mode.wants != '\0') return std::string("give ") + mode.wants;
  if (*mode.use != '\0') return std::string("use ") + mode.use;
  if (*mode.add != '\0') return std::string("add a step of ") + mode.add;
  return "no calculator assesses it";
}

/// The failure modes of the part, and what assesses each.
void show_modes(const Calculator& calculator) {
  Rows rows;
  for (const ModeInfo& mode : calculator.modes) {
    rows.push_back({std::string("  ") + mode.id, mode.title, assessor_of(mode)});
  }
  if (rows.empty()) return;
  std::cout << "Failure modes, and what assesses them; accept.MODE = \"reason\" answers for one that is not assessed\n"
            << terminal::columns(rows) << "\n";
}

/// The names of list elements that a template has laid out, and of those within them.
void add_names(std::span<const FieldInfo> fields, void* owner, const std::string& prefix, Rows& rows) {
  for (const FieldInfo& f : fields) {
    if (f.type != Type::list || f.size(owner) == 0) continue;
    const FieldInfo* name = find_field(f.fields, "name");
    if (name == nullptr) continue;  // elements by number, of which a template says no more
    std::vector<std::string> names;
    for (std::size_t i = 0; i < f.size(owner); ++i) names.emplace_back(name->text(f.element(owner, i)));
    rows.push_back({"  " + prefix + f.key, joined(names)});
    for (std::size_t i = 0; i < names.size(); ++i)
      add_names(f.fields, f.element(owner, i), prefix + f.key + "." + names[i] + ".", rows);
  }
}

void show_template(const Calculator& calculator, const Template& t) {
  std::cout << calculator.id << "." << t.id << ": " << t.title << "\n\n" << terminal::paragraph(t.doc) << "\n";
  show_type("Parameters, in addition to the fields of the calculator", *t.parameters);
  Record laid(*calculator.input);
  t.lay_out(laid.data.get());
  Rows rows;
  add_names(laid.type->fields, laid.data.get(), "", rows);
  std::cout << "Makes\n" << terminal::columns(rows) << "\nExample, a project file that runs:\n\n" << t.example;
}

void show_templates(const Calculator& calculator) {
  Rows rows;
  for (const Template* t : calculator.templates) {
    std::vector<std::string> keys;
    for (const FieldInfo& f : t->parameters->fields) keys.emplace_back(f.key);
    rows.push_back({std::string("  ") + t->id, t->title, joined(keys)});
  }
  std::cout << "Templates, template = \"NAME\" with its parameters in place of what it makes\n"
            << terminal::columns(rows) << "  `loadpath describe " << calculator.id << ".NAME` shows one\n\n";
}

/// "mechanism.planar.slider_crank": shows the template; false where there is none of that name.
bool describe_template(const std::string& id) {
  for (const Calculator* c : calculators()) {
    const std::string prefix = std::string(c->id) + ".";
    const Template* t = id.starts_with(prefix) ? find_template(*c, id.substr(prefix.size())) : nullptr;
    if (t == nullptr) continue;
    show_template(*c, *t);
    return true;
  }
  return false;
}

int refuse(const std::string& id, const Message& hint) {
  std::cerr << "loadpath: unknown calculator '" << id << "'\n  = help: " << hint.text() << "\n";
  return wrong_input;
}

/// What was meant by an id that is none: the calculators of an element, the one of this name, or the nearest id.
Message remedy(const std::string& id) {
  std::vector<std::string> ids, own;
  for (const Calculator* known : calculators()) {
    ids.emplace_back(known->id);
    if (known->element() == id) own.emplace_back(known->id);
    if (std::string_view(known->id).ends_with("." + id)) return say("did you mean '{1}'?", known->id);
    for (const Template* t : known->templates) ids.push_back(std::string(known->id) + "." + t->id);
  }
  if (!own.empty()) return say("'{1}' is an element; `loadpath describe` takes one of {2}", id, joined(own));
  return did_you_mean(id, ids, say("`loadpath list` shows all"));
}

void show_sources(const Calculator& calculator) {
  for (const std::string& key : keys_in(calculator.source))
    std::cout << terminal::paragraph("[" + key + "] " + table::citation(key), 2);
  for (const std::string& key : calculator.used_sources())
    std::cout << terminal::paragraph("[" + key + "] where it is used: " + table::citation(key), 2);
  std::cout << "\n";
}

void show_rules(const Calculator& calculator) {
  for (const RuleInfo& rule : calculator.rules)
    std::cout << terminal::paragraph("  rule (" + std::string(rule.fields) + "): " + rule.text, 2);
  if (!calculator.rules.empty()) std::cout << "\n";
}

void show_inputs(const Calculator& c) { show_type("Inputs", *c.input); }

void show_results(const Calculator& c) {
  if (c.result != nullptr) show_type("Results", *c.result);
  if (const auto patterns = c.patterns(); !patterns.empty()) show_patterns(patterns);
}

void show_example(const Calculator& c) { std::cout << "Example, a project file that runs:\n\n" << c.example; }

struct Part {
  const char* name;
  void (*show)(const Calculator&);
};
constexpr std::array parts{Part{"inputs", show_inputs},       Part{"keys", show_keys},
                           Part{"templates", show_templates}, Part{"rules", show_rules},
                           Part{"results", show_results},     Part{"modes", show_modes},
                           Part{"sources", show_sources},     Part{"example", show_example}};

/// One input with all that it holds: "loads"; a part of what is told: "modes".
int show_part(const Calculator& c, const std::string& name) {
  const auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return name == p.name; });
  const FieldInfo* const field = find_field(c.input->fields, name);
  if (part == parts.end() && field == nullptr) {
    std::vector<std::string> names;
    names.reserve(parts.size() + c.input->fields.size());
    for (const Part& p : parts) names.emplace_back(p.name);
    for (const FieldInfo& f : c.input->fields) names.emplace_back(f.key);
    std::cerr << "loadpath: '" << c.id << "' has no part and no input '" << name
              << "'\n  = help: " << did_you_mean(name, names, there_is(names)).text() << "\n";
    return wrong_input;
  }
  std::cout << c.id << ": " << c.title << "\n\n";
  if (part != parts.end()) {
    part->show(c);
    return passed;
  }
  const Record blank(*c.input);
  Rows rows;
  add_fields({field, 1}, blank.data.get(), "", rows);
  std::cout << terminal::columns(rows);
  return passed;
}

void show(const Calculator& c) {
  std::cout << c.id << ": " << c.title << "\n\n" << terminal::paragraph(c.scope) << "\n";
  show_sources(c);
  show_inputs(c);
  show_keys(c);
  if (!c.templates.empty()) show_templates(c);
  show_rules(c);
  show_results(c);
  show_modes(c);
  show_example(c);
}

}  // namespace

int describe(const DescribeOptions& options) {
  const Calculator* whole = find_calculator(calculators(), options.id);
  const std::string id = whole != nullptr || options.name.empty() ? options.id : options.id + "." + options.name;
  const std::string part = whole != nullptr ? options.name : options.part;
  const Calculator* c = find_calculator(calculators(), id);
  if (c == nullptr) return describe_template(id) ? passed : refuse(id, remedy(id));
  if (options.json) {
    std::cout << exports::json_of(*c);
    return passed;
  }
  if (!part.empty()) return show_part(*c, part);
  show(*c);
  return passed;
}

}  // namespace loadpath::cli
