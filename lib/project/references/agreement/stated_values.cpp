#include "lib/project/references/agreement/stated_values.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double as_stated = 1e-6;

const Dimension pressure = Dimension::of(-1, 1, -2);
const Dimension heat = [] {
  Dimension dimension;
  dimension.twelfths[Dimension::temperature] = Dimension::one;
  return dimension;
}();

/// "start" of "f_start"; the name where it has no index.
std::string_view index_of(std::string_view name) { return name.substr(name.rfind('_') + 1); }

template <std::size_t size>
bool is_one_of(std::string_view word, const std::array<std::string_view, size>& words) {
  return std::ranges::find(words, word) != words.end();
}

/// An entry of [values].
struct Stated {
  const std::string& name;
  double si;
};

bool is_strength(std::string_view what) {
  return strength_bound_of(what) != nullptr || what == allowable_in_normal || what == allowable_in_shear;
}

class StatedCheck {
 public:
  StatedCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) {
      const Dimension& dimension = value.signature.dimension;
      const Stated stated{name, value.si.front()};
      if (dimension.is_number()) compare_peak(stated), compare_repetitions(stated);
      if (dimension == heat) compare_temperature(stated);
      if (dimension == pressure) compare_vacuum(stated);
      compare_same_name(stated, dimension);
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  [[nodiscard]] const FieldInfo* field(std::string_view key) const {
    return find_field(step_.input().calculator->input->fields, key);
  }
  [[nodiscard]] double own(const std::string& key) const { return own_value(step_, project_, key); }

  /// "f_start = 3" next to f_max = 1, "k_start" next to k_max.
  void compare_peak(const Stated& stated) {
    constexpr double most = 10.0;
    constexpr std::array<std::string_view, 9> peaks{"start", "starting", "max",   "peak",    "jam",
                                                    "stall", "shock",    "brake", "overload"};
    if (stated.name.find('_') == std::string::npos || !is_one_of(index_of(stated.name), peaks)) return;
    for (const FieldInfo& factor : step_.input().calculator->input->fields) {
      const std::string key = factor.key;
      if (!key.ends_with("_max") || key[0] != stated.name[0] || !factor.dimension.is_number()) continue;
      const double here = own(key);
      if (factor.is_load || !(here >= 1.0) || !(stated.si > (1.0 + as_stated) * here) || stated.si > most) continue;
      add(key,
          say("values.{1} = {2} acts on no step, and {3} is {4}: refer to it, delete it, or justify it: because.{3} "
              "= \"...\"",
              stated.name, format_number(stated.si, 4), key, format_number(here, 4)));
    }
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

  /// A required life above, or a strength below that of the step under its own name.
  void compare_same_name(const Stated& stated, const Dimension& dimension) {
    const FieldInfo* const same = field(stated.name);
    if (same == nullptr || !(same->dimension == dimension) || same->is_load) return;
    if (!step_.input().reading.typed.contains(stated.name)) return;
    const double here = own(stated.name);
    const bool is_short = stated.name == "L_h" && stated.si > (1.0 + as_stated) * here;
    const bool names_strength =
        stated.name == "R_e" || stated.name == "R_m" || means(*step_.input().calculator, stated.name, &is_strength);
    const bool is_weak = names_strength && stated.si < (1.0 - as_stated) * here;
    if (!is_short && !is_weak) return;
    add(stated.name,
        say("values.{1} = {2} acts on no step, and {1} is {3} here: refer to it, delete it, or justify it: "
            "because.{1} = \"...\"",
            stated.name, format_quantity(stated.si, same->unit, 5), format_quantity(here, same->unit, 5)));
  }

  /// The input that a reason for the temperature belongs to: the temperature itself, or the first strength.
  [[nodiscard]] std::string heated_input() const {
    for (const FieldInfo& one : step_.input().calculator->input->fields) {
      if (one.dimension == heat && one.key == std::string_view("T")) return one.key;
    }
    for (const char* const key : {"R_e", "R_m", "sigma_adm", "tau_adm", "sigma_D", "tau_D", "sigma_B"}) {
      if (field(key) != nullptr && !std::isnan(own(key))) return key;
    }
    return material_of(step_).empty() || field("R_e") == nullptr ? "" : "R_e";
  }

  /// A temperature of the part above the limit of strengths at room temperature.
  void compare_temperature(const Stated& stated) {
    constexpr double most = 373.15;  // 100 degC: of steels but fine-grained ones in [FKM], from memory
    constexpr std::array<std::string_view, 10> states{"service", "operating", "operation", "work",  "working",
                                                      "design",  "max",       "wall",      "metal", "part"};
    const std::string_view name = stated.name;
    const bool is_temperature = name.starts_with("t_") || name.starts_with("T_") || name.starts_with("theta_");
    if (!(stated.si > most) || !is_temperature || !is_one_of(index_of(name), states)) return;
    const std::string key = heated_input();
    if (key.empty() || (key == "T" && own(key) >= stated.si)) return;
    add(key,
        say("values.{1} = {2} acts on no step, and strengths at room temperature apply up to {3}: give the strength "
            "at this temperature or T, or because.{4} = \"...\"",
            stated.name, format_quantity(stated.si, "degC", 4), format_quantity(most, "degC", 4), key));
  }

  [[nodiscard]] bool is_vacuum_assessed() const {
    return std::ranges::any_of(project_.steps, [](const auto& step) {
      return step->input().calculator != nullptr &&
             find_field(step->input().calculator->input->fields, "p_e") != nullptr;
    });
  }

  /// A vacuum that is higher than the external pressure, or that no step assesses a wall for.
  void compare_vacuum(const Stated& stated) {
    if (stated.name[0] != 'p' || index_of(stated.name) != "vacuum" || step_.input().accepted.contains("vacuum")) return;
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
