#include "lib/project/references/machine/chained_drives.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double least_efficiency = 0.85;  // of one drive
constexpr double most_power = 1.1;         // over the power of the drive before: rounded values

bool is_inertia_of_wheel(std::string_view what) { return what == inertia_of_flywheel; }
bool is_flywheel(const Step& step) { return means(*step.input().calculator, "J", &is_inertia_of_wheel); }

/// The load of a drive, "P" or "T_1"; empty if it has none.
std::string load_of(const Step& step, const Project& project) {
  for (const char* const key : {"P", "T_1"}) {
    if (!std::isnan(own_value(step, project, key))) return key;
  }
  return {};
}

double power_of(const Step& step, const Project& project) {
  const std::string load = load_of(step, project);
  if (load == "P") return std::abs(own_value(step, project, "P"));
  return load.empty() ? std::nan("") : std::abs(own_value(step, project, "T_1") * own_value(step, project, "n_1"));
}

/// The mean power of a flywheel, at its shaft or at its motor: the smaller one; NaN if it has no net work.
double power_of_flywheel(const Step& wheel, const Project& project) {
  return std::fmin(std::abs(magnitude_at(project, wheel.name() + ".P_m")),
                   std::abs(magnitude_at(project, wheel.name() + ".P")));
}

/// The drive whose output speed is the input speed of the step, its sign aside, or the flywheel of that speed; null if
/// there is none.
const Step* drive_before(const Step& step, const Project& project) {
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path != "n_1" && operand.path != "n") continue;
    const auto& references = operand.expression.references();
    if (references.size() != 1) continue;
    const auto [name, rest] = split_step(references.front().path);
    const Step* const source = project.find(name);
    if (source == nullptr || source == &step) continue;
    if (rest == "n_2" || (rest == "omega" && is_flywheel(*source))) return source;
  }
  return nullptr;
}

/// Whether a load of the step is one of the other: it is compared there.
bool takes_load_from(const Step& step, const std::string& name) {
  const auto& operands = step.input().reading.operands;
  return std::any_of(operands.begin(), operands.end(), [&](const Operand& operand) {
    const auto& references = operand.expression.references();
    return operand.leaf.field->is_load && std::any_of(references.begin(), references.end(), [&](const auto& one) {
             return split_step(one.path).first == name;
           });
  });
}

/// Whether its load is one of the other as it is: of the driving shaft, say, in place of the driven one.
bool takes_plain_load_from(const Step& step, const std::string& name) {
  return std::ranges::any_of(step.input().reading.operands, [&](const Operand& operand) {
    return operand.leaf.field->is_load && operand.expression.is_reference() &&
           split_step(operand.expression.references().front().path).first == name;
  });
}

}  // namespace

std::vector<ReducedLoad> powers_of_chained(const Step& step, const Project& project) {
  const Step* const before = drive_before(step, project);
  if (before == nullptr) return {};
  const bool is_taken = takes_load_from(step, before->name());
  if (is_taken && !takes_plain_load_from(step, before->name())) return {};
  const std::string load = load_of(step, project);
  const double own = power_of(step, project);
  const bool is_of_flywheel = is_flywheel(*before);
  const double given = is_of_flywheel ? power_of_flywheel(*before, project) : power_of(*before, project);
  if (load.empty() || std::isnan(own) || !(given > 0.0)) return {};
  if (is_of_flywheel) {
    if (own >= least_efficiency * given) return {};
    return {{load, say("{1} corresponds to {2}, and '{3}', whose speed is used, has a mean power of {4}; justify it: "
                       "because.{1} = \"...\"",
                       load, format_quantity(own, "kW", 4), before->name(), format_quantity(given, "kW", 4))}};
  }
  // A load that is taken may hold an application factor, and is compared with its source elsewhere.
  if (own >= least_efficiency * given && (is_taken || own <= most_power * given)) return {};
  return {{load, say("{1} corresponds to {2}, and '{3}', whose output speed is used, transmits {4}; justify it: "
                     "because.{1} = \"...\"",
                     load, format_quantity(own, "kW", 4), before->name(), format_quantity(given, "kW", 4))}};
}

}  // namespace loadpath::project
