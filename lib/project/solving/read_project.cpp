#include "lib/project/solving/read_project.hpp"

#include "lib/project/accept.hpp"
#include "lib/project/own_tables.hpp"
#include "lib/project/parts/heading.hpp"
#include "lib/project/parts/parts.hpp"
#include "lib/project/read/rows_file.hpp"
#include "lib/project/references/idlers.hpp"
#include "lib/project/references/kinds.hpp"
#include "lib/project/references/order.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/solving/bodies.hpp"
#include "lib/project/solving/causes.hpp"
#include "lib/project/solving/companions.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

constexpr std::size_t most_tables = 100'000;  // not a rule: more are a mistake

std::set<std::string> references_of(const Step& step) {
  std::set<std::string> references;
  for_each_reference(step.input().reading, [&](const std::string& path) { references.insert(path); });
  return references;
}

std::vector<std::string> references_of(const Project& project) {
  std::set<std::string> references;
  for (const auto& step : project.steps)
    for_each_reference(step->input().reading, [&](const std::string& path) { references.insert(path); });
  return {references.begin(), references.end()};
}

Takers takers_of(const Project& project) {
  Takers takers;
  for (const auto& step : project.steps) takers.add(step->name(), step->input().reading);
  return takers;
}

/// The values of tables that expressions name. Unknown names are reported when the expression is checked.
std::map<std::string, Value> table_values_of(const Project& project) {
  std::map<std::string, Value> values;
  const auto take = [&](const std::string& path) {
    if (!is_of_tables(path)) return;
    if (const auto referred = project.tables->value_at(path))
      values[path] = {{referred->dimension, nullptr}, {referred->value.si}};
  };
  std::for_each(project.references.begin(), project.references.end(), take);
  for (const Expectation& e : project.expectations) {
    for (const auto& reference : e.value.references()) take(reference.path);
  }
  return values;
}

/// The load of a step varies if it is a series, or comes from a step whose part rotates, directly or through other
/// steps. An expression that makes a number of it does not change that: 15 kW/(1450 rpm) is a torque like 98.8 N*m.
/// In order of evaluation.
void find_varying_loads(Project& project, const Declared& declared) {
  for (const std::size_t i : project.order) {
    Step& step = *project.steps[i];
    for_each_loading_reference(step.input().reading, [&](const std::string& path) {
      const Step* const source = project.find(split_step(path).first);
      if (source == nullptr || step.loads().vary) return;
      step.loads().vary = source->input().calculator->turns || source->loads().vary;
      if (step.loads().vary) return;
      const auto signature = declared(path);
      step.loads().vary = signature && signature->axis != nullptr;
    });
  }
}

Issue taken_once(const Place& place, const std::string& key, std::size_t values) {
  if (values == 1)
    return {place, key, say("this is a list; a single value is required"), say("give the value by itself"),
            Severity::error};
  return {place, key, say("these are {1} values; a single value is required", std::to_string(values)),
          say("`loadpath sweep` goes through all of them, `loadpath run FILE --point 0` takes the first"),
          Severity::error};
}

/// A scattered value has a middle; a range that a search chooses from has no value yet.
Issue taken_of(const sweep::Distribution& law, const Place& place, const std::string& key, const std::string& name) {
  if (sweep::is_design(law))
    return {place, key, say("'{1}' is a range for searches; a single value is required", name),
            say("`loadpath sweep FILE --minimise` chooses from it; scatter is { min = ..., max = ... }"),
            Severity::error};
  return {place, key, say("'{1}' is uncertain; computed at its middle value", name), {}, Severity::warning};
}

void refuse_ranges(const Project& project, std::vector<Issue>& issues) {
  for (const auto& step : project.steps) {
    for (const Varied& varied : step->input().reading.varied) {
      const std::string key = step->name() + "." + varied.path;
      const bool is_reported =
          !issues.empty() && issues.back().place.line == varied.place.line &&
          issues.back().place.column == varied.place.column;  // from a record that is taken in turn
      if (is_reported) continue;
      issues.push_back(
          varied.distribution
              ? taken_of(*varied.distribution, varied.place, key, varied.path)
              : taken_once(varied.place, key, varied.words.empty() ? varied.axis.size() : varied.words.size()));
    }
  }
}

/// Inputs computed from an uncertain value have its middle, too.
void mark_middles(const Project& project, const std::string& of) {
  const auto is_of = [&](const Expression::Reference& reference) { return reference.path == of; };
  for (const auto& step : project.steps) {
    Reading& reading = step->input().reading;
    for (const Operand& operand : reading.operands) {
      const auto& references = operand.expression.references();
      const auto typed = reading.typed.find(operand.path);
      if (typed != reading.typed.end() && std::any_of(references.begin(), references.end(), is_of))
        typed->second.mean_of_uncertain = true;
    }
  }
}

/// Every point has its own values.
void forget_middles(const Project& project) {
  for (const auto& step : project.steps) {
    for (auto& [path, typed] : step->input().reading.typed) typed.mean_of_uncertain = false;
  }
}

/// Values of [values] that expressions calculate with, and that are many.
void refuse_ranges_of_values(const Project& project, std::vector<Issue>& issues) {
  for (const Values::Several& several : project.values.several()) {
    const std::string key = "values." + several.name;
    if (several.distribution) mark_middles(project, key);
    issues.push_back(several.distribution ? taken_of(*several.distribution, several.place, key, key)
                                          : taken_once(several.place, key, several.axis.size()));
  }
}

void add_step(const toml::Tree::Entry& entry, Project& project, Catalogue catalogue, std::vector<Issue>& issues) {
  for (std::string& path : files_in(entry.value)) project.files.push_back({std::move(path), {}});
  if (auto step = read_step(entry, project, catalogue, issues))
    project.steps.push_back(std::move(step));
  else
    project.unread.insert(entry.key);
}

/// Replaces references to values that are expressions, in steps and in expectations.
void write_values_out(Project& project, std::vector<Issue>& issues) {
  for (const auto& step : project.steps) {
    Reading& reading = step->input().reading;
    for (std::vector<Operand>* const all : {&reading.operands, &reading.whole}) {
      for (Operand& operand : *all)
        project.values.write_into(operand.expression, operand.place, step->name() + "." + operand.path, issues);
    }
  }
  for (Expectation& e : project.expectations) project.values.write_into(e.value, e.place, "expect", issues);
}

/// Values of expressions that refer to no step: they are known like literals.
void find_early_values(Step& step, const Project& project, std::vector<Issue>& issues) {
  const auto known = [&](const std::string& path) -> std::optional<Value> {
    if (path.starts_with("values.")) {
      const Value* const value = project.values.fixed(path.substr(7));
      return value == nullptr ? std::nullopt : std::optional(*value);
    }
    const auto row = is_of_tables(path) ? project.tables->value_at(path) : Fault{};
    return row ? std::optional(Value{{row->dimension, nullptr}, {row->value.si}}) : std::nullopt;
  };
  for (Operand& operand : step.input().reading.operands) {
    std::map<std::string, Value> values;
    for (const auto& reference : operand.expression.references()) {
      if (auto value = known(reference.path)) values[reference.path] = std::move(*value);
    }
    const auto& references = operand.expression.references();
    if (std::any_of(references.begin(), references.end(), [&](const auto& r) { return !values.contains(r.path); }))
      continue;
    const auto signature = operand.expression.check(
        [&](const std::string& path) -> Outcome<Signature> { return values.at(path).signature; });
    const double si =
        operand.expression.evaluate([&](const std::string& path) -> const Value& { return values.at(path); }).si[0];
    if (signature && !std::isfinite(si)) {  // another fault of the expression is reported when it is checked
      issues.push_back({operand.place,
                        step.name() + "." + operand.path,
                        say("'{1}' has no value: its expression divides by zero, takes the root or logarithm of a "
                            "negative number, or is too large",
                            operand.path),
                        {},
                        Severity::error});
    }
    if (operand.leaf.field->bounds.holds(si)) operand.early = si;
  }
}

void check_expectations(Project& project, std::vector<Issue>& issues) {
  for (const Expectation& e : project.expectations) {
    const auto signature = e.value.check([&](const std::string& path) { return project.signature(path); });
    if (!signature) {
      const Fault& fault = signature.fault();
      if (fault.message.empty()) continue;
      issues.push_back(
          {place_in(e.place, e.text, fault.at, fault.length), "expect", fault.message, fault.hint, Severity::error});
    } else if (signature->axis != nullptr) {
      issues.push_back({e.place, "expect", say("'{1}' is a series over {2}", e.text, signature->axis->name()),
                        say("reduce it with peak, max, min, mean, rms or at"), Severity::error});
    } else if (signature->dimension.without_angle() != e.is.dimension.without_angle()) {
      issues.push_back({e.place,
                        "expect",
                        say("'{1}' is a {2}, and '{3}' is a {4}", e.text, name_of(signature->dimension), e.is_text,
                            name_of(e.is.dimension)),
                        {},
                        Severity::error});
    }
  }
}

}  // namespace

Project read_project(std::string_view text, const std::string& file, Catalogue catalogue, std::vector<Issue>& issues,
                     Ranges ranges) {
  const toml::Tree tree = toml::read_toml(text, file, issues);
  if (has_errors(issues)) return {};
  return read_project(tree, file, catalogue, issues, ranges);
}

Project read_project(const toml::Tree& tree, const std::string& file, Catalogue catalogue, std::vector<Issue>& issues,
                     Ranges ranges) {
  Project project;
  project.file = file;
  project.catalogue = catalogue;
  if (tree.entries.size() > most_tables) {
    issues.push_back({tree.entries[most_tables].place,
                      "",
                      say("a project has at most {1} tables; there are {2}", std::to_string(most_tables),
                          std::to_string(tree.entries.size())),
                      {},
                      Severity::error});
    return project;
  }
  const auto* const values = tree.find("values");
  if (values != nullptr && is_shared(*values)) project.values.read(*values, issues);
  toml::Tree read_at_once;
  for (const toml::Tree::Entry& entry : tree.entries) {
    if (!is_own_tables(entry) && entry.key != "expect" && entry.key != "project") continue;
    read_at_once.entries.push_back(entry);
    if (entry.key != "project") project.values.write_out_all_numbers(read_at_once.entries.back().value);
  }
  project.tables = read_own_tables(read_at_once, file, catalogue, project.files, issues);
  for (const toml::Tree::Entry& entry : tree.entries) {
    if (!is_shared(entry)) project.values.note_uses(entry.value);
  }
  const auto written_out = [&](const toml::Tree::Entry& entry) {
    return toml::Tree::Entry{entry.key, entry.place, project.values.in_place(entry.value, issues)};
  };
  for (const toml::Tree::Entry& entry : tree.entries) {
    if (is_shared(entry) || is_own_tables(entry)) continue;
    if (entry.key == "project") {
      read_heading(entry, project, issues);
    } else if (entry.key == "expect") {
      read_expectations(read_at_once.find("expect")->value, project.expectations, issues);
    } else {
      add_step(written_out(entry), project, catalogue, issues);
    }
  }
  if (project.steps.empty() && !has_errors(issues)) {
    issues.push_back({{file, 0, 0, 1},
                      "",
                      say("the project has no steps"),
                      say("a step is a table with a key calculator = \"...\""),
                      Severity::error});
  }
  write_values_out(project, issues);
  project.takers = takers_of(project);
  for (const auto& step : project.steps) refuse_own_rows(*step, issues);
  if (ranges == Ranges::refused) refuse_ranges(project, issues);
  find_idlers(project, issues);
  check_bodies(project, issues);
  put_in_order(project, issues);
  const Declared declared = [&](const std::string& path) { return project.signature(path); };
  for (const std::size_t i : project.order) {
    settle_references(*project.steps[i], project, issues);
    const Companions companions = [&, referred = references_of(*project.steps[i])](const std::string& path) {
      return companions_of(project, path, referred);
    };
    find_early_values(*project.steps[i], project, issues);
    project.steps[i]->prepare(declared, companions, issues);
    check_kinds(*project.steps[i], project, declared, issues);
  }
  ask_for_idlers(project, issues);
  ranges == Ranges::refused ? refuse_ranges_of_values(project, issues) : forget_middles(project);
  project.takers = takers_of(project);  // idlers and settled references changed them
  project.references = references_of(project);
  project.table_values = table_values_of(project);
  find_varying_loads(project, declared);
  if (!has_errors(issues)) check_expectations(project, issues);
  project.values.collect_unused();
  project.values.warn_of_unused(issues);
  keep_first_of_values(project, tree, issues);
  return project;
}

}  // namespace loadpath::project
