#include "lib/project/references/machine/unlinked.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

/// Equal but for the digits that are typed.
bool is_alike(double one, double other) { return is_near(one, other, 1e-3); }

double typed_value(const Step& step, const Project& project, const char* path) {
  return std::abs(own_value(step, project, path));
}

/// The other bearing of the pair: it says so itself, and none has the load that is typed here for it.
void compare_load_of_mate(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const double F_r = typed_value(step, project, "F_r"), of_mate = typed_value(step, project, "mate.F_r");
  if (std::isnan(of_mate)) return;
  const Step* mate = nullptr;
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    const double there = typed_value(*other, project, "F_r");
    if (is_alike(there, of_mate)) return;
    if (is_alike(typed_value(*other, project, "mate.F_r"), F_r) && of_mate < there) mate = other.get();
  }
  if (mate == nullptr) return;
  found.push_back({"mate.F_r", say("mate.F_r = {1}, and '{2}', the other bearing of the pair, has {3}; justify it: "
                                   "because.mate.F_r = \"...\"",
                                   format_quantity(of_mate, "kN", 4), mate->name(),
                                   format_quantity(typed_value(*mate, project, "F_r"), "kN", 4))});
}

/// A given value, or that of the row.
double value_at(const Step& step, const Project& project, const char* path) {
  const double typed = typed_value(step, project, path);
  return std::isnan(typed) ? std::abs(magnitude_at(project, step.name() + "." + path)) : typed;
}

/// The factor Y of the other bearing, which says itself that this one is its mate: a larger one makes its induced
/// force F_r/(2 Y) too small.
void compare_factor_of_mate(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double few_digits = 0.02;
  const double F_r = typed_value(step, project, "F_r"), of_mate = typed_value(step, project, "mate.F_r");
  const double Y = typed_value(step, project, "mate.Y");
  const Step* mate = nullptr;
  if (std::isnan(Y)) return;
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    if (!is_alike(typed_value(*other, project, "F_r"), of_mate) ||
        !is_alike(typed_value(*other, project, "mate.F_r"), F_r))
      continue;
    if (!(Y > (1.0 + few_digits) * value_at(*other, project, "Y"))) return;
    mate = other.get();
  }
  if (mate == nullptr) return;
  found.push_back({"mate.Y", say("mate.Y = {1}, and '{2}', the other bearing of the pair, has {3}: write mate.Y = "
                                 "\"={2}.Y\", or because.mate.Y = \"...\"",
                                 format_number(Y, 4), mate->name(), format_number(value_at(*mate, project, "Y"), 4))});
}

std::string word_at(const Step& step, const char* path) {
  const Leaf leaf = find_leaf(step.input().reading.record, path);
  return leaf ? word_of(leaf) : std::string();
}

/// "left", "right": as given, or by the arrangement of the pair and the positions of both; empty if unknown.
std::string direction_carried(const Step& step, const Project& project) {
  if (const std::string given = word_at(step, "carries"); !given.empty()) return given;
  const std::string arrangement = word_at(step, "arrangement");
  if (arrangement.empty()) return {};
  const double x = own_value(step, project, "x"), of_mate = own_value(step, project, "mate.x");
  if (!(std::abs(x - of_mate) > 0.0)) return {};
  return (x < of_mate) == (arrangement == "back_to_back") ? "right" : "left";
}

/// The two bearings of a pair carry the axial force in opposite directions. Several pairs may have the same loads.
void compare_mate(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const std::string carried = direction_carried(step, project);
  const double F_r = typed_value(step, project, "F_r"), of_mate = typed_value(step, project, "mate.F_r");
  if (carried.empty() || std::isnan(of_mate)) return;
  std::vector<const Step*> mates;
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    if (is_alike(typed_value(*other, project, "F_r"), of_mate) &&
        is_alike(typed_value(*other, project, "mate.F_r"), F_r))
      mates.push_back(other.get());
  }
  const auto carries_same = [&](const Step* mate) { return direction_carried(*mate, project) == carried; };
  if (mates.empty() || !std::ranges::all_of(mates, carries_same)) return;
  const char* const key = word_at(step, "carries").empty() ? "arrangement" : "carries";
  found.push_back({key, say("'{1}' carries the axial force in the same direction; the two bearings of a pair carry "
                            "opposite ones: justify it: because.{2} = \"...\"",
                            mates.front()->name(), key)});
}

/// A fatigue limit in bending of a stress that is mainly axial: the limit in tension is lower.
void compare_loading(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& reading = step.input().reading;
  const Operand* const limit = reading.operand("sigma_D");
  const auto cycle = std::ranges::find(reading.records, "cycle", &Taken::path);
  if (limit == nullptr || limit->expression.references().size() != 1 || cycle == reading.records.end()) return;
  const Step* const source = project.find(split_step(limit->expression.references().front().path).first);
  if (source == nullptr) return;
  const Leaf loading = find_leaf(source->input().reading.record, "loading");
  if (!loading || word_of(loading) != "bending") return;
  const std::string part = split_step(cycle->source).first;
  const double sigma_N = std::abs(magnitude_at(project, part + ".sigma_N"));
  const double sigma_M = std::abs(magnitude_at(project, part + ".sigma_M"));
  if (!(sigma_N > sigma_M)) return;
  found.push_back(
      {"sigma_D",
       say("the stress of '{1}' is mainly axial, {2} of {3}, and sigma_D is the limit in bending: "
           "{4}.loading = \"tension\", or because.sigma_D = \"...\"",
           part, format_quantity(sigma_N, "MPa", 4), format_quantity(sigma_N + sigma_M, "MPa", 4), source->name())});
}

/// A motor that runs up, in a file with a hoist whose weights it does not lift.
void compare_hoist(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& fields = step.input().calculator->input->fields;
  const auto& typed = step.input().reading.typed;
  if (find_field(fields, "motor") == nullptr || find_field(fields, "load") == nullptr || typed.contains("load")) return;
  const auto lifts = [&](const auto& other) {
    return find_field(other->input().calculator->input->fields, "weights") != nullptr;
  };
  const auto hoist = std::ranges::find_if(project.steps, lifts);
  if (hoist == project.steps.end() || steps_named_in(step.input().reading).contains((*hoist)->name())) return;
  found.push_back({"motor", say("it runs up without load, and '{1}' has weights: give load, the moment at the motor "
                                "shaft over the speed, or because.motor = \"...\"",
                                (*hoist)->name())});
}

bool is_strength(const std::string& key) { return key == "R_e" || key == "R_m" || key == "R_p02"; }

/// The size that a strength of a table is looked up at.
double size_of(const Step& step, const Project& project) {
  for (const char* const key : {"d_h", "d", "t", "h"}) {
    const double size = own_value(step, project, key);
    if (!std::isnan(size)) return size;
  }
  return std::nan("");
}

/// An allowable stress by the strength of another part, which is thinner: the strength of this size is lower.
void compare_size(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double alike = 1.1;
  for (const Operand& operand : step.input().reading.operands) {
    const auto& references = operand.expression.references();
    if (references.size() != 1 || !means(*step.input().calculator, operand.path, &is_allowable)) continue;
    const auto [name, key] = split_step(references.front().path);
    const Step* const source = project.find(name);
    if (source == nullptr || !is_strength(key) || material_of(*source).empty()) continue;
    const double there = size_of(*source, project), here = size_of(step, project);
    if (std::isnan(there) || here <= alike * there) continue;
    found.push_back({operand.path, say("{1} comes from the strength of '{2}', of {3}: give this step the material and "
                                       "S, or because.{1} = \"...\"",
                                       operand.path, name, format_quantity(there, "mm", 4))});
  }
}

/// A density that is typed next to a modulus: no metal is stiffer for its density than this.
void compare_density(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double most = 4e7;  // m^2/s^2; steel, aluminium and titanium have 2.5e7 to 2.7e7
  const auto& typed = step.input().reading.typed;
  if (!typed.contains("rho") || !typed.contains("E")) return;
  const double rho = own_value(step, project, "rho"), E = own_value(step, project, "E");
  if (!(E > most * rho)) return;
  found.push_back({"rho", say("rho = {1} is too low for a metal of E = {2}: steel has 7850 kg/m^3; justify it: "
                              "because.rho = \"...\"",
                              format_quantity(rho, "kg/m^3", 4), format_quantity(E, "GPa", 4))});
}

/// A typed yield strength that the tensile strength of the material at this size does not reach.
void compare_yield(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  if (!step.input().reading.typed.contains("R_e") || step.input().reading.typed.contains("R_m")) return;
  if (material_of(step).empty() || find_field(step.input().calculator->input->fields, "R_m") == nullptr) return;
  const double R_e = own_value(step, project, "R_e"), R_m = magnitude_at(project, step.name() + ".R_m");
  if (!(R_e > R_m)) return;
  found.push_back({"R_e", say("R_e = {1} is above the tensile strength of '{2}' at this size, {3}; justify it: "
                              "because.R_e = \"...\"",
                              format_quantity(R_e, "MPa", 4), material_of(step), format_quantity(R_m, "MPa", 4))});
}

/// A rim whose moment of inertia no wheel of its diameter has: a steel cylinder as wide as its diameter is lighter.
void compare_rim(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double steel = 7850.0;
  if (step.field("m_rim") == nullptr) return;  // a diameter of other parts is not read
  const double D = own_value(step, project, "D"), m = magnitude_at(project, step.name() + ".m_rim");
  const double most = steel * std::numbers::pi / 4.0 * D * D * D;
  if (!(m > most)) return;
  found.push_back(
      {"D", say("a rim of D = {1} would need a mass of {2} for this moment of inertia, and a steel cylinder "
                "as wide as D has {3}: give a larger D, or because.D = \"...\"",
                format_quantity(D, "mm", 4), format_quantity(m, "kg", 4), format_quantity(most, "kg", 4))});
}

/// "9.81 mm/s^2": weights of a machine that are none.
void compare_gravity(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double least = 9.7, most = 9.9;  // m/s^2, on Earth
  if (!step.input().reading.typed.contains("gravity")) return;
  const double g = std::abs(own_value(step, project, "gravity"));
  if (!(g > 0.0) || (g >= least && g <= most)) return;
  found.push_back({"gravity", say("gravity = {1} is not that of the Earth, 9.81 m/s^2; justify it: because.gravity = "
                                  "\"...\"",
                                  format_quantity(g, "m/s^2", 4))});
}

}  // namespace

std::vector<ReducedLoad> values_of_unlinked(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  compare_load_of_mate(step, project, found);
  compare_factor_of_mate(step, project, found);
  compare_mate(step, project, found);
  compare_loading(step, project, found);
  compare_hoist(step, project, found);
  compare_size(step, project, found);
  compare_density(step, project, found);
  compare_yield(step, project, found);
  compare_rim(step, project, found);
  compare_gravity(step, project, found);
  return found;
}

}  // namespace loadpath::project
