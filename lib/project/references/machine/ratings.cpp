#include "lib/project/references/machine/ratings.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::project {

namespace {

bool is_choice(const Leaf& leaf) { return leaf && leaf.field->type == FieldInfo::Type::choice; }

/// A rating has the place of its pinion.
Leaf place_of(const Step& step) {
  const Leaf place = find_leaf(step.input().reading.record, "place");
  return is_choice(place) && find_leaf(step.input().reading.record, "d_sh") ? place : Leaf{};
}

/// The place of the only two bearings of a shaft; none if they are not known.
std::optional<std::pair<double, double>> bearings_of(const Step& shaft, const Project& project) {
  std::vector<double> places;
  for_each_leaf(shaft.input().reading.record, [&](const std::string& path, const Leaf&) {
    if (path.starts_with("supports") && path.ends_with(".x")) places.push_back(own_value(shaft, project, path));
  });
  if (places.size() != 2 || std::isnan(places[0]) || std::isnan(places[1])) return std::nullopt;
  return std::minmax(places[0], places[1]);
}

/// The mounting of bevel gears next to the shafts that take them: a gear beyond the bearings is overhung.
std::vector<ReducedLoad> mounting_on_shafts(const Step& step, const Project& project) {
  const Calculator* const calculator = step.input().calculator;
  const Leaf mounting = find_leaf(step.input().reading.record, "mounting");
  if (!is_choice(mounting) || std::string_view(calculator->id) != "gear.bevel") return {};
  std::set<std::string> overhung;
  std::string shafts;
  for (const auto& shaft : project.steps) {
    for (const Taken& record : shaft->input().reading.records) {
      const auto [pair, gear] = split_step(record.source);
      if (pair != step.name() || !(gear == "gear_1" || gear == "gear_2")) continue;
      const double x = own_value(*shaft, project, prefix_of(record.path) + "x");
      const auto bearings = bearings_of(*shaft, project);
      if (!bearings || !(x < bearings->first || x > bearings->second) || !overhung.insert(gear).second) continue;
      shafts += (shafts.empty() ? "'" : ", '") + shaft->name() + "'";
    }
  }
  const std::string word = word_of(mounting), right = overhung.size() == 2 ? "overhung" : "one_straddled";
  if (overhung.empty() || word == "overhung" || word == right) return {};
  return {{"mounting", say("mounting = {1}, and the gear is overhung on {2}: give mounting = \"{3}\", or "
                           "because.mounting = \"...\"",
                           word, shafts, right)}};
}

class RatingCheck {
 public:
  RatingCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    const Leaf place = place_of(step_);
    if (!place) return {};
    pairs_ = steps_named_in(step_.input().reading);
    for (const auto& shaft : project_.steps) {
      compare_shaft(*shaft, word_of(place));
      compare_hardening(*shaft);
      compare_mate(*shaft);
    }
    for (const char* const number : {"1", "2"}) compare_deflection(number);
    compare_face();
    compare_cycles(step_);
    for (const auto& pair : project_.steps) {
      if (!pairs_.contains(pair->name())) continue;
      compare_cycles(*pair);
      compare_grade(*pair);
    }
    return std::move(found_);
  }

 private:
  static constexpr double drawn = 0.02;         // of the span: accuracy of a place midway
  static constexpr double drawn_factor = 1e-3;  // of K_A: rounding

  /// Face widths are at most 1.6 pitch diameters of the pinion (common practice, recalled): beyond 2, the load
  /// distribution of the standards does not apply.
  void compare_face() {
    constexpr double most = 2.0;
    const double b = own_value(step_, project_, "b");
    const double d_1 = own_value(step_, project_, "m_n") * own_value(step_, project_, "z_1");
    if (b > most * d_1)
      add("b", say("b = {1} is more than {2} times m_n z_1 = {3}; justify it: because.b = \"...\"",
                   format_quantity(b, "mm", 4), format_number(most, 2), format_quantity(d_1, "mm", 4)));
  }

  void add(const char* path, Message message) { found_.push_back({path, std::move(message)}); }

  /// The largest diameter of a shaft; NaN if one is not known yet.
  double thickest_of(const Step& shaft) const {
    double most = 0.0;
    for_each_leaf(shaft.input().reading.record, [&](const std::string& path, const Leaf&) {
      if (!path.starts_with("pieces") || !path.ends_with(".d")) return;
      const double d = own_value(shaft, project_, path);
      if (d > most || std::isnan(d)) most = d;  // NaN stays
    });
    return most;
  }

  /// The shaft that carries gear 1 of the pair.
  void compare_shaft(const Step& shaft, const std::string& place) {
    for (const Taken& record : shaft.input().reading.records) {
      const auto [pair, gear] = split_step(record.source);
      if (gear != "gear_1" || !pairs_.contains(pair)) continue;
      const double x = own_value(shaft, project_, prefix_of(record.path) + "x");
      const auto bearings = bearings_of(shaft, project_);
      if (!bearings || std::isnan(x)) continue;
      const double l = bearings->second - bearings->first;
      compare_place(shaft, place, l, std::abs(x - 0.5 * (bearings->first + bearings->second)));
    }
  }

  /// Teeth that are cut into a shaft are of its steel.
  void compare_hardening(const Step& shaft) {
    const std::string material = material_of(shaft);
    const auto row = shaft.input().tables->find_row("material", material);
    if (material.empty() || !row || row->row->kind == "case hardening steel") return;
    for (const Taken& record : shaft.input().reading.records) {
      const auto [pair, gear] = split_step(record.source);
      if (!pairs_.contains(pair) || !(gear == "gear_1" || gear == "gear_2")) continue;
      const Leaf integral = find_leaf(shaft.input().reading.record, prefix_of(record.path) + "integral");
      const std::string key = "material_" + gear.substr(5);
      const Leaf teeth = find_leaf(step_.input().reading.record, key);
      if (!is_choice(integral) || word_of(integral) != "true" || !is_choice(teeth) || word_of(teeth) != "case")
        continue;
      found_.push_back({key, say("the teeth are one piece with the shaft '{1}' of {2}, which cannot be case-hardened; "
                                 "justify it: because.{3} = \"...\"",
                                 shaft.name(), material, key)});
    }
  }

  /// The pair whose teeth are rated: of its record, else any step that it refers to.
  bool is_pair(const std::string& name) const {
    const auto& records = step_.input().reading.records;
    const auto mesh = std::find_if(records.begin(), records.end(), [](const Taken& r) { return r.path == "mesh"; });
    return mesh == records.end() ? pairs_.contains(name) : split_step(mesh->source).first == name;
  }

  /// The load of the component at "seats.pinion." of a shaft, "stage.gear_1"; empty if no step gives it.
  static std::string load_at(const Step& shaft, const std::string& seat) {
    const Record& record = shaft.input().reading.record;
    const Leaf x = find_leaf(record, seat + "x");
    for (const Taken& load : shaft.input().reading.records) {
      if (!load.path.ends_with(".load")) continue;
      const Leaf other = find_leaf(record, prefix_of(load.path) + "x");
      if (x && other && x.owner == other.owner) return load.source;
    }
    return {};
  }

  /// The deflection of a shaft is that under the gear of the same number, and under its load with the same K_A.
  void compare_deflection(const std::string& number) {
    const std::string key = "f_sh_" + number;
    const Operand* const operand = step_.input().reading.operand(key);
    if (operand == nullptr) return;
    for (const auto& reference : operand->expression.references()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const shaft = project_.find(name);
      if (shaft == nullptr || !rest.starts_with("seats")) continue;
      const std::string load = load_at(*shaft, prefix_of(rest));
      const auto [pair, gear] = split_step(load);
      if (!load.empty() && !(is_pair(pair) && gear == "gear_" + number)) {
        found_.push_back({key, say("{1} is that of '{2}', which carries '{3}': take that of gear {4} of the pair that "
                                   "is rated, or because.{1} = \"...\"",
                                   key, reference.path, load, number)});
        return;
      }
      if (!rest.ends_with(".f_sh")) {
        found_.push_back({key, say("{1} is taken from '{2}', a part of the misalignment: take '{3}.{4}f_sh', or "
                                   "because.{1} = \"...\"",
                                   key, reference.path, name, prefix_of(rest))});
        return;
      }
      compare_factor(key, *shaft);
    }
  }

  /// K_A is applied once: in the loads of the shaft, so that its deflection includes it.
  void compare_factor(const std::string& key, const Step& shaft) {
    const Factors& held = shaft.loads().factors;
    const std::string of_loads = of_kind(held, "K_A");
    const double in_loads = of_loads.empty() ? 1.0 : held.at(of_loads);
    const double there = in_loads * std::fmax(1.0, own_value(shaft, project_, "K_A"));
    const double here = own_value(step_, project_, "K_A");
    if (!(there < (1.0 - drawn_factor) * here)) return;
    found_.push_back({key, say("{1} includes K_A = {2} of the loads of '{3}', and the teeth are rated with {4}: give "
                               "the shaft the load of the pair, or because.{1} = \"...\"",
                               key, format_number(there, 4), shaft.name(), format_number(here, 4))});
  }

  /// A shaft that carries gear 2 and whose deflection is left out, while that of shaft 1 is taken.
  void compare_mate(const Step& shaft) {
    const Reading& reading = step_.input().reading;
    if (reading.operand("f_sh_1") == nullptr || reading.operand("f_sh_2") != nullptr ||
        !std::isnan(own_value(step_, project_, "f_sh_2")))
      return;
    for (const Taken& record : shaft.input().reading.records) {
      const auto [pair, gear] = split_step(record.source);
      if (gear != "gear_2" || !is_pair(pair) || !record.path.ends_with(".load")) continue;
      found_.push_back({"f_sh_2", say("f_sh_2 is missing, and '{1}' carries gear 2: f_sh_2 = \"={1}.{2}f_sh\", or "
                                      "because.f_sh_2 = \"...\"",
                                      shaft.name(), prefix_of(record.path))});
      return;
    }
  }

  void compare_place(const Step& shaft, const std::string& place, double l, double s) {
    const std::string& name = shaft.name();
    if (place == "middle") {
      if (s > drawn * l)
        add("place", say("the pinion is {1} from the middle of the bearing span of '{2}': give place, l, s and d_sh, "
                         "or because.place = \"...\"",
                         format_quantity(s, "mm", 4), name));
      return;
    }
    compare_length("s", own_value(step_, project_, "s") < s - drawn * l, s, name);
    compare_length("l", own_value(step_, project_, "l") < (1.0 - drawn) * l, l, name);
    const double d = thickest_of(shaft);
    compare_length("d_sh", own_value(step_, project_, "d_sh") > (1.0 + drawn) * d, d, name);
  }

  void compare_length(const char* key, bool is_bold, double there, const std::string& shaft) {
    if (!is_bold) return;
    add(key, say("{1} = {2}, and the shaft '{3}' has {4}; justify it: because.{1} = \"...\"", key,
                 format_quantity(own_value(step_, project_, key), "mm", 4), shaft, format_quantity(there, "mm", 4)));
  }

  /// Cast teeth are not as accurate as cut ones: grades 10 to 12 of DIN 3961, from memory.
  void compare_grade(const Step& pair) {
    constexpr double best_of_cast = 10.0;
    if (pair.word("cutting") != "cast" || own_value(step_, project_, "grade") >= best_of_cast) return;
    add("grade", say("the teeth of '{1}' are cast: grade {2} or coarser, or because.grade = \"...\"", pair.name(),
                     format_number(best_of_cast, 2)));
  }

  /// A sun is loaded by each planet in turn.
  void compare_cycles(const Step& taker) {
    if (std::isnan(own_value(step_, project_, "L_h"))) return;
    const double own = own_value(step_, project_, "q_1");
    for_each_reference(taker.input().reading, [&](const std::string& path) {
      const auto [name, rest] = split_step(path);
      const Step* const set = project_.find(name);
      if (set == nullptr || !(rest.starts_with("sun_mesh.") || rest == "z_s")) return;
      const double planets = own_value(*set, project_, "N_p");
      const bool is_told = std::any_of(found_.begin(), found_.end(), [](const auto& one) { return one.path == "q_1"; });
      if (is_told || !(own < planets)) return;
      add("q_1", say("each revolution of the sun of '{1}' loads its teeth {2} times: give q_1 = {2}, or "
                     "because.q_1 = \"...\"",
                     name, format_number(planets, 2)));
    });
  }

  const Step& step_;
  const Project& project_;
  std::set<std::string> pairs_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

namespace {

/// The first over the second of two strengths. Shear strengths of metals are 0.5 to 0.8 of those in tension, of grey
/// cast iron up to 1.2; fatigue limits of a part include notch factors, which differ between bending and torsion;
/// annealed and austenitic steels yield at a third of their tensile strength (recalled).
struct Proportion {
  const char *one, *other;
  double least, most;
};
constexpr std::array proportions{
    Proportion{"sigma_adm", "tau_adm", 0.8, 4.0}, Proportion{"sigma_D", "tau_D", 0.4, 8.0},
    Proportion{"R_m", "R_e", 1.0, 5.0},           Proportion{"sigma_B", "sigma_S", 1.0, 5.0},
    Proportion{"R_mN", "R_eN", 1.0, 5.0},
};

}  // namespace

std::vector<ReducedLoad> strengths_out_of_proportion(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  for (const Proportion& one : proportions) {
    const double a = own_value(step, project, one.one);
    const double b = a > 0.0 ? own_value(step, project, one.other) : std::nan("");
    if (!(a > one.most * b) && !(a < one.least * b)) continue;
    found.push_back({one.one, say("{1} = {2} and {3} = {4} are out of proportion: check the unit and the power of ten, "
                                  "or justify it: because.{1} = \"...\"",
                                  one.one, format_quantity(a, "MPa", 4), one.other, format_quantity(b, "MPa", 4))});
  }
  return found;
}

std::vector<ReducedLoad> values_of_ratings(const Step& step, const Project& project) {
  const std::vector<ReducedLoad> mounting = mounting_on_shafts(step, project);
  return mounting.empty() ? RatingCheck(step, project).run() : mounting;
}

}  // namespace loadpath::project
