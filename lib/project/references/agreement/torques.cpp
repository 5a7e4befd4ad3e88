#include "lib/project/references/agreement/torques.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double equal_torques = 1e-3;  // of a torque that is typed twice

bool is_typed(const Step& step, const char* key) { return step.input().reading.typed.contains(key); }

/// Whether the torque is a number of this step, not a value of another one.
bool types_torque(const Step& step) { return is_typed(step, "T") && step.input().reading.operand("T") == nullptr; }

/// A connection of a shaft that leaves both the application factor and the peak torque to their defaults.
bool leaves_out_factor(const Step& step) {
  const Calculator* const calculator = step.input().calculator;
  if (!std::string_view(calculator->id).starts_with("shaft.") || !connects(step)) return false;
  return find_field(calculator->input->fields, "K_A") != nullptr && types_torque(step) && !is_typed(step, "K_A") &&
         !is_typed(step, "T_max");
}

/// Belts and chains have service factors of their own.
bool has_application_factor(const Step& step) {
  const Calculator* const calculator = step.input().calculator;
  if (!is_typed(step, "K_A")) return false;
  const std::string_view id = calculator->id;
  return !id.starts_with("belt.") && !id.starts_with("chain.");
}

/// Whether a step has this nominal torque, as an input or a result.
bool has_torque(const Step& step, double T, const Project& project) {
  const auto is_it = [&](double there) { return is_near(std::abs(there), T, equal_torques); };
  for (const char* const key : {"T", "T_1", "T_2"}) {
    if (is_it(own_value(step, project, key)) || is_it(magnitude_at(project, step.name() + "." + key))) return true;
  }
  return false;
}

}  // namespace

std::vector<ReducedLoad> factors_of_torque(const Step& step, const Project& project) {
  if (!leaves_out_factor(step)) return {};
  for (const auto& other : project.steps) {
    if (other.get() == &step || !has_application_factor(*other)) continue;
    const double T = std::abs(own_value(step, project, "T")), K_A = own_value(*other, project, "K_A");
    if (!(K_A > 1.0) || !(T > 0.0) || !has_torque(*other, T, project)) continue;
    return {
        {"K_A", say("'{1}' has the same torque {2} with K_A = {3}, and no K_A is given here: give it, or the reason: "
                    "because.K_A = \"...\"",
                    other->name(), format_quantity(T, "N*m", 4), format_number(K_A, 4))}};
  }
  return {};
}

}  // namespace loadpath::project
