#include "lib/account/conclusion.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::account {

namespace {

bool is_search(const Mode& mode) { return mode.subject == Subject::search; }

std::size_t size_of(const Message& message) { return message.text().size(); }

/// The first of several wordings that has room, else the last.
Message first_in(std::size_t room, std::vector<Message> wordings) {
  for (Message& wording : wordings) {
    if (size_of(wording) <= room) return std::move(wording);
  }
  return std::move(wordings.back());
}

/// "45.3 / 42.3 kN"
Message compared_text(const Compared& both) {
  return say("{1} / {2}", format_number(in_unit(both.demand.si, both.demand.unit), 3),
             format_quantity(both.capacity.si, both.capacity.unit, 3));
}

/// "shaft: tooth root in bending, utilisation 1.07 (277 / 260 MPa)"
std::vector<Message> wordings_of(const Mode& mode, const std::string& subject) {
  const std::string step = subject.empty() ? mode.step + ": " : "";
  const Message part = say("{1}{2}", step, mode.title), brief = say("{1}{2}", step, short_title(mode));
  if (!mode.utilisation) return {part, brief};
  const std::string used = format_number(*mode.utilisation, 4);
  const Message whole = say("{1}, utilisation {2}", part, used);
  const Message shorter = say("{1}, utilisation {2}", brief, used);
  if (!mode.compared) return {whole, shorter, say("{1}utilisation {2}", step, used)};
  const Message both = compared_text(*mode.compared);
  return {say("{1} ({2})", whole, both), say("{1} ({2})", shorter, both), whole, shorter,
          say("{1}utilisation {2}", step, used)};
}

/// A mode assessed by another step is reported under that step.
Message of_failures(Modes sorted, const ExplanationOptions& options) {
  std::erase_if(sorted, [](const Mode& mode) { return is_assessed_elsewhere(mode); });
  const auto count = std::ranges::count(sorted, State::fail, &Mode::state);
  std::vector<Message> wordings = wordings_of(sorted.front(), options.subject);
  for (Message& wording : wordings) {
    if (count > 1) wording = say("{1}; and {2} more", wording, std::to_string(count - 1));
  }
  return first_in(options.room, std::move(wordings));
}

Message of_gaps(const Modes& sorted, const Conclusion& all, std::size_t room) {
  const std::size_t needs = all.count(Group::needs_input), outside = all.count(Group::outside_scope);
  if (needs + outside == 0) {  // only an input check prevents the verdict
    const Mode& check = sorted.front();
    return first_in(room, {say("{1}: {2}", check.step, reason(check)), say("{1}: {2}", check.step, check.title)});
  }
  const std::string total = std::to_string(all.modes() - all.count(Group::not_considered));
  const std::string first = std::to_string(needs), second = std::to_string(outside);
  if (needs == 0)
    return first_in(room, {say(outside == 1 ? "{1} of {2} failure modes is outside the scope of loadpath"
                                            : "{1} of {2} failure modes are outside the scope of loadpath",
                               second, total),
                           say("{1} of {2} failure modes outside the scope", second, total)});
  const std::string need = needs == 1 ? "needs" : "need";
  if (outside == 0)
    return first_in(room, {say("{1} of {2} failure modes {3} input or another step", first, total, need),
                           say("{1} of {2} failure modes {3} input", first, total, need)});
  return first_in(
      room, {say("{1} of {2} failure modes {4} input or a step, {3} outside the scope", first, total, second, need),
             say("{1} of {2} {4} input or a step, {3} outside", first, total, second, need)});
}

/// The strength modes that were not considered: fatigue first, then what a calculator assesses; if there is no such,
/// the rest.
std::vector<std::string> strength_not_considered(const Modes& sorted) {
  std::vector<std::string> assessable, rest;
  for (const Mode& mode : sorted) {
    if (mode.state != State::open || mode.kind != ModeKind::strength) continue;
    std::string name = short_title(mode);
    std::vector<std::string>& names = mode.is_assessable ? assessable : rest;
    if (std::ranges::find(names, name) != names.end()) continue;
    names.insert(name == "fatigue" ? names.begin() : names.end(), std::move(name));
  }
  return assessable.empty() ? rest : assessable;
}

/// As many names as have room: "fatigue, bending and 2 more not considered".
Message not_considered(const std::vector<std::string>& names, std::size_t room) {
  for (std::size_t count = names.size(); count > 0; --count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_last = i + 1 == names.size();
      all += (i == 0 ? "" : is_last ? " and " : ", ") + names[i];
    }
    if (count < names.size()) all += " and " + std::to_string(names.size() - count) + " more";
    const Message text = say("{1} not considered", all);
    if (size_of(text) <= room) return text;
  }
  return say("{1} not considered", std::to_string(names.size()));
}

/// The coverage of a pass, and its exclusions.
Message of_pass(const Modes& sorted, const Conclusion& all, const ExplanationOptions& options) {
  if (all.modes() == all.count(Group::not_considered)) return say("no failure mode is assessed here");
  const std::size_t passed = all.count(Group::passes) + all.count(Group::accepted);
  const auto left = strength_not_considered(sorted);
  const Message covered =
      passed == 1 ? say("1 failure mode assessed") : say("{1} failure modes assessed", std::to_string(passed));
  if (left.empty()) return covered;
  const Message first = options.subject.empty() ? covered : say("{1} only", options.subject);
  const std::size_t used = size_of(first) + 2;
  return say("{1}; {2}", first, not_considered(left, options.room > used ? options.room - used : 0));
}

}  // namespace

Group group_of(const Mode& mode) {
  switch (mode.state) {
    case State::fail:
      return Group::fails;
    case State::not_judged:
      return mode.is_assessable ? Group::needs_input : Group::outside_scope;
    case State::not_covered:
    case State::not_available:
      return Group::needs_input;
    case State::open:
      return Group::not_considered;
    case State::accepted:
      return Group::accepted;
    case State::pass:
      break;
  }
  return Group::passes;
}

const char* key(Group group) {
  constexpr std::array names{"fails", "needs_input", "outside_scope", "not_considered", "accepted", "passes"};
  static_assert(names.size() == all_groups.size());
  return names[static_cast<std::size_t>(group)];
}

const char* word(Headline headline) {
  constexpr std::array words{"PASS", "FAIL", "NO SOLUTION", "INCOMPLETE"};
  return words[static_cast<std::size_t>(headline)];
}

std::size_t Conclusion::modes() const { return std::accumulate(counts.begin(), counts.end(), std::size_t{0}); }

Conclusion conclude(const Modes& modes) {
  Conclusion all;
  for (const Mode& mode : modes) {
    if (is_counted(mode)) ++all.counts[static_cast<std::size_t>(group_of(mode))];
  }
  const State state = worst(modes);
  if (state == State::fail)
    all.headline = Headline::fail;
  else if (std::ranges::any_of(modes, is_search))
    all.headline = Headline::no_solution;
  else if (rank(state) > rank(State::open))
    all.headline = Headline::incomplete;
  return all;
}

bool is_assessed_elsewhere(const Mode& mode) {
  const bool waits = mode.state == State::open || mode.state == State::not_judged;
  return !waits && !mode.judge.empty() && mode.governs.empty();
}

bool is_counted(const Mode& mode) {
  const bool is_counted_there = is_assessed_elsewhere(mode) && (mode.state == State::pass || mode.state == State::fail);
  return mode.subject == Subject::mode && !is_counted_there;
}

bool is_ranked(const Mode& mode) {
  return mode.state == State::fail || (mode.kind != ModeKind::shape && !mode.is_limit);
}

std::string short_title(const Mode& mode) {
  const std::string title = mode.title.text();
  std::string first = title.substr(0, title.find_first_of(",:;("));
  first.resize(first.find_last_not_of(' ') + 1);
  return first;
}

Message explanation(const Modes& modes, const ExplanationOptions& options) {
  const Conclusion all = conclude(modes);
  const Modes sorted = in_order(modes);
  switch (all.headline) {
    case Headline::fail:
      return of_failures(sorted, options);
    case Headline::no_solution: {
      const Mode& search = *std::ranges::find_if(sorted, is_search);
      const std::string note = search.note.text();
      return first_in(options.room, {say("{1}: {2}", search.step, note),
                                     say("{1}: {2}", search.step, note.substr(0, note.find(", nearest"))),
                                     say("{1}: no size passes", search.step)});
    }
    case Headline::incomplete:
      return of_gaps(sorted, all, options.room);
    case Headline::pass:
      break;
  }
  return of_pass(sorted, all, options);
}

}  // namespace loadpath::account
