#include "lib/project/references/agreement/stated_motors.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double motor_slip = 0.1;      // of the speed of a motor
constexpr double weakest_motor = 0.95;  // power of the motor over that of the drive: rounded values

const Dimension power = Dimension::of(2, 1, -3);
const Dimension work_or_torque = Dimension::of(2, 1, -2);
const Dimension rate = Dimension::of(0, 0, -1);

constexpr std::array speeds{"n_1", "n", "n_2"};

/// The speed that a drive starts from, if it is typed in the step: "n_1" of a pair, "n" of a bearing. Pins of links
/// swing.
std::string typed_speed(const Step& step) {
  if (std::string_view(step.input().calculator->id).starts_with("pin.")) return {};
  for (const char* const key : {"n_1", "n"}) {
    if (!step.input().reading.typed.contains(key)) continue;
    const FieldInfo* const field = find_field(step.input().calculator->input->fields, key);
    if (field != nullptr && field->dimension.without_angle() == rate) return key;
  }
  return {};
}

bool is_first_of_drive(const Step& step, const Project& project) {
  const auto first = std::ranges::find_if(project.steps, [](const auto& one) { return !typed_speed(*one).empty(); });
  return first != project.steps.end() && first->get() == &step;
}

/// Whether a shaft of the file has this speed, but for the slip: of an input, a result, or a train.
bool is_speed_of_shaft(double n, const Project& project) {
  const auto is_it = [&](double there) { return is_near(std::abs(there), std::abs(n), motor_slip); };
  return std::ranges::any_of(project.steps, [&](const auto& step) {
    for (const char* const key : speeds) {
      if (is_it(own_value(*step, project, key)) || is_it(magnitude_at(project, step->name() + "." + key))) return true;
    }
    for (int k = 1;; ++k) {
      const double there = magnitude_at(project, step->name() + ".shafts[" + std::to_string(k) + "].n");
      if (std::isnan(there)) return false;
      if (is_it(there)) return true;
    }
  });
}

/// Whether a ratio of [values] leads from this speed to that of the drive: a geared motor, "i_gear = 23.7".
bool is_geared(double n, double drive, const Project& project) {
  return std::ranges::any_of(project.values.unused(), [&](const auto& entry) {
    const auto& [name, value] = entry;
    const double i = std::abs(value.si.front());
    const bool is_ratio = value.signature.dimension.is_number() && has_word(name, {"i", "ratio"});
    return is_ratio && is_near(n / i, drive, motor_slip);
  });
}

bool is_motor(std::string_view name) { return has_word(name, {"motor", "mot", "engine"}); }

class MotorCheck {
 public:
  MotorCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    speed_ = typed_speed(step_);
    if (speed_.empty() || !is_first_of_drive(step_, project_)) return {};
    for (const auto& [name, value] : project_.values.unused()) {
      const Dimension& dimension = value.signature.dimension;
      const double si = std::abs(value.si.front());
      if (dimension.without_angle() == rate) compare_speed(name, si);
      if (!is_motor(name)) continue;
      if (dimension == power) compare_power(name, si);
      if (dimension == work_or_torque) compare_torque(name, si);
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& key, const std::string& name, const std::string& stated, const std::string& here) {
    found_.push_back({key, say("values.{1} = {2} acts on no step, and the drive has {3}: refer to it, delete it, or "
                               "justify it: because.{4} = \"...\"",
                               name, stated, here, key)});
  }

  /// "n_motor", "n", or "n_drum" of a part of the machine, which is the speed of no shaft.
  void compare_speed(const std::string& name, double si) {
    const bool is_speed =
        name == "n" || name == "n_1" || (name.starts_with("n_") && (is_motor(name) || is_of_machine(name, project_)));
    const double here = std::abs(own_value(step_, project_, speed_));
    if (!is_speed || std::isnan(here) || is_speed_of_shaft(si, project_)) return;
    if (si < here && is_overspeed_of(name)) return;
    if (is_geared(si, here, project_)) return;
    add(speed_, name, format_quantity(si, "rpm", 4), speed_ + " = " + format_quantity(here, "rpm", 4));
  }

  /// "n_over" in the step, for "n": the part is assessed for more than its speed.
  [[nodiscard]] bool is_overspeed_of(const std::string& name) const {
    const std::string& taken = step_.input().reading.typed.at(speed_).shared;
    return taken.starts_with("values." + name + "_") && is_of_overspeed(taken);
  }

  /// A motor that is weaker than its drive.
  void compare_power(const std::string& name, double si) {
    const double P = std::abs(own_value(step_, project_, "P"));
    constexpr double strongest = 4.0;  // times the power of its drive: beyond, one of them is mistyped
    if (si < weakest_motor * P || si > strongest * P)
      add("P", name, format_quantity(si, "kW", 4), "P = " + format_quantity(P, "kW", 4));
  }

  void compare_torque(const std::string& name, double si) {
    const double P = std::abs(own_value(step_, project_, "P")), n = std::abs(own_value(step_, project_, speed_));
    const double T_1 = std::abs(own_value(step_, project_, "T_1")), T = std::isnan(T_1) ? P / n : T_1;
    if (!(si < weakest_motor * T)) return;
    add(std::isnan(T_1) ? "P" : "T_1", name, format_quantity(si, "N*m", 4),
        "a torque of " + format_quantity(T, "N*m", 4));
  }

  const Step& step_;
  const Project& project_;
  std::string speed_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> motors_stated_only(const Step& step, const Project& project) {
  return MotorCheck(step, project).run();
}

}  // namespace loadpath::project
