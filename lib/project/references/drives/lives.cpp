#include "lib/project/references/drives/lives.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

bool share_one(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& name) { return b.contains(name); });
}

/// The gears that a step rates: itself, or those whose values it takes.
std::set<std::string> drives_of(const Step& step) {
  if (!std::string_view(step.input().calculator->id).starts_with("gear.")) return {};
  std::set<std::string> drives = steps_named_in(step.input().reading);
  drives.insert(step.name());
  return drives;
}

/// Whether its speed is one of these drives as it is: both are on one shaft.
bool takes_speed_of(const Step& step, const std::set<std::string>& drives) {
  return std::ranges::any_of(step.input().reading.operands, [&](const Operand& operand) {
    return operand.path == "n" && operand.expression.is_reference() &&
           drives.contains(split_step(operand.expression.references().front().path).first);
  });
}

double required_life(const Step& step, const Project& project) { return own_value(step, project, "L_h"); }

}  // namespace

std::vector<ReducedLoad> lives_on_shaft(const Step& step, const Project& project) {
  const double own = required_life(step, project);
  if (std::isnan(own)) return {};
  const std::set<std::string> loading = steps_loading(step.input().reading);
  std::set<std::string> near = loading;  // and the shafts that carry what loads this step
  for (const auto& shaft : project.steps) {
    if (shaft.get() != &step && share_one(steps_loading(shaft->input().reading), loading)) near.insert(shaft->name());
  }
  std::vector<ReducedLoad> shorter;
  const std::set<std::string> drives = drives_of(step);
  for (const auto& other : project.steps) {
    const double life = required_life(*other, project);
    if (other.get() == &step || !(life > own * (1.0 + 1e-6))) continue;
    if (!share_one(steps_loading(other->input().reading), near) && !takes_speed_of(*other, drives)) continue;
    shorter.push_back({"L_h", say("L_h = {1} is shorter than that of '{2}' in the same machine, {3}; justify it: "
                                  "because.L_h = \"...\"",
                                  format_quantity(own, "h", 4), other->name(), format_quantity(life, "h", 4))});
    break;
  }
  return shorter;
}

}  // namespace loadpath::project
