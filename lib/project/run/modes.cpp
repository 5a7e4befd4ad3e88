#include "lib/project/modes.hpp"

#include "lib/account/rows.hpp"
#include "lib/project/run/judgement.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::project {

namespace {

/// A step that has no results because of a missing input has not been assessed at all.
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

/// Whether a load is given; an omitted one, or a default of zero, requires no verdict on loads.
bool is_load_given(const Evaluation& evaluation) {
  bool is_typed_load = false;
  for_each_leaf(evaluation.record(), [&](const std::string& path, const Leaf& leaf) {
    is_typed_load = is_typed_load || (leaf.field->is_load && evaluation.step().input().reading.typed.contains(path));
  });
  return is_typed_load;
}

/// Whether a mode of strength is utilised: a part under loads other than the declared ones, a liquid, its own speed, is
/// loaded.
bool is_utilised(const ModeInfo& mode, const std::vector<account::Verdict>& verdicts) {
  const auto rows = rows_of(mode, verdicts);
  return mode.kind == ModeKind::strength && !mode.is_limit &&
         std::any_of(rows.begin(), rows.end(),
                     [](const account::Verdict* row) { return row->utilisation && *row->utilisation > 0.0; });
}

account::Mode load_to_give(const Evaluation& evaluation, Message note) {
  account::Mode mode;
  mode.step = evaluation.step().name();
  mode.subject = account::Subject::input;
  mode.id = "load";
  mode.title = say("non-zero load");
  mode.note = std::move(note);
  return mode;
}

/// A pass without load is not an assessment: a reference may give none by mistake. A slenderness within its limit is no
/// strength either: without any load, nothing that a load decides was assessed.
void add_missing_load(const Evaluation& evaluation, const Results& results,
                      const std::vector<account::Verdict>& verdicts, account::Modes& modes) {
  const auto& all = evaluation.calculator().modes;
  const auto bears = [&](const ModeInfo& mode) { return is_utilised(mode, verdicts); };
  const auto is_limited = [&](const ModeInfo& mode) { return mode.is_limit && !rows_of(mode, verdicts).empty(); };
  if (results.series.empty() || is_loaded(evaluation.inputs()) || std::any_of(all.begin(), all.end(), bears)) return;
  if (is_load_given(evaluation)) {
    const auto is_strength = [](const ModeInfo& mode) { return mode.kind == ModeKind::strength; };
    if (std::any_of(all.begin(), all.end(), is_strength))
      modes.push_back(load_to_give(evaluation, say("all loads are zero: no strength assessment")));
    return;
  }
  if (std::none_of(all.begin(), all.end(), is_limited)) return;
  account::Mode mode = load_to_give(evaluation, say("no load is given: no strength assessment"));
  for (const ModeInfo& info : all) {
    if (info.kind != ModeKind::strength || info.is_limit || !mode.wants.empty()) continue;
    const auto is_asked = [&](const FieldInfo& check) { return evaluation.is_asked(check); };
    mode.wants = needs_of(info, *evaluation.calculator().result, is_asked).wants;
  }
  modes.push_back(std::move(mode));
}

/// A load that only [values] state, next to gears of geometry only: their modes of strength do not apply without one.
void add_stated_load(const Evaluation& evaluation, account::Modes& modes) {
  if (is_loaded(evaluation.inputs())) return;
  for (const ReducedLoad& value : evaluation.step().loads().reduced) {
    if (value.path != "m_x" && value.path != "m_et" && value.path != "m_n") continue;
    modes.push_back(load_to_give(evaluation, value.message));
    return;
  }
}

/// A contradiction of [values] to a step without a mode of strength that could show it: the mass of a moving body.
void add_contradiction(const Evaluation& evaluation, account::Modes& modes) {
  const Step& step = evaluation.step();
  const auto& all = evaluation.calculator().modes;
  const bool has_strength =
      std::any_of(all.begin(), all.end(), [](const ModeInfo& m) { return m.kind == ModeKind::strength; });
  if (has_strength || !step.contradictions()) return;
  for (const ReducedLoad& value : step.loads().reduced) {
    if (std::ranges::find(*step.contradictions(), value) == step.contradictions()->end()) continue;
    account::Mode mode;
    mode.step = step.name();
    mode.subject = account::Subject::input;
    mode.id = "stated_values";
    mode.title = say("values stated and not taken");
    mode.kind = ModeKind::shape;
    mode.note = value.message;
    modes.push_back(std::move(mode));
    return;
  }
}

/// A value that no check here uses is passed on to other steps, whose results with it do not assess it.
void add_handed_on(const Evaluation& evaluation, const WeighedValues& weighed, account::Modes& modes) {
  if (weighed.handed_on.empty()) return;
  account::Mode mode;
  mode.step = evaluation.step().name();
  mode.subject = account::Subject::input;
  mode.id = "typed_values";
  mode.title = say("typed values confirmed by rows and records");
  mode.kind = ModeKind::shape;
  mode.wants = weighed.handed_on.front().wants;
  mode.note = weighed.handed_on.front().why;
  modes.push_back(std::move(mode));
}

/// Adds the assumptions behind a decided mode that were not given.
void add_assumptions(const Evaluation& evaluation, const ModeInfo& info, account::Mode& mode) {
  if (mode.governs.empty()) return;
  const auto& rules = evaluation.calculator().rules;
  for (std::size_t rule = 0; rule < rules.size(); ++rule) {
    const auto named = listed_keys(rules[rule].modes);
    if (std::find(named.begin(), named.end(), info.id) == named.end() || evaluation.holds(rule)) continue;
    const Message assumed = evaluation.broken_rule(rule).message;
    mode.note = mode.note.empty() ? say("with {1}", assumed) : say("{1}, with {2}", mode.note, assumed);
  }
}

LessConservative bolder_in(const WeighedValues& weighed, const std::vector<const account::Verdict*>& rows) {
  for (const account::Verdict* row : rows) {
    if (const auto found = weighed.decided.find(row->symbol); found != weighed.decided.end()) return found->second;
  }
  return {};
}

/// A value more favourable than that of its source may be the reason why a mode does not apply: no sliding at a speed
/// of zero. Checks of several modes do not show that.
Applies applies_with(const ModeInfo& mode, Applies applies, const LessConservative& bolder) {
  const bool is_sole = std::string_view(mode.checks).find(',') == std::string_view::npos;
  return applies == Applies::no && is_sole && !bolder.wants.empty() ? Applies::yes : applies;
}

}  // namespace

void add_modes(const Evaluation& evaluation, const Results& results, const WeighedValues& weighed,
               const std::vector<account::Verdict>& verdicts, account::Modes& modes) {
  add_missing_input(evaluation, results, modes);
  add_missing_load(evaluation, results, verdicts, modes);
  add_contradiction(evaluation, modes);
  add_stated_load(evaluation, modes);
  add_handed_on(evaluation, weighed, modes);
  const Calculator& calculator = evaluation.calculator();
  for (std::size_t k = 0; k < calculator.modes.size(); ++k) {
    const ModeInfo& mode = calculator.modes[k];
    const auto rows = rows_of(mode, verdicts);
    const CheckNeeds needs =
        needs_of(mode, *calculator.result, [&](const FieldInfo& check) { return evaluation.is_asked(check); });
    const LessConservative bolder = bolder_in(weighed, rows);
    const Applies applies = applies_with(mode, results.applies[k], bolder);
    auto one = judged(evaluation.step(), mode, applies, rows, needs, bolder);
    if (!one) continue;
    add_assumptions(evaluation, mode, *one);
    modes.push_back(std::move(*one));
  }
}

}  // namespace loadpath::project
