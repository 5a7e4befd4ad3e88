// Which modes of failure concern the part of a run, and what its checks and limits say of them.
#include "lib/project/modes.hpp"

#include "lib/project/run/run.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

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

}  // namespace

void Run::ask_modes() {
  for (std::size_t k = 0; k < calculator_.modes.size(); ++k)
    applies_[k] = std::max(applies_[k], calculator_.applies(k, record_.data.get()));
}

void Run::doubt_modes() {
  for (Applies& applies : applies_) applies = std::max(applies, Applies::unseen);
}

/// Whether a mode that passes is judged by that: no check of it is missing, and one there is, unless limits alone judge
/// it. A limit without its input does not apply. `wants` takes what asks for the checks that are missing.
bool Run::is_judged(const ModeInfo& mode, const Account& account, std::string& wants) const {
  bool by_checks = false, checked = false;
  for (const std::string& key : listed_keys(mode.checks)) {
    const FieldInfo* const field = field_of(*calculator_.result, key);
    if (field == nullptr || field->role != Role::check) continue;
    by_checks = true;
    const bool shown = std::any_of(account.verdicts.begin(), account.verdicts.end(),
                                   [&](const auto& row) { return names_row(key, row.symbol); });
    checked = checked || shown;
    if (!shown && !is_asked(*field)) add_words(field->asked_by, wants);
  }
  return wants.empty() && (checked || !by_checks);
}

/// A step that has no results for want of an input has not been judged at all.
void Run::add_missing_input(Account& account) const {
  const Message missing = missing_input();
  if (!columns_.empty() || missing.empty()) return;
  account::Mode mode;
  mode.step = step_.name();
  mode.id = "inputs";
  mode.title = say("every input has a value");
  mode.kind = ModeKind::shape;
  mode.state = account::State::not_available;
  mode.note = missing;
  account.modes.push_back(std::move(mode));
}

/// Whether a load of the step is anything but zero anywhere; of a formula no one knows.
bool Run::is_loaded() const {
  bool loaded = false;
  for_each_leaf(record_, [&](const std::string&, const Leaf& leaf) {
    if (leaf.field->is_load && (leaf.field->get == nullptr || acts(leaf.get()))) loaded = true;
  });
  return loaded || std::any_of(inputs_.begin(), inputs_.end(), [](const Input& input) {
           const auto& si = input.value.si;
           return input.leaf.field->is_load && std::any_of(si.begin(), si.end(), acts);
         });
}

/// Whether a load is told at all; what is left out, or is zero where nobody says else, asks for no verdict on loads.
bool Run::is_load_told() const {
  bool told = false;
  for_each_leaf(record_, [&](const std::string& path, const Leaf& leaf) {
    told = told || (leaf.field->is_load && step_.input().reading.typed.contains(path));
  });
  return told;
}

/// What holds without a load has not been judged under one: a reference may bring none by mistake. What another load
/// than those that are declared has utilised, a liquid, its own speed, is loaded.
void Run::add_missing_load(Account& account) const {
  const auto is_strength = [](const ModeInfo& mode) { return mode.kind == ModeKind::strength; };
  const auto is_utilised = [](const account::Verdict* row) { return row->utilisation && *row->utilisation > 0.0; };
  const auto bears = [&](const ModeInfo& mode) {
    const auto rows = rows_of(mode, account.verdicts);
    return is_strength(mode) && std::any_of(rows.begin(), rows.end(), is_utilised);
  };
  if (columns_.empty() || !is_load_told() || is_loaded()) return;
  if (std::none_of(calculator_.modes.begin(), calculator_.modes.end(), is_strength)) return;
  if (std::any_of(calculator_.modes.begin(), calculator_.modes.end(), bears)) return;
  account::Mode mode;
  mode.step = step_.name();
  mode.id = "load";
  mode.title = say("a load that is not zero");
  mode.note = say("every load is zero: nothing is judged that a load could break");
  account.modes.push_back(std::move(mode));
}

/// A value that nothing here is held against goes on to other steps: what they say with it is no verdict.
void Run::add_bolder(Account& account) const {
  if (handed_on_.empty()) return;
  account::Mode mode;
  mode.step = step_.name();
  mode.id = "typed_values";
  mode.title = say("typed values that rows and records bear out");
  mode.kind = ModeKind::shape;
  mode.wants = handed_on_.front().wants;
  mode.note = handed_on_.front().why;
  account.modes.push_back(std::move(mode));
}

void Run::fill_modes(Account& account) const {
  add_missing_input(account);
  add_missing_load(account);
  add_bolder(account);
  for (std::size_t k = 0; k < calculator_.modes.size(); ++k) {
    const ModeInfo& mode = calculator_.modes[k];
    const auto rows = rows_of(mode, account.verdicts);
    const auto passes = [](const account::Verdict* row) { return row->state == account::State::pass; };
    // What does not concern the part, and yet does not pass, was seen wrongly: no verdict is better than its checks.
    if (applies_[k] == Applies::no && std::all_of(rows.begin(), rows.end(), passes)) continue;
    std::string wants;
    const bool enough = is_judged(mode, account, wants);
    account.modes.push_back(judged(step_, mode, applies_[k], rows, std::move(wants), enough, bolder_in(rows)));
  }
}

}  // namespace loadpath::project
