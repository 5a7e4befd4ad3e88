#include "lib/project/accept.hpp"

#include "lib/project/because.hpp"

#include <algorithm>

namespace loadpath::project {

using toml::Tree;

namespace {

void read_reason(const Tree::Entry& entry, StepInput& input, std::vector<Issue>& issues) {
  const std::string key = input.name + ".accept." + entry.key;
  const auto& modes = input.calculator->modes;
  if (std::none_of(modes.begin(), modes.end(), [&](const ModeInfo& m) { return entry.key == m.id; })) {
    std::vector<std::string> ids;
    for (const ModeInfo& mode : modes) ids.emplace_back(mode.id);
    issues.push_back({entry.place, key, say("'{1}' has no failure mode '{2}'", input.calculator->id, entry.key),
                      did_you_mean(entry.key, ids, say("`loadpath describe {1}` lists them", input.calculator->id)),
                      Severity::error});
  } else if (!is_reason(entry.value)) {
    issues.push_back({entry.value.place, key, say("an accepted mode needs a reason, a text of one line"),
                      say("write accept.{1} = \"rated by the manufacturer, drawing 12\"", entry.key), Severity::error});
  } else {
    input.accepted[entry.key] = {entry.value.text, entry.place};
  }
}

/// The reason why a mode cannot be accepted.
Message instead_of_accepted(const std::string& id, const account::Modes& modes) {
  using account::State;
  const auto mode = std::find_if(modes.begin(), modes.end(), [&](const account::Mode& m) { return m.id == id; });
  if (mode == modes.end()) return say("{1} does not apply here", id);
  if (mode->state == State::pass) return say("{1} is assessed and passes", id);
  if (mode->state == State::fail) return say("{1} fails, and a failure is never accepted", id);
  return say("{1}: {2}, which cannot be accepted", id, account::shown(mode->state));
}

}  // namespace

void read_accepted(const Tree& table, StepInput& input, std::vector<Issue>& issues) {
  const auto* accepted = table.find("accept");
  if (accepted == nullptr) return;
  if (accepted->value.type != Tree::Type::table) {
    issues.push_back({accepted->value.place, input.name + ".accept",
                      say("'{1}' is a table of reasons, not {2}", "accept", toml::word_for(accepted->value.type)),
                      say("name the modes: accept = { fatigue = \"runs for an hour in all\" }"), Severity::error});
    return;
  }
  for (const Tree::Entry& entry : accepted->value.entries) read_reason(entry, input, issues);
}

void accept(const StepInput& input, account::Mode& mode) {
  if (!is_accepted(input, mode.id, mode.state)) return;
  mode.state = account::State::accepted;
  mode.note = say("{1}", input.accepted.at(mode.id).text);
}

bool is_accepted(const StepInput& input, const std::string& mode, account::State state) {
  const bool waits = state == account::State::open || state == account::State::not_judged;
  return waits && input.accepted.contains(mode);
}

void warn_of_idle_acceptances(const Step& step, std::vector<Issue>& issues) {
  const account::Modes& modes = step.account().modes;
  for (const auto& [id, reason] : step.input().accepted) {
    if (std::any_of(modes.begin(), modes.end(),
                    [&id = id](const account::Mode& m) { return m.id == id && m.state == account::State::accepted; }))
      continue;
    const std::string path = "accept." + id;
    issues.push_back({reason.place,
                      step.name() + "." + path,
                      say("{1} has no effect: {2}", path, instead_of_accepted(id, modes)),
                      {},
                      Severity::warning});
  }
}

}  // namespace loadpath::project
