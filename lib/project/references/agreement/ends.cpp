#include "lib/project/references/agreement/ends.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/gravity.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double as_typed = 1e-3;  // of a value with few digits
constexpr double of_wall = 0.1;    // of a radius: to the inner, middle or outer surface of a thin wall

/// The key of the radius at the shell, of a cone, an ellipsoid or a hemisphere; empty for other steps.
const char* edge_of(const Step& step) {
  if (id_of(step) == "vessel.cone" || id_of(step) == "vessel.sphere") return "R";
  return id_of(step) == "vessel.ellipsoid" ? "a" : "";
}

/// The radius of a shell, or of the shell that a dished end is typed for; NaN of other steps.
double radius_of_shell(const Step& step, const Project& project) {
  if (id_of(step) == "vessel.cylinder") return own_value(step, project, "R");
  const bool is_end = id_of(step) == "vessel.end" && step.input().reading.typed.contains("D_i");
  return is_end ? 0.5 * own_value(step, project, "D_i") : std::nan("");
}

/// "values.p", which its pressure was written as.
std::string pressure_of(const Step& step) {
  const auto typed = step.input().reading.typed.find("p");
  return typed == step.input().reading.typed.end() ? "" : typed->second.shared;
}

/// Whether both have the pressure of the same [values], or the same number.
bool have_one_pressure(const Step& end, const Step& shell, const Project& project) {
  const std::string shared = pressure_of(end);
  if (!shared.empty()) return pressure_of(shell) == shared;
  const double p = own_value(end, project, "p");
  return p > 0.0 && is_near(own_value(shell, project, "p"), p, as_typed);
}

/// A cone, an ellipsoid or a hemisphere with the pressure of the shells of the file, none of which has its radius.
void compare_radius(const Step& end, const Project& project, std::vector<ReducedLoad>& found) {
  const std::string edge = edge_of(end);
  if (edge.empty() || !end.input().reading.typed.contains(edge)) return;
  const Step* nearest = nullptr;
  double least = 0.0;
  for (const auto& shell : project.steps) {
    const double R = radius_of_shell(*shell, project);
    if (std::isnan(R) || !have_one_pressure(end, *shell, project)) continue;
    const double own = own_value(end, project, edge), apart = std::abs(R - own);
    if (std::isnan(apart) || apart <= of_wall * own) return;
    if (nearest == nullptr || apart < least) nearest = shell.get(), least = apart;
  }
  if (nearest == nullptr) return;
  found.push_back(
      {edge, say("{1} = {2}, and '{3}', with the same pressure, is for R = {4}: correct one of them, or because.{1} = "
                 "\"...\" if it closes another vessel",
                 edge, format_quantity(own_value(end, project, edge), "mm", 4), nearest->name(),
                 format_quantity(radius_of_shell(*nearest, project), "mm", 4))});
}

/// The pressure of the test at the lowest point, under a column of water.
double test_pressure(const Step& step, const Project& project) {
  constexpr double water = 1000.0;  // kg/m^3
  const double h_t = own_value(step, project, "h_t");
  return own_value(step, project, "p_t") + (std::isnan(h_t) ? 0.0 : standard_gravity * water * h_t);
}

/// An end with less water at the test than its shell.
void compare_water(const Step& end, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& records = end.input().reading.records;
  const auto record = std::ranges::find(records, "shell", &Taken::path);
  if (record == records.end()) return;
  const Step* const shell = project.find(split_step(record->source).first);
  if (shell == nullptr) return;
  const double h_t = own_value(end, project, "h_t"), of_shell = own_value(*shell, project, "h_t");
  if (!(h_t < (1.0 - as_typed) * of_shell)) return;
  const double p = test_pressure(end, project), there = test_pressure(*shell, project);
  if (!(p < there) || own_value(end, project, "p_t") < (1.0 - as_typed) * own_value(*shell, project, "p_t")) return;
  found.push_back({"h_t", say("h_t = {1}, and the test of '{2}' has {3} of water, {4} at its lowest point: write h_t = "
                              "\"={2}.h_t\", or because.h_t = \"...\" if this end is higher",
                              format_quantity(h_t, "m", 4), shell->name(), format_quantity(of_shell, "m", 4),
                              format_quantity(there, "MPa", 5))});
}

}  // namespace

std::vector<ReducedLoad> ends_of_vessel(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  compare_radius(step, project, found);
  compare_water(step, project, found);
  return found;
}

}  // namespace loadpath::project
