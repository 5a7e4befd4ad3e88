#include "lib/project/modes.hpp"

#include "lib/account/rows.hpp"
#include "lib/project/run/judgement.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// A step that has no results for want of an input has not been judged at all.
void add_missing_input(const Evaluation& evaluation, const Results& results, account::Modes& modes) {
  const Message missing = evaluation.missing();
  if (!results.series.empty() || missing.empty()) return;
  account::Mode mode;
  mode.step = evaluation.step().name();
  mode.subject = evaluation.inputs().subject_of_missing();
  const bool is_search = mode.subject == account::Subject::search;
  mode.id = is_search ? "search" : "inputs";
  mode.title = is_search ? say("a size for which no assessed failure mode fails") : say("a value for every input");
  mode.kind = ModeKind::shape;
  mode.state = account::State::not_available;
  mode.note = missing;
  modes.push_back(std::move(mode));
}

/// Whether a load of the step is anything but zero anywhere; of a formula no one knows.
bool is_loaded(const Inputs& inputs) {
  bool loaded = false;
  for_each_leaf(inputs.record(), [&](const std::string&, const Leaf& leaf) {
    if (leaf.field->is_load && (leaf.field->get == nullptr || account::acts(leaf.get()))) loaded = true;
  });
  const auto& computed = inputs.computed();
  return loaded || std::any_of(computed.begin(), computed.end(), [](const ComputedInput& input) {
           const auto& si = input.value.si;
           return input.leaf.field->is_load && std::any_of(si.begin(), si.end(), account::acts);
         });
}

/// Whether a load is told at all; what is left out, or is zero where nobody says else, asks for no verdict on loads.
bool is_load_told(const Evaluation& evaluation) {
  bool told = false;
  for_each_leaf(evaluation.record(), [&](const std::string& path, const Leaf& leaf) {
    told = told || (leaf.field->is_load && evaluation.step().input().reading.typed.contains(path));
  });
  return told;
}

/// What holds without a load has not been judged under one: a reference may bring none by mistake. What another load
/// than those that are declared has utilised, a liquid, its own speed, is loaded.
void add_missing_load(const Evaluation& evaluation, const Results& results,
                      const std::vector<account::Verdict>& verdicts, account::Modes& modes) {
  const auto is_strength = [](const ModeInfo& mode) { return mode.kind == ModeKind::strength; };
  const auto is_utilised = [](const account::Verdict* row) { return row->utilisation && *row->utilisation > 0.0; };
  const auto bears = [&](const ModeInfo& mode) {
    const auto rows = rows_of(mode, verdicts);
    return is_strength(mode) && std::any_of(rows.begin(), rows.end(), is_utilised);
  };
  const auto& all = evaluation.calculator().modes;
  if (results.series.empty() || !is_load_told(evaluation) || is_loaded(evaluation.inputs())) return;
  if (std::none_of(all.begin(), all.end(), is_strength) || std::any_of(all.begin(), all.end(), bears)) return;
  account::Mode mode;
  mode.step = evaluation.step().name();
  mode.subject = account::Subject::input;
  mode.id = "load";
  mode.title = say("non-zero load");
  mode.note = say("all loads are zero: no strength assessment");
  modes.push_back(std::move(mode));
}

/// A value that nothing here is held against goes on to other steps: what they say with it is no verdict.
void add_handed_on(const Evaluation& evaluation, const WeighedValues& weighed, account::Modes& modes) {
  if (weighed.handed_on.empty()) return;
  account::Mode mode;
  mode.step = evaluation.step().name();
  mode.subject = account::Subject::input;
  mode.id = "typed_values";
  mode.title = say("agreement of typed values with rows and records");
  mode.kind = ModeKind::shape;
  mode.wants = weighed.handed_on.front().wants;
  mode.note = weighed.handed_on.front().why;
  modes.push_back(std::move(mode));
}

Bolder bolder_in(const WeighedValues& weighed, const std::vector<const account::Verdict*>& rows) {
  for (const account::Verdict* row : rows) {
    if (const auto found = weighed.decided.find(row->symbol); found != weighed.decided.end()) return found->second;
  }
  return {};
}

}  // namespace

void add_modes(const Evaluation& evaluation, const Results& results, const WeighedValues& weighed,
               const std::vector<account::Verdict>& verdicts, account::Modes& modes) {
  add_missing_input(evaluation, results, modes);
  add_missing_load(evaluation, results, verdicts, modes);
  add_handed_on(evaluation, weighed, modes);
  const Calculator& calculator = evaluation.calculator();
  for (std::size_t k = 0; k < calculator.modes.size(); ++k) {
    const ModeInfo& mode = calculator.modes[k];
    const auto rows = rows_of(mode, verdicts);
    const CheckNeeds needs =
        needs_of(mode, *calculator.result, [&](const FieldInfo& check) { return evaluation.is_asked(check); });
    if (auto one = judged(evaluation.step(), mode, results.applies[k], rows, needs, bolder_in(weighed, rows)))
      modes.push_back(std::move(*one));
  }
}

}  // namespace loadpath::project
