#include "calculators/machine/motion/step.hpp"

#include "calculators/machine/motion/motion.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::machine {

namespace {

Motion::Input& motion_of(project::StepInput& input) {
  return *static_cast<Motion::Input*>(input.reading.record.data.get());
}

bool is_typed(const project::Reading& reading, const std::string& key) {
  return std::ranges::any_of(reading.operands, [&](const project::Operand& operand) { return operand.path == key; });
}

}  // namespace

void MotionStep::take_series(const std::string& key, const project::Declared& declared, std::vector<Issue>& issues) {
  project::Reading& reading = own().reading;
  const auto found = std::ranges::find_if(reading.operands, [&](const auto& operand) { return operand.path == key; });
  if (found == reading.operands.end()) return;
  const auto place = found - reading.operands.begin();
  project::Reading alone;
  alone.operands.push_back(std::move(*found));
  reading.operands.erase(found);
  const Axis* const axis = project::check_operands(alone, name(), true, declared, issues);
  if (axis == nullptr) {
    reading.operands.insert(reading.operands.begin() + place, std::move(alone.operands.front()));
    return;
  }
  reading.whole.push_back(std::move(alone.operands.front()));
  // Given, for the rules; the values come when the project is solved.
  if (key == "M") motion_of(own()).M = 0.0 * N_m;
  if (key == "J_red") motion_of(own()).J_red = 0.0 * kg_m2;
}

void MotionStep::prepare(const project::Declared& declared, const project::Companions& companions,
                         std::vector<Issue>& issues) {
  take_series("M", declared, issues);
  take_series("J_red", declared, issues);
  CalculatorStep::prepare(declared, companions, issues);
}

bool MotionStep::counts_inertia_twice(const project::Operand& operand, const project::Known& known,
                                      std::vector<Issue>& issues) const {
  const auto& in = *static_cast<const Motion::Input*>(input().reading.record.data.get());
  if (operand.path != "M" || is_typed(input().reading, "n_M") || is_set(in.n_M)) return false;
  constexpr std::string_view driving = ".drive.M";
  for (const auto& reference : operand.expression.references()) {
    const std::string& path = reference.path;
    if (!path.ends_with(driving)) continue;
    const std::string step = path.substr(0, path.size() - driving.size());
    if (known.word && known.word(step + ".analysis") == "static") continue;
    issues.push_back(
        project::issue_at(input(), "M", say("'{1}' includes the inertia forces, which J_red adds once more", path),
                          say("take \"=-{1}.drive.M_red\", or give the speed of that analysis as n_M", step)));
    return true;
  }
  return false;
}

bool MotionStep::has_wrong_sign(const project::Operand& operand, std::vector<Issue>& issues) const {
  if (operand.path != "M") return false;
  const std::string_view text = operand.text;
  const bool has_minus = text.find('-') != std::string_view::npos, is_negative = text.starts_with('-');
  for (const auto& reference : operand.expression.references()) {
    const std::string& path = reference.path;
    if (path.ends_with(".drive.M_red") && !has_minus)
      issues.push_back(project::issue_at(
          input(), "M", say("'{1}' is positive in the direction of motion, but a load M against it", path),
          say("take \"=-{1}\"", path)));
    else if (path.ends_with(".drive.M") && is_negative)
      issues.push_back(project::issue_at(input(), "M",
                                         say("'{1}' is the torque that overcomes the load, positive like M", path),
                                         say("take \"={1}\"", path)));
    else
      continue;
    return true;
  }
  return false;
}

bool MotionStep::fill(const project::Operand& operand, const Value& series, std::vector<Issue>& issues) {
  const auto refuse = [&](Message message, Message hint = {}) {
    issues.push_back(project::issue_at(input(), operand.path, std::move(message), std::move(hint)));
    return false;
  };
  if (!series.is_series() || !series.signature.axis->cyclic())
    return refuse(say("{1} is not given over a closed cycle", operand.path),
                  say("let the crank make full revolutions"));
  const Axis& axis = *series.signature.axis;
  if (series.si.size() > Motion::most_samples)
    return refuse(say("the cycle has {1} positions, and at most {2} are accepted", std::to_string(series.si.size()),
                      std::to_string(Motion::most_samples)));
  if (std::ranges::any_of(series.si, [](double value) { return std::isnan(value); }))
    return refuse(say("{1} is not known at every position of the cycle", operand.path));
  Motion::Input& in = motion_of(own());
  const double period = std::abs(axis.period);
  const bool is_load = operand.path == "M";
  const Motion::Samples& other = is_load ? in.inertia_series : in.load_series;
  if (!other.empty() && std::abs(in.period - period) > 1e-9 * period)
    return refuse(say("M and J_red have cycles of different lengths, {1} and {2}",
                      format_quantity(in.period, deg.symbol, 5), format_quantity(period, deg.symbol, 5)));
  in.period = period;
  Motion::Samples& samples = is_load ? in.load_series : in.inertia_series;
  samples.clear();
  // A crank with reverse rotation: the angle is counted in its direction, and so is the moment.
  const double sense = axis.period < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < series.si.size(); ++i)
    samples.push_back({sense * axis.at[i], is_load ? sense * series.si[i] : series.si[i]});
  return true;
}

void MotionStep::solve(const project::Known& known, const project::Wanted& wanted, std::vector<Issue>& issues) {
  const std::vector<project::Operand>& whole = input().reading.whole;
  if (whole.empty()) return CalculatorStep::solve(known, wanted, issues);
  motion_of(own()).load_series.clear();
  motion_of(own()).inertia_series.clear();
  std::vector<Value> all;
  for (const project::Operand& operand : whole) {
    if (counts_inertia_twice(operand, known, issues) || has_wrong_sign(operand, issues)) return;
    auto series = project::evaluate_operand(operand, name(), known, issues);
    if (!series || !fill(operand, *series, issues)) return;
    all.push_back(std::move(*series));
  }
  CalculatorStep::solve(known, wanted, issues);
  // The samples hold the series, so that the calculator does not depend on the fields.
  std::erase_if(issues, [&](const Issue& issue) {
    const bool taken = std::ranges::any_of(whole, [&](const auto& o) { return issue.key == name() + "." + o.path; });
    return taken && issue.severity == Severity::warning;
  });
  for (account::Entry& entry : own_account().inputs) {
    for (std::size_t k = 0; k < whole.size(); ++k) {
      if (entry.path != whole[k].path) continue;
      entry.value = all[k];
      entry.origin = {say("= {1}", whole[k].text), {}, false};
    }
  }
}

std::unique_ptr<project::Step> make_motion_step(project::StepInput&& input) {
  return std::make_unique<MotionStep>(std::move(input));
}

}  // namespace loadpath::machine
