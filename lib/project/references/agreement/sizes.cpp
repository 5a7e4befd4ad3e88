#include "lib/project/references/agreement/sizes.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double few = 1e-3;  // of a value: sizes typed with few digits

/// A fatigue limit for a smaller rectangle than the part whose cycle it is compared with: its size factor is higher.
void compare_rectangle(const Step& life, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& reading = life.input().reading;
  const Operand* const limit = reading.operand("sigma_D");
  const auto cycle = std::ranges::find(reading.records, "cycle", &Taken::path);
  if (limit == nullptr || limit->expression.references().size() != 1 || cycle == reading.records.end()) return;
  const Step* const source = project.find(split_step(limit->expression.references().front().path).first);
  const Step* const part = project.find(split_step(cycle->source).first);
  if (source == nullptr || part == nullptr || source == part) return;
  const double h = own_value(*source, project, "h"), b = own_value(*source, project, "b");
  const double h_part = own_value(*part, project, "h"), b_part = own_value(*part, project, "b");
  if (!(h * b < (1.0 - few) * h_part * b_part)) return;
  const auto mm = [](double si) { return format_quantity(si, "mm", 4); };
  found.push_back({"sigma_D", say("the fatigue limit of '{1}' is for h = {2}, b = {3}, and '{4}' has h = {5}, b = {6}: "
                                  "write h = \"={4}.h\", b = \"={4}.b\" there, or because.sigma_D = \"...\"",
                                  source->name(), mm(h), mm(b), part->name(), mm(h_part), mm(b_part))});
}

/// A moment of inertia of the step of a flywheel, with less mass than its rim has.
void compare_rim(const Step& shaft, const Project& project, std::vector<ReducedLoad>& found) {
  std::set<std::string> held;
  for (const Operand& operand : shaft.input().reading.operands) {
    const auto& references = operand.expression.references();
    if (!operand.path.ends_with(".J") && !operand.path.ends_with(".I_p")) continue;
    if (!operand.expression.is_reference() || references.empty()) continue;
    const std::string wheel = split_step(references.front().path).first, path = prefix_of(operand.path) + "mass";
    const double m_rim = magnitude_at(project, wheel + ".m_rim"), own = own_value(shaft, project, path);
    if (!(own < (1.0 - few) * m_rim) || !held.insert(path).second) continue;
    found.push_back(
        {path, say("{1} = {2}, and the rim of '{3}', whose moment of inertia it has, weighs {4}: write {1} "
                   "= \"={3}.m_rim\", or {5} = \"...\"",
                   path, format_quantity(own, "kg", 4), wheel, format_quantity(m_rim, "kg", 4), because_key(path))});
  }
}

const Dimension of_inertia = Dimension::of(2, 1, 0);

/// A moment of inertia about the centre of mass of a body that turns about another axis.
void compare_axis(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  for (const Operand& operand : step.input().reading.operands) {
    const auto& references = operand.expression.references();
    if (!(operand.leaf.field->dimension == of_inertia) || references.size() != 1) continue;
    const auto [body, key] = split_step(references.front().path);
    if (key != "J_S" || project.find(body) == nullptr) continue;
    const double J_S = magnitude_at(project, body + ".J_S"), J = magnitude_at(project, body + ".J");
    if (!(J_S < (1.0 - few) * J)) continue;
    found.push_back({operand.path, say("'{1}.J_S' is about the centre of mass, which is off the axis of '{1}': write "
                                       "\"={1}.J\", {2} about this axis, or {3} = \"...\"",
                                       body, format_quantity(J, "kg*m^2", 4), because_key(operand.path))});
  }
}

/// A mass or an inertia of a body without a material, with the density of steel but for a digit.
void compare_tenth(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double steel = 7850.0;
  const Dimension mass = Dimension::of(0, 1, 0);
  for (const Operand& operand : step.input().reading.operands) {
    const auto& references = operand.expression.references();
    const Dimension& dimension = operand.leaf.field->dimension;
    if (references.empty() || !(dimension == of_inertia || dimension == mass)) continue;
    const Step* const body = project.find(split_step(references.front().path).first);
    if (body == nullptr || std::string_view(body->input().calculator->id) != "dynamics.inertia") continue;
    const double rho = own_value(*body, project, "rho");
    if (!material_of(*body).empty() || !is_near(10.0 * rho, steel, few)) continue;
    found.push_back({operand.path, say("'{1}' has rho = {2}, a tenth of that of steel: correct it, or {3} = \"...\"",
                                       body->name(), format_quantity(rho, "kg/m^3", 4), because_key(operand.path))});
  }
}

}  // namespace

std::vector<ReducedLoad> sizes_in_disagreement(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  compare_rectangle(step, project, found);
  compare_rim(step, project, found);
  compare_axis(step, project, found);
  compare_tenth(step, project, found);
  return found;
}

}  // namespace loadpath::project
