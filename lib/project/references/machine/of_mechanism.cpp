#include "lib/project/references/machine/of_mechanism.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace loadpath::project {

namespace {

const Dimension force = Dimension::of(1, 1, -2);
constexpr double of_aluminium = 2700.0;  // kg/m^3, of a bar of unknown density

/// The key under which a mechanism has the crank angles that it is solved at, in place of a revolution.
constexpr std::string_view given_angles = "crank.at";

bool is_at_given_angles(const Step& step) {
  const auto& typed = step.input().reading.typed;
  return std::ranges::any_of(typed, [](const auto& entry) { return entry.first.starts_with(given_angles); });
}

void compare_parts_of_turn(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  std::set<std::string> held;
  for (const Operand& operand : step.input().reading.operands) {
    if (!operand.leaf.field->is_load || held.contains(operand.path)) continue;
    for (const auto& reference : operand.expression.references()) {
      const Step* const source = project.find(split_step(reference.path).first);
      if (source == nullptr || source == &step || !is_at_given_angles(*source)) continue;
      held.insert(operand.path);
      found.push_back(
          {operand.path, say("'{1}' is solved at given crank angles, not over its cycle: leave out crank.at, "
                             "or justify it: {2} = \"...\"",
                             source->name(), because_key(operand.path))});
      break;
    }
  }
}

/// The largest force of each joint, by the path of its result.
std::map<std::string, double> joint_forces(const Step& mechanism) {
  NotedReads::note(mechanism.name() + ".joints");
  std::map<std::string, double> forces;
  for (const account::Entry& entry : mechanism.account().results) {
    if (!entry.path.starts_with("joints.") || !entry.path.ends_with(".F")) continue;
    double& most = forces[entry.path];
    for (const double si : entry.value.si) most = std::fmax(most, std::abs(si));
  }
  return forces;
}

/// The least of the largest forces of the joints of a solved mechanism; NaN if it has none.
double least_joint_force(const Step& mechanism) {
  double least = std::nan("");
  for (const auto& [path, most] : joint_forces(mechanism)) least = std::fmin(least, most);
  return least;
}

bool has_joint_forces(const Step& step) {
  const auto& results = step.account().results;
  return std::ranges::any_of(results, [](const auto& entry) { return entry.path.starts_with("joints."); });
}

/// The mechanisms that no step takes values of.
std::vector<const Step*> idle_mechanisms(const Project& project) {
  std::vector<const Step*> idle;
  for (const auto& step : project.steps) {
    if (has_joint_forces(*step) && !project.is_referred_into(step->name() + ".")) idle.push_back(step.get());
  }
  return idle;
}

/// Another load case of the same joints, with larger forces, that no step takes.
void compare_load_cases(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto is_of_mechanism = [&](const Taken& record) {
    const Step* const taken = project.find(split_step(record.source).first);
    return taken != nullptr && has_joint_forces(*taken);
  };
  if (std::ranges::none_of(step.input().reading.records, is_of_mechanism)) return;
  const auto idle = idle_mechanisms(project);
  if (idle.empty()) return;
  for (const Taken& record : step.input().reading.records) {
    if (!is_of_mechanism(record)) continue;
    const Step* const taken = project.find(split_step(record.source).first);
    const auto forces = joint_forces(*taken);
    for (const Step* const other : idle) {
      const auto there = joint_forces(*other);
      const bool is_heavier = std::ranges::equal(forces, there, [](const auto& light, const auto& heavy) {
        return light.first.substr(light.first.find('.')) == heavy.first.substr(heavy.first.find('.')) &&
               heavy.second >= light.second * (1.0 - 1e-6);
      });
      if (other == taken || !is_heavier || there == forces) continue;
      found.push_back(
          {record.path, say("'{1}' has the same joints with larger forces, and no step takes them: assess that "
                            "load case, or {2} = \"...\"",
                            other->name(), because_key(record.path))});
      return;
    }
  }
}

/// A typed force, next to values of a mechanism: "F = 1 kN" with "n = =press.links.rod.omega".
void compare_typed_forces(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  std::vector<std::string> typed;
  for (const auto& entry : step.input().reading.typed) {
    const std::string& path = entry.first;
    if (path.find_first_of(".[") != std::string::npos) continue;  // first: a mechanism has thousands of them
    const Leaf leaf = find_leaf(step.input().reading.record, path);
    const bool is_taken = step.input().reading.operand(path) != nullptr;
    const bool is_force = leaf && leaf.field->is_load && leaf.field->dimension == force;
    if (is_force && !is_taken) typed.push_back(path);
  }
  if (typed.empty()) return;  // forces that are read keep a sweep from solving its points together
  for (const std::string& name : steps_named_in(step.input().reading)) {
    const Step* const source = project.find(name);
    const double least = source == nullptr || source == &step ? std::nan("") : least_joint_force(*source);
    if (!(least > 0.0)) continue;
    for (const std::string& path : typed) {
      const double own = std::abs(own_value(step, project, path));
      if (!(own > 0.0 && own < 0.99 * least)) continue;
      found.push_back(
          {path, say("{1} = {2}, below the force of every joint of '{3}', at least {4}: take it from there, or "
                     "justify it: because.{1} = \"...\"",
                     path, format_quantity(own, "kN", 4), name, format_quantity(least, "kN", 4))});
    }
  }
}

/// Whether a load does no work: a force at right angles to the motion of its point. False where that is not known.
bool does_no_work(const Step& mechanism, const Project& project, const std::string& load) {
  constexpr double negligible = 1e-6;
  const Record& record = mechanism.input().reading.record;
  const Leaf point = find_leaf(record, load + ".at"), axes = find_leaf(record, load + ".axes");
  if (!point || (axes && word_of(axes) == "link")) return false;
  const auto own = [&](const char* key) {
    const double si = own_value(mechanism, project, load + key);
    return std::isnan(si) ? 0.0 : si;
  };
  if (own(".M") != 0.0) return false;
  const double F_x = std::abs(own(".F_x") + own(".F") * std::cos(own(".direction")));
  const double F_y = std::abs(own(".F_y") + own(".F") * std::sin(own(".direction")));
  const std::string at = mechanism.name() + ".points." + word_of(point) + ".";
  const double v_x = std::abs(magnitude_at(project, at + "v_x")), v_y = std::abs(magnitude_at(project, at + "v_y"));
  const double F = std::hypot(F_x, F_y), v = std::hypot(v_x, v_y);  // 0 of a mechanism at rest
  return v > 0.0 && F_x * v_x + F_y * v_y <= negligible * F * v;
}

/// Whether friction, springs or weights load the drive of a mechanism.
bool has_other_actions(const Step& mechanism) {
  return std::ranges::any_of(mechanism.input().reading.typed, [](const auto& entry) {
    const std::string& path = entry.first;
    return path == "mu" || path.ends_with(".mu") || path == "gravity" || path.starts_with("springs");
  });
}

/// A mechanism whose loads do no work: its drive moves masses only.
void compare_work(const Step& mechanism, const Project& project, std::vector<ReducedLoad>& found) {
  const Record& record = mechanism.input().reading.record;
  const FieldInfo* const loads = find_field(record.type->fields, "loads");
  if (std::string_view(mechanism.input().calculator->id) != "mechanism.planar" || loads == nullptr) return;
  const std::size_t count = loads->size(record.data.get());
  if (count == 0 || has_other_actions(mechanism)) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (!does_no_work(mechanism, project, "loads" + element_path(*loads, record.data.get(), i))) return;
  }
  found.push_back({"loads", say("no load does work, each is at right angles to the motion of its point, and the drive "
                                "moves masses only: correct the directions, or because.loads = \"...\"")});
}

/// The mass of a link in its mechanism, next to the bar that is assessed with its load: the bar has half of its
/// volume at least, without the bores of its eyes.
void compare_masses(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double least = 0.5;
  for (const Taken& record : step.input().reading.records) {
    const auto [name, rest] = split_step(record.source);
    const Step* const mechanism = project.find(name);
    if (record.path != "load" || !rest.starts_with("links.") || mechanism == nullptr || mechanism == &step) continue;
    const double mass = own_value(*mechanism, project, rest + ".mass");
    const double volume =
        own_value(step, project, "b") * own_value(step, project, "h") * magnitude_at(project, step.name() + ".l");
    const double rho = magnitude_at(project, step.name() + ".rho");
    const double bar = volume * (std::isnan(rho) ? of_aluminium : rho);
    if (!(mass > 0.0 && mass < least * bar)) continue;
    found.push_back({record.path, say("'{1}' has a mass of {2}, and this bar one of {3}: correct it, or {4} = \"...\"",
                                      record.source, format_quantity(mass, "kg", 3), format_quantity(bar, "kg", 3),
                                      because_key(record.path))});
  }
}

}  // namespace

std::vector<ReducedLoad> loads_of_mechanism(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  compare_parts_of_turn(step, project, found);
  compare_load_cases(step, project, found);
  compare_typed_forces(step, project, found);
  compare_masses(step, project, found);
  compare_work(step, project, found);
  return found;
}

}  // namespace loadpath::project
