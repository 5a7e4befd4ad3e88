#include "lib/project/project.hpp"

#include "lib/project/order.hpp"
#include "lib/project/parts.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

constexpr std::size_t most_tables = 1000;

/// "lever.drive.M" -> "lever", "drive.M".
std::pair<std::string, std::string> split_step(const std::string& path) {
  const std::size_t dot = path.find('.');
  return {path.substr(0, dot), dot == std::string::npos ? "" : path.substr(dot + 1)};
}

std::vector<std::string> names_of(const Project& project) {
  std::vector<std::string> names;
  for (const auto& step : project.steps) names.push_back(step->name());
  return names;
}

Outcome<Signature> signature_of(const Project& project, const std::string& path) {
  const auto [name, rest] = split_step(path);
  const Step* step = project.find(name);
  if (step != nullptr) return step->signature(rest);
  const std::string near = nearest(name, names_of(project));
  if (!near.empty())
    return Fault{0, path.size(), say("there is no step '{1}'", name), say("did you mean '{1}'?", near + "." + rest)};
  return Fault{0, path.size(), say("there is no step '{1}'", name), there_is(names_of(project))};
}

std::vector<std::string> companions_of(const Project& project, const std::string& path) {
  const auto [name, rest] = split_step(path);
  const Step* step = project.find(name);
  return step == nullptr ? std::vector<std::string>{} : step->companions_of(rest);
}

std::vector<std::string> references_of(const Project& project) {
  std::vector<std::string> references;
  for (const auto& step : project.steps) {
    for (const Operand& operand : step->input().reading.operands) {
      for (const auto& reference : operand.expression.references()) references.push_back(reference.path);
    }
  }
  return references;
}

/// What the steps refer to, and what loads a part beside it.
std::set<std::string> taken_series(const Project& project) {
  std::set<std::string> taken(project.references.begin(), project.references.end());
  for (const std::string& path : project.references) {
    for (std::string& companion : companions_of(project, path)) taken.insert(std::move(companion));
  }
  return taken;
}

/// What loads a step varies where it is a series, or comes from something that turns, at once or through other steps.
/// In order of evaluation.
void find_varying_loads(Project& project, const Declared& declared) {
  for (const std::size_t i : project.order) {
    Step& step = *project.steps[i];
    for (const Operand& operand : step.input().reading.operands) {
      for (const auto& reference : operand.expression.references()) {
        const Step* const source = project.find(split_step(reference.path).first);
        if (source == nullptr) continue;
        const auto signature = declared(reference.path);
        if (source->input().calculator->turns || source->load_varies() || (signature && signature->axis != nullptr))
          step.set_load_varies(true);
      }
    }
  }
}

/// Customs that the input breaks stand with the step that they are about.
void hand_out_warnings(Project& project, const std::vector<Issue>& issues) {
  for (const Issue& issue : issues) {
    if (issue.severity != Severity::warning) continue;
    for (const auto& step : project.steps) {
      if ((issue.key + ".").starts_with(step->name() + "."))
        step->warn(
            say("{1}: {2}", issue.key.substr(std::min(step->name().size() + 1, issue.key.size())), issue.message));
    }
  }
}

void check_expectations(const Project& project, std::vector<Issue>& issues) {
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

const Step* Project::find(std::string_view name) const {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const auto& s) { return s->name() == name; });
  return found == steps.end() ? nullptr : found->get();
}

const Value* Project::value(const std::string& path) const {
  const auto [name, rest] = split_step(path);
  const Step* step = find(name);
  return step == nullptr ? nullptr : step->value(rest);
}

Project read_project(std::string_view text, const std::string& file, Catalogue catalogue, std::vector<Issue>& issues) {
  const toml::Tree tree = toml::read_toml(text, file, issues);
  if (has_errors(issues)) return {};
  return read_project(tree, file, catalogue, issues);
}

Project read_project(const toml::Tree& tree, const std::string& file, Catalogue catalogue, std::vector<Issue>& issues) {
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
  for (const toml::Tree::Entry& entry : tree.entries) {
    if (entry.key == "project") {
      read_heading(entry, project, issues);
    } else if (entry.key == "expect") {
      read_expectations(entry.value, project, issues);
    } else if (auto step = read_step(entry, catalogue, issues)) {
      project.steps.push_back(std::move(step));
    }
  }
  if (project.steps.empty() && !has_errors(issues)) {
    issues.push_back({{file, 0, 0, 1},
                      "",
                      say("the project has no step"),
                      say("a step is a table with a key calculator = \"...\""),
                      Severity::error});
  }
  project.order = order_of_evaluation(project, issues);
  project.references = references_of(project);
  const Declared declared = [&](const std::string& path) { return signature_of(project, path); };
  const Companions companions = [&](const std::string& path) { return companions_of(project, path); };
  for (const std::size_t i : project.order) project.steps[i]->prepare(declared, companions, issues);
  find_varying_loads(project, declared);
  if (!has_errors(issues)) check_expectations(project, issues);
  return project;
}

void solve(Project& project, std::vector<Issue>& issues, Wanted wanted) {
  static const Value none{{}, {std::numeric_limits<double>::quiet_NaN()}};
  const Known known = [&](const std::string& path) -> const Value& {
    const Value* value = project.value(path);
    return value == nullptr ? none : *value;
  };
  wanted.taken = taken_series(project);
  for (const std::size_t i : project.order) {
    project.steps[i]->solve(known, wanted, issues);
    if (has_errors(issues)) return;
  }
  hand_out_warnings(project, issues);
}

account::Modes modes(const Project& project) {
  account::Modes all;
  for (const auto& step : project.steps)
    all.insert(all.end(), step->account().modes.begin(), step->account().modes.end());
  return all;
}

std::vector<account::Verdict> verdicts(const Project& project) {
  std::vector<account::Verdict> all;
  for (const auto& step : project.steps) {
    all.insert(all.end(), step->account().verdicts.begin(), step->account().verdicts.end());
  }
  return all;
}

}  // namespace loadpath::project
