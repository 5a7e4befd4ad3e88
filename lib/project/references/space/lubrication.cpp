#include "lib/project/references/space/lubrication.hpp"

#include "lib/project/references/origins.hpp"

#include <cmath>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr std::string_view rated_bearing = "bearing.rolling";

bool is_bearing(const Step& step) { return rated_bearing == step.input().calculator->id; }

/// Whether the rating life includes the lubricant, by nu or kappa, or a life factor given as a whole.
bool has_lubricant(const Step& step, const Project& project) {
  return !std::isnan(own_value(step, project, "nu")) || !std::isnan(own_value(step, project, "kappa"));
}

/// A bearing at rest, or without a required life, is not rated for one.
bool has_life(const Step& step, const Project& project) {
  return own_value(step, project, "L_h") > 0.0 || own_value(step, project, "L_m") > 0.0;
}

}  // namespace

std::vector<ReducedLoad> lubrication_of_others(const Step& step, const Project& project) {
  if (!is_bearing(step) || !has_life(step, project) || has_lubricant(step, project)) return {};
  for (const auto& other : project.steps) {
    if (other.get() == &step || !is_bearing(*other) || !has_lubricant(*other, project)) continue;
    return {{"nu", say("lubrication and contamination are not included (a_ISO = 1), and '{1}' includes them: give nu "
                       "and e_C, or because.nu = \"...\"",
                       other->name())}};
  }
  return {};
}

}  // namespace loadpath::project
