#include "lib/project/references/agreement/stated_values.hpp"

#include "lib/project/references/agreement/drive_lines.hpp"
#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

constexpr double as_stated = 1e-6;
constexpr double in_few_digits = 1e-3;   // of values with few digits
constexpr double atmosphere = 101325.0;  // Pa, of a full vacuum

const Dimension pressure = Dimension::of(-1, 1, -2);
const Dimension heat = [] {
  Dimension dimension;
  dimension.twelfths[Dimension::temperature] = Dimension::one;
  return dimension;
}();

const Dimension duration = Dimension::of(0, 0, 1);

/// An entry of [values].
struct Stated {
  const std::string& name;
  double si;
};

class StatedCheck {
 public:
  StatedCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) {
      const Dimension& dimension = value.signature.dimension;
      const Stated stated{name, value.si.front()};
      if (dimension.is_number()) compare_peak(stated), compare_repetitions(stated);
      if (dimension == heat) compare_temperature(stated);
      if (is_geometry_of_teeth()) compare_load(stated, dimension.without_angle());
      if (dimension == pressure && (is_of_vacuum(name) || is_below_atmosphere(stated))) compare_vacuum(stated);
      if (dimension == duration && is_of_life(name)) compare_life(stated);
      compare_same_name(stated, dimension);
    }
    for (const auto& [name, word] : project_.values.unused_words()) {
      if (is_of_vacuum(name) && word == "full") compare_vacuum({name, atmosphere});
    }
    compare_years();
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  [[nodiscard]] const FieldInfo* field(std::string_view key) const {
    return find_field(step_.input().calculator->input->fields, key);
  }
  [[nodiscard]] double own(const std::string& key) const { return own_value(step_, project_, key); }

  /// Whether a number is named as a peak factor: "k_start", "f_max", "start_factor", "shock"; "n_start" is a count.
  static bool is_peak_factor(std::string_view name) {
    if (!is_of_peak(name)) return false;
    const bool is_alone = name.find('_') == std::string_view::npos;
    return (is_alone && name != "max") || has_word(name, {"k", "f", "factor"});
  }

  /// The peak factor of the step: its input, and by how much it covers a peak; empty if it has none.
  [[nodiscard]] std::pair<std::string, double> own_peak() const {
    for (const FieldInfo& factor : step_.input().calculator->input->fields) {
      const std::string_view key = factor.key;
      if ((key == "k_max" || key == "f_max") && factor.dimension.is_number() && own(factor.key) >= 1.0)
        return {factor.key, own(factor.key)};
    }
    if (field("T_max") != nullptr && field("T") != nullptr) return {"T_max", peak_factor_of(step_, project_)};
    return {};
  }

  /// "f_start = 3" next to f_max = 1, "k_start" next to k_max, or to the T_max of a key.
  void compare_peak(const Stated& stated) {
    constexpr double most = 10.0;
    if (!(stated.si <= most) || !is_peak_factor(stated.name)) return;
    const auto [key, here] = own_peak();
    if (key.empty()) return compare_shock(stated);
    if (!(stated.si > (1.0 + in_few_digits) * here)) return;
    add(key,
        say("values.{1} = {2} acts on no step, and {3} covers a peak of {4} times the load: refer to it, delete it, or "
            "justify it: because.{3} = \"...\"",
            stated.name, format_number(stated.si, 4), key, format_number(here, 4)));
  }

  /// A shock of a machine none of whose steps has a peak factor is one of its application factor.
  void compare_shock(const Stated& stated) {
    const bool has_peak = std::ranges::any_of(project_.steps, [](const auto& step) {
      const Calculator* const calculator = step->input().calculator;
      return find_field(calculator->input->fields, "k_max") != nullptr ||
             find_field(calculator->input->fields, "T_max") != nullptr;
    });
    const double here = own("K_A");
    if (has_peak || !(stated.si > (1.0 + in_few_digits) * here)) return;
    add("K_A", say("values.{1} = {2} acts on no step, and K_A is {3}: refer to it, delete it, or justify it: "
                   "because.K_A = \"...\"",
                   stated.name, format_number(stated.si, 4), format_number(here, 4)));
  }

  /// "days = 7300" next to n_req = 1.
  void compare_repetitions(const Stated& stated) {
    constexpr std::array<std::string_view, 7> periods{"days",   "weeks",       "months", "years",
                                                      "shifts", "repetitions", "n_req"};
    if (!std::ranges::any_of(periods, [&](std::string_view period) { return stated.name == period; })) return;
    const double here = own("n_req");
    if (!(stated.si > (1.0 + as_stated) * here)) return;
    add("n_req", say("values.{1} = {2} acts on no step, and n_req is {3}: refer to it, delete it, or justify it: "
                     "because.n_req = \"...\"",
                     stated.name, format_number(stated.si, 6), format_number(here, 6)));
  }

  /// The required life of the step and its input: L_h, or L_req where L_h is its result, or N load cycles at the speed
  /// n_1.
  [[nodiscard]] std::pair<const char*, double> own_life() const {
    const FieldInfo* const required = field("L_req");
    if (required != nullptr && required->dimension == duration) return {"L_req", own("L_req")};
    const double L_h = own("L_h"), cycles = own("N"), n_1 = std::abs(own("n_1"));
    if (!std::isnan(L_h) || std::isnan(cycles) || !(n_1 > 0.0)) return {"L_h", L_h};
    constexpr double turn = 2.0 * std::numbers::pi;
    return {"N", turn * cycles / n_1};
  }

  /// "life = 40000 h" next to L_h = 20000 h, or next to fewer load cycles.
  void compare_life(const Stated& stated) {
    const auto [key, here] = own_life();
    if (stated.name == std::string_view(key)) return;  // under its own name
    if (!(stated.si > (1.0 + in_few_digits) * here)) return;
    add(key, say("values.{1} = {2} acts on no step, and {3} is {4}: refer to it, delete it, or justify it: "
                 "because.{3} = \"...\"",
                 stated.name, format_quantity(stated.si, "h", 5), key, life_here(key, here)));
  }

  [[nodiscard]] std::string life_here(std::string_view key, double life) const {
    const std::string hours = format_quantity(life, "h", 5);
    return key == "N" ? format_number(own("N"), 5) + ", " + hours : hours;
  }

  /// "hours_per_day" and "years", of working days, next to a shorter required life.
  void compare_years() {
    constexpr double days = 250.0, hours_of_shift = 8.0 * 3600.0;
    double years = std::nan(""), hours = std::nan(""), of_year = std::nan("");
    for (const auto& [name, value] : project_.values.unused()) {
      if (name == "years" && value.signature.dimension.is_number()) years = value.si.front();
      if (has_word(name, {"year"}) && has_word(name, {"hours", "h"}))
        of_year = value.si.front() * (value.signature.dimension.is_number() ? 3600.0 : 1.0);
      if (has_word(name, {"shifts"}) && value.signature.dimension.is_number())
        hours = hours_of_shift * value.si.front();
      if (!has_word(name, {"day", "daily"})) continue;
      if (value.signature.dimension == duration) hours = value.si.front();
      if (value.signature.dimension.is_number() && has_word(name, {"hours", "h"})) hours = 3600.0 * value.si.front();
    }
    if (hours > (1.0 + in_few_digits) * own("h_day"))
      add("h_day", say("the hours per day of [values] act on no step, and h_day is {1}: refer to them, delete them, or "
                       "justify it: because.h_day = \"...\"",
                       format_quantity(own("h_day"), "h", 4)));
    const double life = years * (std::isnan(hours) ? of_year : days * hours);
    if (std::isnan(life)) return;
    const auto [key, here] = own_life();
    if (!(life > (1.0 + in_few_digits) * here)) return;
    add(key, say("the years and hours of [values] act on no step: {1} on 250 days a year, and {2} is {3}: refer to "
                 "them, delete them, or justify it: because.{2} = \"...\"",
                 format_quantity(life, "h", 5), key, life_here(key, here)));
  }

  /// Teeth whose strength no calculator assesses, and which take no load.
  [[nodiscard]] bool is_geometry_of_teeth() const {
    return std::string_view(step_.input().calculator->id) == "gear.cycloidal";
  }

  [[nodiscard]] bool is_worm() const { return std::string_view(step_.input().calculator->id) == "gear.worm"; }

  /// A torque, a force or a power next to them.
  void compare_load(const Stated& stated, const Dimension& dimension) {
    const bool is_load = dimension == Dimension::of(2, 1, -2) || dimension == Dimension::of(1, 1, -2) ||
                         dimension == Dimension::of(2, 1, -3);
    if (!is_load || stated.si == 0.0) return;
    add("m", say("values.{1} acts on no step, and the strength of these teeth is not assessed: assess it separately, "
                 "because.m = \"...\", or delete the value",
                 stated.name));
  }

  /// The value of an input: typed, of a row, or the usual one.
  [[nodiscard]] double known(const std::string& key) const {
    constexpr double usual_reliability = 0.9;  // of a rating life
    const double here = own(key);
    if (key == "R" && std::isnan(here) && field("L_h") != nullptr) return usual_reliability;
    return std::isnan(here) ? magnitude_at(project_, step_.name() + "." + key) : here;
  }

  /// Whether a larger value requires more than the step has: a life, a reliability, a safety factor, an
  /// allowance for corrosion, a speed.
  [[nodiscard]] bool asks_for_more(const Stated& stated, double here) const {
    if (stated.name == "R") return here >= 0.5 && stated.si < 1.0 && stated.si > here;
    const bool is_allowance =
        stated.name == "c" && std::string_view(step_.input().calculator->id).starts_with("vessel.");
    const FieldInfo* const same = field(stated.name);
    const bool is_safety =
        stated.name.starts_with("S_") && same->dimension.is_number() && !same->is_factor && here > 0.0;
    const bool is_limit = stated.name == "n_max" && here > 0.0;  // a speed that the part must bear
    return (stated.name == std::string_view(own_life().first) || is_allowance || is_limit || is_safety) &&
           stated.si > (1.0 + as_stated) * here;
  }

  /// A required life above, or a strength below that of the step under its own name.
  void compare_same_name(const Stated& stated, const Dimension& dimension) {
    const FieldInfo* const same = field(stated.name);
    if (same == nullptr || !(same->dimension == dimension) || same->is_load) return;
    const bool names_strength =
        stated.name == "R_e" || stated.name == "R_m" || means(*step_.input().calculator, stated.name, &is_strength);
    const double here = known(stated.name);
    const bool is_weak = names_strength && stated.si < (1.0 - as_stated) * here;
    if (!asks_for_more(stated, here) && !is_weak) return;
    const auto shown = [&](double si) {
      return dimension.is_number() ? format_number(si, 5) : format_quantity(si, same->unit, 5);
    };
    add(stated.name,
        say("values.{1} = {2} acts on no step, and {1} is {3} here: refer to it, delete it, or justify it: "
            "because.{1} = \"...\"",
            stated.name, shown(stated.si), shown(here)));
  }

  /// The input that a reason for the temperature belongs to: the temperature itself, or the first strength.
  [[nodiscard]] std::string heated_input() const {
    for (const FieldInfo& one : step_.input().calculator->input->fields) {
      const std::string_view name = one.key;
      if (one.dimension == heat && (name == "T" || name == "T_G")) return one.key;
    }
    for (const char* const key : {"R_e", "R_m", "R_e_1", "sigma_adm", "tau_adm", "sigma_D", "tau_D", "sigma_B"}) {
      if (field(key) != nullptr && !std::isnan(own(key))) return key;
    }
    if (std::string_view(step_.input().calculator->id) == "bearing.rolling") return "C";  // its steel is tempered
    if (std::string_view(step_.input().calculator->id) == "belt.synchronous") return "F_a";
    if (is_worm()) return "m_x";  // the bronze of its wheel, and the oil
    return material_of(step_).empty() || field("R_e") == nullptr ? "" : "R_e";
  }

  /// A temperature of the part above the limit of strengths at room temperature.
  void compare_temperature(const Stated& stated) {
    constexpr double most_of_steel = 373.15;    // 100 degC: of steels but fine-grained ones in [FKM], from memory
    constexpr double most_of_bearing = 393.15;  // 120 degC: dimensions of rolling bearings, from memory
    constexpr double most_of_bevel = 394.15;    // 121 degC: temperature factor of 1, [AGMA2003]
    constexpr double most_of_belt = 358.15;     // 85 degC: belts of rubber or polyurethane, from memory
    const std::string_view name = stated.name;
    const std::string key = heated_input();
    const double most = key == "F_a"   ? most_of_belt
                        : key == "C"   ? most_of_bearing
                        : key == "T_G" ? most_of_bevel
                                       : most_of_steel;
    const bool is_temperature = name.starts_with("t_") || name.starts_with("T_") || name.starts_with("theta_");
    const bool is_named =
        is_temperature &&
        !has_word(name, {"join", "joining", "temper", "tempering", "melting", "melt", "hardening", "annealing",
                         "shrink", "mounting", "oil", "sump", "flash", "ignition", "store", "storage", "limit", "adm"});
    const bool is_of_part = is_named || has_word(name, {"ambient", "temperature"}) ||
                            ((key == "T_G" || key == "C" || is_worm()) && has_word(name, {"oil", "sump"})) ||
                            has_only_words(name, {"t", "theta"});
    if (!(stated.si > most) || !is_of_part) return;
    if (key.empty() || ((key == "T" || key == "T_G") && own(key) >= stated.si)) return;
    if (key == "T_G")
      return add(key, say("values.{1} = {2} acts on no step: give T_G, the temperature of the gears, or "
                          "because.T_G = \"...\"",
                          stated.name, format_quantity(stated.si, "degC", 4)));
    if (key == "F_a")
      return add(key, say("values.{1} = {2} acts on no step, and usual belts apply up to {3}: because.F_a "
                          "= \"...\"",
                          stated.name, format_quantity(stated.si, "degC", 4), format_quantity(most, "degC", 4)));
    add(key,
        say("values.{1} = {2} acts on no step, and strengths at room temperature apply up to {3}: give the strength "
            "at this temperature or T, or because.{4} = \"...\"",
            stated.name, format_quantity(stated.si, "degC", 4), format_quantity(most, "degC", 4), key));
  }

  /// "p_min = -0.08 MPa": a gauge pressure.
  [[nodiscard]] static bool is_below_atmosphere(const Stated& stated) {
    constexpr double least = -0.11e6;  // Pa, a full vacuum as a round number
    return stated.si < 0.0 && stated.si >= least && has_word(stated.name, {"p", "pressure", "suction"});
  }

  [[nodiscard]] bool is_vacuum_assessed() const {
    return std::ranges::any_of(project_.steps, [](const auto& step) {
      return find_field(step->input().calculator->input->fields, "p_e") != nullptr;
    });
  }

  /// A vacuum that is higher than the external pressure, or that no step assesses a wall for.
  void compare_vacuum(const Stated& stated) {
    if (step_.input().accepted.contains("vacuum")) return;
    const double si = std::abs(stated.si), p_e = own("p_e");
    const bool is_wall = std::string_view(step_.input().calculator->id).starts_with("vessel.");
    if (!is_wall || !(p_e < (1.0 - as_stated) * si || (std::isnan(p_e) && !is_vacuum_assessed()))) return;
    const std::string key = std::isnan(p_e) ? "p" : "p_e";
    if (field(key) == nullptr) return;
    add(key, std::isnan(p_e)
                 ? say("values.{1} = {2} acts on no step: add a step of vessel.external, delete it, or justify it: "
                       "because.p = \"...\"",
                       stated.name, format_quantity(si, "MPa", 4))
                 : say("values.{1} = {2} acts on no step, and p_e is {3}: refer to it, delete it, or justify it: "
                       "because.p_e = \"...\"",
                       stated.name, format_quantity(si, "MPa", 4), format_quantity(p_e, "MPa", 4)));
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> values_stated_only(const Step& step, const Project& project) {
  return StatedCheck(step, project).run();
}

}  // namespace loadpath::project
