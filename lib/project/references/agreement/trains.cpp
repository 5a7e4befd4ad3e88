#include "lib/project/references/agreement/trains.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

namespace {

constexpr double typed_digits = 1e-3;  // of a speed that is typed twice
constexpr double creep = 0.05;         // by which wheels turn slower than their stage
constexpr double losses = 0.85;        // power of the wheels over that of their shaft, at least

std::string_view kind_of_step(const Step& step) { return step.input().calculator->id; }

/// Whether a path, "train.shafts[2].T", is within another, "train.shafts[2]".
bool is_within(const std::string& path, const std::string& part) {
  return path.starts_with(part) && (path.size() == part.size() || path[part.size()] == '.');
}

bool refers_into(const Step& step, const std::string& part) {
  bool found = false;
  for_each_reference(step.input().reading, [&](const std::string& path) { found = found || is_within(path, part); });
  return found;
}

bool is_referred_to(const Project& project, const Step& train, const std::string& part) {
  return std::ranges::any_of(project.steps,
                             [&](const auto& step) { return step.get() != &train && refers_into(*step, part); });
}

double at_shaft(const Project& project, const std::string& train, std::size_t number, const char* key) {
  return std::abs(magnitude_at(project, train + ".shafts[" + std::to_string(number) + "]." + key));
}

/// A stage of gears with a module.
struct GearStage {
  std::string path;  // "stages.first"
  double m_n;
  std::size_t shaft;  // number of the shaft of its pinion
  bool is_rated;      // another step refers to it
};

std::vector<GearStage> gear_stages(const Step& train, const Project& project) {
  const Record& record = train.input().reading.record;
  const FieldInfo* const stages = find_field(record.type->fields, "stages");
  std::vector<GearStage> all;
  for (std::size_t i = 0; stages != nullptr && i < stages->size(record.data.get()); ++i) {
    const std::string path = "stages" + element_path(*stages, record.data.get(), i);
    const std::string number = "stages[" + std::to_string(i + 1) + "]";
    const double m_n = own_value(train, project, path + ".m_n");
    if (std::isnan(m_n)) continue;
    const bool is_rated = is_referred_to(project, train, train.name() + "." + path) ||
                          is_referred_to(project, train, train.name() + "." + number);
    all.push_back({path, m_n, i + 1, is_rated});
  }
  return all;
}

/// Of two stages, the one with the larger torque and no larger module decides.
void compare_stages(const Step& train, const Project& project, std::vector<ReducedLoad>& found) {
  const std::vector<GearStage> stages = gear_stages(train, project);
  const auto torque = [&](const GearStage& stage) { return at_shaft(project, train.name(), stage.shaft, "T"); };
  for (const GearStage& stage : stages) {
    if (stage.is_rated) continue;
    const auto is_less_loaded = [&](const GearStage& other) {
      return other.is_rated && torque(stage) > (1.0 + typed_digits) * torque(other) && stage.m_n <= other.m_n;
    };
    const auto other = std::ranges::find_if(stages, is_less_loaded);
    if (other == stages.end()) continue;
    found.push_back(
        {"stages", say("a step assesses {1}, but none assesses {2}, which has the larger torque and no larger module: "
                       "add a step for it, or because.stages = \"...\"",
                       other->path, stage.path)});
    return;
  }
}

/// The worm gear that has the load of the first shaft of a stage, or its teeth.
const Step* worm_of_stage(const Step& train, const std::string& path, std::size_t number, const Project& project) {
  const std::string shaft = train.name() + ".shafts[" + std::to_string(number) + "]";
  const auto is_it = [&](const auto& step) {
    return kind_of_step(*step) == "gear.worm" &&
           (refers_into(*step, shaft) || refers_into(*step, train.name() + "." + path));
  };
  const auto worm = std::ranges::find_if(project.steps, is_it);
  return worm == project.steps.end() ? nullptr : worm->get();
}

/// Whether a step takes the load of a shaft behind this stage: too low an efficiency of the stage reduces it.
bool is_taken_behind(const Step& train, std::size_t number, const Project& project) {
  const Record& record = train.input().reading.record;
  const FieldInfo* const stages = find_field(record.type->fields, "stages");
  const std::size_t count = stages == nullptr ? 0 : stages->size(record.data.get());
  bool found = is_referred_to(project, train, train.name() + ".T_out");
  for (std::size_t k = number + 1; k <= count + 1; ++k)
    found = found || is_referred_to(project, train, train.name() + ".shafts[" + std::to_string(k) + "]");
  return found;
}

/// The efficiency of a stage next to that of the mesh of its worm gear: bearings and seals take a little of it. One a
/// little above it, rounded or of a catalogue, loads the parts behind more.
void compare_worms(const Step& train, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double least_alone = 0.85, least_in_front = 0.98, most = 1.06;  // of the efficiency of the mesh
  const Record& record = train.input().reading.record;
  const FieldInfo* const stages = find_field(record.type->fields, "stages");
  for (std::size_t i = 0; stages != nullptr && i < stages->size(record.data.get()); ++i) {
    const std::string path = "stages" + element_path(*stages, record.data.get(), i);
    const Leaf kind = find_leaf(record, path + ".kind");
    const Step* const worm = kind && word_of(kind) == "worm" ? worm_of_stage(train, path, i + 1, project) : nullptr;
    if (worm == nullptr) continue;
    const double least = is_taken_behind(train, i + 1, project) ? least_in_front : least_alone;
    const double typed = own_value(train, project, path + ".eta"), mesh = magnitude_at(project, worm->name() + ".eta");
    if (!(typed > most * mesh) && !(typed < least * mesh)) continue;
    found.push_back({"stages", say("the efficiency {1} of {2} is {3} that of the mesh, '{4}.eta' = {5}, {6}: correct "
                                   "it, or because.stages = \"...\"",
                                   format_number(typed, 3), path, typed > mesh ? say("above") : say("below"),
                                   worm->name(), format_number(mesh, 3),
                                   typed > mesh ? say("without losses of bearings")
                                                : say("and the driven shafts have too little torque"))});
  }
}

/// The speed of the driven wheel, before its step is solved too.
double driven_speed(const Step& wheels, const Project& project) {
  const double i = own_value(wheels, project, "d_2") / own_value(wheels, project, "d_1");
  return own_value(wheels, project, "n_1") / i * (1.0 - own_value(wheels, project, "epsilon"));
}

class WheelCheck {
 public:
  WheelCheck(const Step& wheels, const Project& project) : wheels_(wheels), project_(project) {}

  std::vector<ReducedLoad> run() {
    const auto is_train = [](const auto& step) { return kind_of_step(*step) == "drive.train"; };
    if (std::ranges::none_of(project_.steps, is_train)) return {};
    n_1_ = own_value(wheels_, project_, "n_1"), n_2_ = driven_speed(wheels_, project_);
    if (!(n_1_ > 0.0) || !(n_2_ > 0.0)) return {};
    for (const auto& step : project_.steps) {
      if (kind_of_step(*step) != "drive.train") continue;
      const std::string& train = step->name();
      for (std::size_t k = 1; found_.empty() && !std::isnan(at_shaft(project_, train, k + 1, "n")); ++k) {
        if (refers_into(wheels_, train + ".shafts[" + std::to_string(k) + "]"))
          compare_ratio(train, k);
        else if (!refers_into(wheels_, train))
          compare_power(train, k);
      }
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool is_behind(const std::string& train, std::size_t k) const {
    const double behind = at_shaft(project_, train, k + 1, "n");
    return is_near(n_2_, behind, creep);
  }

  /// Wheels with the load of a shaft turn the next one.
  void compare_ratio(const std::string& train, std::size_t k) {
    if (is_behind(train, k)) return;
    found_.push_back(
        {"d_2", say("the driven wheel rotates at {1}, and the next shaft of '{2}', whose load is used, at {3}: correct "
                    "the diameters or the stage, or because.d_2 = \"...\"",
                    format_quantity(n_2_, "rpm", 4), train,
                    format_quantity(at_shaft(project_, train, k + 1, "n"), "rpm", 4))});
  }

  /// Wheels between the speeds of two shafts are the stage between them.
  void compare_power(const std::string& train, std::size_t k) {
    const double n = at_shaft(project_, train, k, "n"), P = at_shaft(project_, train, k, "P");
    if (std::abs(n_1_ - n) > typed_digits * n || !is_behind(train, k)) return;
    const double given = own_value(wheels_, project_, "P");
    const double own = std::isnan(given) ? own_value(wheels_, project_, "T_1") * n_1_ : given;
    if (!(own < losses * P)) return;
    const char* const load = std::isnan(given) ? "T_1" : "P";
    found_.push_back({load, say("{1} corresponds to {2}, and the stage of '{3}' between the same speeds transmits {4}: "
                                "correct one of them, or because.{1} = \"...\"",
                                load, format_quantity(own, "kW", 4), train, format_quantity(P, "kW", 4))});
  }

  const Step& wheels_;
  const Project& project_;
  double n_1_ = std::nan(""), n_2_ = std::nan("");
  std::vector<ReducedLoad> found_;
};

/// A speed that is asked for, next to a train none of whose shafts has it.
void compare_wanted_speeds(const Step& train, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double apart = 0.1;  // of the required speed: numbers of teeth are integers
  const Dimension turning = Dimension::of(0, 0, -1, 0, 1);
  for (const auto& [name, value] : project.values.unused()) {
    if (!(value.signature.dimension == turning) || !has_word(name, {"n", "omega", "speed", "drehzahl"})) continue;
    if (!has_word(name, {"target", "wanted", "desired", "required", "req", "soll", "goal", "nominal"})) continue;
    const double wanted = std::abs(value.si.front());
    double nearest = std::nan("");
    for (std::size_t k = 1;; ++k) {
      const double n = at_shaft(project, train.name(), k, "n");
      if (std::isnan(n)) break;
      if (!(std::abs(n - wanted) > std::abs(nearest - wanted))) nearest = n;
    }
    if (!(std::abs(nearest - wanted) > apart * wanted)) continue;
    found.push_back({"stages", say("values.{1} = {2} acts on no step, and no shaft has this speed, the nearest {3}: "
                                   "correct the stages, delete it, or because.stages = \"...\"",
                                   name, format_quantity(wanted, "rpm", 4), format_quantity(nearest, "rpm", 4))});
  }
}

}  // namespace

std::vector<ReducedLoad> stages_of_trains(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (kind_of_step(step) == "drive.train") {
    compare_stages(step, project, found);
    compare_worms(step, project, found);
    compare_wanted_speeds(step, project, found);
  }
  if (kind_of_step(step) == "drive.friction_wheels") found = WheelCheck(step, project).run();
  return found;
}

}  // namespace loadpath::project
