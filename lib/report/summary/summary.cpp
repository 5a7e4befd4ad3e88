#include "lib/report/summary/summary.hpp"

#include "lib/numerics/magnitude.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::report {

namespace {

using account::Group;
using account::Mode;
using account::Modes;
using account::State;
using project::Project;
using project::Step;

double used(const Mode& mode) { return mode.utilisation.value_or(-1.0); }

/// The failing mode, else the most utilised one of strength or service, else the first that passes.
std::optional<Mode> governing_of(const Modes& modes, const std::string& step) {
  const Mode* best = nullptr;
  const auto is_worse = [](const Mode& a, const Mode& b) {
    const bool fails = a.state == State::fail, other = b.state == State::fail;
    return fails != other ? fails : numerics::exceeds(used(a), used(b));
  };
  for (const Mode& mode : modes) {
    const bool is_assessed = mode.state == State::fail || mode.state == State::pass || mode.utilisation;
    if (mode.step != step || !is_told(mode) || !is_assessed) continue;
    if (best == nullptr || is_worse(mode, *best)) best = &mode;
  }
  if (best != nullptr && (best->utilisation || best->state == State::fail)) return *best;
  const auto limit =
      std::ranges::find_if(modes, [&](const Mode& m) { return m.step == step && m.is_limit && m.utilisation; });
  if (limit != modes.end()) return *limit;
  if (best != nullptr) return *best;
  const auto proved = std::ranges::find_if(
      modes, [&](const Mode& m) { return m.step == step && m.state == State::pass && !m.utilisation; });
  return proved == modes.end() ? std::nullopt : std::optional(*proved);
}

/// Adds a step to the row of the same body; false where there is none.
bool join(const Component& part, std::vector<Component>& all) {
  const auto same = std::ranges::find_if(all, [&](const Component& other) { return other.name == part.name; });
  if (same == all.end()) return false;
  for (const std::string& size : part.sizes) {
    if (std::ranges::find(same->sizes, size) == same->sizes.end()) same->sizes.push_back(size);
  }
  same->is_sized = same->is_sized || part.is_sized;
  if (part.fails() > same->fails() || numerics::exceeds(part.utilisation(), same->utilisation()) ||
      std::isnan(same->utilisation()))
    same->governing = part.governing ? part.governing : same->governing;
  return true;
}

/// Failing rows, rows that were sized, then by falling utilisation.
bool is_before(const Component& a, const Component& b) {
  if (a.fails() != b.fails()) return a.fails();
  if (a.is_sized != b.is_sized) return a.is_sized;
  const auto rank = [](const Component& c) { return std::isnan(c.utilisation()) ? -1.0 : c.utilisation(); };
  return rank(a) > rank(b);
}

double highest_utilisation(const std::vector<Component>& components) {
  double most = -1.0;
  for (const Component& component : components)
    most = std::max(most, std::isnan(component.utilisation()) ? -1.0 : component.utilisation());
  return most;
}

std::string counts_of(const account::Conclusion& all, const std::vector<Component>& components) {
  const auto count_of = [&](Group group) { return std::to_string(all.count(group)); };
  const std::size_t outside = all.count(Group::outside_scope), needs = all.count(Group::needs_input);
  if (all.headline == account::Headline::fail) {
    const std::size_t total = all.modes() - all.count(Group::not_considered);
    std::string text = say(all.count(Group::fails) == 1 ? "{1} of {2} fails" : "{1} of {2} fail",
                           count_of(Group::fails), std::to_string(total))
                           .text();
    if (needs > 0)
      text += ", " + say(needs == 1 ? "{1} needs input" : "{1} need input", count_of(Group::needs_input)).text();
    if (outside > 0) text += ", " + say("{1} outside the scope", count_of(Group::outside_scope)).text();
    return text + ", " + say("{1} pass", count_of(Group::passes)).text();
  }
  std::string text = say("{1} pass", count_of(Group::passes)).text();
  if (needs > 0 && all.headline == account::Headline::no_solution)
    text += ", " + say("{1} have no result", count_of(Group::needs_input)).text();
  if (all.count(Group::accepted) > 0) text += ", " + say("{1} accepted", count_of(Group::accepted)).text();
  const double most = highest_utilisation(components);
  return most < 0.0 ? text : text + ", " + say("highest utilisation {1}", utilisation_text(most)).text();
}

std::string title_of(const Project& project, const account::Conclusion& all, const std::vector<Component>& components) {
  const std::string counts = all.modes() == 0 ? "" : counts_of(all, components);
  return project.title.empty() || counts.empty() ? project.title + counts : project.title + ": " + counts;
}

std::string governing_step(const Modes& sorted, const Project& project) {
  Modes own = sorted;
  std::erase_if(own, [](const Mode& mode) { return !is_told(mode); });
  if (const auto mode = explaining(own)) return mode->step;
  return sorted.empty() ? (project.steps.empty() ? "" : project.steps.front()->name()) : sorted.front().step;
}

}  // namespace

double Component::utilisation() const {
  return governing && governing->utilisation ? *governing->utilisation : std::numeric_limits<double>::quiet_NaN();
}

bool is_told(const Mode& mode) {
  return mode.subject == account::Subject::mode && !account::is_assessed_elsewhere(mode) && account::is_ranked(mode);
}

std::string component_name(const Step& step) {
  const std::string& body = step.input().body.text;
  return spoken(body.empty() ? step.name() : body);
}

std::string location_of(const Mode& mode) {
  if (mode.at) return short_quantity(mode.at->si, mode.at->unit);
  const bool is_of_list = std::ranges::count(mode.governs, '.') > 1;  // "safeties.key_end.u_D"
  const std::string owner = is_of_list ? owner_of(mode.governs) : std::string();
  return owner.find('[') == std::string::npos ? owner : std::string();
}

std::string plain_title(const Mode& mode) {
  constexpr std::string_view of_method = "validity: ";
  std::string title = mode.title.text();
  if (title.starts_with(of_method)) title.erase(0, of_method.size());
  const std::size_t end = std::min({title.find(" ("), title.find(':'), title.find(';')});
  return end == std::string::npos ? title : title.substr(0, end);
}

std::string subject_of(const Project& project) {
  if (project.steps.size() != 1) return "";
  const Step& step = *project.steps.front();
  const Calculator& calculator = *step.input().calculator;
  // A subject is claimed only if the first failure mode, which it is named for, was assessed.
  const bool is_assessed = std::ranges::any_of(step.account().modes, [&](const Mode& mode) {
    return !calculator.modes.empty() && mode.id == calculator.modes.front().id && mode.state == State::pass;
  });
  return is_assessed ? calculator.subject : "";
}

namespace {

Component component_of(const Step& step, const Modes& modes) {
  return {component_name(step), short_sizes(step), is_sized(step), details_of(step), governing_of(modes, step.name())};
}

/// The candidates nearest to passing, of a search without a result.
std::vector<account::TriedSize> tried_sizes(const Step& step) {
  for (const account::Entry& entry : step.account().inputs) {
    if (!entry.origin.tried.empty()) return entry.origin.tried;
  }
  return {};
}

/// What follows from the modes and the components.
void conclude(const Project& project, bool several, Summary& all) {
  for (const Mode& mode : all.modes) {
    if (mode.subject != account::Subject::search) continue;
    const Step* const step = project.find(mode.step);
    all.searches.push_back({mode.step + ": " + mode.note.text(),
                            step == nullptr ? std::vector<account::TriedSize>() : tried_sizes(*step)});
  }
  all.failures = failures_of(project, all.modes);
  all.gaps = gaps_of(project, all.modes, Group::needs_input);
  all.outside = gaps_of(project, all.modes, Group::outside_scope);
  all.open = not_considered(project, all.modes, several);
}

}  // namespace

std::vector<Component> components_of(const Project& project, const Modes& modes) {
  std::vector<Component> all;
  for (const auto& step : project.steps) {
    Component part = component_of(*step, modes);
    if (!step->input().body.text.empty() && join(part, all)) continue;
    if (!part.sizes.empty() || part.governing) all.push_back(std::move(part));
  }
  std::ranges::stable_sort(all, is_before);
  return all;
}

std::vector<NextOf> next_sizes(const Step& step) {
  std::vector<NextOf> all;
  for (const account::Entry* entry : chosen(step.account())) {
    if (!entry->origin.next) continue;
    const std::string owner = owner_of(entry->path);
    all.push_back({owner.empty() ? spoken(step.name()) : owner, *entry->origin.next});
  }
  return all;
}

Summary summarise(const Project& project) {
  Summary all;
  all.modes = project::modes(project);
  all.subject = subject_of(project);
  all.components = components_of(project, all.modes);
  all.title = title_of(project, account::conclude(all.modes), all.components);
  for (const auto& step : project.steps) {
    for (NextOf& next : next_sizes(*step)) all.next.push_back(std::move(next));
  }
  conclude(project, project.steps.size() > 1, all);
  all.governing_step = governing_step(account::in_order(all.modes), project);
  return all;
}

Summary summarise(const Project& project, const Step& step) {
  Summary all;
  all.modes = project::modes(project);
  std::erase_if(all.modes, [&](const Mode& mode) { return mode.step != step.name(); });
  const Calculator& calculator = *step.input().calculator;
  all.subject = calculator.subject;
  all.title = say("{1} ({2})", calculator.title, calculator.id).text();
  all.components = {component_of(step, all.modes)};
  all.next = next_sizes(step);
  conclude(project, false, all);
  all.governing_step = step.name();
  return all;
}

}  // namespace loadpath::report
