#include "lib/project/references/drives/taken_powers.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double as_typed = 0.05;  // slip, and speeds with few digits

/// The speed of the shaft that a power belongs to: "worm.n_2" of "worm.P_2", "train.shafts[2].n" of
/// "train.shafts[2].P"; empty of a power that belongs to no single shaft.
std::string speed_of(const std::string& power) {
  const std::size_t dot = power.rfind('.');
  const std::string key = power.substr(dot + 1), at = power.substr(0, dot + 1);
  if (key == "P_2") return at + "n_2";
  return key == "P" && at.ends_with("].") ? at + "n" : std::string();
}

}  // namespace

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
