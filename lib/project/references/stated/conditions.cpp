#include "lib/project/references/stated/conditions.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

using stated::heat;
using stated::in_few_digits;
using stated::length;
using stated::rate;

using stated::duration;
using stated::pressure;

class Conditions {
 public:
  Conditions(const Step& step, const Project& project)
      : step_(step), project_(project), id_(step.input().calculator->id) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) {
      const Dimension& dimension = value.signature.dimension;
      const double si = value.si.front();
      if (dimension.is_number()) compare_number(name, si);
      if (dimension.without_angle() == rate) compare_overspeed(name, std::abs(si));
      if (dimension == length && si != 0.0) compare_opening(name), compare_level(name, si);
      if (dimension == pressure) compare_residual(name, si);
      if (dimension == heat) compare_cold(name, si), compare_heating(name, si);
      if (dimension == pressure) compare_limit_of_pressure(name, std::abs(si));
      if (si != 0.0 && is_of_surroundings(name)) compare_loading(name);
      if (dimension == duration && is_of_life(name)) compare_life(name, si);
    }
    for (const auto& [name, word] : project_.values.unused_words()) {
      compare_surroundings(name, word);
      const bool is_free = word == "none" || word == "no" || word == "free" || word == "missing";
      if (is_free && has_only_words(name, {"restraint", "restraints", "bracing", "braces"})) compare_loading(name);
      if (is_free || word == "dry") compare_lubrication(name);
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& key, Message message) { found_.push_back({key, std::move(message)}); }

  void add_number(const std::string& name, double si, const std::string& key, double here) {
    found_.push_back(not_taken(name, format_number(si, 5), key, format_number(here, 5)));
  }

  [[nodiscard]] const FieldInfo* field(std::string_view key) const {
    return find_field(step_.input().calculator->input->fields, key);
  }
  [[nodiscard]] double own(const std::string& key) const { return own_value(step_, project_, key); }
  /// The result of the step: the speed of a shaft by its mounted components.
  [[nodiscard]] double found(const std::string& key) const { return magnitude_at(project_, step_.name() + "." + key); }
  [[nodiscard]] bool has_mode(std::string_view mode) const {
    return std::ranges::any_of(step_.input().calculator->modes, [&](const ModeInfo& one) { return one.id == mode; });
  }
  [[nodiscard]] bool is_accepted(const std::string& mode) const { return step_.input().accepted.contains(mode); }

  void compare_number(const std::string& name, double si) {
    compare_reliability(name, si);
    compare_seam(name, si);
    compare_partial(name, si);
    compare_dynamic(name, si);
    compare_cycles(name, si);
    compare_passages(name, si);
    compare_years(name, si);
  }

  /// "reliability = 0.99" next to a rating life of 90 %.
  void compare_reliability(const std::string& name, double si) {
    constexpr double usual = 0.9;
    if (!has_word(name, {"reliability", "survival"}) || !(si > usual && si < 1.0)) return;
    if (field("R") == nullptr || field("L_h") == nullptr || own("a_1") < 1.0) return;
    const double here = std::isnan(own("R")) ? usual : own("R");
    if (si > here) add_number(name, si, "R", here);
  }

  /// "weld_factor = 0.85" next to a seam of 1.
  void compare_seam(const std::string& name, double si) {
    const bool is_factor = has_word(name, {"factor", "efficiency", "coefficient", "z", "eta", "v", "phi", "e"});
    if (!has_word(name, {"weld", "seam", "joint"}) || !(is_factor || name == "seam")) return;
    if (field("z_l") == nullptr || !(si > 0.0 && si < (1.0 - in_few_digits) * own("z_l"))) return;
    add_number(name, si, "z_l", own("z_l"));
  }

  /// "gamma_Q = 1.5" next to gamma_F = 1.
  void compare_partial(const std::string& name, double si) {
    if (!is_partial_of_load(name)) return;
    if (field("gamma_F") == nullptr || !(si > (1.0 + in_few_digits) * own("gamma_F"))) return;
    add_number(name, si, "gamma_F", own("gamma_F"));
  }

  /// A partial factor of an action: those of resistances are gamma_M, gamma_R.
  [[nodiscard]] static bool is_partial_of_load(std::string_view name) {
    return name.starts_with("gamma_") && !name.starts_with("gamma_M") && !name.starts_with("gamma_R");
  }

  /// A factor of the load of a part without an application factor, or with 1: "phi = 1.15" of a crane. A partial
  /// factor of actions, gamma_F, includes no impact.
  void compare_dynamic(const std::string& name, double si) {
    constexpr double most = 5.0;
    constexpr std::array<std::string_view, 4> names{"phi", "f_w", "f_s", "load_factor"};
    const bool is_factor = has_word(name, {"impact", "shock", "dynamic", "dyn", "gust", "surge", "overload"}) &&
                           has_word(name, {"factor", "coefficient", "allowance", "phi", "psi", "f", "k"}) &&
                           has_only_words(name, {"impact", "shock", "dynamic", "dyn", "gust", "surge", "overload",
                                                 "factor", "coefficient", "allowance", "phi", "psi", "f", "k", "load"});
    const bool is_one = is_factor || std::ranges::find(names, std::string_view(name)) != names.end() ||
                        (name == "f" && is_pin()) || (is_partial_of_load(name) && field("gamma_F") == nullptr) ||
                        name.starts_with("phi_") || is_unapplied_factor(name);
    const bool is_partial = name == "load_factor" && si <= (1.0 + in_few_digits) * own("gamma_F");
    const double covered = name.starts_with("phi_") ? si - in_few_digits : 1.0;  // by the application factor
    if (!is_one || !(si > 1.0 + in_few_digits && si <= most) || own("K_A") > covered || is_partial) return;
    const std::string key = typed_load();
    if (key.empty()) return;
    add(key, say("values.{1} = {2} acts on no step: refer to it, delete it, or justify it: because.{3} = \"...\"", name,
                 format_number(si, 5), key));
  }

  /// "K_A" of a project none of whose steps has an application factor.
  [[nodiscard]] bool is_unapplied_factor(const std::string& name) const {
    const auto has_one = [](const auto& one) { return find_field(one->input().calculator->input->fields, "K_A"); };
    return (name == "K_A" || name.starts_with("K_A_")) && std::ranges::none_of(project_.steps, has_one);
  }

  /// The first load that is typed or comes from [values]: the file states it, not another step.
  [[nodiscard]] std::string typed_load() const {
    const auto& reading = step_.input().reading;
    const auto is_of_step = [&](const std::string& key) {
      return std::ranges::any_of(reading.operands, [&](const Operand& operand) {
        return operand.path == key && std::ranges::any_of(operand.expression.references(), [](const auto& reference) {
                 return !reference.path.starts_with("values.");
               });
      });
    };
    for (const FieldInfo& one : step_.input().calculator->input->fields) {
      if (one.is_load && !one.dimension.is_number() && reading.typed.contains(one.key) && !is_of_step(one.key))
        return one.key;
    }
    return id_ == "shaft.design" ? "seats" : std::string();
  }

  /// A load or a position of the whole machine, by words without the name of a part: "wind", "tilt_angle". "F_wind" and
  /// "q_snow" may be carried by another structure.
  [[nodiscard]] static bool is_of_surroundings(const std::string& name) {
    const bool is_meant = has_word(name, {"wind", "gust", "snow", "ice", "seismic", "earthquake", "tilt", "sway",
                                          "unbalance", "imbalance", "misalignment", "settlement", "sling", "slings"});
    return is_meant &&
           has_only_words(name, {"wind",     "gust",  "snow",      "ice",       "seismic",      "earthquake", "tilt",
                                 "sway",     "angle", "unbalance", "imbalance", "misalignment", "settlement", "load",
                                 "pressure", "force", "moment",    "speed",     "max",          "design",     "e",
                                 "alpha",    "beta",  "sling",     "slings",    "leg"});
  }

  /// Chains, gears and bearings are rated with a lubricant.
  void compare_lubrication(const std::string& name) {
    const bool is_lubricated = id_.starts_with("chain.") || id_.starts_with("gear.") || id_ == "bearing.rolling";
    if (!is_lubricated || !has_only_words(name, {"lubrication", "lubricant", "oil", "grease"})) return;
    for (const char* const key : {"P", "T_1", "F_r", "z_1"}) {
      if (step_.input().reading.typed.contains(key)) return add_unused(name, key);
    }
  }

  void compare_loading(const std::string& name) {
    const std::string key = typed_load();
    if (key.empty()) return;
    add_unused(name, key);
  }

  /// A relief, set or test pressure above that of a wall. A relief valve may be named by where it opens fully, up to
  /// 1.1 times the pressure.
  void compare_limit_of_pressure(const std::string& name, double si) {
    constexpr double of_valves = 1.1;
    if (!id_.starts_with("vessel.") || !is_pressure_name(name)) return;
    const bool is_test = says_one_of(name, {"test", "hydro", "proof"});
    const bool is_limit = says_one_of(name, {"relief", "opening", "blowoff", "blow_off", "mawp", "burst"}) ||
                          has_word(name, {"set", "pset", "psv", "prv", "srv", "sv", "rv", "ps", "safety"});
    const bool is_valve = says_one_of(name, {"valve"});
    if (!is_test && !is_limit && !is_valve) return;
    const double most = is_valve && !is_limit && !is_test ? of_valves : 1.0 + in_few_digits;
    const auto covers = [&](const auto& other) {
      const auto is_above = [&](const char* key) { return own_value(*other, project_, key) * most >= si; };
      return std::string_view(other->input().calculator->id).starts_with("vessel.") &&
             (is_above("p") || (is_test && is_above("p_t")));
    };
    if (std::isnan(own("p")) || std::ranges::any_of(project_.steps, covers)) return;
    const std::string key = is_test && !std::isnan(own("p_t")) ? "p_t" : "p";
    add(key,
        say("values.{1} = {2} acts on no step, and {3} is {4}: refer to it, delete it, or justify it: because.{3} = "
            "\"...\"",
            name, format_quantity(si, "MPa", 4), key, format_quantity(own(key), "MPa", 4)));
  }

  [[nodiscard]] static bool says_one_of(std::string name, std::initializer_list<std::string_view> parts) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::ranges::any_of(parts, [&](std::string_view part) { return name.find(part) != std::string::npos; });
  }

  /// Stresses and strengths have the same dimension.
  [[nodiscard]] static bool is_pressure_name(std::string_view name) {
    return !has_word(name, {"sigma", "tau", "stress", "strength", "r", "e", "s", "yield", "modulus"});
  }

  [[nodiscard]] bool is_pin() const { return id_.starts_with("pin."); }

  [[nodiscard]] static bool is_of_fatigue(const Step& step) {
    return std::string_view(step.input().calculator->id).starts_with("fatigue.");
  }

  [[nodiscard]] static bool is_shaft_design(const Step& step) {
    return step.input().calculator->id == std::string_view("shaft.design");
  }

  /// Load cycles of a part whose fatigue nothing assesses.
  void compare_cycles(const std::string& name, double si) {
    constexpr double fewest = 1e4;
    if (is_of_peak(name) || (!name.starts_with("N_") && name != "N" && !has_word(name, {"cycles", "lifts", "strokes"})))
      return;
    const bool is_on_shaft = id_.starts_with("shaft.");  // whose fatigue a step of shaft.design assesses
    const bool is_assessed = std::ranges::any_of(
        project_.steps, [&](const auto& one) { return is_of_fatigue(*one) || (is_on_shaft && is_shaft_design(*one)); });
    if (!(si >= fewest) || is_assessed || !has_mode("fatigue") || is_accepted("fatigue") || field("N") != nullptr)
      return;
    for (const char* const key : {"p", "F", "T", "P"}) {
      if (field(key) == nullptr) continue;
      return add(key, say("values.{1} = {2} acts on no step, and fatigue is not assessed: add a step of fatigue.life, "
                          "or accept.fatigue = \"...\"",
                          name, format_number(si, 5)));
    }
  }

  /// Repetitions of a history under another word.
  void compare_passages(const std::string& name, double si) {
    if (field("n_req") == nullptr ||
        !has_word(name, {"passages", "passes", "starts", "trips", "blocks", "repeats", "missions"}))
      return;
    if (si > (1.0 + in_few_digits) * own("n_req")) add_number(name, si, "n_req", own("n_req"));
  }

  /// Years of service that enter no life.
  void compare_years(const std::string& name, double si) {
    if (name != "years" || !(si > 0.0) || field("n_req") != nullptr || field("L_h") != nullptr) return;
    if (std::isnan(own("N"))) return;
    add("N", say("values.years = {1} acts on no step, and N is {2}: refer to it, delete it, or justify it: because.N = "
                 "\"...\"",
                 format_number(si, 5), format_number(own("N"), 5)));
  }

  /// A life next to fewer repetitions of a history of known duration.
  void compare_life(const std::string& name, double si) {
    const double here = own("n_req") * own("t");  // NaN of a step without them
    if (!(si > (1.0 + in_few_digits) * here)) return;
    add("n_req", say("values.{1} = {2} acts on no step, and n_req t is {3}: refer to it, delete it, or justify it: "
                     "because.n_req = \"...\"",
                     name, format_quantity(si, "h", 5), format_quantity(here, "h", 5)));
  }

  /// The input with the speed of a part that rotates, of a drive its first one.
  [[nodiscard]] std::string speed_of_part() const {
    if (id_ == "machine.flywheel") return "omega";
    for (const char* const speed : {"n", "n_1"})
      if (field(speed) != nullptr) return speed;
    return "";
  }

  /// "n_over", "n_trip" above the speed of a rotating part; a much higher one is that of another shaft.
  void compare_overspeed(const std::string& name, double si) {
    constexpr double most = 3.0;
    const bool is_most = name == "n_max" && (id_ == "machine.disc" || id_ == "shaft.press_fit");
    const std::string key = speed_of_part();
    if (!(is_most || is_of_overspeed(name)) || key.empty()) return;
    const auto has_it = [&](const auto& one) {
      return std::ranges::any_of(std::array{"n", "n_1", "n_2", "omega"}, [&](const char* speed) {
        return std::abs(own_value(*one, project_, speed)) >= si * (1.0 - 1e-3);
      });
    };
    const double typed = own(key), here = std::abs(std::isnan(typed) ? found(key) : typed);
    if (!(si > here && si <= most * here) || std::ranges::any_of(project_.steps, has_it)) return;
    add(key, say("values.{1} = {2} acts on no step, and {4} is {3}: refer to it, delete it, or justify it: because.{4} "
                 "= \"...\"",
                 name, format_quantity(si, "rpm", 5), format_quantity(here, "rpm", 5), key));
  }

  /// A level above that of the step; the density and the level of a liquid, next to a wall that holds none.
  void compare_level(const std::string& name, double si) {
    const bool is_level =
        name == "H" || name == "h" || has_word(name, {"level", "height", "fill", "filling", "liquid"});
    constexpr double lightest = 300.0, heaviest = 3000.0;  // kg/m^3, of liquids and suspensions
    const bool has_density = std::ranges::any_of(project_.values.unused(), [](const auto& entry) {
      const double of_other = entry.second.si.front();
      return entry.second.signature.dimension == Dimension::of(-3, 1, 0) && of_other > lightest && of_other < heaviest;
    });
    const bool is_held =
        std::ranges::any_of(project_.steps, [&](const auto& one) { return own_value(*one, project_, "h_l") > 0.0; });
    const double h_l = own("h_l");
    const bool is_of_liquid =
        has_word(name, {"level", "fill", "filling", "full", "liquid"}) || has_only_words(name, {"h", "max"});
    const bool is_higher = is_of_liquid && name != "h" && name != "H" && si > (1.0 + in_few_digits) * h_l;
    if (is_higher)
      add("h_l", say("values.{1} = {2} acts on no step, and h_l is {3}: refer to it, delete it, or justify it: "
                     "because.h_l = \"...\"",
                     name, format_quantity(si, "m", 4), format_quantity(h_l, "m", 4)));
    if (!is_level || !has_density || field("h_l") == nullptr || is_held) return;
    add("p", say("values.{1} and a density act on no step: give rho and h_l, delete them, or justify it: because.p = "
                 "\"...\"",
                 name));
  }

  void add_unused(const std::string& name, const std::string& key) {
    add(key, say("values.{1} is not used by any step: include it in a load, delete it, or justify it: because.{2} = "
                 "\"...\"",
                 name, key));
  }

  /// A warm room around a gear that may get hotter than it by dT_adm: oils of gears bear up to 100 degC, from memory.
  void compare_heating(const std::string& name, double si) {
    constexpr double most = 373.15;
    const bool is_of_room = has_word(name, {"ambient", "room", "hall", "air"});
    if (!is_of_room || id_ != "gear.worm" || !(si + own("dT_adm") > most + 0.01)) return;
    add("dT_adm", say("values.{1} = {2} acts on no step, and with dT_adm the oil reaches {3}: lower dT_adm, or justify "
                      "it: because.dT_adm = \"...\"",
                      name, format_quantity(si, "degC", 4), format_quantity(si + own("dT_adm"), "degC", 4)));
  }

  /// A nozzle or a manhole of a vessel, whose reinforcement is assessed elsewhere; holes of a disc.
  void compare_opening(const std::string& name) {
    if (!has_word(name, {"nozzle", "nozzles", "opening", "openings", "manhole", "manway", "hole", "holes", "branch"}))
      return;
    if (has_mode("nozzles") && !is_accepted("nozzles") && field("p") != nullptr)
      add("p", say("values.{1} acts on no step, and the reinforcement of openings is not assessed: assess it "
                   "separately, accept.nozzles = \"...\", or delete the value",
                   name));
    if (id_ == "machine.disc" && has_word(name, {"hole", "holes"}) && !is_accepted("notches"))
      add("D", say("values.{1} acts on no step, and the stress concentration at holes is not assessed: assess it "
                   "separately, accept.notches = \"...\", or delete the value",
                   name));
  }

  /// A residual stress next to a cycle without it.
  void compare_residual(const std::string& name, double si) {
    if (!(si > 0.0) || !has_word(name, {"res", "residual"}) || !is_of_fatigue(step_)) return;
    for (const char* const key : {"sigma_m", "S_D"}) {
      if (field(key) == nullptr) continue;
      return add(key, say("values.{1} = {2} acts on no step, and raises the mean stress: add it to the cycle, or "
                          "because.{3} = \"...\"",
                          name, format_quantity(si, "MPa", 5), key));
    }
  }

  /// A temperature at which structural steels may be brittle: below -20 degC, from memory.
  void compare_cold(const std::string& name, double si) {
    constexpr double least = 253.15;
    const bool is_temperature = has_word(name, {"t", "theta", "temperature", "ambient"});
    const bool is_meant = has_word(name, {"min", "design", "ambient", "service", "operating", "temperature", "low"}) ||
                          has_only_words(name, {"t", "theta"});
    if (!(si < least) || !is_temperature || !is_meant || is_accepted("low_temperature") || is_accepted("brittle"))
      return;
    const bool is_cold_mode = has_mode("low_temperature");
    if (!is_cold_mode && !has_mode("brittle")) return;
    for (const char* const key : {"p", "T", "n", "D"}) {
      if (field(key) == nullptr) continue;
      return add(key, say("values.{1} = {2} acts on no step, and brittle fracture is not assessed: assess it "
                          "separately, accept.{3} = \"...\", or delete the value",
                          name, format_quantity(si, "degC", 4), is_cold_mode ? "low_temperature" : "brittle"));
    }
  }

  /// A corrosive environment next to fatigue strengths in air.
  void compare_surroundings(const std::string& name, const std::string& word) {
    if (!has_word(name, {"environment", "atmosphere", "surroundings", "medium"})) return;
    const auto says = [&](std::string_view part) { return word.find(part) != std::string::npos; };
    const bool is_corrosive = says("corros") || says("sea") || says("salt") || says("acid") || says("chlor");
    if (!is_corrosive || is_accepted("surroundings") || is_accepted("corrosion")) return;
    const bool has_corrosion = has_mode("surroundings") || has_mode("corrosion");
    if (!has_corrosion) return;
    const char* const mode = has_mode("surroundings") ? "surroundings" : "corrosion";
    add(mode, say("values.{1} = {2} acts on no step, and corrosion is not assessed: assess it separately, accept.{3} = "
                  "\"...\", or delete the value",
                  name, word, mode));
  }

  const Step& step_;
  const Project& project_;
  std::string_view id_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> conditions_stated_only(const Step& step, const Project& project) {
  return Conditions(step, project).run();
}

}  // namespace loadpath::project
