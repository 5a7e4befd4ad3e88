#include "lib/project/modes.hpp"

#include "lib/project/accept.hpp"

#include <algorithm>

namespace loadpath::project {

using account::State;

namespace {

/// The row that decides: of the worst ones the most utilised.
const account::Verdict& governing(const std::vector<const account::Verdict*>& rows) {
  return **std::max_element(rows.begin(), rows.end(), [](const auto* a, const auto* b) {
    if (a->state != b->state) return rank(a->state) < rank(b->state);
    return a->utilisation.value_or(-1.0) < b->utilisation.value_or(-1.0);
  });
}

/// What is said of a mode that nothing was held against.
State unjudged(const ModeInfo& mode, Applies applies) {
  const bool waits = mode.kind == ModeKind::service || applies == Applies::unseen;
  return waits ? State::open : State::not_judged;
}

}  // namespace

bool names_row(std::string_view key, std::string_view symbol) {
  if (key.ends_with('*')) return symbol.starts_with(key.substr(0, key.size() - 1));
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return key == symbol;
  const bool in_list =
      symbol.size() > dot && symbol.starts_with(key.substr(0, dot)) && (symbol[dot] == '[' || symbol[dot] == '.');
  return in_list && symbol.ends_with(key.substr(dot));
}

std::vector<const account::Verdict*> rows_of(const ModeInfo& mode, const std::vector<account::Verdict>& all) {
  std::vector<const account::Verdict*> rows;
  for (const std::string& key : listed_keys(mode.checks)) {
    for (const account::Verdict& row : all) {
      if (names_row(key, row.symbol)) rows.push_back(&row);
    }
  }
  return rows;
}

account::Mode judged(const Step& step, const ModeInfo& info, Applies applies,
                     const std::vector<const account::Verdict*>& rows, std::string wants, bool enough) {
  const bool rest = info.by_rest && !step.left_of_loads().empty();
  if (applies == Applies::unseen && (rest || (info.by_service && step.load_varies()))) applies = Applies::yes;
  account::Mode mode;
  mode.step = step.name();
  mode.id = info.id;
  mode.title = say(info.title);
  mode.kind = info.kind;
  mode.state = rows.empty() ? unjudged(info, applies) : governing(rows).state;
  if (mode.state == State::pass && !enough) mode.state = unjudged(info, applies);
  if (mode.state == State::open || mode.state == State::not_judged) {
    mode.wants = wants.empty() ? info.wants : std::move(wants);
    mode.judge = info.judge;
    if (mode.wants.empty() && *info.checks != '\0') mode.note = say("{1} has no value here", info.checks);
    if (rest)
      mode.note = say("not taken, though it comes with the load: {1}; judge it by hand: accept.{2} = \"...\"",
                      step.left_of_loads(), info.id);
  } else {
    mode.governs = governing(rows).symbol;
    mode.utilisation = governing(rows).utilisation;
    mode.note = governing(rows).note;
  }
  accept(step.input(), mode);
  return mode;
}

}  // namespace loadpath::project
