#include "lib/project/references/drives/stated_loads.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/kinds.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double rounded = 0.02;            // values that are computed elsewhere with few digits
constexpr double implausible_ratio = 50.0;  // beyond, it is the load of another machine
constexpr double typed_digits = 1e-3;

const Dimension of_power = Dimension::of(2, 1, -3);
const Dimension of_torque = Dimension::of(2, 1, -2);
const Dimension of_force = Dimension::of(1, 1, -2);

/// An input, or the result of this name.
double known(const Step& step, const Project& project, const std::string& key) {
  const double own = std::abs(own_value(step, project, key));
  return std::isnan(own) ? std::abs(magnitude_at(project, step.name() + "." + key)) : own;
}

bool has_input(const Step& step, const char* key) {
  return find_field(step.input().calculator->input->fields, key) != nullptr;
}

}  // namespace

bool is_drive(const Step& step) { return has_input(step, "n_1") && (has_input(step, "P") || has_input(step, "T_1")); }

namespace {

/// The input that holds the load: "T_1"; empty if none is given.
std::string load_of(const Step& step, const Project& project) {
  for (const char* const key : {"P", "T_1", "T_2"}) {
    if (has_input(step, key) && !std::isnan(own_value(step, project, key))) return key;
  }
  return {};
}

double torque_of(const Step& step, const Project& project, const std::string& side) {
  double T = known(step, project, "T_" + side);
  if (side == "2") T = std::fmax(T, std::abs(magnitude_at(project, step.name() + ".T_out")));  // of a train
  const double P = std::abs(own_value(step, project, "P"));
  return std::isnan(T) ? P / known(step, project, "n_" + side) : T;
}

/// The largest power that the torques at both sides correspond to, or the given one.
double power_of(const Step& step, const Project& project) {
  double most = std::abs(own_value(step, project, "P"));
  for (const char* const side : {"1", "2"})
    most = std::fmax(most,
                     known(step, project, std::string("T_") + side) * known(step, project, std::string("n_") + side));
  return most;
}

/// "P_start", or "P_fan" of the machine that is driven.
bool is_of_peak_or_part(const std::string& name) {
  constexpr std::size_t fewest_letters = 3;
  const bool is_word = name.size() > name.rfind('_') + fewest_letters && name.find('_') != std::string::npos;
  return is_of_peak(name) || (is_word && !is_of_other_state(name));
}

/// The load of the step that a name of [values] means; NaN if it means none.
double meant_load(const Step& step, const Project& project, const std::string& name, const Dimension& dimension) {
  const bool is_peak = is_of_peak_or_part(name);
  if (dimension == of_power && (name == "P" || name == "P_1" || (is_peak && name.starts_with("P_"))))
    return power_of(step, project);
  if (dimension == of_torque && (name == "T_1" || name == "T_2")) return torque_of(step, project, name.substr(2));
  if (dimension == of_torque && (name == "T" || (is_peak && name.starts_with("T_"))))
    return std::fmax(torque_of(step, project, "1"), torque_of(step, project, "2"));
  if (dimension == of_force && (name == "F_t" || (is_peak && name.starts_with("F_"))))
    return std::abs(magnitude_at(project, step.name() + ".F_t"));
  return std::nan("");
}

/// Whether left_out.hpp compares it: with an input under this name, or torques with the torque of a peak.
bool is_under_own_name(const Step& step, const Project& project, const std::string& name, const Dimension& dimension) {
  if (!std::isnan(own_value(step, project, name))) return true;
  const std::string load = load_of(step, project);
  return is_of_peak_or_part(name) && (dimension == of_power) == (load == "P");
}

}  // namespace

std::vector<ReducedLoad> loads_stated_otherwise(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (project.values.unused().empty() || !is_drive(step)) return found;
  const std::string load = load_of(step, project);
  for (const auto& [name, value] : project.values.unused()) {
    const Dimension dimension = value.signature.dimension;
    if (project.values.kind(name) == Meant::work || is_under_own_name(step, project, name, dimension)) continue;
    const double si = std::abs(value.si.front()), own = meant_load(step, project, name, dimension);
    const auto carries = [&, &name = name](const auto& drive) {
      if (!is_drive(*drive)) return false;
      const double most = factors_included(name, *drive, project) * meant_load(*drive, project, name, dimension);
      return most >= (1.0 - rounded) * si;
    };
    if (!(si <= implausible_ratio * own) || std::ranges::any_of(project.steps, carries)) continue;
    const char* const unit = dimension == of_power ? "kW" : dimension == of_torque ? "N*m" : "N";
    found.push_back({load, say("values.{1} = {2} acts on no step, and {3} corresponds to {4} here: refer to it, delete "
                               "it, or justify it: because.{3} = \"...\"",
                               name, format_quantity(si, unit, 4), load, format_quantity(own, unit, 4))});
  }
  return found;
}

namespace {

/// The module of gears, which may have no load.
std::string module_of(const Step& step) {
  for (const char* const key : {"m_x", "m_et", "m_n"}) {
    if (has_input(step, key)) return key;
  }
  return {};
}

bool is_load(const std::string& name, const Dimension& dimension) {
  const bool is_peak = is_of_peak(name);
  if (dimension == of_power) return name == "P" || name == "P_1" || (is_peak && name.starts_with("P_"));
  if (dimension == of_torque)
    return name == "T" || name == "T_1" || name == "T_2" || (is_peak && name.starts_with("T_"));
  return dimension == of_force && name == "F_t";
}

bool is_loaded_drive(const Step& step, const Project& project) {
  return is_drive(step) && !load_of(step, project).empty();
}

/// A torque of a step without a speed on both sides: of a shaft, a key, a press fit; 0 if it has none.
double single_torque(const Step& step, const Project& project) {
  if (is_drive(step)) return 0.0;
  const FieldInfo* const T = find_field(step.input().calculator->input->fields, "T");
  if (T == nullptr || !T->is_load || !(T->dimension == of_torque)) return 0.0;
  const double most = std::fmax(std::abs(own_value(step, project, "T")), std::abs(own_value(step, project, "T_max")));
  return std::isnan(most) ? 0.0 : most;
}

/// Whether the torque is typed, or comes from [values].
bool is_torque_of_file(const Step& step) {
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path != "T") continue;
    for (const auto& reference : operand.expression.references()) {
      if (!reference.path.starts_with("values.")) return false;
    }
  }
  return true;
}

/// Values of [values] that no step takes and that may be loads. They are looked for before the loads of steps, so that
/// sweeps of files without them need no comparison.
template <class IsLoad>
std::vector<std::pair<std::string, Value>> stated_loads(const Project& project, const IsLoad& is_it) {
  std::vector<std::pair<std::string, Value>> found;
  for (const auto& [name, value] : project.values.unused()) {
    if (is_it(name, value.signature.dimension) && value.si.front() != 0.0) found.emplace_back(name, value);
  }
  return found;
}

/// The speed of the step or of [values]; 0 if the file has none, NaN if it cannot be known which one is meant.
double speed_for(const Step& step, const Project& project) {
  const double own = std::abs(own_value(step, project, "n"));
  if (own > 0.0) return own;
  for (const char* const path : {"values.n", "values.n_1"}) {
    const double stated = std::abs(magnitude_at(project, path));
    if (stated > 0.0) return project.values.kind(path + 7) == Meant::frequency ? std::nan("") : stated;
  }
  return 0.0;
}

/// "values.n_mix" of "P_mix".
std::string speed_of_word(const std::string& power) {
  return "values.n" + power.substr(std::min<std::size_t>(1, power.size()));
}

/// Whether a power has a word and [values] the speed with this word.
bool has_speed(const std::string& name, const Project& project) {
  return name.starts_with("P_") && !is_of_other_state(name) && magnitude_at(project, speed_of_word(name)) > 0.0;
}

}  // namespace

std::vector<ReducedLoad> loads_of_unloaded_gears(const Step& step, const Project& project) {
  const std::string module = is_drive(step) ? module_of(step) : std::string();
  if (module.empty()) return {};
  const auto stated = stated_loads(project, [&](const std::string& name, const Dimension& dimension) {
    return project.values.kind(name) != Meant::work && is_load(name, dimension);
  });
  const auto is_loaded = [&](const auto& other) { return is_loaded_drive(*other, project); };
  if (stated.empty() || std::ranges::any_of(project.steps, is_loaded)) return {};
  std::vector<ReducedLoad> found;
  found.reserve(stated.size());
  for (const auto& [name, value] : stated) {
    found.push_back(
        {module, say("values.{1} acts on no step, and the strength of these gears is not assessed without a "
                     "load: give it here, delete the value, or justify it: because.{2} = \"...\"",
                     name, module)});
  }
  return found;
}

std::vector<ReducedLoad> powers_of_torques(const Step& step, const Project& project) {
  const auto powers = stated_loads(project, [&](const std::string& name, const Dimension& dimension) {
    return dimension == of_power && (is_load(name, of_power) || has_speed(name, project));
  });
  if (powers.empty()) return {};
  const double T = single_torque(step, project);
  const auto is_loaded = [&](const auto& other) { return is_loaded_drive(*other, project); };
  if (T == 0.0 || !is_torque_of_file(step) || std::ranges::any_of(project.steps, is_loaded)) return {};
  std::vector<ReducedLoad> found;
  found.reserve(powers.size());
  for (const auto& [name, value] : powers) {
    const double n = has_speed(name, project) ? magnitude_at(project, speed_of_word(name)) : speed_for(step, project);
    if (std::isnan(n)) continue;
    const double P = std::abs(value.si.front()), stated = P / n;
    const auto carries = [&](const auto& other) { return single_torque(*other, project) >= (1.0 - rounded) * stated; };
    if (n > 0.0 && (stated > implausible_ratio * T || std::ranges::any_of(project.steps, carries))) continue;
    found.push_back(
        {"T",
         n > 0.0 ? say("values.{1} = {2} acts on no step: at {3} it has {4}, and T is {5}: refer to it, delete "
                       "it, or justify it: because.T = \"...\"",
                       name, format_quantity(P, "kW", 4), format_quantity(n, "rpm", 4),
                       format_quantity(stated, "N*m", 4), format_quantity(T, "N*m", 4))
                 : say("values.{1} = {2} acts on no step, and the file has no speed to compare it with T: write "
                       "T = \"=values.{1}/values.n\" with n in [values], delete it, or justify it: because.T = \"...\"",
                       name, format_quantity(P, "kW", 4))});
  }
  return found;
}

namespace {

/// A load that is computed from values of the file only, as a number; NaN if it refers to a step.
double from_values(const Operand& operand, const Project& project) {
  for (const auto& reference : operand.expression.references()) {
    if (!reference.path.starts_with("values.") || project.value(reference.path) == nullptr) return std::nan("");
  }
  const Value taken =
      operand.expression.evaluate([&](const std::string& path) -> const Value& { return *project.value(path); });
  return taken.si.size() == 1 ? std::abs(taken.si.front()) : std::nan("");
}

/// A rated load by its name: a design or peak load may include the factor.
bool is_rated(const std::string& path) {
  const std::string name = path.substr(path.find('.') + 1);
  return !is_of_peak(name) && !has_word(name, {"d", "des", "design", "eff", "eq", "k", "ka", "b", "dyn"});
}

}  // namespace

std::vector<ReducedLoad> factors_cancelled(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (!has_input(step, "K_A")) return found;
  const double K_A = own_value(step, project, "K_A");
  for (const Operand& operand : step.input().reading.operands) {
    if (!operand.leaf.field->is_load || operand.expression.is_reference()) continue;
    const double taken = from_values(operand, project);
    for (const auto& reference : operand.expression.references()) {
      const double stated = std::abs(magnitude_at(project, reference.path));
      if (std::isnan(taken) || project.value(reference.path)->signature.dimension != operand.leaf.field->dimension)
        continue;
      const double divisor = stated / taken, of_file = std::abs(magnitude_at(project, "values.K_A"));
      const auto is = [&](double factor) { return factor > 1.0 && is_near(divisor, factor, typed_digits); };
      if (!is_rated(reference.path) || !(is(K_A) || is(of_file))) continue;
      found.push_back(
          {operand.path, say("{1} is '{2}' divided by the application factor, which then has no effect: write {1} = "
                             "\"={2}\", or because.{1} = \"...\"",
                             operand.path, reference.path)});
    }
  }
  return found;
}

}  // namespace loadpath::project
