#include "lib/project/references/agreement/excitations.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace loadpath::project {

namespace {

/// Whether an order is named as the mesh of teeth: "teeth", "tooth_mesh", "mesh_1".
bool is_of_teeth(const std::string& name) {
  return name.find("teeth") != std::string::npos || name.find("tooth") != std::string::npos ||
         name.find("mesh") != std::string::npos;
}

/// The teeth of the gear, or the threads of the worm, that a load of a shaft comes from: "gears.z_2" of
/// "=gears.gear_2"; NaN without a gear.
double teeth_of(const Taken& record, const Project& project) {
  if (!record.path.ends_with(".load")) return std::nan("");
  const auto [pair, gear] = split_step(record.source);
  if (gear == "gear_1" || gear == "worm") return magnitude_at(project, pair + ".z_1");
  if (gear == "gear_2" || gear == "wheel") return magnitude_at(project, pair + ".z_2");
  return std::nan("");
}

bool is_multiple(double h, double z) { return h >= z - 1e-6 && std::abs(h / z - std::round(h / z)) <= 1e-6; }

std::string listed(const std::vector<double>& teeth) {
  std::string text;
  for (const double z : teeth) text += (text.empty() ? "" : ", ") + format_number(z, 4);
  return text;
}

}  // namespace

std::vector<ReducedLoad> excitations_of(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  std::vector<double> teeth, orders;
  for (const Taken& record : step.input().reading.records) {
    const double z = teeth_of(record, project);
    if (!std::isnan(z)) teeth.push_back(z);
  }
  if (teeth.empty()) return found;
  std::vector<std::pair<std::string, double>> of_teeth;
  for_each_leaf(step.input().reading.record, [&](const std::string& path, const Leaf&) {
    if (!path.starts_with("orders") || !path.ends_with(".h")) return;
    const double h = own_value(step, project, path);
    const Leaf name = find_leaf(step.input().reading.record, prefix_of(path) + "name");
    orders.push_back(h);
    if (!std::isnan(h) && name && is_of_teeth(word_of(name))) of_teeth.emplace_back(path, h);
  });
  // A harmonic of a mesh counts only if the mesh itself is given.
  const auto is_given = [&](double z) {
    return std::ranges::any_of(orders, [&](double h) { return std::abs(h - z) <= 1e-6; });
  };
  if (!orders.empty() && of_teeth.empty() && !std::ranges::any_of(teeth, is_given)) {
    found.push_back({"orders", say("the orders do not include the mesh of the gears on this shaft, which have {1} "
                                   "teeth: add it, or because.orders = \"...\"",
                                   listed(teeth))});
  }
  for (const auto& [path, h] : of_teeth) {
    const double order = h;
    if (std::ranges::any_of(teeth, [&](double z) { return is_multiple(order, z) && is_given(z); })) continue;
    found.push_back({"orders", say("{1} = {2}, and the gears on this shaft have {3} teeth: give that order, or "
                                   "because.orders = \"...\"",
                                   path, format_number(h, 4), listed(teeth))});
  }
  return found;
}

}  // namespace loadpath::project
