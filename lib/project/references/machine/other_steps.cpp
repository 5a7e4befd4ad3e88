#include "lib/project/references/machine/other_steps.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/references/agreement/drive_lines.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace loadpath::project {

namespace {

/// The factor that a step applies to its loads; 1 if it is not known yet, or not given.
double applied_factor(const Step& step, const Project& project, const std::string& key) {
  const double factor = own_value(step, project, key);
  return std::isnan(factor) ? 1.0 : factor;
}

bool applies_factor(const Step& step, const std::string& key) {
  const Calculator* const calculator = step.input().calculator;
  const FieldInfo* const field = find_field(calculator->input->fields, key);
  return field != nullptr && field->is_factor;
}

/// The input of the step that is a load of the other one as it is, "post.P"; empty if none is.
std::string load_taken_by(const Step& taker, const Step& step) {
  for (const Operand& operand : taker.input().reading.operands) {
    if (!operand.leaf.field->is_load || !operand.expression.is_reference()) continue;
    const std::string& path = operand.expression.references().front().path;
    const auto [name, rest] = split_step(path);
    const FieldInfo* const field =
        name == step.name() ? find_field(step.input().calculator->input->fields, rest) : nullptr;
    if (field != nullptr && field->is_load) return path;
  }
  return {};
}

/// The values of [values] that are loads of a step, as they are or in an expression: "values.P".
std::set<std::string> shared_loads(const Step& step) {
  std::set<std::string> shared;
  for (const auto& [key, typed] : step.input().reading.typed) {
    const FieldInfo* const field = find_field(step.input().calculator->input->fields, key);
    if (field != nullptr && field->is_load && !typed.shared.empty()) shared.insert(typed.shared);
  }
  for (const Operand& operand : step.input().reading.operands) {
    if (!operand.leaf.field->is_load) continue;
    for (const auto& reference : operand.expression.references()) {
      if (reference.path.starts_with("values.")) shared.insert(reference.path);
    }
  }
  return shared;
}

/// The first of these values that is a load of the other step, too; empty if none is.
std::string load_shared_with(const std::set<std::string>& own, const Step& other) {
  if (own.empty()) return {};
  const std::set<std::string> there = shared_loads(other);
  const auto both = std::find_if(own.begin(), own.end(), [&](const std::string& path) { return there.contains(path); });
  return both == own.end() ? "" : *both;
}

/// The steps that take a value of this one, or one of these, in the order of the file.
std::vector<const Step*> takers_of(const Step& step, const std::set<std::string>& values, const Project& project) {
  std::vector<std::size_t> positions = project.takers.of(step.name());
  for (const std::string& value : values) {
    const auto& others = project.takers.of(value);
    positions.insert(positions.end(), others.begin(), others.end());
  }
  std::ranges::sort(positions);
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  std::vector<const Step*> takers;
  for (const std::size_t position : positions) {
    const Step* const taker = project.steps[position].get();
    if (taker != &step) takers.push_back(taker);
  }
  return takers;
}

/// Whether two steps have the same factor, as neither states one.
bool have_same_default(const Step& one, const Step& other, const std::string& key) {
  const auto may_state = [&](const Step& step) {
    return step.input().reading.typed.contains(key) || step.input().reading.operand(key) != nullptr ||
           !step.input().reading.records.empty();
  };
  return one.input().calculator == other.input().calculator && !may_state(one) && !may_state(other);
}

bool is_ratio_of_speeds(std::string_view what) { return what == ratio_of_speeds; }
bool is_speed_of_run(std::string_view what) { return what == speed_of_run; }
bool is_moment_of_motor(std::string_view what) { return what == moment_of_motor; }
bool is_inertia_of_flywheel(std::string_view what) { return what == inertia_of_flywheel; }

/// A run of a drive, next to the other steps of the same machine.
class RunCheck {
 public:
  RunCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    speed_ = largest_input(&is_speed_of_run, speed_path_);
    compare_discs();
    compare_wheels_of_motor();
    if (!(speed_ > 0.0)) return std::move(found_);
    compare_wheels();
    compare_end();
    moment_ = largest_input(&is_moment_of_motor, moment_path_);
    for (const std::string& source : steps_named_in(step_.input().reading)) compare_train(source);
    compare_shaft();
    compare_flywheels();
    return std::move(found_);
  }

 private:
  static constexpr double slip = 0.1;
  static constexpr double most_of_motor = 3.5;  // breakdown torque over rated torque, motors with a squirrel cage

  void add(const std::string& path, Message message) {
    found_.push_back({path.substr(0, path.find_first_of(".[")), std::move(message)});
  }

  /// The largest magnitude of the inputs with a meaning, and the path of that input.
  double largest_input(bool (*is_it)(std::string_view what), std::string& at) const {
    double most = std::nan("");
    for_each_leaf(step_.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      if (!leaf.field->is_number() || !means(*step_.input().calculator, path, is_it)) return;
      const double si = std::abs(own_value(step_, project_, path));
      if (!std::isnan(si) && !(si <= most)) most = si, at = path;
    });
    return most;
  }

  /// A run ends, or starts, at the speed of a shaft of the train, by a motor of its power.
  void compare_train(const std::string& train) {
    double T = std::nan(""), n = std::nan("");
    std::vector<double> ratios;
    for (int k = 1;; ++k) {
      const std::string shaft = train + ".shafts[" + std::to_string(k) + "].";
      const double there = std::abs(magnitude_at(project_, shaft + "n"));
      if (std::isnan(there)) break;
      if (std::isnan(n)) n = there;
      ratios.push_back(there / speed_);
      if (is_near(speed_, there, slip)) T = std::abs(magnitude_at(project_, shaft + "T")), n = speed_;
    }
    if (!std::isnan(n) && n != speed_)
      add(speed_path_, say("{1} = {2} is the speed of no shaft of '{3}'; justify it: because.{1} = \"...\"",
                           speed_path_, format_quantity(speed_, "rpm", 4), train));
    if (n == speed_) compare_ratios(train, ratios);
    compare_motor(train, ratios.empty() ? torque_of_drive(train) : T);
  }

  /// The torque of a belt, a chain or a pair that starts at this speed; NaN of others.
  [[nodiscard]] double torque_of_drive(const std::string& drive) const {
    const double n_1 = std::abs(magnitude_at(project_, drive + ".n_1"));
    if (!is_near(speed_, n_1, slip)) return std::nan("");
    return std::abs(magnitude_at(project_, drive + ".P")) / n_1;
  }

  /// A part turns as the shaft of the run, or as another one of the train.
  void compare_ratios(const std::string& train, const std::vector<double>& ratios) {
    for_each_leaf(step_.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      if (!leaf.field->is_number() || !means(*step_.input().calculator, path, &is_ratio_of_speeds)) return;
      const double u = std::abs(own_value(step_, project_, path));
      const auto is_u = [&](double ratio) { return is_near(u, ratio, slip); };
      if (std::isnan(u) || std::any_of(ratios.begin(), ratios.end(), is_u)) return;
      add("parts", say("{1} = {2} is the ratio of no shaft of '{3}'; justify it: because.parts = \"...\"", path,
                       format_number(u, 4), train));
    });
  }

  /// No motor gives much more than its rated torque.
  void compare_motor(const std::string& source, double rated) {
    if (!(moment_ > most_of_motor * rated)) return;
    add(moment_path_, say("the motor moment of {1} is more than {2} times the torque of '{3}', {4}; justify it: "
                          "because.motor = \"...\"",
                          format_quantity(moment_, "N*m", 4), format_number(most_of_motor), source,
                          format_quantity(rated, "N*m", 4)));
  }

  /// A disc whose moment of inertia is taken was calculated for its speed here.
  void compare_discs() {
    for (const Operand& operand : step_.input().reading.operands) {
      const auto& references = operand.expression.references();
      if (!operand.expression.is_reference() || !references.front().path.ends_with(".J_z")) continue;
      const std::string disc = split_step(references.front().path).first;
      const double u = own_value(step_, project_, prefix_of(operand.path) + "u");
      const double own = speed_ > 0.0 ? speed_ : std::abs(own_value(step_, project_, "omega"));
      const double n = own * (std::isnan(u) ? 1.0 : u), calculated = std::abs(magnitude_at(project_, disc + ".n"));
      if (!(n > (1.0 + 1e-3) * calculated)) continue;
      add(operand.path, say("the disc '{1}' turns at {2} here, and is calculated for {3}; justify it: because.{4} = "
                            "\"...\"",
                            disc, format_quantity(n, "rpm", 4), format_quantity(calculated, "rpm", 4),
                            operand.path.substr(0, operand.path.find_first_of(".["))));
    }
  }

  /// A flywheel that a motor without load drives faster than the speed that it is calculated for.
  void compare_wheels_of_motor() {
    constexpr double most_above = 1.15;  // slip, and the fluctuation within a cycle
    if (step_.input().reading.operand("J_F") == nullptr) return;
    const double n = std::abs(own_value(step_, project_, "n_0") / own_value(step_, project_, "i"));
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.path != "J_F") continue;
      for (const auto& reference : operand.expression.references()) {
        const std::string wheel = split_step(reference.path).first;
        const Step* const source = project_.find(wheel);
        if (source == nullptr || !means(*source->input().calculator, "J", &is_inertia_of_flywheel)) continue;
        const double omega = std::abs(own_value(*source, project_, "omega"));
        if (!(n > most_above * omega)) continue;
        add("J_F",
            say("the motor without load turns the crank at n_0/i = {1}, and the flywheel '{2}' is calculated for "
                "{3}; justify it: because.J_F = \"...\"",
                format_quantity(n, "rpm", 4), wheel, format_quantity(omega, "rpm", 4)));
      }
    }
  }

  /// A flywheel among the parts turns with the speed that it is calculated for.
  void compare_wheels() {
    constexpr double apart = 0.15;  // slip, and the fluctuation within a cycle
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.path.starts_with("parts") || !operand.path.ends_with(".J") || !operand.expression.is_reference())
        continue;
      const std::string wheel = split_step(operand.expression.references().front().path).first;
      const Step* const source = project_.find(wheel);
      if (source == nullptr || !means(*source->input().calculator, "J", &is_inertia_of_flywheel)) continue;
      const double u = own_value(step_, project_, prefix_of(operand.path) + "u");
      const double n = speed_ * std::abs(std::isnan(u) ? 1.0 : u);
      const double omega = std::abs(own_value(*source, project_, "omega"));
      if (!(std::abs(n - omega) > apart * omega)) continue;
      add(operand.path, say("the flywheel '{1}' turns at {2} here, and is calculated for {3}: correct u, or "
                            "because.parts = \"...\"",
                            wheel, format_quantity(n, "rpm", 4), format_quantity(omega, "rpm", 4)));
    }
  }

  /// A start ends where motor and load are near their last speed: a part of it takes less time and heat.
  void compare_end() {
    constexpr double least = 0.75;  // of the last speed of both curves
    const double n_1 = std::abs(own_value(step_, project_, "n_1")), n_2 = std::abs(own_value(step_, project_, "n_2"));
    if (!(n_2 > (std::isnan(n_1) ? 0.0 : n_1))) return;
    const double last = std::fmin(last_speed("motor"), last_speed("load"));
    if (!(n_2 < least * last)) return;
    add("n_2",
        say("n_2 = {1}, and the curves of motor and load extend to {2}: give the speed that the machine runs at, "
            "or because.n_2 = \"...\"",
            format_quantity(n_2, "rpm", 4), format_quantity(last, "rpm", 4)));
  }

  /// The last speed of a list of points; NaN if it has none.
  [[nodiscard]] double last_speed(std::string_view list) const {
    double most = std::nan("");
    for_each_leaf(step_.input().reading.record, [&](const std::string& path, const Leaf&) {
      if (path.starts_with(list) && path.ends_with(".n")) most = std::fmax(most, own_value(step_, project_, path));
    });
    return most;
  }

  /// A run at the speed of another step loads its shaft by the moment of the motor, unless a peak factor covers it.
  void compare_shaft() {
    const auto& operands = step_.input().reading.operands;
    const auto speed =
        std::find_if(operands.begin(), operands.end(), [&](const Operand& o) { return o.path == speed_path_; });
    if (speed == operands.end() || !speed->expression.is_reference()) return;
    const auto [name, key] = split_step(speed->expression.references().front().path);
    const double given = magnitude_at(project_, name + ".K_A"), K_A = std::isnan(given) ? 1.0 : given;
    if (std::isnan(given) && !loads_another(name)) return;
    const double T = std::abs(magnitude_at(project_, name + ".T" + key.substr(std::min<std::size_t>(1, key.size()))));
    if (!(moment_ > K_A * T * largest_peak_factor())) return;
    add(moment_path_, say("the motor moment of {1} is more than K_A T = {2} of '{3}': give the shaft k_max or the key "
                          "T_max, or because.motor = \"...\"",
                          format_quantity(moment_, "N*m", 4), format_quantity(K_A * T, "N*m", 4), name));
  }

  bool loads_another(const std::string& name) const {
    return std::any_of(project_.steps.begin(), project_.steps.end(),
                       [&](const auto& step) { return steps_loading(step->input().reading).contains(name); });
  }

  double largest_peak_factor() const {
    double most = 1.0;
    for (const auto& step : project_.steps) most = std::fmax(most, peak_factor_of(*step, project_));
    return most;
  }

  /// A flywheel at this speed is accelerated, too.
  void compare_flywheels() {
    for (const auto& wheel : project_.steps) {
      const Calculator* const calculator = wheel->input().calculator;
      if (!means(*calculator, "J", &is_inertia_of_flywheel)) continue;
      const double omega = own_value(*wheel, project_, "omega"), J = own_value(*wheel, project_, "J");
      if (!is_near(omega, speed_, slip)) continue;
      compare_motor(wheel->name(), own_value(*wheel, project_, "P_n") / std::abs(omega));
      if (is_named_in_parts(wheel->name()) || is_among_parts(J)) continue;
      add("parts", say("the flywheel '{1}' turns at this speed, and is not among the parts: add J = \"={1}.{2}\", or "
                       "because.parts = \"...\"",
                       wheel->name(), std::isnan(J) ? "J_F" : "J"));
    }
  }

  bool is_named_in_parts(const std::string& wheel) const {
    const auto names_it = [&](const Expression::Reference& reference) {
      return split_step(reference.path).first == wheel;
    };
    const auto& operands = step_.input().reading.operands;
    return std::any_of(operands.begin(), operands.end(), [&](const Operand& operand) {
      const auto& references = operand.expression.references();
      return operand.path.starts_with("parts") && std::any_of(references.begin(), references.end(), names_it);
    });
  }

  bool is_among_parts(double J) const {
    bool found = false;
    for_each_leaf(step_.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      const bool is_inertia = path.ends_with(".J") && leaf.field->is_number();
      found = found || (is_inertia && is_near(own_value(step_, project_, path), J, slip));
    });
    return found;
  }

  const Step& step_;
  const Project& project_;
  double speed_ = std::nan(""), moment_ = std::nan("");
  std::string speed_path_, moment_path_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

namespace {

/// Belts and chains have service factors of their own, which are lower than the application factors of gears.
bool has_service_factor(const Step& step) {
  const std::string_view id = step.input().calculator->id;
  return id.starts_with("belt.") || id.starts_with("chain.");
}

/// The record of a rated gear that a shaft takes, "bevel.gear_1"; empty if it takes none.
std::string gear_taken_by(const Step& shaft, const Step& step) {
  const std::string_view id = step.input().calculator->id;
  if (id != "gear.bevel" && id != "gear.worm") return {};
  for (const Taken& record : shaft.input().reading.records) {
    if (split_step(record.source).first == step.name()) return record.source;
  }
  return {};
}

}  // namespace

std::vector<ReducedLoad> factors_of_takers(const Step& step, const Project& project) {
  constexpr double rounding = 1e-6;
  std::vector<ReducedLoad> lower;
  const bool applies_one = applies_factor(step, "K_A") || applies_factor(step, "gamma_F");
  const std::set<std::string> values = applies_one ? shared_loads(step) : std::set<std::string>();
  const auto takers = applies_one ? takers_of(step, values, project) : std::vector<const Step*>();
  for (const char* const key : {"K_A", "gamma_F"}) {
    if (!applies_factor(step, key)) continue;
    const double own = applied_factor(step, project, key);
    for (const Step* const taker : takers) {
      if (have_same_default(step, *taker, key) || !applies_factor(*taker, key)) continue;
      if (has_service_factor(step) != has_service_factor(*taker)) continue;
      const double factor = applied_factor(*taker, project, key);
      if (!(factor > own * (1.0 + rounding))) continue;
      const std::string taken = load_taken_by(*taker, step);
      const std::string load = taken.empty() ? load_shared_with(values, *taker) : taken;
      if (const std::string gear = gear_taken_by(*taker, step); load.empty() && !gear.empty())
        lower.push_back({key, say("'{1}' applies {2} = {3} to '{4}'; here {2} is lower: give it here, and {2} = 1 "
                                  "there, or say why, because.{2} = \"...\"",
                                  taker->name(), key, format_number(factor, 4), gear)});
      if (load.empty()) continue;
      lower.push_back(
          {key, say("{1} takes '{2}' with {3} = {4}; here {3} is lower: give it, or the reason, because.{3} = \"...\"",
                    taker->name(), load, key, format_number(factor, 4))});
    }
  }
  return lower;
}

std::vector<ReducedLoad> values_of_runs(const Step& step, const Project& project) {
  return RunCheck(step, project).run();
}

}  // namespace loadpath::project
