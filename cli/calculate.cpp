#include "cli/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/output.hpp"
#include "cli/settings/settings.hpp"
#include "cli/solving.hpp"
#include "lib/project/selection.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <iostream>

namespace loadpath::cli {

namespace {

using toml::Tree;

/// Whether an element of a list may be written as its only value, and the list of one element as that: `--families
/// IPE`.
bool takes_text(const FieldInfo* field);
bool holds_single_texts(const FieldInfo& list) {
  return list.type == FieldInfo::Type::list && list.positional && list.fields.size() == 1 &&
         takes_text(&list.fields[0]);
}

bool takes_text(const FieldInfo* field) {
  return field == nullptr || field->type == FieldInfo::Type::quantity || field->type == FieldInfo::Type::choice ||
         field->type == FieldInfo::Type::name || field->type == FieldInfo::Type::formula || holds_single_texts(*field);
}

/// Converts a place in a line to one in the flag's own text, which followed `length` characters.
void move_back(Place& place, int length) {
  if (place.line == 1) place.column = std::max(1, place.column - length);
}
void move_back(Tree& tree, int length) {
  move_back(tree.place, length);
  for (Tree& item : tree.items) move_back(item, length);
  for (Tree::Entry& entry : tree.entries) {
    move_back(entry.place, length);
    move_back(entry.value, length);
  }
}

/// The value of a flag as in a project file: a text as it is, anything else as TOML's inline text.
Tree value_of(const std::string& key, const std::string& text, const FieldInfo* field, std::vector<Issue>& issues) {
  const std::string flag = "--" + key;
  Tree value;
  value.type = Tree::Type::text;
  value.text = text;
  value.place = {flag, 1, 1, 1};
  // { stock = "R20" }, ["0 deg", "90 deg"], or a text in the quotes of a project file
  const bool structured = text.starts_with('{') || text.starts_with('[') || text.starts_with('"');
  const bool is_table =
      field != nullptr && field->has_fields() && !field->positional;  // its reader says how to write it
  if ((takes_text(field) || is_table || text.starts_with('=')) && !structured) return value;
  const std::string prefix = "value = ";
  const auto length = static_cast<int>(prefix.size());
  const std::size_t before = issues.size();
  Tree tree = toml::read_toml(prefix + text, flag, issues);
  if (issues.size() > before && field != nullptr && field->type == FieldInfo::Type::count && !structured) {
    issues.resize(before);
    issues.push_back({{flag, 1, 1, std::max(1, static_cast<int>(text.size()))},
                      "",
                      say("an integer is expected, not '{1}'", text),
                      say("for example {1} 3", flag),
                      Severity::error});
    return value;
  }
  for (std::size_t i = before; i < issues.size(); ++i) move_back(issues[i].place, length);
  if (tree.entries.empty()) return value;
  move_back(tree, length);
  return std::move(tree.entries[0].value);
}

void put(Tree& table, Tree::Entry entry) {
  const auto known = std::find_if(table.entries.begin(), table.entries.end(),
                                  [&](const Tree::Entry& e) { return e.key == entry.key; });
  if (known == table.entries.end())
    table.entries.push_back(std::move(entry));
  else
    *known = std::move(entry);
}

void take(Tree& table, const std::string& key) {
  std::erase_if(table.entries, [&](const Tree::Entry& e) { return e.key == key; });
}

Tree* crank_of(Tree& step) {
  for (Tree::Entry& entry : step.entries) {
    if (entry.key == "crank" && entry.value.type == Tree::Type::table) return &entry.value;
  }
  return nullptr;
}

Tree::Entry flag_entry(const std::string& key, const std::string& text, const FieldInfo* field,
                       std::vector<Issue>& issues) {
  return {key, {"--" + key, 1, 1, 1}, value_of(key, text, field, issues)};
}

/// The crank angles of `--at`, in place of a full revolution.
void put_angles(Tree& step, const std::string& at, std::vector<Issue>& issues) {
  Tree* const crank = crank_of(step);
  if (crank == nullptr) {
    issues.push_back({{"--at", 0, 0, 1},
                      "",
                      say("crank angles need a crank, and this mechanism has none"),
                      say("write its speed: crank = { speed = \"60 rpm\" }"),
                      Severity::error});
    return;
  }
  for (const char* key : {"at", "start", "positions"}) take(*crank, key);
  put(*crank, flag_entry("at", at, nullptr, issues));
}

/// Reasons from the shell, in addition to those of the file: accepted failure modes, justified inputs.
void put_reasons(Tree& step, const std::string& key, const std::vector<std::string>& reasons) {
  if (reasons.empty()) return;
  const Place place{"--" + key, 1, 1, 1};
  auto table = std::find_if(step.entries.begin(), step.entries.end(), [&](const auto& e) { return e.key == key; });
  if (table == step.entries.end()) table = step.entries.insert(step.entries.end(), {key, place, {}});
  for (const std::string& text : reasons) {
    const std::size_t equals = std::min(text.find('='), text.size());
    Tree reason;
    reason.type = Tree::Type::text;
    reason.place = place;
    reason.text = text.substr(std::min(equals + 1, text.size()));
    put(table->value, {text.substr(0, equals), place, std::move(reason)});
  }
}

/// Flags that replace the inputs of a step. The number of positions goes to the crank if there is one.
void put_flags(Tree& step, const CalculateOptions& options, std::vector<Issue>& issues) {
  for (const auto& [key, text] : options.values) {
    if (key != "positions")
      put(step, flag_entry(key, text, find_input(options.calculator->input->fields, key), issues));
  }
  for (const auto& [key, text] : options.values) {
    if (key != "positions") continue;
    Tree* const crank = crank_of(step);
    if (crank != nullptr) take(*crank, "at");
    put(crank == nullptr ? step : *crank,
        flag_entry(key, text, find_input(options.calculator->input->fields, key), issues));
  }
  if (!options.at.empty()) put_angles(step, options.at, issues);
  put_reasons(step, "accept", options.accepted);
  put_reasons(step, "because", options.because);
}

Tree tree_of_flags(const CalculateOptions& options, std::vector<Issue>& issues) {
  Tree step;
  step.place = {"command line", 0, 0, 1};
  Tree id;
  id.type = Tree::Type::text;
  id.text = options.calculator->id;
  step.entries.push_back({"calculator", step.place, id});
  put_flags(step, options, issues);
  const std::string_view all = options.calculator->id;
  Tree tree;
  tree.entries.push_back({std::string(all.substr(all.find('.') + 1)), step.place, std::move(step)});
  return tree;
}

Tree tree_of_file(const CalculateOptions& options, const terminal::SourceText& source, std::vector<Issue>& issues) {
  const std::string id = options.calculator->id;
  Tree project = toml::read_toml(source.text, source.file, issues);
  if (!has_errors(issues)) put_settings(project, options.settings, issues);
  Tree part = project::part_for(project, id);
  if (part.entries.empty() && !has_errors(issues)) {
    issues.push_back({{source.file, 0, 0, 1}, "", say("the project has no step of '{1}'", id), {}, Severity::error});
  }
  for (Tree::Entry& entry : part.entries) {
    if (project::runs(entry, id)) put_flags(entry.value, options, issues);
  }
  return part;
}

}  // namespace

int calculate(const CalculateOptions& options) {
  if (!can_write(options.output)) return wrong_input;
  if (!options.settings.empty() && options.file.empty()) {
    std::cerr << "loadpath: '--set' changes a step of a file\n  = help: name the file with --file, or write the field "
                 "as a flag: --T \"900 N*m\"\n";
    return wrong_input;
  }
  std::vector<terminal::SourceText> sources;
  for (const auto& [key, text] : options.values) sources.push_back({"--" + key, text});
  sources.push_back({"--at", options.at});
  terminal::SourceText file{options.file == "-" ? "standard input" : options.file, ""};
  if (!options.file.empty() && !toml::read_file(options.file, file.text)) {
    std::cerr << "loadpath: cannot read '" << options.file << "'\n  = help: " << help_for_file(options.file) << "\n";
    return wrong_input;
  }
  sources.push_back(file);
  sources.push_back(source_of(options.settings));
  return solve_and_show(
      [&](std::vector<Issue>& issues) {
        const Tree tree = options.file.empty() ? tree_of_flags(options, issues) : tree_of_file(options, file, issues);
        if (has_errors(issues)) return project::Project{};
        const std::string name = options.file.empty() ? "command line" : file.file;
        project::Project project = project::read_project(tree, name, catalogue(), issues);
        if (!options.settings.empty()) project.meta.emplace_back("set", text_of(options.settings));
        return project;
      },
      sources, options.output, report::Detail::full);
}

}  // namespace loadpath::cli
