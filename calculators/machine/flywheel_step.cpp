#include "calculators/machine/flywheel_step.hpp"

#include "calculators/machine/flywheel.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::machine {

namespace {

constexpr double most_apart = 0.01;  // share of the speeds of shaft and crank, for they are typed twice

Flywheel::Input& data_of(project::StepInput& input) {
  return *static_cast<Flywheel::Input*>(input.reading.record.data.get());
}

}  // namespace

void FlywheelStep::take_series(const project::Declared& declared, std::vector<Issue>& issues) {
  project::Reading& reading = own().reading;
  const Message hint = say("give a series of a cycle (M = \"=press.drive.M\"), M_of_phi, or points");
  const auto found = std::find_if(reading.operands.begin(), reading.operands.end(),
                                  [](const project::Operand& operand) { return operand.path == "M"; });
  if (found == reading.operands.end()) {
    if (is_set(data_of(own()).M))
      issues.push_back(project::issue_at(input(), "M", say("a single value is not a moment over a cycle"), hint));
    return;
  }
  project::Reading alone;
  alone.operands.push_back(std::move(*found));
  reading.operands.erase(found);
  const std::size_t before = issues.size();
  const Axis* const axis = project::check_operands(alone, name(), true, declared, issues);
  if (axis == nullptr && issues.size() == before)
    issues.push_back(project::issue_at(input(), "M", say("a single value is not a moment over a cycle"), hint));
  reading.whole = std::move(alone.operands);
  data_of(own()).M = 0.0 * N_m;  // given, for the rules; its values come when the project is solved
}

void FlywheelStep::prepare(const project::Declared& declared, const project::Companions& companions,
                           std::vector<Issue>& issues) {
  take_series(declared, issues);
  CalculatorStep::prepare(declared, companions, issues);
}

double FlywheelStep::number(const char* key, double typed, const project::Known& known) const {
  for (const project::Operand& operand : input().reading.operands) {
    if (operand.path == key) return operand.expression.evaluate(known).si.front();
  }
  return typed;
}

bool FlywheelStep::fill(const Value& series, const project::Known& known, std::vector<Issue>& issues) {
  const auto refuse = [&](Message message, Message hint = {}) {
    issues.push_back(project::issue_at(input(), "M", std::move(message), std::move(hint)));
    return false;
  };
  if (!series.is_series() || !series.signature.axis->cyclic())
    return refuse(say("the moment is not over a closed cycle"), say("let the crank make full revolutions"));
  const Axis& axis = *series.signature.axis;
  if (series.si.size() > Flywheel::most_samples)
    return refuse(say("the cycle has {1} positions, and at most {2} are accepted", std::to_string(series.si.size()),
                      std::to_string(Flywheel::most_samples)));
  if (std::any_of(series.si.begin(), series.si.end(), [](double M) { return std::isnan(M); }))
    return refuse(say("the moment is not known at every position of the cycle"));
  Flywheel::Input& in = data_of(own());
  const double own_speed = number("omega", in_si(in.omega), known);
  const double per_turn = number("ratio", in.turns_per_turn, known), speed = per_turn * axis.speed;
  if (!(per_turn > 0.0)) return true;  // a value that its field refuses
  if (axis.speed > 0.0 && std::abs(own_speed - speed) > most_apart * own_speed) {
    return refuse(say("the moment runs over the turn of a crank at {1}, and this shaft turns at {2}",
                      format_quantity(axis.speed, "rpm", 5), format_quantity(own_speed, "rpm", 5)),
                  say("give the ratio of the two, ratio = {1}, with the moment on this shaft",
                      format_number(own_speed / axis.speed, 6)));
  }
  in.period = per_turn * std::abs(axis.period);
  in.series.clear();
  for (std::size_t i = 0; i < series.si.size(); ++i) in.series.push_back({per_turn * axis.at[i], series.si[i]});
  if (axis.period < 0.0) {  // a crank with reverse rotation: the angle is counted in its direction
    for (Sample& sample : in.series) sample.phi = -sample.phi, sample.M = -sample.M;
  }
  return true;
}

void FlywheelStep::solve(const project::Known& known, const project::Wanted& wanted, std::vector<Issue>& issues) {
  if (input().reading.whole.empty()) return CalculatorStep::solve(known, wanted, issues);
  const project::Operand& moment = input().reading.whole.front();
  const auto series = project::evaluate_operand(moment, name(), known, issues);
  if (!series || !fill(*series, known, issues)) return;
  CalculatorStep::solve(known, wanted, issues);
  // The samples include both, so that the calculator depends on neither.
  std::erase_if(issues, [&](const Issue& issue) {
    const bool taken = issue.key == name() + ".M" || issue.key == name() + ".ratio";
    return taken && issue.severity == Severity::warning;
  });
  for (account::Entry& entry : own_account().inputs) {
    if (entry.path != "M") continue;
    entry.value = *series;
    entry.origin = {say("= {1}", moment.text), {}, false};
  }
}

std::unique_ptr<project::Step> make_flywheel_step(project::StepInput&& input) {
  return std::make_unique<FlywheelStep>(std::move(input));
}

}  // namespace loadpath::machine
