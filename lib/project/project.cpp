#include "lib/project/project.hpp"

#include "lib/project/accept.hpp"
#include "lib/project/factors.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/order.hpp"
#include "lib/project/parts.hpp"
#include "lib/project/read/rows_file.hpp"
#include "lib/project/references.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <array>

namespace loadpath::project {

namespace {

constexpr std::size_t most_tables = 100'000;  // no rule: what has more is a slip

std::vector<std::string> names_of(const Project& project) {
  std::vector<std::string> names;
  for (const auto& step : project.steps) names.push_back(step->name());
  return names;
}

bool is_of_tables(const std::string& path) { return path.starts_with("tables."); }

Outcome<Signature> signature_of(Project& project, const std::string& path) {
  if (is_of_tables(path)) {
    const auto referred = project.tables->value_at(path);
    return referred ? Outcome<Signature>(Signature{referred->dimension, nullptr}) : referred.fault();
  }
  const auto [name, rest] = split_step(path);
  if (name == "values") return project.values.signature(rest);
  const Step* step = project.find(name);
  return step == nullptr ? project.unknown_step(path) : step->signature(rest);
}

/// Of what acts on one of several parts, "chain.T_1|T_2", that which `referred` has; where it has none, all.
std::vector<std::string> alternatives_of(const std::string& companion, const std::string& beside,
                                         const std::set<std::string>& referred) {
  std::vector<std::string> all, meant;
  for (std::size_t from = 0; from <= companion.size();) {
    const std::size_t to = std::min(companion.find('|', from), companion.size());
    const std::string key = companion.substr(from, to - from);
    all.push_back(from == 0 ? key : beside + key);
    if (referred.count(all.back()) != 0) meant.push_back(all.back());
    from = to + 1;
  }
  return meant.empty() ? all : meant;
}

/// For a step that refers to these paths.
std::vector<std::string> companions_of(const Project& project, const std::string& path,
                                       const std::set<std::string>& referred = {}) {
  const auto [name, rest] = split_step(path);
  const Step* step = project.find(name);
  std::vector<std::string> all;
  if (step == nullptr) return all;
  for (const std::string& companion : step->companions_of(rest)) {
    for (std::string& one : alternatives_of(companion, path.substr(0, path.rfind('.') + 1), referred))
      all.push_back(std::move(one));
  }
  return all;
}

std::set<std::string> references_of(const Step& step) {
  std::set<std::string> references;
  for_each_reference(step.input().reading, [&](const std::string& path) { references.insert(path); });
  return references;
}

std::vector<std::string> references_of(const Project& project) {
  std::vector<std::string> references;
  for (const auto& step : project.steps)
    for_each_reference(step->input().reading, [&](const std::string& path) { references.push_back(path); });
  return references;
}

/// The values of tables that expressions name. What is none is told where the expression is checked.
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

/// What expectations are held against.
std::set<std::string> compared_series(const Project& project) {
  std::set<std::string> compared;
  for (const Expectation& e : project.expectations) {
    for (const auto& reference : e.value.references()) compared.insert(reference.path);
  }
  return compared;
}

/// What the steps refer to, and what loads a part beside it.
std::set<std::string> taken_series(const Project& project) {
  std::set<std::string> taken(project.references.begin(), project.references.end());
  for (const auto& step : project.steps) {
    for_each_loading_reference(step->input().reading, [&](const std::string& path) {
      for (std::string& companion : companions_of(project, path)) taken.insert(std::move(companion));
    });
  }
  return taken;
}

/// Whether a load is calculated from a power or a speed of turning: T = "=5 kW/(1450 rpm)".
bool comes_from_turning(const Operand& operand, const Declared& declared) {
  const std::array turning{Dimension::of(0, 0, -1, 0, 1), Dimension::of(0, 0, -1), Dimension::of(2, 1, -3)};
  return operand.leaf.field->is_load && std::any_of(turning.begin(), turning.end(), [&](const Dimension& dimension) {
           return operand.expression.speaks_of(dimension, declared);
         });
}

/// What loads a step varies where it is a series, or comes from something that turns, at once or through other steps.
/// In order of evaluation.
void find_varying_loads(Project& project, const Declared& declared) {
  for (const std::size_t i : project.order) {
    Step& step = *project.steps[i];
    const auto& operands = step.input().reading.operands;
    if (std::any_of(operands.begin(), operands.end(),
                    [&](const Operand& o) { return comes_from_turning(o, declared); }))
      step.set_load_varies(true);
    for_each_loading_reference(step.input().reading, [&](const std::string& path) {
      const Step* const source = project.find(split_step(path).first);
      if (source == nullptr) return;
      const auto signature = declared(path);
      if (source->input().calculator->turns || source->load_varies() || (signature && signature->axis != nullptr))
        step.set_load_varies(true);
    });
  }
}

/// What steps know of one another while the project is solved.
Known known_of(const Project& project) {
  static const Value none{{}, {std::numeric_limits<double>::quiet_NaN()}};
  const auto value = [&project](const std::string& path) -> const Value& {
    const Value* known = project.value(path);
    return known == nullptr ? none : *known;
  };
  const auto word = [&project](const std::string& path) {
    const auto [name, rest] = split_step(path);
    const Step* const step = project.find(name);
    return step == nullptr ? std::string() : step->word(rest);
  };
  const auto within = [&project](const std::string& path) {
    const auto [name, rest] = split_step(path);
    return project.find(name)->within(rest);
  };
  return {value, word, within};
}

/// A warning as it stands with its step: behind the path that it is about, where it does not start with that.
Message of_step(const Issue& warning, const std::string& step) {
  const std::string path = warning.key.substr(std::min(step.size() + 1, warning.key.size()));
  return warning.message.text().starts_with(path) ? warning.message : say("{1}: {2}", path, warning.message);
}

/// Customs that the input breaks stand with the step that they are about.
void hand_out_warnings(Project& project, const std::vector<Issue>& issues) {
  for (const Issue& issue : issues) {
    if (issue.severity != Severity::warning) continue;
    for (const auto& step : project.steps) {
      if ((issue.key + ".").starts_with(step->name() + ".")) step->warn(of_step(issue, step->name()));
    }
  }
}

void refuse_ranges(const Project& project, std::vector<Issue>& issues) {
  for (const auto& step : project.steps) {
    for (const Varied& varied : step->input().reading.varied) {
      const std::string key = step->name() + "." + varied.path;
      const bool told = !issues.empty() && issues.back().place.line == varied.place.line &&
                        issues.back().place.column == varied.place.column;  // of a record that is taken in turn
      if (told) continue;
      if (varied.distribution)
        issues.push_back({varied.place,
                          key,
                          say("'{1}' is uncertain; computed at its middle value", varied.path),
                          {},
                          Severity::warning});
      else
        issues.push_back(
            {varied.place, key,
             say("these are {1} values, and one is taken here",
                 std::to_string(varied.words.empty() ? varied.axis.size() : varied.words.size())),
             say("`loadpath sweep` goes through all of them, `loadpath run FILE --point 0` takes the first"),
             Severity::error});
    }
  }
}

void add_step(const toml::Tree::Entry& entry, Project& project, Catalogue catalogue, std::vector<Issue>& issues) {
  for (std::string& path : files_in(entry.value)) project.files.push_back({std::move(path), {}});
  if (auto step = read_step(entry, project, catalogue, issues)) project.steps.push_back(std::move(step));
}

void check_expectations(Project& project, std::vector<Issue>& issues) {
  for (const Expectation& e : project.expectations) {
    const auto signature = e.value.check([&](const std::string& path) { return signature_of(project, path); });
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

Outcome<Signature> Project::signature(const std::string& path) { return signature_of(*this, path); }

const Step* Project::find(std::string_view name) const {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const auto& s) { return s->name() == name; });
  return found == steps.end() ? nullptr : found->get();
}

Fault Project::unknown_step(const std::string& path) const {
  const auto [name, rest] = split_step(path);
  const std::string near = nearest(name, names_of(*this));
  return {
      0, path.size(), say("there is no step '{1}'", name),
      near.empty() ? there_is(names_of(*this)) : say("did you mean '{1}'?", rest.empty() ? near : near + "." + rest)};
}

const Value* Project::value(const std::string& path) const {
  if (const auto found = table_values.find(path); found != table_values.end()) return &found->second;
  const auto [name, rest] = split_step(path);
  if (name == "values") return values.literal(rest);
  const Step* step = find(name);
  return step == nullptr ? nullptr : step->value(rest);
}

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
  if (tree.entries.size() > most_tables) {
    issues.push_back({tree.entries[most_tables].place,
                      "",
                      say("a project has at most {1} tables; here are {2}", std::to_string(most_tables),
                          std::to_string(tree.entries.size())),
                      {},
                      Severity::error});
    return project;
  }
  project.tables = read_own_tables(tree, file, catalogue, project.files, issues);
  const auto* const values = tree.find("values");
  if (values != nullptr && is_shared(*values)) project.values.read(*values, issues);
  const auto written_out = [&](const toml::Tree::Entry& entry) {
    return toml::Tree::Entry{entry.key, entry.place, project.values.in_place(entry.value, issues)};
  };
  for (const toml::Tree::Entry& entry : tree.entries) {
    if (is_shared(entry) || is_own_tables(entry)) continue;
    if (entry.key == "project") {
      read_heading(entry, project, issues);
    } else if (entry.key == "expect") {
      read_expectations(entry.value, project.expectations, issues);
    } else {
      add_step(written_out(entry), project, catalogue, issues);
    }
  }
  if (project.steps.empty() && !has_errors(issues)) {
    issues.push_back({{file, 0, 0, 1},
                      "",
                      say("the project has no step"),
                      say("a step is a table with a key calculator = \"...\""),
                      Severity::error});
  }
  for (const auto& step : project.steps) refuse_own_rows(*step, issues);
  if (ranges == Ranges::refused) refuse_ranges(project, issues);
  project.order = order_of_evaluation(project, issues);
  const Declared declared = [&](const std::string& path) { return signature_of(project, path); };
  for (const std::size_t i : project.order) {
    settle_references(*project.steps[i], project, issues);
    const Companions companions = [&, referred = references_of(*project.steps[i])](const std::string& path) {
      return companions_of(project, path, referred);
    };
    project.steps[i]->prepare(declared, companions, issues);
  }
  project.references = references_of(project);
  project.table_values = table_values_of(project);
  find_varying_loads(project, declared);
  if (!has_errors(issues)) check_expectations(project, issues);
  project.values.warn_of_unused(issues);
  return project;
}

Wanted with_references(const Project& project, Wanted wanted) {
  wanted.taken.merge(taken_series(project));
  wanted.compared.merge(compared_series(project));
  return wanted;
}

void solve(Project& project, std::vector<Issue>& issues, Wanted wanted) {
  solve_again(project, issues, with_references(project, std::move(wanted)));
}

void solve_again(Project& project, std::vector<Issue>& issues, const Wanted& wanted) {
  const Known known = known_of(project);
  for (const auto& step : project.steps) step->forget();
  for (const std::size_t i : project.order) {
    check_factors(*project.steps[i], project, issues);
    check_meanings(*project.steps[i], project, issues);
    if (!has_errors(issues)) project.steps[i]->solve(known, wanted, issues);
    if (has_errors(issues)) return;
  }
  settle_left(project);
  for (const auto& step : project.steps) warn_of_idle_acceptances(*step, issues);
  hand_out_warnings(project, issues);
}

account::Modes modes(const Project& project) {
  account::Modes all;
  for (const auto& step : project.steps)
    all.insert(all.end(), step->account().modes.begin(), step->account().modes.end());
  return project.strict ? account::strictly(std::move(all)) : all;
}

std::vector<account::Verdict> verdicts(const Project& project) {
  std::vector<account::Verdict> all;
  for (const auto& step : project.steps) {
    all.insert(all.end(), step->account().verdicts.begin(), step->account().verdicts.end());
  }
  return all;
}

}  // namespace loadpath::project
