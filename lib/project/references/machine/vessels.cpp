#include "lib/project/references/machine/vessels.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/gravity.hpp"
#include "lib/table/largest.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double few_digits = 1e-3;  // of a value that is typed

bool hands_over(const Step& step, std::string_view key) {
  const Calculator* const calculator = step.input().calculator;
  const FieldInfo* const field = calculator->result == nullptr ? nullptr : find_field(calculator->result->fields, key);
  return field != nullptr && field->is_handed_over;
}

bool is_wall(const Step& step) { return std::string_view(step.input().calculator->id).starts_with("vessel."); }

/// The first step that hands over such a record; null if there is none.
const Step* step_with(const Project& project, std::string_view key) {
  const auto found = std::ranges::find_if(project.steps, [&](const auto& step) { return hands_over(*step, key); });
  return found == project.steps.end() ? nullptr : found->get();
}

/// Whether the step takes this record as a whole: a size by itself leaves out the allowance and the pressure.
bool takes_record(const Step& step, std::string_view key) {
  return std::ranges::find(step.input().reading.records, key, &Taken::path) != step.input().reading.records.end();
}

/// What the step has typed of a shell that it could refer to: "p, D_i, c".
std::string typed_of_shell(const Step& step) {
  std::string keys;
  for (const char* const key : {"p", "D_i", "D_o", "c"})
    if (step.input().reading.typed.contains(key)) keys += (keys.empty() ? "" : ", ") + std::string(key);
  return keys;
}

/// An end whose pressure is typed, in a file with a shell that it does not refer to.
void compare_shell(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& fields = step.input().calculator->input->fields;
  if (find_field(fields, "shell") == nullptr || !step.input().reading.typed.contains("p")) return;
  const Step* const shell = step_with(project, "shell");
  if (shell == nullptr || takes_record(step, "shell")) return;
  found.push_back(
      {"p", say("the end gives {2} itself next to '{1}': replace them by shell = \"={1}.shell\", or justify "
                "it for another vessel: because.p = \"...\"",
                shell->name(), typed_of_shell(step))});
}

/// The share of its thickness that the shell needs, below which an end may not count on its strength.
void compare_share(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& records = step.input().reading.records;
  const auto shell = std::ranges::find(records, "shell", &Taken::path);
  if (shell == records.end() || !step.input().reading.typed.contains("m_r")) return;
  const std::string name = split_step(shell->source).first;
  const double c = magnitude_at(project, shell->source + ".c"), allowed = std::isnan(c) ? 0.0 : c;
  const double share =
      (magnitude_at(project, name + ".delta_min") - allowed) / (magnitude_at(project, name + ".delta") - allowed);
  const double m_r = own_value(step, project, "m_r");
  if (!(m_r < (1.0 - few_digits) * share)) return;
  found.push_back({"m_r", say("m_r = {1}, and '{2}' needs {3} of its thickness; justify it: because.m_r = \"...\"",
                              format_number(m_r, 4), name, format_number(share, 4))});
}

/// An end is tested with the pressure of the shell whose record it takes.
void compare_test(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& records = step.input().reading.records;
  const auto shell = std::ranges::find(records, "shell", &Taken::path);
  if (shell == records.end()) return;
  const std::string name = split_step(shell->source).first;
  const Step* const tested = project.find(name);
  if (tested == nullptr) return;
  const double p_t = own_value(step, project, "p_t"), of_shell = own_value(*tested, project, "p_t");
  if (std::isnan(p_t) && of_shell > 0.0) {
    found.push_back({"p_t", say("'{1}' is tested with {2}, and this end is not assessed for it: give p_t, or "
                                "because.p_t = \"...\"",
                                name, format_quantity(of_shell, "MPa", 4))});
    return;
  }
  if (!(p_t < (1.0 - few_digits) * of_shell)) return;
  found.push_back({"p_t", say("p_t = {1}, and '{2}' is tested with {3}; justify it: because.p_t = \"...\"",
                              format_quantity(p_t, "MPa", 4), name, format_quantity(of_shell, "MPa", 4))});
}

/// A wall under external pressure whose thickness is typed, in a file with the wall of a vessel that it does not take.
void compare_vacuum(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& fields = step.input().calculator->input->fields;
  if (find_field(fields, "wall") == nullptr || find_field(fields, "p_e") == nullptr) return;
  if (!step.input().reading.typed.contains("delta") || takes_record(step, "wall")) return;
  const auto named = steps_named_in(step.input().reading);
  const auto is_of_wall = [&](const std::string& name) { return is_wall(*project.find(name)); };
  const auto has_record = [&](const std::string& name) { return hands_over(*project.find(name), "wall"); };
  const bool takes_sizes = std::ranges::any_of(named, is_of_wall) && std::ranges::none_of(named, has_record);
  if (takes_sizes) return;  // of a wall without a record
  const Step* const wall = step_with(project, "wall");
  if (wall == nullptr) return;
  found.push_back({"delta", say("this step does not refer to '{1}', whose diameter, thickness and allowance it has: "
                                "give wall = \"={1}.wall\", or because.delta = \"...\" if it is of another vessel",
                                wall->name())});
}

/// Whether a step under external pressure takes the record or the sizes of this wall.
bool is_assessed_from_outside(const Step& wall, const Project& project) {
  return std::ranges::any_of(project.steps, [&](const auto& step) {
    return find_field(step->input().calculator->input->fields, "p_e") != nullptr &&
           find_field(step->input().calculator->input->fields, "wall") != nullptr &&
           steps_named_in(step->input().reading).contains(wall.name());
  });
}

/// An end of a shell that is assessed under external pressure.
void compare_end_in_vacuum(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& records = step.input().reading.records;
  const auto shell = std::ranges::find(records, "shell", &Taken::path);
  if (shell == records.end() || is_assessed_from_outside(step, project) || step.input().accepted.contains("vacuum"))
    return;
  const Step* const wall = project.find(split_step(shell->source).first);
  if (wall == nullptr || !is_assessed_from_outside(*wall, project)) return;
  found.push_back({"p", say("'{1}' is assessed under external pressure, and this end is not: add a step of "
                            "vessel.external with its sizes, D_a and delta = \"={2}.delta\", or because.p = \"...\"",
                            wall->name(), step.name())});
}

/// A wall without the liquid of another one of its vessel: the same [values] give their pressure, or it takes the
/// record of that shell.
void compare_liquid(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& own = step.input().reading;
  const auto typed = own.typed.find("p");
  if (typed == own.typed.end()) return;
  const auto pressure_at_bottom = [&](const Step& wall) {
    const double head = standard_gravity * own_value(wall, project, "rho") * own_value(wall, project, "h_l");
    return own_value(wall, project, "p") + (std::isnan(head) ? 0.0 : head);
  };
  const bool may_hold_liquid = find_field(step.input().calculator->input->fields, "rho") != nullptr;
  const auto shell = std::ranges::find(own.records, "shell", &Taken::path);
  const std::string of_record = shell == own.records.end() ? "" : split_step(shell->source).first;
  for (const auto& other : project.steps) {
    const auto& there = other->input().reading;
    const auto pressure = there.typed.find("p");
    if (other.get() == &step || pressure == there.typed.end() || !there.typed.contains("h_l")) continue;
    const bool is_shared = !typed->second.shared.empty() && typed->second.shared == pressure->second.shared;
    if (!is_shared && other->name() != of_record) continue;
    const double p = pressure_at_bottom(*other);
    if (!(pressure_at_bottom(step) < (1.0 - few_digits) * p)) continue;
    const std::string at_bottom = format_quantity(p, "MPa", 4);
    found.push_back({"p", may_hold_liquid
                              ? say("'{1}' holds a liquid: {2} at its lowest point; give rho and h_l, or that "
                                    "pressure as p, or because.p = \"above the liquid\"",
                                    other->name(), at_bottom)
                              : say("'{1}' holds a liquid: {2} at its lowest point; give that pressure as p, or "
                                    "because.p = \"above the liquid\"",
                                    other->name(), at_bottom)});
    return;
  }
}

/// The value of [values] that is the pressure of a wall; empty if none is.
std::string shared_pressure(const Step& step) {
  const auto& typed = step.input().reading.typed;
  const auto pressure = typed.find("p");
  return pressure == typed.end() ? std::string() : pressure->second.shared;
}

/// Whether two walls are of one vessel: one takes values of the other, or both the same pressure.
bool are_of_one_vessel(const Step& wall, const Step& other) {
  if (steps_named_in(other.input().reading).contains(wall.name())) return true;
  if (steps_named_in(wall.input().reading).contains(other.name())) return true;
  const std::string pressure = shared_pressure(wall);
  return !pressure.empty() && pressure == shared_pressure(other);
}

/// The allowable stress of a wall without a material, next to another one of its vessel.
void compare_wall(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double least = 1.5;  // against yielding, as of every wall
  const auto& typed = step.input().reading.typed;
  if (!is_wall(step) || !typed.contains("sigma_adm") || !material_of(step).empty()) return;
  const double sigma = own_value(step, project, "sigma_adm");
  for (const auto& end : project.steps) {
    if (end.get() == &step || material_of(*end).empty() || !are_of_one_vessel(step, *end)) continue;
    const auto row = project.tables->find_row("material", material_of(*end));
    const double R_e = row ? table::largest_value(*row, "R_e") : std::nan("");
    if (!(least * sigma > (1.0 + 1e-3) * R_e)) continue;
    found.push_back(
        {"sigma_adm", say("sigma_adm = {1} is above R_e/{2} of '{3}', the material of '{4}'; justify it: "
                          "because.sigma_adm = \"...\"",
                          format_quantity(sigma, "MPa", 4), format_number(least, 2), material_of(*end), end->name())});
    return;
  }
}

}  // namespace

std::vector<ReducedLoad> values_of_vessels(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  compare_shell(step, project, found);
  compare_share(step, project, found);
  compare_test(step, project, found);
  compare_vacuum(step, project, found);
  compare_end_in_vacuum(step, project, found);
  compare_liquid(step, project, found);
  compare_wall(step, project, found);
  return found;
}

}  // namespace loadpath::project
