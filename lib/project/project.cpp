#include "lib/project/project.hpp"

#include "lib/table/tables.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

std::vector<std::string> names_of(const Project& project) {
  std::vector<std::string> names;
  for (const auto& step : project.steps) names.push_back(step->name());
  return names;
}

/// Whether a path names tables without their first word: "materials.S355.E".
bool names_table(const Project& project, const std::string& path) {
  if (project.tables == nullptr) return false;
  const auto referred = project.tables->value_at("tables." + path);
  const std::string_view fault = referred ? std::string_view() : referred.fault().message.id;
  return !fault.starts_with("unknown tables") && !fault.starts_with("no {1} '{2}' in the tables") &&
         fault.find("is not a value of a table") == std::string_view::npos;
}

}  // namespace

std::pair<std::string, std::string> split_step(const std::string& path) {
  const std::size_t dot = path.find('.');
  return {path.substr(0, dot), dot == std::string::npos ? "" : path.substr(dot + 1)};
}

bool is_of_tables(const std::string& path) { return path.starts_with("tables."); }

Outcome<Signature> Project::signature(const std::string& path) {
  if (is_of_tables(path)) {
    const auto referred = tables->value_at(path);
    return referred ? Outcome<Signature>(Signature{referred->dimension, nullptr}) : referred.fault();
  }
  const auto [name, rest] = split_step(path);
  if (name == "values") return values.signature(rest);
  const Step* const step = find(name);
  return step == nullptr ? unknown_step(path) : step->signature(rest);
}

const Step* Project::find(std::string_view name) const {
  if (takers.size() == steps.size()) {
    const auto position = takers.find(name);
    return position ? steps[*position].get() : nullptr;
  }
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const auto& s) { return s->name() == name; });
  return found == steps.end() ? nullptr : found->get();
}

bool Project::is_referred_to(const std::string& path) const { return std::ranges::binary_search(references, path); }

bool Project::is_referred_into(const std::string& beginning) const {
  const auto first = std::ranges::lower_bound(references, beginning);
  return first != references.end() && first->starts_with(beginning);
}

Fault Project::unknown_step(const std::string& path) const {
  const auto [name, rest] = split_step(path);
  if (unread.contains(name)) return {};  // its error has been reported
  std::vector<std::string> names = names_of(*this);
  names.insert(names.end(), {"values", "tables"});
  const std::string near = names_table(*this, path) ? "tables." + name : nearest(name, names);
  return {
      0, path.size(), say("unknown step '{1}'", name),
      near.empty() ? there_is(names_of(*this)) : say("did you mean '{1}'?", rest.empty() ? near : near + "." + rest)};
}

const Value* Project::value(const std::string& path) const {
  if (const auto found = table_values.find(path); found != table_values.end()) return &found->second;
  const auto [name, rest] = split_step(path);
  if (name == "values") return values.literal(rest);
  const Step* step = find(name);
  const Value* const found = step == nullptr ? nullptr : step->value(rest);
  const auto before = found == nullptr ? beforehand.find(path) : beforehand.end();
  return before == beforehand.end() ? found : &before->second;
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
