#include "lib/project/references/drives/taken_powers.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/drives/products.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double as_typed = 0.05;  // slip, and speeds with few digits
const Dimension a_speed = Dimension::of(0, 0, -1);

/// The speed of the shaft that a power belongs to: "worm.n_2" of "worm.P_2", "train.shafts[2].n" of
/// "train.shafts[2].P"; empty of a power that belongs to no single shaft.
std::string speed_of(const std::string& power) {
  const std::size_t dot = power.rfind('.');
  const std::string key = power.substr(dot + 1), at = power.substr(0, dot + 1);
  if (key == "P_2") return at + "n_2";
  return key == "P" && at.ends_with("].") ? at + "n" : std::string();
}

/// The word of a part in a name: "fan" of "values.n_fan"; empty of "values.n_1", which names none.
std::string_view part_of(std::string_view path) {
  constexpr std::size_t fewest_letters = 3;
  const std::string_view word = path.substr(path.find_last_of("_.") + 1);
  return word.size() < fewest_letters ? std::string_view() : word;
}

/// The speed in a torque of P/n, without a ratio or an efficiency; empty of any other load.
std::string speed_in(const Operand& operand, const Project& project) {
  if (operand.expression.is_reference() || operand.leaf.field->dimension.without_angle() != Dimension::of(2, 1, -2))
    return {};
  const std::optional<Product> product = product_of(operand, project);
  if (!product || !product->rest.empty()) return {};
  std::string speed;
  for (const Product::Power& one : product->powers) {
    const bool is_speed = one.dimension.without_angle() == a_speed && one.exponent == -1;
    if (is_speed) speed = one.path;
    if (!is_speed && one.dimension != Dimension::of(2, 1, -3) && !is_application_factor(one.path)) return {};
  }
  return speed;
}

/// The speed of [values] that the shaft of this step has by its name, lower than another one: of a step with both.
std::string slower_shaft(const Step& step, const Project& project, const std::string& speed) {
  const double here = value_of_file(project, speed)->si.front();
  for (const std::size_t position : project.takers.of(speed)) {
    for (const auto& [key, typed] : project.steps[position]->input().reading.typed) {
      const std::string_view part = part_of(typed.shared);
      if (part.empty() || !is_named(step, part)) continue;
      const Value* const there = value_of_file(project, typed.shared);
      if (there == nullptr || there->is_series() || there->signature.dimension.without_angle() != a_speed) continue;
      if (there->si.front() > 0.0 && there->si.front() < (1.0 - as_typed) * here) return typed.shared;
    }
  }
  return {};
}

}  // namespace

std::vector<ReducedLoad> torques_of_faster_shafts(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  for (const Operand& operand : step.input().reading.operands) {
    const std::string speed = speed_in(operand, project);
    if (speed.empty() || is_named(step, part_of(speed))) continue;
    const std::string slower = slower_shaft(step, project, speed);
    if (slower.empty()) continue;
    const auto shown = [&](const std::string& path) {
      return format_quantity(value_of_file(project, path)->si.front(), "rpm", 5);
    };
    found.push_back(
        {operand.path, say("{1} is the torque at '{2}' = {3}, and the shaft of this step turns at '{4}' = "
                           "{5}: take the torque of this shaft, or justify it: {6} = \"...\"",
                           operand.path, speed, shown(speed), slower, shown(slower), because_key(operand.path))});
  }
  return found;
}

std::vector<ReducedLoad> speeds_of_taken_powers(const Step& step, const Project& project) {
  const Operand* const power = step.input().reading.operand("P");
  if (power == nullptr || !power->expression.is_reference()) return {};
  const std::string source = power->expression.references().front().path, path = speed_of(source);
  if (path.empty()) return {};
  const std::string key = std::isnan(own_value(step, project, "n_1")) ? "n" : "n_1";
  if (const Operand* const speed = step.input().reading.operand(key);
      speed != nullptr && speed->expression.is_reference()) {
    const std::string& taken = speed->expression.references().front().path;
    if (taken.ends_with("].n") && split_step(taken).first == split_step(source).first) return {};  // losses left out
  }
  const double own = std::abs(own_value(step, project, key)), there = std::abs(magnitude_at(project, path));
  if (!(there > 0.0) || !(std::abs(own - there) > as_typed * there)) return {};
  return {{key, say("{1} = {2}, and the shaft that '{3}' is taken from turns at {4}: give {1} = \"={5}\", or "
                    "because.{1} = \"...\"",
                    key, format_quantity(own, "rpm", 5), source, format_quantity(there, "rpm", 5), path)}};
}

}  // namespace loadpath::project
