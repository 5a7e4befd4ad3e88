#include "lib/project/modes.hpp"

#include "lib/numerics/magnitude.hpp"
#include "lib/project/accept.hpp"
#include "lib/project/still_wanted.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace loadpath::project {

using account::State;

namespace {

/// The row or mode that decides: of the worst ones the most utilised, of those alike the first.
template <class Row>
const Row& governing(const std::vector<const Row*>& rows) {
  return **std::max_element(rows.begin(), rows.end(), [](const Row* a, const Row* b) {
    if (a->state != b->state) return rank(a->state) < rank(b->state);
    return numerics::exceeds(b->utilisation.value_or(-1.0), a->utilisation.value_or(-1.0));
  });
}

/// Their largest utilisation, to the last bit.
template <class Row>
std::optional<double> utilisation_of(const std::vector<const Row*>& rows) {
  const State state = governing(rows).state;
  std::optional<double> most;
  for (const Row* row : rows) {
    if (row->state == state) most = std::max(most, row->utilisation);
  }
  return most;
}

/// The state of a mode without any check.
State unjudged(const ModeInfo& mode, Applies applies) {
  const bool waits = mode.kind == ModeKind::service || applies == Applies::unseen;
  return waits ? State::open : State::not_judged;
}

/// "=epi.sun_mesh and =epi.ring_mesh", "each of =shaft.bearings": the records that an assessing step takes.
std::string records_of(const ModeInfo& left, std::span<const FieldInfo> fields, const std::string& part) {
  std::string all;
  for (const std::string& key : listed_keys(left.taken)) {
    const std::string name = key.substr(0, key.find('.'));
    const FieldInfo* const field = find_field(fields, name);
    const bool is_list = field != nullptr && field->type == FieldInfo::Type::list;
    const std::string record = std::string(is_list ? "each of =" : "=").append(part).append(".").append(name);
    if (all.find(record) == std::string::npos) all += (all.empty() ? "" : " and ") + record;
  }
  return all;
}

const ModeInfo* info_of(const Step& step, const std::string& mode) {
  const auto& all = step.input().calculator->modes;
  const auto found = std::find_if(all.begin(), all.end(), [&](const ModeInfo& info) { return mode == info.id; });
  return found == all.end() ? nullptr : &*found;
}

/// Equal but for rounding: the value typed instead may be the same.
bool is_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return x == y || std::abs(x - y) <= 1e-9 * std::max(std::abs(x), std::abs(y));
  });
}

/// Whether an input of the assessing step has the value of the part; values that the part leaves open are its own.
/// `prefix`: the fields that the record fills, "notches[2].", and the path before their keys.
bool agrees(const Step& judge, const std::string& prefix, const Step& part, const Member& member) {
  const auto& inputs = judge.account().inputs;
  const std::string path = prefix + member.key;
  const auto input = std::find_if(inputs.begin(), inputs.end(), [&](const Entry& entry) { return entry.path == path; });
  const bool has_field = find_field_at(judge.input().calculator->input->fields, path) != nullptr;
  if (member.is_word) {
    const std::string word = part.word(member.path);
    return !has_field || word.empty() || judge.word(path) == word;
  }
  const Value* const given = part.value(member.path);
  const bool open = given == nullptr || std::ranges::all_of(given->si, [](double x) { return std::isnan(x); });
  return !has_field || open || (input != inputs.end() && is_same(input->values().si, given->si));
}

/// The names of a record of a part: an element of a list by its index, and by its name.
using Names = std::vector<std::string>;

/// The records behind a key: the one of that name, or every element of the list of that name.
std::vector<Names> records_behind(const Step& part, const std::string& key) {
  const FieldInfo* const field = find_field(part.input().calculator->result->fields, key);
  if (field == nullptr || field->type != FieldInfo::Type::list) return {{key}};
  std::vector<Names> all;
  for (const auto& [path, entry] : part.within(key)) {  // ".left.F_r", "[1].F_r"
    const std::string element = key + path.substr(0, path.find('.', 1));
    if (!all.empty() && all.back().front() == element) continue;
    all.push_back({element, key + "[" + std::to_string(all.size() + 1) + "]"});
  }
  return all;
}

/// Whether the step has taken a record of the part, and kept it: a typed replacement may be another part.
bool takes(const Step& judge, const Step& part, const Names& record) {
  const auto members = part.members(record.front());
  const auto& records = judge.input().reading.records;
  return std::any_of(records.begin(), records.end(), [&](const Taken& taken) {
    const std::string prefix = taken.path.substr(0, taken.path.rfind('.') + 1);
    const bool named = std::any_of(record.begin(), record.end(),
                                   [&](const std::string& name) { return taken.source == part.name() + "." + name; });
    return named &&
           std::all_of(members.begin(), members.end(), [&](const Member& m) { return agrees(judge, prefix, part, m); });
  });
}

/// The modes of a calculator's steps that assess a mode left to it. A record that no such step takes, or of which
/// none of these modes concerns the step, leaves all of it open: the result is empty.
std::vector<const account::Mode*> judges_of(const ModeInfo& left, const Step& part, const Project& project) {
  std::vector<const account::Mode*> judges;
  std::map<std::string, bool> judged;  // each record by one mode at least
  for (const std::string& key : listed_keys(left.taken)) {
    const std::size_t dot = key.find('.');
    for (const Names& record : records_behind(part, key.substr(0, dot))) {
      bool taken = false, &any = judged[record.front()];
      for (const auto& step : project.steps) {
        if (step->input().calculator->id != std::string_view(left.judge) || !takes(*step, part, record)) continue;
        taken = true;
        for (const account::Mode& mode : step->account().modes) {
          if (mode.id != key.substr(dot + 1)) continue;
          judges.push_back(&mode);
          any = true;
        }
      }
      if (!taken) return {};
    }
  }
  if (std::any_of(judged.begin(), judged.end(), [](const auto& record) { return !record.second; })) return {};
  return judges;
}

/// The extremes of a series.
struct Swing {
  double least, most;
};
std::optional<Swing> swing_of(const Step& part, const std::string& key) {
  const Value* const value = part.value(key);
  if (value == nullptr || value->si.empty()) return std::nullopt;
  const auto [least, most] = std::minmax_element(value->si.begin(), value->si.end());
  return Swing{*least, *most};
}

/// Whether a cycle is at most as severe as another one.
bool is_within(const Swing& a, const Swing& b) {
  const double rounding = 1e-9 * std::max(std::abs(b.least), std::abs(b.most));
  return a.most <= b.most + rounding && a.most - a.least <= b.most - b.least + rounding;
}

/// Whether a step takes a series of the part as it is.
bool counts(const Step& judge, const Step& part, const std::string& key) {
  const auto& operands = judge.input().reading.operands;
  return std::any_of(operands.begin(), operands.end(), [&](const Operand& operand) {
    return operand.leaf.field->takes_whole() && operand.expression.is_reference() &&
           operand.expression.references().front().path == part.name() + "." + key;
  });
}

/// The modes of steps that count a series of the part; empty if another of its series is more severe.
std::vector<const account::Mode*> counters_of(const ModeInfo& left, const Step& part, const Project& project) {
  std::vector<const account::Mode*> judges;
  std::vector<Swing> taken;
  const auto series = listed_keys(left.counted);
  for (const auto& step : project.steps) {
    if (step->input().calculator->id != std::string_view(left.counter)) continue;
    for (const std::string& key : series) {
      const auto swing = swing_of(part, key);
      if (!swing || !counts(*step, part, key)) continue;
      taken.push_back(*swing);
      for (const account::Mode& mode : step->account().modes) {
        if (mode.id == left.id) judges.push_back(&mode);
      }
    }
  }
  const bool covers = std::all_of(series.begin(), series.end(), [&](const std::string& key) {
    const auto swing = swing_of(part, key);
    return swing && std::any_of(taken.begin(), taken.end(), [&](const Swing& one) { return is_within(*swing, one); });
  });
  return covers ? judges : std::vector<const account::Mode*>{};
}

}  // namespace

void settle(account::Mode& mode, const std::vector<const account::Mode*>& judges) {
  const account::Mode& worst = governing(judges);
  // An assessing step without information on the service does not override that of the part.
  const bool weaker = mode.state != State::open && worst.state == State::open;
  if (!weaker) mode.state = worst.state;
  mode.utilisation = utilisation_of(judges);
  mode.wants.clear();
  mode.governs.clear();
  mode.compared = worst.compared;
  mode.at = worst.at;
  mode.note = say("by {1}.{2}: {3}", worst.step, worst.id, reason(worst));
}

namespace {

/// The field that a key of a mode names: "u_tau", "segments.u_tau".
const FieldInfo* field_of(const RecordType& result, std::string_view key) {
  const std::size_t dot = key.find('.');
  const FieldInfo* field = find_field(result.fields, key.substr(0, dot));
  return field == nullptr || dot == std::string_view::npos ? field : find_field(field->fields, key.substr(dot + 1));
}

void add_words(std::string_view words, std::string& to) {
  if (!words.empty() && to.find(words) == std::string::npos) to += (to.empty() ? "" : ", ") + std::string(words);
}

/// Whether a mode of strength, or one of service with a limit, rests on a load that is less than its series.
bool is_doubtful(const Step& step, const ModeInfo& info, const CheckNeeds& needs) {
  const bool is_bounded = info.kind == ModeKind::service && needs.needs_checks && needs.wants.empty();
  return (info.kind == ModeKind::strength || is_bounded) && !step.loads().reduced.empty();
}

/// A mode that no calculator can assess, as the part does not hand over the record.
void leave_out_of_scope(const ModeInfo& left, const Step& part, account::Mode& mode) {
  const std::string taken = left.taken;
  if (part.has_values(taken.substr(0, taken.find('.')))) return;
  mode.judge.clear(), mode.note = {}, mode.is_assessable = false;
}

/// Whether a mode waits for the reason of a load, or of a size that goes with the record.
bool is_contested(const account::Mode& mode, const ModeInfo& left, const Step& part) {
  constexpr std::string_view because = "because.";
  if (!mode.wants.starts_with(because)) return false;
  const std::string key = mode.wants.substr(because.size());
  if (const auto* const field = find_field(part.input().calculator->input->fields, key); field && field->is_load)
    return true;
  return std::ranges::any_of(listed_keys(left.taken), [&](const std::string& record) {
    return std::ranges::count(part.members(record.substr(0, record.find('.'))), key, &Member::key) != 0;
  });
}

}  // namespace

void settle_left(Project& project) {
  for (auto part = project.order.rbegin(); part != project.order.rend(); ++part) {  // assesses first
    Step& step = *project.steps[*part];
    for (account::Mode& mode : step.modes()) {
      const ModeInfo* const info = info_of(step, mode.id);
      const bool waits =
          mode.state == State::open || mode.state == State::not_judged || mode.state == State::not_covered;
      if (info == nullptr || *info->judge == '\0' || !waits || is_contested(mode, *info, step)) continue;
      auto judges = judges_of(*info, step, project);
      if (judges.empty() && *info->counter != '\0') judges = counters_of(*info, step, project);
      if (!judges.empty())
        settle(mode, judges);
      else if (info->by_record && mode.state == State::not_judged && mode.wants.empty())
        leave_out_of_scope(*info, step, mode);
    }
  }
}

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

CheckNeeds needs_of(const ModeInfo& mode, const RecordType& result,
                    const std::function<bool(const FieldInfo&)>& is_asked) {
  CheckNeeds needs;
  for (const std::string& key : listed_keys(mode.checks)) {
    const FieldInfo* const field = field_of(result, key);
    if (field == nullptr || field->role != Role::check) continue;
    needs.needs_checks = true;
    if (!is_asked(*field)) add_words(field->asked_by, needs.wants);
  }
  return needs;
}

account::Unjudged unjudged_of(const Step& step, const ModeInfo& info, const CheckNeeds& needs) {
  const bool doubtful = is_doubtful(step, info, needs);
  const bool shows_service = (info.by_rest && !step.loads().left.empty()) || (info.by_service && step.loads().vary);
  account::Unjudged by{.needs_checks = needs.needs_checks, .never = doubtful || !needs.wants.empty()};
  for (const Applies applies : {Applies::no, Applies::unseen, Applies::yes}) {
    const Applies when = applies == Applies::unseen && shows_service ? Applies::yes : applies;
    const State state = doubtful && applies != Applies::no ? State::not_judged : unjudged(info, when);
    by.state[static_cast<std::size_t>(applies)] = account::number(state);
  }
  // A check passed under a load without its factor may fail under the full load.
  if (info.kind == ModeKind::strength && !step.loads().missing_factor.empty())
    by.passed = account::number(State::not_judged);
  return by;
}

namespace {

account::Folded folded(const std::vector<const account::Verdict*>& rows) {
  account::Folded all;
  for (const account::Verdict* row : rows)
    all = all.with_row(account::number(row->state), row->utilisation.value_or(NAN), row->utilisation.has_value());
  return all;
}

/// The missing inputs for the mode, or the reason why it may apply, if its rows do not decide it.
void explain_unjudged(const Step& step, const ModeInfo& info, const std::vector<const account::Verdict*>& rows,
                      const CheckNeeds& needs, account::Mode& mode) {
  mode.wants = needs.wants.empty() ? still_wanted(step, info.wants) : needs.wants;
  if (mode.wants.empty() && mode.state != State::open) mode.wants = wanted_by_limits(step, info);
  mode.judge = info.judge, mode.use = info.use, mode.add = info.add;
  if (!mode.wants.empty() && *info.request != '\0')
    mode.note = say(info.request);
  else if (mode.wants.empty() && *info.advice != '\0')
    mode.note = say(info.advice);
  else if (mode.wants.empty() && *info.checks != '\0')
    mode.note = say("{1} has no value here", info.checks);
  if (mode.state == State::not_judged && *info.judge != '\0') {
    const std::string records = records_of(info, step.input().calculator->result->fields, step.name());
    mode.note = mode.wants.empty()
                    ? say("add a step of {1} that takes {2}", info.judge, records)
                    : say("give {1}, or add a step of {3} that takes {2}", mode.wants, records, info.judge);
  }
  const bool passes = !rows.empty() && governing(rows).state == State::pass;
  if (passes && !step.loads().missing_factor.empty()) {
    mode.wants.clear();
    mode.note = step.loads().missing_factor;
  }
  if (info.by_rest && !step.loads().left.empty()) {
    mode.note = *info.use != '\0'
                    ? say("acting with the load: {1}; replace with a step of {2}, or assess them separately: "
                          "accept.{3} = \"...\"",
                          step.loads().left, info.use, info.id)
                    : say("acting with the load: {1}; assess them separately: accept.{2} = \"...\"", step.loads().left,
                          info.id);
  }
  // A row that assesses nothing says itself why.
  if (!rows.empty() && governing(rows).state == mode.state) mode.note = governing(rows).note, mode.wants.clear();
  if (mode.state == State::not_judged && is_doubtful(step, info, needs)) {
    mode.wants.clear();
    mode.use.clear(), mode.add.clear();  // another step does not answer for the value
    mode.note = step.loads().reduced.front().message;
  }
}

void explain_decided(const std::vector<const account::Verdict*>& rows, const LessConservative& bolder,
                     account::Mode& mode) {
  mode.governs = governing(rows).symbol;
  mode.compared = governing(rows).compared;
  mode.at = governing(rows).at;
  mode.note = governing(rows).note;
  if (!bolder.why.empty())
    mode.note = mode.note.empty() ? say("with {1}", bolder.why) : say("{1}, with {2}", mode.note, bolder.why);
}

}  // namespace

std::optional<account::Mode> judged(const Step& step, const ModeInfo& info, Applies applies,
                                    const std::vector<const account::Verdict*>& rows, const CheckNeeds& needs,
                                    const LessConservative& bolder) {
  account::Mode mode;
  mode.step = step.name();
  mode.id = info.id;
  mode.title = say(info.title);
  mode.kind = info.kind;
  mode.is_limit = info.is_limit;
  const account::Judged came =
      account::judged(folded(rows), static_cast<double>(static_cast<int>(applies)), unjudged_of(step, info, needs));
  if (came.state == account::absent_state) return std::nullopt;
  mode.state = account::state_of(came.state);
  mode.is_assessable = is_assessable(info);
  if (!std::isnan(came.utilisation)) mode.utilisation = came.utilisation;
  if (!bolder.wants.empty() && mode.state == State::pass) {
    mode.state = State::not_judged;
    mode.utilisation.reset();
    mode.wants = bolder.wants;
    mode.note = bolder.why;
  } else if (mode.state == State::open || mode.state == State::not_judged) {
    explain_unjudged(step, info, rows, needs, mode);
  } else {
    explain_decided(rows, bolder, mode);
    if (mode.state == State::not_covered) mode.use = info.use;
  }
  accept(step.input(), mode);
  return mode;
}

}  // namespace loadpath::project
