#include "lib/report/brief/fields.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/appendix.hpp"
#include "lib/report/brief/governing.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/numbers/numbers.hpp"

#include <algorithm>
#include <map>

namespace loadpath::report {

namespace {

using account::Entry;
using account::Mode;

constexpr std::size_t most_entries = 4;  // in a field

Panel field(Message title, Message remark, std::vector<Message> lines) {
  Panel panel{std::move(title), std::move(remark), {}};
  if (lines.empty()) lines.push_back(say("None."));
  const std::size_t left = lines.size() - std::min(lines.size(), most_entries);
  if (left > 0) lines.resize(most_entries), lines.push_back(say("{1} more: appendix.", std::to_string(left)));
  for (Message& line : lines) panel.blocks.emplace_back(Paragraph{std::move(line)});
  return panel;
}

std::vector<Message> lines_of(const std::vector<Gap>& gaps) {
  std::vector<Message> lines;
  for (const Gap& gap : gaps) {
    const std::string modes = modes_text(gap);
    lines.push_back(gap.action.spoken.empty() ? say("{1}.", modes) : say("{1}: {2}.", modes, gap.action.spoken));
  }
  return lines;
}

/// "K_A 1.25 (belts, gears)": equal factors of several steps are one.
std::vector<std::string> factors_of(const project::Project& project, bool assumed) {
  constexpr std::size_t most_steps = 3;
  std::vector<std::pair<std::string, std::string>> all;  // factor, steps
  std::map<std::string, std::size_t> count;
  for (const AppliedFactor& factor : applied_factors(project)) {
    if (factor.entry->origin.assumed != assumed || !is_available(*factor.entry)) continue;
    const std::string text = short_symbol(factor.entry->path) + "\u00A0" + short_value(*factor.entry);
    const std::string name = component_name(*factor.step);
    const auto known = std::ranges::find(all, text, &std::pair<std::string, std::string>::first);
    if (known == all.end())
      all.emplace_back(text, name);
    else if (known->second.find(name) == std::string::npos && ++count[text] < most_steps)
      known->second += ", " + name;
  }
  for (auto& [text, steps] : all) {
    if (const std::size_t more = count[text] + 1; more > most_steps)
      steps += ", " + say("{1} more", std::to_string(more - most_steps)).text();
  }
  std::vector<std::string> texts(all.size());
  std::ranges::transform(all, texts.begin(), [&](const auto& of) {
    return project.steps.size() > 1 ? std::string(of.first).append(" (").append(of.second).append(")") : of.first;
  });
  return texts;
}

/// Inputs whose source was not seen, with their steps.
std::vector<std::string> recalled_inputs(const project::Project& project) {
  std::vector<std::string> all;
  for (const auto& step : project.steps) {
    for (const Entry& entry : step->account().inputs) {
      if (!entry.origin.recalled) continue;
      std::string text = component_name(*step) + ": " + short_name(entry);
      for (const std::string& key : entry.origin.sources) text += " [" + key + "]";
      if (std::ranges::find(all, text) == all.end()) all.push_back(std::move(text));
    }
  }
  return all;
}

void add_list(const char* heading, const std::vector<std::string>& texts, std::size_t most, Panel& panel) {
  if (texts.empty()) return;
  std::string all;
  for (std::size_t i = 0; i < std::min(most, texts.size()); ++i) all += (i == 0 ? "" : "; ") + texts[i];
  if (texts.size() > most) all += "; " + say("{1} more", std::to_string(texts.size() - most)).text();
  panel.blocks.emplace_back(Paragraph{say("{1}: {2}.", say("{1}", heading), all)});
}

}  // namespace

Panel outside_scope(const Summary& summary) {
  return field(say("Outside the scope of loadpath"), say("assess by hand"), lines_of(summary.outside));
}

Panel accepted_by_user(const Summary& summary, const project::Project& project) {
  std::vector<Message> lines;
  for (const Mode& mode : summary.modes) {
    if (mode.state != account::State::accepted) continue;
    lines.push_back(say("{1}, {2}: {3}.", spoken(mode.step), plain_title(mode), mode.note));
  }
  for (const auto& step : project.steps) {
    for (const Justified& value : justified_values(*step))
      lines.push_back(say("{1}, {2}: {3}.", spoken(step->name()), value.name(), value.reason));
  }
  return field(say("Accepted by user"), {}, std::move(lines));
}

Panel not_assessed(const Summary& summary) {
  std::vector<Message> lines;
  for (const FailedSearch& search : summary.searches) {
    lines.push_back(say("No solution: {1}.", search.text));
    if (search.tried.size() < 2) continue;
    for (const account::TriedSize& tried : search.tried) lines.push_back(say("{1}.", failure_text(tried)));
  }
  for (Message& line : lines_of(summary.gaps)) lines.push_back(std::move(line));
  return field(say("Not assessed"), say("give the input, or the step"), std::move(lines));
}

namespace {

/// By name where they are few, or follow no strength modes, else their number.
std::string rest_of_modes(const NotConsidered& open, bool follow_others) {
  constexpr std::size_t most_named = 2;
  if (!follow_others || open.other_names.size() <= most_named) return other_modes(open);
  return say("{1} others", std::to_string(open.others)).text();
}

}  // namespace

Panel not_considered(const Summary& summary) {
  constexpr std::size_t most_names = 7, most_hints = 2;
  const NotConsidered& open = summary.open;
  if (open.names.empty() && open.others == 0) return field(say("Not considered"), {}, {});
  std::string text;
  for (std::size_t i = 0; i < std::min(most_names, open.names.size()); ++i)
    text += (i == 0 ? "" : ", ") + open.names[i];
  if (const std::size_t rest = open.names.size() - std::min(most_names, open.names.size()); rest > 0)
    text +=
        "; " + (rest == 1 ? say("1 more strength mode") : say("{1} more strength modes", std::to_string(rest))).text();
  if (open.others > 0) text += (text.empty() ? "" : "; ") + rest_of_modes(open, !text.empty());
  std::vector<Message> lines{say("{1}.", capitalised(text))};
  for (std::size_t i = 0; i < std::min(most_hints, open.hints.size()); ++i)
    lines.push_back(say("{1}.", capitalised(open.hints[i].spoken)));
  return field(say("Not considered"), {}, std::move(lines));
}

Panel assumptions(const project::Project& project) {
  constexpr std::size_t most_factors = 12, most_defaults = 8, most_recalled = 3, most_warnings = 2;
  Panel panel{say("Assumptions"), {}, {}};
  add_list("Factors, each applied once", factors_of(project, false), most_factors, panel);
  add_list("Factors by default", factors_of(project, true), most_defaults, panel);
  add_list("Not checked against the source", recalled_inputs(project), most_recalled, panel);
  std::vector<std::string> warnings;
  for (const auto& step : project.steps) {
    for (const Message& warning : step->account().warnings)
      warnings.push_back(component_name(*step) + ": " + with_greek(warning.text()));
  }
  add_list("Warnings", warnings, most_warnings, panel);
  if (panel.blocks.empty()) panel.blocks.emplace_back(Paragraph{say("None.")});
  return panel;
}

}  // namespace loadpath::report
