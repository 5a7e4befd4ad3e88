#include "lib/project/references/drives/elements.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/drives/stated_loads.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double least_part = 0.85;  // of the torque of the shaft: losses of the drive

bool is_named_any(const Step& step, std::initializer_list<const char*> words) {
  return std::ranges::any_of(words, [&](const char* word) { return is_named(step, word); });
}

/// The only drive of the file; null if it has none, or several, whose shafts may be one.
const Step* only_drive(const Project& project) {
  const Step* drive = nullptr;
  for (const auto& step : project.steps) {
    const bool is_train = find_field(step->input().calculator->input->fields, "stages") != nullptr;
    if (is_train || (is_drive(*step) && drive != nullptr)) return nullptr;
    if (is_drive(*step)) drive = step.get();
  }
  return drive;
}

/// The torques and speeds of both shafts of a drive; NaN as far as they are not known.
struct Shafts {
  double T_1, T_2, n_1, n_2;
};

double first_known(std::initializer_list<double> values) {
  for (const double value : values) {
    if (!std::isnan(value)) return std::abs(value);
  }
  return std::nan("");
}

Shafts shafts_of(const Step& drive, const Project& project) {
  const auto own = [&](const char* key) { return own_value(drive, project, key); };
  const auto result = [&](const char* key) { return magnitude_at(project, drive.name() + "." + key); };
  Shafts shafts{};
  shafts.n_1 = first_known({own("n_1"), result("n_1")});
  shafts.n_2 = first_known({result("n_2"), shafts.n_1 * own("z_1") / own("z_2"), shafts.n_1 * own("d_1") / own("d_2")});
  const double P = first_known({own("P"), result("P")});
  shafts.T_1 = first_known({own("T_1"), result("T_1"), result("shaft_1.T"), P / shafts.n_1});
  shafts.T_2 = first_known({result("T_2"), result("shaft_2.T"), P / shafts.n_2});
  return shafts;
}

bool names_element(const Step& step, std::string_view drive) {
  if (drive.starts_with("belt.")) return is_named_any(step, {"pulley"});
  if (drive.starts_with("chain.")) return is_named_any(step, {"sprocket"});
  return drive.starts_with("gear.") && is_named_any(step, {"gear", "wheel", "pinion", "worm"});
}

/// The number of the shaft that the step is on by its name and title: 1, 2; 0 if they name none, or both.
int shaft_named(const Step& step, const Step& drive, bool is_slower) {
  const bool is_gear = id_of(drive).starts_with("gear.");
  const bool is_small = is_named_any(step, {"small", "smaller"}), is_large = is_named_any(step, {"large", "larger"});
  const bool is_wheel = is_gear && is_named(step, "wheel");
  const bool is_first = is_named_any(step, {"pinion", "motor", "engine", "driving", "input", "intermediate"}) ||
                        (is_named(step, "worm") && !is_wheel) || (is_slower ? is_small : is_large);
  const bool is_second = is_wheel || (is_slower ? is_large : is_small) ||
                         is_named_any(step, {"driven", "output", "drum", "pump", "fan", "blower", "mixer", "conveyor",
                                             "agitator", "crusher", "mill", "compressor"});
  return is_first == is_second ? 0 : is_first ? 1 : 2;
}

/// Whether a torque is computed from the load of the drive, and from speeds and factors alone.
bool is_of_drive(const Operand& torque, const Step& drive) {
  constexpr std::string_view prefix = "values.";
  const auto at_drive = [&](const auto& reference) { return split_step(reference.path).first == drive.name(); };
  const auto& references = torque.expression.references();
  const bool is_of_others = std::ranges::any_of(
      references, [&](const auto& reference) { return !reference.path.starts_with(prefix) && !at_drive(reference); });
  if (is_of_others) return false;
  const auto& typed = drive.input().reading.typed;
  const auto power = typed.find("P");
  bool takes_load = std::ranges::any_of(references, [&](const auto& reference) {
    const std::string rest = split_step(reference.path).second;
    return at_drive(reference) && (rest.starts_with('P') || rest.find('T') != std::string::npos);
  });
  for (std::size_t at = torque.text.find(prefix); at != std::string::npos; at = torque.text.find(prefix, at + 1)) {
    const auto is_of_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; };
    const auto begin = torque.text.begin() + static_cast<std::ptrdiff_t>(at);
    const std::string path(begin, std::find_if_not(begin, torque.text.end(), is_of_name));
    const std::string name = path.substr(prefix.size());
    const bool is_load = power != typed.end() && power->second.shared == path;
    takes_load = takes_load || is_load;
    if (!is_load && !name.starts_with("n") && !name.starts_with("omega") && !name.starts_with("K_A")) return false;
  }
  return takes_load;
}

/// A ratio between the shafts in the formula explains another torque.
bool takes_ratio(const Operand& torque, const Step& drive) {
  return std::ranges::any_of(torque.expression.references(), [&](const auto& reference) {
    const auto [name, rest] = split_step(reference.path);
    return name == drive.name() && (rest == "i" || rest == "u" || rest.starts_with("z_") || rest.starts_with("d_"));
  });
}

}  // namespace

std::vector<ReducedLoad> torques_of_other_elements(const Step& step, const Project& project) {
  const Operand* const torque = step.input().reading.operand("T");
  if (torque == nullptr || !torque->leaf.field->is_load || is_drive(step)) return {};
  const Step* const drive = only_drive(project);
  if (drive == nullptr || !is_of_drive(*torque, *drive) || takes_ratio(*torque, *drive)) return {};
  const bool is_element = names_element(step, id_of(*drive));
  if (!is_element && shaft_named(step, *drive, true) == 0) return {};
  const Shafts shafts = shafts_of(*drive, project);
  const int number = shaft_named(step, *drive, shafts.n_2 < shafts.n_1);
  if (number == 0 && !is_element) return {};
  const double there = number == 1 ? shafts.T_1 : number == 2 ? shafts.T_2 : std::fmin(shafts.T_1, shafts.T_2);
  const double own = std::abs(own_value(step, project, "T"));
  if (!(own < least_part * there)) return {};
  const std::string here = format_quantity(own, "N*m", 4), least = format_quantity(there, "N*m", 4);
  if (number == 0)
    return {{"T", say("T = {1}, and '{2}' has at least {3} on either shaft: take the torque of the shaft of this step, "
                      "or justify it: because.T = \"...\"",
                      here, drive->name(), least)}};
  return {{"T", say("T = {1}, and shaft {2} of '{3}', which this step is on by its title, has {4}: take the torque of "
                    "this shaft, or justify it: because.T = \"...\"",
                    here, std::to_string(number), drive->name(), least)}};
}

}  // namespace loadpath::project
