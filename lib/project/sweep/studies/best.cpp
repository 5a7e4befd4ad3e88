#include "lib/project/sweep/studies/best.hpp"

#include "lib/project/sweep/columns.hpp"
#include "lib/project/sweep/ranges.hpp"
#include "lib/project/sweep/slice.hpp"
#include "lib/project/sweep/studies/drawn.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/sweep/sensitivity/robust.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace loadpath::project {

namespace {

using Kind = sweep::Constraint::Kind;

sweep::Variable variable_of(const SweptInput& input) {
  sweep::Variable variable;
  if (is_continuous(input)) {
    const auto& ends = std::get<sweep::Uniform>(input.distribution->law());
    variable.from = ends.min;
    variable.to = ends.max;
    return variable;
  }
  for (std::uint64_t i = 0; i < input.axis.size(); ++i) variable.values.push_back(input.axis.at(i));
  variable.ordered = input.words.empty();
  if (variable.ordered) std::sort(variable.values.begin(), variable.values.end());
  return variable;
}

bool is_chosen(const SweptInput& input) { return is_continuous(input) || !input.distribution; }

std::vector<sweep::Scattered> scatter_of(const std::vector<SweptInput>& inputs) {
  std::vector<sweep::Scattered> all;
  std::size_t design = 0, scatter = 0;
  for (const SweptInput& input : inputs) {
    sweep::Scattered& one = all.emplace_back();
    if (is_chosen(input))
      one.design = design++;
    else
      one.scatter = scatter++;
  }
  return all;
}

std::vector<sweep::Statistic> statistics_of(const BestRequest& asked, const std::vector<Demand>& demands) {
  using Statistic = sweep::Statistic;
  const double p = *asked.quantile;
  std::vector<Statistic> all{{0, Statistic::Kind::quantile, asked.maximise ? 1.0 - p : p}};
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const bool is_flag = demands[i].kind == Kind::is_one;
    const double may_fail = (1.0 - p) * (1.0 + 1e-12);  // 10 of 100 samples at 0.9, whose complement rounds below 0.1
    all.push_back({i + 1, is_flag ? Statistic::Kind::not_one : Statistic::Kind::quantile, is_flag ? may_fail : p});
  }
  return all;
}

std::vector<sweep::Constraint> constraints_of(const BestRequest& asked, const std::vector<Demand>& demands) {
  std::vector<sweep::Constraint> all;
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const bool is_followed = i + 1 < demands.size() && demands[i + 1].kind == Kind::is_one;  // by its flag: see above
    const bool is_shown = demands[i].kind == Kind::at_most_one && is_followed && demands[i].text == demands[i + 1].text;
    all.push_back({i + 1, asked.quantile ? Kind::at_most_one : demands[i].kind,  // the share over the permitted one
                   is_shown ? i + 1 : sweep::Constraint::itself, demands[i].bound});
  }
  return all;
}

/// The unit of a column; an issue if it cannot be read.
std::string unit_of(const Placed& asked, Project& project, std::vector<Issue>& issues) {
  const auto column = read_column(asked.text, project);
  if (!column) issues.push_back(refusal(asked, column.fault().message, column.fault().hint));
  return column ? column->unit : std::string();
}

/// A search chooses each input separately: inputs that vary in parallel would be crossed. A Pareto set of one objective
/// is the best design, too.
void refuse_zips(const BestRequest& asked, const SweepSettings& settings, std::vector<Issue>& issues) {
  const std::string& objective = asked.objective.text;
  const bool is_result = meant(objective, asked.results) != objective;
  const std::string result = is_result ? "" : "--results \"x = " + name_and_text(objective).second + "\" ";
  const std::string set = result + "--pareto \"" + (is_result ? objective : "x") + (asked.maximise ? ":max" : ":min") +
                          "\" --such-that \"every mode passes\"";
  for (const std::vector<Placed>& zip : settings.zip) {
    if (zip.size() < 2) continue;
    issues.push_back({zip.front().place, "project.sweep",
                      say("'{1}' and '{2}' vary in parallel (zip), and a search chooses each input separately",
                          zip[0].text, zip[1].text),
                      say("the best of all designs: {1}", set), Severity::error});
  }
}

/// Objective and demands as columns, whose texts it returns; nothing, with issues, if they cannot be read.
std::vector<std::string> form_columns(const Searching& searching, const BestRequest& asked, Best& best,
                                      std::vector<Issue>& issues) {
  best.demands = demands_of(asked.such_that, asked.results, issues);
  if (has_errors(issues)) return {};
  const std::string objective = meant(asked.objective.text, asked.results);
  Project project = searching.read();
  best.objective = name_and_text(asked.objective.text).first;
  best.unit = unit_of({objective, asked.objective.place}, project, issues);
  std::vector<std::string> texts{"objective = " + name_and_text(objective).second};
  for (Demand& demand : best.demands) {
    form(demand, asked.such_that.empty() ? asked.objective.place : asked.such_that.front().place, project, issues);
    texts.push_back("demand " + std::to_string(texts.size()) + " = " + demand.column);
  }
  return texts;
}

std::vector<double> outputs_at(Variants& variants, const std::vector<double>& point) {
  std::vector<double> found(variants.outputs());
  std::vector<const double*> in(point.size());
  std::vector<double*> out(found.size());
  std::ranges::transform(point, in.begin(), [](const double& value) { return &value; });
  std::ranges::transform(found, out.begin(), [](double& value) { return &value; });
  variants.evaluate(in, out, 1);
  return found;
}

/// The reason why a point is invalid, or the failure mode without a verdict.
Message cause_of(Variants& variants, const std::vector<double>& point) {
  const std::vector<double> found = outputs_at(variants, point);
  if (!variants.refusals().empty()) {
    const Issue& issue = variants.refusals().front().issue;
    return say("invalid design: {1}: {2}", issue.key, issue.message);
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    const SweptResult& column = variants.columns()[k];
    const bool is_mode = column.kind == SweptResult::Kind::state && !column.mode.empty();
    if (is_mode && found[k] == static_cast<double>(account::State::not_available))
      return say("{1}.{2} is not available", column.step, column.mode);
  }
  return {};
}

/// The failure mode that a point fails by, or does not assess; empty if all pass.
Message failure_of(Variants& variants, const std::vector<double>& point) {
  const std::vector<double> found = outputs_at(variants, point);
  const SweptResult* worst = nullptr;
  double state = account::number(account::State::open);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const SweptResult& column = variants.columns()[k];
    if (column.kind != SweptResult::Kind::state || column.mode.empty() || !(found[k] > state)) continue;
    worst = &column;
    state = found[k];
  }
  if (worst == nullptr) return {};
  const Step& step = *variants.project().find(worst->step);
  const auto& modes = step.input().calculator->modes;
  const auto info = std::find_if(modes.begin(), modes.end(), [&](const ModeInfo& m) { return worst->mode == m.id; });
  const std::string title = info == modes.end() ? worst->mode : info->title;
  return state == account::number(account::State::fail) ? say("{1}: {2}", step.name(), title)
                                                        : say("{1}: {2} is not assessed", step.name(), title);
}

/// Why a design violates a demand with this value; nothing where the demand says it all.
Message reason_at(Variants& variants, const Demand& demand, double value, const std::vector<double>& point) {
  Message reason = std::isfinite(value) ? Message{} : cause_of(variants, point);
  const bool is_verdict = demand.text.ends_with("passes") || is_utilisation(demand.column);
  return reason.empty() && is_verdict ? failure_of(variants, point) : reason;
}

/// Reasons that searches ignore but the reader needs.
void find_reasons(Variants& variants, Best& best) {
  const auto point_at = [&](const std::vector<double>& chosen) {
    std::vector<double> point = best.point;
    for (std::size_t k = 0; k < best.chosen.size(); ++k) point[best.chosen[k]] = chosen[k];
    return point;
  };
  const auto reason_of = [&](std::size_t broken, const std::vector<double>& outputs,
                             const std::vector<double>& chosen) {
    if (broken >= best.demands.size()) return Message{};
    return reason_at(variants, best.demands[broken], outputs[broken + 1], point_at(chosen));
  };
  const sweep::Optimum& optimum = best.optimum;
  best.reasons.reserve(optimum.neighbours.size());
  for (const sweep::Neighbour& n : optimum.neighbours) best.reasons.push_back(reason_of(n.broken, n.outputs, n.point));
  if (!optimum.allowed) best.reason = reason_of(optimum.worst, optimum.outputs, optimum.point);
  if (optimum.allowed) best.fails = failure_of(variants, point_at(optimum.point));
}

/// Objective and demands of the designs at the requested quantile.
std::unique_ptr<sweep::Robust> robust_of(sweep::Function& function, const Best& best, const BestRequest& asked,
                                         const DrawnSamples& drawn, std::uint64_t samples) {
  const auto fill = [&drawn](std::uint64_t first, std::size_t n, std::span<double* const> columns) {
    drawn.fill(first, n, columns);
  };
  return std::make_unique<sweep::Robust>(function, best.chosen.size(), scatter_of(best.inputs),
                                         best.inputs.size() - best.chosen.size(), fill,
                                         static_cast<std::size_t>(samples), statistics_of(asked, best.demands),
                                         [&drawn](std::span<const double> chosen) { return drawn.first_of(chosen); });
}

constexpr double risk = 0.05;  // of a confidence of 95 %

}  // namespace

double samples_needed(double quantile) { return std::ceil(std::log(risk) / std::log(quantile)); }
double shown_by(std::uint64_t samples) { return std::pow(risk, 1.0 / static_cast<double>(samples)); }

std::optional<Best> find_best(const Searching& searching, const BestRequest& asked, const SweepSettings& settings,
                              std::vector<Issue>& issues) {
  Best best;
  refuse_zips(asked, settings, issues);
  if (has_errors(issues)) return std::nullopt;
  const std::vector<std::string> texts = form_columns(searching, asked, best, issues);
  if (has_errors(issues)) return std::nullopt;
  Variants variants(searching.read(), texts);
  sweep::Threaded threaded = in_threads(variants, searching, texts);
  best.inputs = variants.axes();
  std::vector<std::size_t> scattering;
  for (std::size_t i = 0; i < best.inputs.size(); ++i) {
    (is_chosen(best.inputs[i]) ? best.chosen : scattering).push_back(i);
  }
  if (best.chosen.empty()) {
    issues.push_back(refusal(asked.objective, say("there are no designs to choose from"),
                             say("make an input a list, a range, { each = \"R40\" } or { from = ..., to = ... }")));
    return std::nullopt;
  }
  best.point = middles_of(best.inputs);
  best.quantile = asked.quantile;
  best.samples = asked.quantile && !scattering.empty() ? settings.samples : 0;
  Slice chosen(threaded, best.point, best.chosen, 1 + best.demands.size());
  const DrawnSamples drawn(best.inputs, settings, issues);
  if (has_errors(issues)) return std::nullopt;
  std::unique_ptr<sweep::Robust> robust;
  if (asked.quantile) robust = robust_of(threaded, best, asked, drawn, settings.samples);
  sweep::Problem problem{robust ? static_cast<sweep::Function&>(*robust) : chosen,
                         {},
                         0,
                         asked.maximise,
                         constraints_of(asked, best.demands)};
  for (const std::size_t i : best.chosen) problem.variables.push_back(variable_of(best.inputs[i]));
  best.optimum = sweep::minimise(problem);
  for (std::size_t k = 0; k < best.chosen.size(); ++k) best.point[best.chosen[k]] = best.optimum.point[k];
  find_reasons(variants, best);
  return best;
}

std::optional<SoughtValue> seek_value(const Searching& searching, const Placed& goal, std::vector<Issue>& issues) {
  const std::size_t equals = goal.text.find('=');
  const std::string result = trimmed(goal.text.substr(0, equals));
  const auto target = parse_literal(equals == std::string::npos ? "" : trimmed(goal.text.substr(equals + 1)));
  if (equals == std::string::npos || !target) {
    issues.push_back(refusal(goal, say("'{1}' is not a goal", goal.text), say("write \"shaft.u_tau = 0.9\"")));
    return std::nullopt;
  }
  Project project = searching.read();
  const std::string unit = unit_of({result, goal.place}, project, issues);
  if (has_errors(issues)) return std::nullopt;
  Variants variants(searching.read(), {result});
  const Dimension& dimension = variants.columns().front().dimension;
  if (dimension.without_angle() != target->dimension.without_angle()) {
    issues.push_back(
        refusal(goal, say("'{1}' is {2}, and the goal is {3}", result, name_of(dimension), name_of(target->dimension)),
                unit.empty() ? Message{} : say("give the goal in {1}", unit)));
    return std::nullopt;
  }
  std::vector<std::size_t> ranges;
  for (std::size_t i = 0; i < variants.axes().size(); ++i) {
    const SweptInput& input = variants.axes()[i];
    if (input.words.empty() && (is_continuous(input) || (!input.distribution && input.axis.size() > 1)))
      ranges.push_back(i);
  }
  if (ranges.size() != 1) {
    issues.push_back(refusal(goal,
                             say("exactly one input must have a range; there are {1}", std::to_string(ranges.size())),
                             say("give the others a value")));
    return std::nullopt;
  }
  SoughtValue sought{variants.axes()[ranges[0]], unit, target->si, {}};
  const bool free = is_continuous(sought.input);
  const auto ends = free ? std::get<sweep::Uniform>(sought.input.distribution->law()) : sweep::Uniform{};
  sweep::Goal wanted{ranges[0], free ? ends.min : low_of(sought.input), free ? ends.max : high_of(sought.input), 0,
                     target->si};
  sweep::Threaded threaded = in_threads(variants, searching, {result});
  sought.sought = sweep::seek(threaded, middles_of(variants.axes()), wanted);
  return sought;
}

}  // namespace loadpath::project
