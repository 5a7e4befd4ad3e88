#include "lib/project/sweep/plan.hpp"

#include "lib/project/sweep/ranges.hpp"

#include <algorithm>
#include <optional>

namespace loadpath::project {

namespace {

Issue refusal(const Place& place, const std::string& key, Message message, Message hint = {}) {
  return {place, key, std::move(message), std::move(hint), Severity::error};
}

std::vector<SweptInput>::const_iterator input_named(const std::vector<SweptInput>& inputs, const std::string& name) {
  return std::find_if(inputs.begin(), inputs.end(), [&](const SweptInput& input) { return input.name == name; });
}

/// Reports a column name that conflicts with an earlier one or an input.
void check_name(const SweepPlan& plan, const SweptResult& column, const Place& place, std::vector<Issue>& issues) {
  const auto same = [&](const SweptResult& other) { return other.name == column.name; };
  if (std::any_of(plan.columns.begin(), plan.columns.end(), same))
    issues.push_back(refusal(place, "project.sweep", say("there are two results '{1}'", column.name),
                             say("name one of them: \"second = {1}\"", column.text)));
  if (column.text != column.name && input_named(plan.inputs, column.name) != plan.inputs.end())
    issues.push_back(refusal(place, "project.sweep", say("'{1}' is an input that the sweep varies", column.name),
                             say("give the result a name of its own: \"my_result = {1}\"", column.text)));
}

class Planning {
 public:
  Planning(const std::vector<SweptInput>& inputs, const SweepSettings& settings, std::vector<Issue>& issues)
      : inputs_(inputs), settings_(settings), issues_(issues), variables_(inputs.size()) {}

  sweep::Space space();
  [[nodiscard]] std::vector<std::size_t> variables() const { return variables_; }

 private:
  std::optional<std::size_t> input_of(const Placed& name);
  void add_level(const std::vector<std::size_t>& together);
  void add_levels();
  void add_random();
  void correlate();

  const std::vector<SweptInput>& inputs_;
  const SweepSettings& settings_;
  std::vector<Issue>& issues_;
  std::vector<std::size_t> variables_;
  std::vector<sweep::Space::Level> levels_;
  sweep::Space::Random random_;
  std::vector<std::size_t> uncertain_;  // inputs, in the order of the random variables
  std::size_t next_ = 0;                // variable
};

std::optional<std::size_t> Planning::input_of(const Placed& name) {
  const auto found = input_named(inputs_, name.text);
  if (found != inputs_.end()) return static_cast<std::size_t>(found - inputs_.begin());
  std::vector<std::string> names;
  for (const SweptInput& input : inputs_) names.push_back(input.name);
  issues_.push_back(refusal(name.place, "project.sweep", say("'{1}' is not an input that can be varied", name.text),
                            did_you_mean(name.text, names, there_is(names))));
  return std::nullopt;
}

void Planning::add_level(const std::vector<std::size_t>& together) {
  sweep::Space::Level level;
  for (const std::size_t i : together) {
    level.push_back(inputs_[i].axis);
    variables_[i] = next_++;
  }
  levels_.push_back(std::move(level));
}

/// Zipped inputs are at the position of the first of them.
void Planning::add_levels() {
  std::vector<std::vector<std::size_t>> zips;
  for (const std::vector<Placed>& zip : settings_.zip) {
    std::vector<std::size_t> together;
    for (const Placed& name : zip) {
      const auto input = input_of(name);
      if (!input) return;
      if (inputs_[*input].distribution)
        return issues_.push_back(refusal(name.place, "project.sweep",
                                         say("'{1}' is uncertain: it cannot vary in parallel with others", name.text),
                                         say("use correlations")));
      const bool twice = std::any_of(zips.begin(), zips.end(), [&](const auto& other) {
        return std::find(other.begin(), other.end(), *input) != other.end();
      });
      if (twice || std::find(together.begin(), together.end(), *input) != together.end())
        return issues_.push_back(refusal(name.place, "project.sweep", say("'{1}' is named twice", name.text)));
      if (!together.empty() && inputs_[together[0]].axis.size() != inputs_[*input].axis.size())
        return issues_.push_back(
            refusal(name.place, "project.sweep",
                    say("'{1}' has {2} values, '{3}' has {4}: they cannot vary in parallel", inputs_[together[0]].name,
                        std::to_string(inputs_[together[0]].axis.size()), name.text,
                        std::to_string(inputs_[*input].axis.size()))));
      together.push_back(*input);
    }
    if (!together.empty()) zips.push_back(std::move(together));
  }
  std::vector<bool> placed(inputs_.size());
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (placed[i] || inputs_[i].distribution) continue;
    const auto zip = std::find_if(zips.begin(), zips.end(), [&](const auto& together) {
      return std::find(together.begin(), together.end(), i) != together.end();
    });
    const std::vector<std::size_t> together = zip == zips.end() ? std::vector<std::size_t>{i} : *zip;
    for (const std::size_t k : together) placed[k] = true;
    add_level(together);
  }
}

void Planning::add_random() {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (!inputs_[i].distribution) continue;
    random_.variables.push_back(*inputs_[i].distribution);
    uncertain_.push_back(i);
    variables_[i] = next_++;
  }
  random_.samples = uncertain_.empty() ? 1 : settings_.samples;
  random_.seed = settings_.seed;
  random_.sampling = settings_.latin ? sweep::Sampling::latin_hypercube : sweep::Sampling::random;
}

void Planning::correlate() {
  if (settings_.correlations.empty()) return;
  for (const Correlated& pair : settings_.correlations) {
    for (const Placed* name : {&pair.first, &pair.second}) {
      const auto input = input_of(*name);
      if (!input) return;
      if (std::find(uncertain_.begin(), uncertain_.end(), *input) == uncertain_.end())
        return issues_.push_back(
            refusal(name->place, "project.sweep", say("'{1}' is not uncertain: it has no correlation", name->text)));
    }
  }
  std::vector<double> matrix = correlation_matrix(inputs_, uncertain_, settings_.correlations);
  std::vector<std::string> names;
  for (const std::size_t i : uncertain_) names.push_back(inputs_[i].name);
  auto correlation = sweep::Correlation::of(std::move(matrix), names);
  if (correlation)
    random_.correlation = std::move(*correlation);
  else
    issues_.push_back(refusal(settings_.correlations.front().first.place, "project.sweep", correlation.fault().message,
                              correlation.fault().hint));
}

sweep::Space Planning::space() {
  add_levels();
  add_random();
  correlate();
  if (has_errors(issues_)) return {};
  auto space = sweep::Space::of(std::move(levels_), std::move(random_));
  if (space) return std::move(*space);
  issues_.push_back(refusal(inputs_.empty() ? Place{} : inputs_.front().place, "project.sweep", space.fault().message,
                            space.fault().hint));
  return {};
}

}  // namespace

std::vector<std::size_t> SweepPlan::output_columns() const {
  std::vector<std::size_t> columns_only;
  for (std::size_t k = 0; k < requested().size(); ++k) {
    if (input_named(inputs, columns[k].name) == inputs.end()) columns_only.push_back(k);
  }
  return columns_only;
}

std::vector<std::size_t> SweepPlan::kept_results() const {
  std::vector<std::size_t> kept = output_columns();
  kept.push_back(columns.size());
  kept.push_back(columns.size() + 1);
  return kept;
}

std::vector<double> SweepPlan::at(std::uint64_t index) const {
  const std::vector<double> point = space.point(index);
  std::vector<double> values;
  for (const std::size_t variable : variables) values.push_back(point[variable]);
  return values;
}

void SweepPlan::fill(std::uint64_t first, std::size_t n, std::span<double* const> of_inputs) const {
  std::vector<double*> ordered(of_inputs.size());
  for (std::size_t i = 0; i < of_inputs.size(); ++i) ordered[variables[i]] = of_inputs[i];
  space.fill(first, n, ordered);
}

sweep::Space space_of(const std::vector<SweptInput>& inputs, const SweepSettings& settings,
                      std::vector<std::size_t>& variables, std::vector<Issue>& issues) {
  Planning planning(inputs, settings, issues);
  sweep::Space space = planning.space();
  variables = planning.variables();
  return space;
}

SweepPlan plan_sweep(Project& project, const SweepSettings& settings, std::vector<Issue>& issues) {
  SweepPlan plan;
  plan.inputs = swept_inputs(project);
  for (const Placed& result : settings.results) {
    auto column = read_column(result.text, project);
    if (!column) {
      const Fault& fault = column.fault();
      issues.push_back(refusal(result.place, "project.sweep", fault.message, fault.hint));
      continue;
    }
    check_name(plan, *column, result.place, issues);
    plan.columns.push_back(std::move(*column));
  }
  plan.space = space_of(plan.inputs, settings, plan.variables, issues);
  return plan;
}

void refuse_open_ranges(const SweepPlan& plan, std::vector<Issue>& issues) {
  for (const SweptInput& input : plan.inputs) {
    if (!is_continuous(input)) continue;
    issues.push_back(
        refusal(input.place, input.name, say("a sweep needs the values of '{1}': a step or a count", input.name),
                say("write { from = ..., to = ..., count = 11 }; --minimise and --maximise choose between the "
                    "ends, and scatter is { min = ..., max = ... }")));
  }
}

void set_point(Project& project, const SweepPlan& plan, std::uint64_t index, std::vector<Issue>& issues) {
  const std::vector<double> values = plan.at(index);
  const std::vector<SweptInput> inputs = swept_inputs(project);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    set_input(project, inputs[i], values[i], issues);
    for (const SweptInput::Target& target : inputs[i].targets) {
      Reading& reading = target.step->input().reading;
      const auto typed = reading.typed.find(reading.varied[target.varied].path);
      if (typed != reading.typed.end()) typed->second.of_point = true;
    }
  }
}

}  // namespace loadpath::project
