#include "lib/account/conclusion.hpp"

#include "lib/numerics/magnitude.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/conclusion.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {

namespace {

/// "; 4 more rows: assessed by another step, counted there"
Message counted_there(const Modes& modes) {
  const auto count = std::ranges::count_if(
      modes, [](const Mode& mode) { return mode.subject == account::Subject::mode && !account::is_counted(mode); });
  if (count == 0) return {};
  return count == 1 ? say("; 1 more row: assessed by another step, counted there")
                    : say("; {1} more rows: assessed by another step, counted there", std::to_string(count));
}

}  // namespace

Message tally(const Modes& modes) {
  Modes sorted = account::in_order(modes);
  std::erase_if(sorted, [](const Mode& mode) { return !account::is_counted(mode); });
  std::string counts;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(),
                                   [&](const Mode& m) { return account::shown(m).id != account::shown(*first).id; });
    counts += (counts.empty() ? "" : ", ") + std::to_string(last - first) + " " + account::shown(*first).text();
    first = last;
  }
  const std::string all = sorted.size() == 1 ? say("1 failure mode").text()
                                             : say("{1} failure modes", std::to_string(sorted.size())).text();
  return say("{1}{2}{3}{4}.", all, counts.empty() ? "" : ": ", counts, counted_there(modes));
}

Message conclusion_of(const Modes& modes) {
  using account::Headline;
  const Headline headline = account::conclude(modes).headline;
  const bool is_counted = headline == Headline::pass || headline == Headline::incomplete;  // by the tally
  return is_counted ? tally(modes) : say("{1}. {2}", account::explanation(modes), tally(modes));
}

const Mode* most_utilised(const Modes& modes) {
  const auto rank = [](const Mode& mode) { return account::is_ranked(mode) ? mode.utilisation.value_or(-1.0) : -1.0; };
  const auto highest = std::max_element(
      modes.begin(), modes.end(), [&](const Mode& a, const Mode& b) { return numerics::exceeds(rank(b), rank(a)); });
  return highest != modes.end() && rank(*highest) >= 0.0 ? &*highest : nullptr;
}

Message utilisation(const Mode& mode) {
  return say("Highest utilisation {1}: {2}, {3}.", format_number(mode.utilisation.value_or(NAN), 3), mode.step,
             mode.title);
}

bool is_proved(const Mode& mode) { return mode.state == State::pass && !mode.utilisation; }

Modes doubtful(const Modes& modes) {
  Modes rows = account::in_order(modes);
  std::erase_if(rows, [](const Mode& mode) { return account::is_remote(mode) || mode.state == State::pass; });
  return rows;
}

Modes passing(const Modes& modes) {
  Modes rows = account::in_order(modes);
  std::erase_if(rows, [](const Mode& mode) { return mode.state != State::pass || is_proved(mode); });
  return rows;
}

namespace {

/// "lever: wear of pins, shaft: brittle fracture"
std::string names_of(const Modes& modes, bool (*is_meant)(const Mode&)) {
  std::string names;
  for (const Mode& mode : modes) {
    if (is_meant(mode)) names += (names.empty() ? "" : ", ") + mode.step + ": " + mode.title.text();
  }
  return names;
}

}  // namespace

Message proved(const Modes& modes) {
  const std::string names = names_of(modes, is_proved);
  return names.empty() ? Message{} : say("Excluded by geometry or validity checks: {1}.", names);
}

Message remote(const Modes& modes) {
  const std::string names = names_of(modes, account::is_remote);
  return names.empty() ? Message{} : say("Not considered (applicability not stated): {1}.", names);
}

std::string Numbering::heading(int level) {
  if (level <= 2) {
    parts_ = 0;
    return prefix_ + std::to_string(++sections_);
  }
  return prefix_ + std::to_string(sections_) + "." + std::to_string(++parts_);
}

void Numbering::begin_appendix() {
  prefix_ = "A";
  sections_ = parts_ = 0;
}

}  // namespace loadpath::report
