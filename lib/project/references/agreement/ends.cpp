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

std::string_view id_of(const Step& step) {
  return step.input().calculator == nullptr ? std::string_view() : std::string_view(step.input().calculator->id);
}

/// The key of the radius at the shell, of a cone or an ellipsoid; empty for other steps.
const char* edge_of(const Step& step) {
  if (id_of(step) == "vessel.cone") return "R";
  return id_of(step) == "vessel.ellipsoid" ? "a" : "";
}

/// "values.p", which its pressure was written as.
std::string pressure_of(const Step& step) {
  const auto typed = step.input().reading.typed.find("p");
  return typed == step.input().reading.typed.end() ? "" : typed->second.shared;
}

/// A cone or an ellipsoid with the pressure of the shells of the file, none of which has its radius.
void compare_radius(const Step& end, const Project& project, std::vector<ReducedLoad>& found) {
  const std::string edge = edge_of(end), pressure = pressure_of(end);
  if (edge.empty() || pressure.empty() || !end.input().reading.typed.contains(edge)) return;
  const double own = own_value(end, project, edge);
  const Step* nearest = nullptr;
  double least = 0.0;
  for (const auto& shell : project.steps) {
    if (id_of(*shell) != "vessel.cylinder" || pressure_of(*shell) != pressure) continue;
    const double apart = std::abs(own_value(*shell, project, "R") - own);
    if (std::isnan(apart) || apart <= of_wall * own) return;
    if (nearest == nullptr || apart < least) nearest = shell.get(), least = apart;
  }
  if (nearest == nullptr) return;
  found.push_back(
      {edge, say("{1} = {2}, and the shell '{3}' of the same pressure {4} has R = {5}: correct one of them, or "
                 "because.{1} = \"...\" if it closes another vessel",
                 edge, format_quantity(own, "mm", 4), nearest->name(), pressure,
                 format_quantity(own_value(*nearest, project, "R"), "mm", 4))});
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
  if (shell == nullptr || shell->input().calculator == nullptr) return;
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
