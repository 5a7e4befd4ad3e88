#include "lib/export/json.hpp"

#include "lib/account/conclusion.hpp"
#include "lib/export/json_writer.hpp"
#include "lib/export/unit_name.hpp"
#include "lib/project/project.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/appendix.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::exports {

namespace {

using account::Entry;
using project::SeriesChoice;

constexpr int schema_version = 2;

/// The English word of a state, in any language of the report.
std::string word_of(account::State state) { return std::string(account::word(state).id); }

/// A value, with its reason where it does not exist.
void write_value(double si, const Message& missing, JsonWriter& out) {
  out.member("value", si);
  if (std::isinf(si)) out.member("reason", "infinite");
  if (std::isnan(si)) out.member("reason", missing.empty() ? "not available" : missing.text());
}

void write_series(const Entry& e, JsonWriter& out) {
  const auto& si = e.values().si;
  out.member("axis", e.values().signature.axis->name());
  out.key("values").write(si, e.values().rounding);
  const bool complete = std::all_of(si.begin(), si.end(), [](double x) { return std::isfinite(x); });
  if (!complete) out.member("reason", e.missing.empty() ? "not available where null" : e.missing.text());
}

void write_tried(const account::TriedSize& tried, JsonWriter& out) {
  out.open_object();
  out.member("name", tried.name);
  if (tried.si) out.member("value", *tried.si);
  if (!tried.mode.empty()) out.member("mode", tried.mode);
  if (!tried.title.empty()) out.member("meaning", tried.title.text());
  if (!tried.fails.empty()) out.member("fails", tried.fails);
  if (tried.number) out.member("number", *tried.number);
  if (tried.number && !tried.unit.empty()) out.member("shown_in", tried.unit);
  out.member("reason", tried.reason.text());
  out.close_object();
}

/// The candidate before the one that was found, or those nearest to passing, and what they fail.
void write_sizing(const Entry& e, JsonWriter& out) {
  if (!e.origin.next && e.origin.tried.empty()) return;
  out.key("sizing").open_object();
  if (e.origin.next) {
    out.key("next");
    write_tried(*e.origin.next, out);
  }
  if (!e.origin.tried.empty()) {
    out.key("tried").open_array();
    for (const account::TriedSize& tried : e.origin.tried) write_tried(tried, out);
    out.close_array();
  }
  out.close_object();
}

void write_entry(const Entry& e, JsonWriter& out) {
  out.key(e.path).open_object();
  if (!e.word.empty()) {
    out.member("value", e.word);
  } else {
    out.member("unit", unit_name(e.values().signature.dimension));
    if (e.values().is_series())
      write_series(e, out);
    else
      write_value(e.values().si.empty() ? NAN : e.values().si[0], e.missing, out);
  }
  out.member("meaning", e.doc);
  if (!e.origin.text.empty()) out.member("from", e.origin.text.text());
  if (e.origin.recalled) out.member("recalled", true);
  write_sizing(e, out);
  out.close_object();
}

void write_verdicts(const std::vector<account::Verdict>& list, JsonWriter& out) {
  out.key("checks").open_array();
  for (const account::Verdict& v : list) {
    const auto* value = std::get_if<account::Quantity>(&v.value);
    const double si = value == nullptr ? NAN : value->si;
    out.open_object();
    out.member("step", v.step);
    out.member("name", v.symbol);
    out.member("meaning", v.meaning.text());
    out.member("value", si);
    out.member("limit", v.bound.text());
    out.member("verdict", word_of(v.state));
    if (!v.note.empty() || !std::isfinite(si)) out.member("reason", v.note.empty() ? word_of(v.state) : v.note.text());
    out.close_object();
  }
  out.close_array();
}

const char* kind_of(ModeKind kind) {
  switch (kind) {
    case ModeKind::service:
      return "service";
    case ModeKind::shape:
      return "shape";
    case ModeKind::special:
      return "special";
    case ModeKind::strength:
      break;
  }
  return "strength";
}

void write_quantity(const char* key, const account::Quantity& quantity, JsonWriter& out) {
  out.key(key).open_object();
  out.member("value", quantity.si);
  out.member("shown_in", quantity.unit);
  out.close_object();
}

void write_list(const char* key, const std::string& list, JsonWriter& out) {
  if (list.empty()) return;
  out.key(key).open_array();
  for (const std::string& item : listed_keys(list)) out.write(item);
  out.close_array();
}

/// The values compared by the mode; if it is not assessed, the remedy.
void write_assessment(const account::Mode& mode, JsonWriter& out) {
  if (mode.compared) write_quantity("demand", mode.compared->demand, out);
  if (mode.compared) write_quantity("capacity", mode.compared->capacity, out);
  if (mode.at) write_quantity("at", *mode.at, out);
  const bool waits = mode.state == account::State::not_judged || mode.state == account::State::open;
  if (!waits || (mode.wants.empty() && mode.use.empty() && mode.add.empty() && mode.judge.empty())) return;
  out.key("fix").open_object();
  write_list("inputs", mode.wants, out);
  if (!mode.use.empty()) out.member("replace_by", mode.use);
  write_list("add", mode.judge.empty() ? mode.add : mode.judge, out);
  if (!mode.takes.empty()) out.member("takes", mode.takes);
  out.close_object();
}

/// The verdict on a part or a project: its worst mode, its coverage, and every mode.
void write_modes(const project::Project& project, JsonWriter& out) {
  const account::Modes modes = project::modes(project);
  out.key("verdict").open_object();
  if (project.strict) out.member("strict", true);
  const account::Conclusion conclusion = account::conclude(modes);
  out.member("headline", account::word(conclusion.headline));
  for (const account::Group group : account::all_groups)
    out.member(account::key(group), static_cast<double>(conclusion.count(group)));
  out.member("state", word_of(account::overall(modes)));
  out.member("scope", account::scope(modes).text());
  out.key("modes").open_array();
  for (const account::Mode& mode : account::in_order(modes)) {
    out.open_object();
    out.member("step", mode.step);
    out.member("mode", mode.id);
    out.member("meaning", mode.title.text());
    out.member("kind", kind_of(mode.kind));
    out.member("state", word_of(mode.state));
    if (mode.subject == account::Subject::mode) out.member("group", account::key(account::group_of(mode)));
    if (mode.utilisation) out.member("utilisation", *mode.utilisation);
    if (!mode.governs.empty()) out.member("governs", mode.governs);
    if (!mode.judge.empty()) out.member("left_to", mode.judge);
    if (!mode.use.empty()) out.member("use", mode.use);
    if (!mode.add.empty()) out.member("add", mode.add);
    if (!mode.wants.empty()) out.member("wants", mode.wants);
    write_assessment(mode, out);
    out.member("reason", account::reason(mode).text());
    out.close_object();
  }
  out.close_array();
  out.close_object();
}

void write_derivation(const std::vector<account::Derived>& lines, JsonWriter& out) {
  out.key("derivation").open_array();
  for (const auto& [scope, step, element] : lines) {
    out.open_object();
    out.member("scope", scope);
    out.member("symbol", step.symbol);
    out.member("formula", step.formula);
    out.key("given").open_object();
    for (const auto& g : step.given) {
      out.key(g.name).open_object();
      out.member("shown_in", g.unit);
      write_value(g.si, {}, out);
      out.close_object();
    }
    out.close_object();
    out.member("shown_in", step.value.unit);
    out.member("why", step.why.text());
    write_value(step.value.si, {}, out);
    out.close_object();
  }
  out.close_array();
}

/// The axes that the series of a step are given at, each once.
std::vector<const Axis*> axes_of(const account::Account& account) {
  std::vector<const Axis*> axes;
  for (const Entry& e : account.results) {
    const Axis* axis = e.values().signature.axis;
    if (axis != nullptr && std::find(axes.begin(), axes.end(), axis) == axes.end()) axes.push_back(axis);
  }
  return axes;
}

void write_axes(const std::vector<const Axis*>& axes, JsonWriter& out) {
  out.key("axes").open_object();
  for (const Axis* axis : axes) {
    out.key(axis->name()).open_object();
    out.member("shown_in", axis->unit);
    out.member("period", axis->period);
    out.key("at").write(axis->at.values());
    out.close_object();
  }
  out.close_object();
}

void write_step(const project::Step& step, const SeriesChoice& choice, JsonWriter& out) {
  const account::Account& account = step.account();
  out.open_object();
  out.member("name", step.name());
  out.member("calculator", step.input().calculator->id);
  out.member("title", step.input().title);
  if (!step.input().body.text.empty()) out.member("body", step.input().body.text);
  out.key("inputs").open_object();
  for (const Entry& e : account.inputs) write_entry(e, out);
  out.close_object();
  if (const auto axes = axes_of(account); !axes.empty()) write_axes(axes, out);
  out.key("results").open_object();
  for (const Entry& e : account.results) {
    if (!e.values().is_series() || choice.holds(step.name(), e.path)) write_entry(e, out);
  }
  out.close_object();
  write_verdicts(account.verdicts, out);
  if (!step.input().because.empty()) {
    out.key("because").open_object();
    for (const auto& [key, reason] : step.input().because) out.member(key, reason.text);
    out.close_object();
  }
  if (!account.warnings.empty()) {
    out.key("warnings").open_array();
    for (const Message& warning : account.warnings) out.write(warning.text());
    out.close_array();
  }
  if (!account.governing.empty()) out.member("derivation_for", account.governing.text());
  if (!account.derivation.empty()) write_derivation(account.derivation, out);
  out.close_object();
}

}  // namespace

std::string json_of(const project::Project& project, std::string_view program, const SeriesChoice& choice) {
  JsonWriter out;
  out.open_object();
  out.member("schema", schema_version);
  out.member("program", program);
  out.key("project").open_object();
  out.member("file", project.file);
  out.member("title", project.title);
  for (const auto& [key, value] : project.meta) out.member(key, value);
  out.close_object();
  write_modes(project, out);
  out.key("steps").open_array();
  for (const auto& step : project.steps) write_step(*step, choice, out);
  out.close_array();
  out.close_object();
  return out.take();
}

std::string json_of(const std::vector<Issue>& issues) {
  JsonWriter out;
  out.open_object();
  out.member("schema", schema_version);
  out.key("issues").open_array();
  for (const Issue& i : issues) {
    out.open_object();
    out.member("file", i.place.file);
    out.member("line", i.place.line);
    out.member("column", i.place.column);
    out.member("key", i.key);
    out.member("severity", i.severity == Severity::error ? "error" : "warning");
    out.member("message", i.message.text());
    out.member("help", i.hint.text());
    out.close_object();
  }
  out.close_array();
  out.close_object();
  return out.take();
}

}  // namespace loadpath::exports
