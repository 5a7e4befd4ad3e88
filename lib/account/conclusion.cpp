#include "lib/account/conclusion.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace loadpath::account {

namespace {

bool is_search(const Mode& mode) { return mode.subject == Subject::search; }

/// "shaft: tooth root in bending, utilisation 1.07"
Message told(const Mode& mode) {
  const Message part = say("{1}: {2}", mode.step, mode.title);
  return mode.utilisation ? say("{1}, utilisation {2}", part, format_number(*mode.utilisation, 4)) : part;
}

Message of_failures(const Modes& sorted, std::size_t count) {
  const Message first = told(sorted.front());
  return count > 1 ? say("{1}; and {2} more", first, std::to_string(count - 1)) : first;
}

Message of_gaps(const Modes& sorted, const Conclusion& all) {
  const std::size_t needs = all.count(Group::needs_input), outside = all.count(Group::outside_scope);
  if (needs + outside == 0) {  // only an input check prevents the verdict
    const auto check = std::ranges::find_if(sorted, [](const Mode& m) { return m.subject != Subject::mode; });
    return check == sorted.end() ? Message{} : say("{1}: {2}", check->step, reason(*check));
  }
  const std::string total = std::to_string(all.modes());
  if (needs == 0) return say("{1} of {2} failure modes outside the scope of loadpath", std::to_string(outside), total);
  const Message needed = say("{1} of {2} failure modes need input or another step", std::to_string(needs), total);
  return outside == 0 ? needed : say("{1}, {2} outside the scope", needed, std::to_string(outside));
}

/// "fatigue" of "fatigue (shoulders, keyways, press fits)".
std::string short_title(const Mode& mode) {
  const std::string title = mode.title.text();
  return title.substr(0, title.find_first_of(",:;("));
}

/// The strength modes that were not considered, fatigue first: as many as one line has room for.
std::string not_considered(const Modes& sorted) {
  constexpr std::size_t room = 60;
  std::vector<std::string> names;
  for (const Mode& mode : sorted) {
    if (mode.state != State::open || mode.kind != ModeKind::strength) continue;
    std::string name = short_title(mode);
    if (std::ranges::find(names, name) != names.end()) continue;
    names.insert(name == "fatigue" ? names.begin() : names.end(), std::move(name));
  }
  std::string all;
  std::size_t told = 0;
  for (; told < names.size() && (told == 0 || all.size() + names[told].size() < room); ++told)
    all += (told == 0 ? "" : ", ") + names[told];
  return told == names.size() ? all : all + " and " + std::to_string(names.size() - told) + " more";
}

/// The coverage of a pass, and its exclusions.
Message of_pass(const Modes& sorted, const Conclusion& all) {
  if (all.modes() == all.count(Group::not_considered)) return say("no failure mode is assessed here");
  const Message passed =
      say("{1} of {2} failure modes assessed", std::to_string(all.count(Group::passes) + all.count(Group::accepted)),
          std::to_string(all.modes()));
  const std::string left = not_considered(sorted);
  return left.empty() ? passed : say("{1}; not considered: {2}", passed, left);
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
    if (mode.subject == Subject::mode) ++all.counts[static_cast<std::size_t>(group_of(mode))];
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

Message explanation(const Modes& modes) {
  const Conclusion all = conclude(modes);
  const Modes sorted = in_order(modes);
  switch (all.headline) {
    case Headline::fail:
      return of_failures(sorted, all.count(Group::fails));
    case Headline::no_solution: {
      const Mode& search = *std::ranges::find_if(sorted, is_search);
      return say("{1}: {2}", search.step, search.note);
    }
    case Headline::incomplete:
      return of_gaps(sorted, all);
    case Headline::pass:
      break;
  }
  return of_pass(sorted, all);
}

}  // namespace loadpath::account
