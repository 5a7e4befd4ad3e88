// Which modes of failure concern the part of a run, and what its checks and limits say of them.
#include "lib/project/modes.hpp"

#include "lib/project/run/run.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

void Run::ask_modes() {
  for (std::size_t k = 0; k < calculator_.modes.size(); ++k)
    applies_[k] = std::max(applies_[k], calculator_.applies(k, record_.data.get()));
}

void Run::doubt_modes() {
  for (Applies& applies : applies_) applies = std::max(applies, Applies::unseen);
}

/// A step that has no results for want of an input has not been judged at all.
void Run::add_missing_input(Account& account) const {
  const Message missing = missing_input();
  if (!columns_.empty() || missing.empty()) return;
  account::Mode mode;
  mode.step = step_.name();
  mode.subject = search_failed_ ? account::Subject::search : account::Subject::input;
  mode.id = search_failed_ ? "search" : "inputs";
  mode.title = search_failed_ ? say("a size for which no assessed failure mode fails") : say("a value for every input");
  mode.kind = ModeKind::shape;
  mode.state = account::State::not_available;
  mode.note = missing;
  account.modes.push_back(std::move(mode));
}

/// Whether a load of the step is anything but zero anywhere; of a formula no one knows.
bool Run::is_loaded() const {
  bool loaded = false;
  for_each_leaf(record_, [&](const std::string&, const Leaf& leaf) {
    if (leaf.field->is_load && (leaf.field->get == nullptr || account::acts(leaf.get()))) loaded = true;
  });
  return loaded || std::any_of(inputs_.begin(), inputs_.end(), [](const Input& input) {
           const auto& si = input.value.si;
           return input.leaf.field->is_load && std::any_of(si.begin(), si.end(), account::acts);
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
  mode.subject = account::Subject::input;
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
  mode.subject = account::Subject::input;
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
    const CheckNeeds needs =
        needs_of(mode, *calculator_.result, [&](const FieldInfo& check) { return is_asked(check); });
    if (auto one = judged(step_, mode, applies_[k], rows, needs, bolder_in(rows)))
      account.modes.push_back(std::move(*one));
  }
}

}  // namespace loadpath::project
