#include "lib/project/parts/heading.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/brief/brief.hpp"
#include "lib/report/brief/governing.hpp"
#include "lib/report/numbers/numbers.hpp"

#include <algorithm>
#include <filesystem>

namespace loadpath::report {

namespace {

using project::Project;

std::string heading_of(const Project& project, std::string_view key) {
  for (const auto& [name, text] : project.meta) {
    if (name == key) return text;
  }
  return {};
}

/// "belts, gears, shaft and 4 more"
std::string parts_of(const Project& project) {
  constexpr std::size_t most = 8;
  std::vector<std::string> names;
  for (const auto& step : project.steps) {
    std::string name = component_name(*step);
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  std::string all;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) all += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? say("{1} and {2} more", all, std::to_string(names.size() - most)).text() : all;
}

/// Modes that the headline is about: those that fail, else those that are not assessed, or outside the scope.
std::vector<std::string> concerned(const Summary& summary) {
  using account::Group;
  const bool fails = account::conclude(summary.modes).headline == account::Headline::fail;
  std::vector<std::string> names;
  for (const account::Mode& mode : account::in_order(summary.modes)) {
    const Group group = account::group_of(mode);
    const bool concerns = fails ? group == Group::fails : group == Group::needs_input || group == Group::outside_scope;
    if (mode.subject != account::Subject::mode || !concerns || account::is_assessed_elsewhere(mode)) continue;
    names.push_back(mode_name(mode));
    if (summary.components.size() > 1) names.back() += " (" + spoken(mode.step) + ")";
  }
  return names;
}

/// Their names where these are few.
std::string named(const Summary& summary) {
  constexpr std::size_t most = 4;
  const std::vector<std::string> names = concerned(summary);
  if (names.empty() || names.size() > most) return {};
  const bool has_comma =
      std::ranges::any_of(names, [](const std::string& name) { return name.find(',') != std::string::npos; });
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? ": " : has_comma ? "; " : ", ") + name;
  return all;
}

const Component* most_utilised_component(const Summary& summary) {
  const Component* most = nullptr;
  for (const Component& component : summary.components) {
    if (!(component.utilisation() >= 0.0)) continue;
    if (most == nullptr || component.utilisation() > most->utilisation()) most = &component;
  }
  return most;
}

/// "53 pass, 1 accepted by user, 33 not considered"
std::string counts_of(const account::Conclusion& all) {
  using account::Group;
  std::string text = say("{1} pass", std::to_string(all.count(Group::passes))).text();
  for (const auto& [group, words] : {std::pair{Group::needs_input, "{1} not assessed"},
                                     {Group::outside_scope, "{1} outside the scope"},
                                     {Group::accepted, "{1} accepted by user"},
                                     {Group::not_considered, "{1} not considered"}}) {
    const bool is_told_before =
        all.headline == account::Headline::incomplete && (group == Group::needs_input || group == Group::outside_scope);
    if (all.count(group) > 0 && !is_told_before) text += ", " + say(words, std::to_string(all.count(group))).text();
  }
  return text;
}

}  // namespace

TitleBlock title_block(const Project& project, const Summary& summary, const std::string& input) {
  constexpr std::size_t shown_digits = 8;
  const auto given = [&](const char* key) { return heading_of(project, key); };
  TitleBlock block;
  if (project.steps.size() > 1 && !summary.components.empty())
    block.subject.push_back({say("Components"), parts_of(project)});
  block.subject.push_back({say("Company"), given("company")});
  block.subject.push_back({say("Project"), given("project")});
  block.subject.push_back({say("Load case"), given("load_case")});
  for (const auto& [key, text] : project.meta) {
    if (!project::is_in_title_block(key)) block.subject.push_back({say("{1}", capitalised(spoken(key))), text});
  }
  if (project.strict)
    block.subject.push_back({say("Strict"), say("modes not considered count as not assessed").text()});
  block.number = {{say("Number"), given("number")},
                  {say("Revision"), given("revision")},
                  {say("Date"), given("date")},
                  {say("File"), std::filesystem::path(project.file).filename().string()},
                  {say("Input"), input.substr(0, shown_digits)}};
  block.signatures = {{say("Prepared"), given("prepared"), given("date")},
                      {say("Checked"), given("checked"), {}},
                      {say("Approved"), given("approved"), {}}};
  return block;
}

Finding finding_of(const Summary& summary) {
  constexpr std::size_t room = 240;
  const account::Conclusion all = account::conclude(summary.modes);
  const bool names_modes = all.headline == account::Headline::incomplete ||
                           (all.headline == account::Headline::fail && all.count(account::Group::fails) > 1);
  const std::string names = names_modes ? named(summary) : "";
  const std::size_t count = concerned(summary).size();
  const bool says_count = all.headline == account::Headline::fail && !names.empty() && count > 1;
  const Message reason = says_count ? say("{1} failure modes fail", std::to_string(count))
                                    : account::explanation(summary.modes, {room, summary.subject});
  Message text = say("{1}{2}. {3}", reason, names, capitalised(counts_of(all)));
  if (const Component* const most = most_utilised_component(summary))
    text = say("{1}; highest utilisation {2}: {3}, {4}", text, utilisation_text(most->utilisation()), most->name,
               mode_name(*most->governing));
  return {all.headline, account::overall(summary.modes), say("{1}.", text)};
}

}  // namespace loadpath::report
