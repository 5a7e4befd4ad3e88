#include "lib/project/references/stated/own_inputs.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/largest.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

using stated::heat;
using stated::in_few_digits;
using stated::length;
using stated::rate;

using stated::density;
using stated::mass;
using stated::speed;

bool is_within(double share, double a, double b) {
  return std::abs(a - b) <= share * std::max(std::abs(a), std::abs(b));
}

bool is_equal(double a, double b) { return is_within(in_few_digits, a, b); }

/// Whether a constant of a material is the same with that of another table, or one of another substance: steel of 7850
/// and 7840 kg/m^3, sand next to it.
bool is_same_or_foreign(const std::string& name, const Dimension& dimension, double here, double stated) {
  constexpr double of_tables = 0.05, of_densities = 0.01, of_one_substance = 2.0;
  if (name == "E" || name == "G" || name == "nu") return is_within(of_tables, here, stated);
  if (dimension == Dimension::of(-1, 1, 0)) return is_within(of_tables, here, stated);  // chains of other makers
  if (!(dimension == density)) return false;
  return is_within(of_densities, here, stated) || stated > of_one_substance * here || here > of_one_substance * stated;
}

const FieldInfo* input_of(const Step& step, std::string_view key) {
  return find_field(step.input().calculator->input->fields, key);
}

/// The value of an input: typed, of a row, of a record or found.
double known(const Step& step, const Project& project, const std::string& key) {
  const double here = own_value(step, project, key);
  return std::isnan(here) ? magnitude_at(project, step.name() + "." + key) : here;
}

/// The word of a choice; empty where it has none.
std::string word_at(const Step& step, const std::string& key) {
  const Leaf leaf = find_leaf(step.input().reading.record, key);
  if (!leaf || leaf.field->type != FieldInfo::Type::choice || std::isnan(leaf.get())) return {};
  const auto k = static_cast<std::size_t>(leaf.get());
  return k < leaf.field->choices.size() ? leaf.field->choices[k].key : std::string();
}

/// Sizes and masses: their names are those of many parts.
bool is_of_body(const Dimension& dimension) {
  return dimension == length || dimension == mass || dimension == Dimension::of(2, 0, 0);
}

/// The efficiency of a seam: a factor that is worse if it is smaller.
bool is_of_seam(std::string_view name) { return name == "z_l" || name == "z_c"; }

/// The yield strength in the designation of a structural or pressure vessel steel by EN 10027-1, "S185"; NaN of others.
double yield_by_designation(const std::string& word) {
  constexpr double MPa = 1e6;
  if (word.empty() || (word[0] != 'S' && word[0] != 'P' && word[0] != 'E')) return std::nan("");
  const std::string digits = word.substr(1, word.find_first_not_of("0123456789", 1) - 1);
  const bool is_strength = digits.size() == 3 || digits.size() == 4;  // "S1100QL"
  return is_strength ? MPa * std::stod(digits) : std::nan("");
}

/// "non-reversing", "not alternating", "no pulsating load".
bool is_negated(const std::string& text, const std::string& word) {
  const std::string before = text.substr(0, text.find(word));
  return std::ranges::any_of(std::array{"non", "non-", "non ", "not ", "no "},
                             [&](const char* negation) { return before.ends_with(negation); });
}

class OwnInputs {
 public:
  OwnInputs(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused())
      compare(name, value.si.front(), value.signature.dimension);
    for (const auto& [name, word] : project_.values.unused_words()) compare_word(name, word);
    return std::move(found_);
  }

 private:
  /// Inputs that this file does not compare: loads and factors have rules of their own, as have shaft speeds and
  /// temperatures; one letter without a unit is the name of too much.
  [[nodiscard]] static bool is_compared(const FieldInfo& field, const std::string& name, const Dimension& dimension) {
    const bool is_short = name.size() == 1 && dimension.is_number() && name != "N";
    const bool is_absolute_heat = dimension == heat && !name.starts_with("dT");
    const bool is_number = field.is_number() || field.type == FieldInfo::Type::count;
    return is_number && field.dimension == dimension && !field.is_load && (!field.is_factor || is_of_seam(name)) &&
           !is_short && !is_absolute_heat && dimension.without_angle() != rate;
  }

  void compare(const std::string& name, double stated, const Dimension& dimension) {
    const FieldInfo* const field = input_of(step_, name);
    if (field == nullptr) return compare_symbol(name, stated, dimension);
    if (!is_compared(*field, name, dimension) || is_taken_elsewhere(name, stated)) return;
    const double here = known(step_, project_, name);
    if (name == "L_h" && std::isnan(here) && !std::isnan(known(step_, project_, "N"))) return;  // a life in cycles
    if (std::isnan(here)) {
      if (is_missed(name, dimension, stated)) add(*field, stated, say("is not given here"));
      return;
    }
    const bool is_of_part = is_of_body(dimension) || name.starts_with("z_1") || name.starts_with("z_2");
    const bool is_one_of_many = is_of_part && name != "c_t" && !is_same_in_all(name, here);
    const bool is_spur = name == "beta" && here == 0.0 && is_harmless(name, stated);
    if (is_spur || is_equal(here, stated) || is_safe(name, here, stated) || is_one_of_many) return;
    if (is_same_or_foreign(name, dimension, here, stated)) return;
    add(*field, stated, say("is {1} here", shown(*field, here)));
  }

  /// A size under the symbol of another standard, or of one of two parts: the module m, the widths b_1 and b_2 of
  /// gears, the plates t of a pin. The narrower of two gears carries.
  void compare_symbol(const std::string& name, double stated, const Dimension& dimension) {
    const std::string_view id = step_.input().calculator->id;
    const bool is_gear = id == "gear.pair" || id == "gear.rating" || id == "gear.bevel" || id == "gear.worm";
    if (!(dimension == length) || !(is_gear || id == "pin.en1993")) return;
    const bool is_width = is_gear && (name == "b_1" || name == "b_2");
    for (const char* const key : {"m_n", "m_x", "m_et"}) {
      const FieldInfo* const field =
          is_gear && name.starts_with(std::string(key) + "_") ? input_of(step_, key) : nullptr;
      const double here = field == nullptr ? std::nan("") : known(step_, project_, key);
      if (!std::isnan(here) && !is_equal(here, stated) && !is_taken_elsewhere(key, stated))
        add_size(name, stated, *field, here);
    }
    for (const auto& [symbol, key] :
         {std::pair{"m", "m_n"}, {"m", "m_x"}, {"m", "m_et"}, {"b_1", "b"}, {"b_2", "b"}, {"t", "t_1"}}) {
      const FieldInfo* const field = name == symbol ? input_of(step_, key) : nullptr;
      const double here = field == nullptr ? std::nan("") : known(step_, project_, key);
      if (std::isnan(here) || is_equal(here, stated) || (is_width && stated > here)) continue;
      if (!is_taken_elsewhere(key, stated)) add_size(name, stated, *field, here);
    }
  }

  void add_size(const std::string& name, double stated, const FieldInfo& field, double here) {
    found_.push_back(not_taken(name, shown(field, stated), field.key, shown(field, here)));
  }

  /// Whether a value that the step does not have changes its assessment: a requirement, an eccentricity, the level of a
  /// liquid. Constants of materials and sizes may be notes.
  [[nodiscard]] bool is_missed(const std::string& name, const Dimension& dimension, double stated) const {
    if (stated == 0.0 || is_of_endurance(name) || is_harmless(name, stated)) return false;
    if (name.ends_with("_adm") || name == "h_l" || name.starts_with("e_")) return true;
    const bool is_strength_of_part = dimension == Dimension::of(-1, 1, -2);
    const bool is_constant = is_strength_of_part || dimension == density || name == "nu" || name == "alpha";
    return !is_of_body(dimension) && !is_constant && dimension != speed;
  }

  /// Without a required life the part is rated for endurance.
  [[nodiscard]] bool is_of_endurance(std::string_view name) const { return name == step_.input().calculator->life; }

  /// A value that the step does without on the safe side: an oil whose lubricant factor is not below 1, the slope of a
  /// conveyor or the helix angle of gears whose forces no step takes.
  [[nodiscard]] bool is_harmless(std::string_view name, double stated) const {
    constexpr double neutral_oil = 167.5e-6;  // m^2/s, (1.2 + 134/nu_40)^2 = 4 in Z_L of ISO 6336-2
    const std::string_view id = step_.input().calculator->id;
    if (name == "nu_40") return stated >= neutral_oil;
    return name == "beta" && id.starts_with("gear.") && !is_force_taken();
  }

  /// Whether another step takes a load of these gears: their axial force depends on the helix angle.
  [[nodiscard]] bool is_force_taken() const { return project_.is_referred_into(step_.name() + ".gear_"); }

  /// Another step has this value under this name: it is meant for that one.
  [[nodiscard]] bool is_taken_elsewhere(const std::string& name, double stated) const {
    return std::ranges::any_of(project_.steps, [&](const auto& other) {
      if (other.get() == &step_ || input_of(*other, name) == nullptr) return false;
      return is_equal(known(*other, project_, name), stated);
    });
  }

  /// Whether all steps that have a value of this name have the same one, as the rating of a gear pair and the pair.
  [[nodiscard]] bool is_same_in_all(const std::string& name, double here) const {
    return std::ranges::all_of(project_.steps, [&](const auto& other) {
      const double there = input_of(*other, name) == nullptr ? std::nan("") : known(*other, project_, name);
      return std::isnan(there) || is_equal(there, here);
    });
  }

  /// Whether the step requires more, or allows less, than the value.
  [[nodiscard]] bool is_safe(const std::string& name, double here, double stated) const {
    const bool is_required = name.starts_with("S_") || name == "L_h" || name == "L_req" || name == "N" ||
                             name == "n_req" || name == "R" || name == "P_s" || name == "c" || name == "c_t" ||
                             name == "f_t" || name == "grade";
    if (is_required) return here > stated;
    // a key, a spline or a fit that is shorter than the hub or the shaft of this length carries less
    const std::string_view id = step_.input().calculator->id;
    const bool is_carrying = id == "shaft.key" || id == "shaft.spline" || id == "shaft.press_fit";
    if (name == "l" && is_carrying) return here < stated;
    const bool is_allowed = name.ends_with("_adm") || is_of_seam(name) || name == "R_e" || name == "R_m" ||
                            name == "D_adm" || means(*step_.input().calculator, name, &is_strength);
    return is_allowed && here < stated;
  }

  void compare_word(const std::string& name, const std::string& word) {
    const bool is_wall = id_of(step_).starts_with("vessel.") && has_word(name, {"plate", "plates", "shell", "sheet"});
    if (has_word(name, {"material", "steel", "grade"}) || is_wall || (connects(step_) && name == "hub"))
      compare_material(name, word);
    if (word == "yes" || word == "true") compare_sense(name, name, word);
    for (const char* const sense : {"reversing", "alternating", "pulsating", "dynamic"}) {
      if (word.find(sense) == std::string::npos || is_negated(word, sense)) continue;
      compare_sense(name, sense, word);
      if (std::string_view(sense) != "dynamic") compare_sense(name, "dynamic", word);
    }
    compare_pivots(name, word);
    compare_row(name, word);
    const FieldInfo* const own = input_of(step_, name);
    const FieldInfo* const field = own == nullptr ? input_of(step_, name + "_1") : own;  // of two parts
    if (field == nullptr || field->type != FieldInfo::Type::choice) return;
    const bool is_choice = std::ranges::any_of(field->choices, [&](const auto& one) { return word == one.key; });
    const std::string here = word_at(step_, field->key);
    const bool is_elsewhere = std::ranges::any_of(project_.steps, [&](const auto& other) {
      return word_at(*other, field->key) == word || word_at(*other, name + "_2") == word;
    });
    const bool is_finer = name == "finish" && (word == "ground" || word == "polished");
    if (!is_choice || here == word || is_elsewhere || is_of_row(name) || is_finer) return;
    add_word(name, word, *field);
  }

  /// Whether a row has the word: the kind of a rolling bearing.
  [[nodiscard]] bool is_of_row(const std::string& name) const {
    const auto& rows = step_.input().rows;
    return name == "kind" && rows.contains("bearing") && !step_.input().reading.typed.contains(name);
  }

  /// Whether a material is that of this step, whose strength is typed, by its word: "steel_pin" of a step "pin".
  [[nodiscard]] bool is_of_this_step(const std::string& name) const {
    const std::string last = name.substr(name.rfind('_') + 1);
    return material_of(step_).empty() && last.size() < name.size() && is_named(step_, last);
  }

  /// The name of a material that no other step has, and whose strength is below that of the step.
  void compare_material(const std::string& name, const std::string& word) {
    const std::string here = material_of(step_);
    const bool is_elsewhere = !is_of_this_step(name) && std::ranges::any_of(project_.steps, [&](const auto& other) {
      return material_of(*other) == word;
    });
    const auto row = project_.tables->find_row("material", word);
    const double by_name = row ? std::nan("") : yield_by_designation(word);
    if (is_elsewhere || (!row && std::isnan(by_name) && (here.empty() || name != "material"))) return;
    const double R_e = row ? table::largest_value(*row, "R_e") : std::fmax(0.0, by_name),
                 R_m = row ? table::largest_value(*row, "R_m") : 0.0;
    for (const char* const key : {"R_e", "R_e_2", "R_e_1", "R_eN", "f_y_1", "R_m"}) {
      if (!row && !std::isnan(by_name) && std::string_view(key) == "R_m") continue;  // a designation states none
      const double own = input_of(step_, key) == nullptr ? std::nan("") : known(step_, project_, key);
      const double there = std::isnan(R_e) || std::string_view(key) == "R_m" ? R_m : R_e;
      const bool is_other = name == "material" && !here.empty() && own > 0.0;
      if (!(own > (1.0 + in_few_digits) * there) && !is_other) continue;
      return found_.push_back(not_taken(name, word, key, format_quantity(own, "MPa", 4)));
    }
  }

  /// "reversing = yes" or "duty = reversing" next to torque = "one_way".
  void compare_sense(const std::string& name, const std::string& choice, const std::string& word) {
    for (const FieldInfo& field : step_.input().calculator->input->fields) {
      if (field.type != FieldInfo::Type::choice || !step_.input().reading.typed.contains(field.key)) continue;
      const bool is_choice = std::ranges::any_of(field.choices, [&](const auto& one) { return choice == one.key; });
      const auto has_it = [&](const auto& other) { return word_at(*other, field.key) == choice; };
      const bool is_safe = (choice == "pulsating" || choice == "dynamic") && !is_steady(word_at(step_, field.key));
      if (is_choice && !is_safe && std::ranges::none_of(project_.steps, has_it)) add_word(name, word, field);
    }
  }

  /// "clevis at both ends" next to a bar with fixed ends.
  void compare_pivots(const std::string& name, const std::string& word) {
    const FieldInfo* const ends = input_of(step_, "ends");
    const std::string here = ends == nullptr ? std::string() : word_at(step_, "ends");
    const auto says = [&](std::string_view part) { return word.find(part) != std::string::npos; };
    const bool is_pivot = says("clevis") || says("clevises") || says("pinned") || says("hinge");
    const bool is_fixed = here == "fixed_fixed" || (says("both") && here.find("fixed") != std::string::npos);
    const bool is_free = word == "free" && !here.empty() && here.find("free") == std::string::npos &&
                         has_word(name, {"top", "head", "foot", "end", "upper", "lower"});
    if ((is_pivot && is_fixed && !says("fixed")) || is_free) add_word(name, word, *ends);
  }

  /// "section = CHS 101.6x4" next to another row of that table.
  void compare_row(const std::string& name, const std::string& word) {
    const auto row = step_.input().rows.find(name);
    if (row == step_.input().rows.end() || name == "material" || row->second.text == word) return;
    const auto has_it = [&](const auto& other) {
      const auto there = other->input().rows.find(name);
      return there != other->input().rows.end() && there->second.text == word;
    };
    if (row->second.text.starts_with('=') || row->second.text == "?" || std::ranges::any_of(project_.steps, has_it))
      return;
    for (const FieldInfo& field : step_.input().calculator->input->fields) {
      if (!field.is_load || !step_.input().reading.typed.contains(field.key)) continue;
      return found_.push_back(
          {field.key, say("values.{1} = {2} acts on no step, and {1} is {3} here: correct one of them, "
                          "delete it, or justify it: because.{4} = \"...\"",
                          name, word, row->second.text, field.key)});
    }
  }

  [[nodiscard]] static bool is_steady(std::string_view word) { return word == "steady" || word == "static"; }

  void add_word(const std::string& name, const std::string& word, const FieldInfo& field) {
    const std::string here = word_at(step_, field.key);
    found_.push_back(not_taken(name, word, field.key, here.empty() ? "not given" : here));
  }

  [[nodiscard]] static std::string shown(const FieldInfo& field, double si) {
    return field.dimension.is_number() ? format_number(si, 5) : format_quantity(si, field.unit, 5);
  }

  void add(const FieldInfo& field, double stated, const Message& here) { add(field.key, shown(field, stated), here); }

  void add(const std::string& name, const std::string& stated, const Message& here) {
    found_.push_back({name, say("values.{1} = {2} acts on no step, and {1} {3}: refer to it, delete it, or justify it: "
                                "because.{1} = \"...\"",
                                name, stated, here)});
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> inputs_stated_otherwise(const Step& step, const Project& project) {
  return OwnInputs(step, project).run();
}

}  // namespace loadpath::project
