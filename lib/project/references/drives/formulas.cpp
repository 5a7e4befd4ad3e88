#include "lib/project/references/drives/formulas.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/drives/products.hpp"
#include "lib/project/references/drives/shares.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

using std::numbers::pi;

const Dimension a_length = Dimension::of(1, 0, 0), a_stress = Dimension::of(-1, 1, -2);
const Dimension a_force = Dimension::of(1, 1, -2), a_torque = Dimension::of(2, 1, -2),
                a_power = Dimension::of(2, 1, -3);

/// "d", "D_i" for "dD": a symbol alone or with an index.
bool begins_with_symbol(const std::string& path, std::string_view letters) {
  const std::string_view name = std::string_view(path).substr(path.rfind('.') + 1);
  return letters.find(name[0]) != std::string_view::npos && (name.size() == 1 || name[1] == '_');
}

/// "r", "e_beam", "L_arm": the distance of a force from an axis.
bool is_arm(const std::string& path) {
  return begins_with_symbol(path, "rRe") || has_word(path, {"arm", "lever", "reach", "overhang", "crank"});
}

/// "d_i", "D_bore": the inside of a hollow part.
bool is_of_bore(const std::string& name) {
  return begins_with_symbol(name, "dDrR") && has_word(name, {"i", "bore", "inner", "hollow", "inside"});
}

/// "d_core", "d_neck": the smallest diameter of a part.
bool is_of_neck(const std::string& name) {
  return begins_with_symbol(name, "dD") && has_word(name, {"core", "root", "neck", "groove", "thread", "undercut",
                                                           "relief", "min", "worn", "rust", "corroded"});
}

/// The formula of a load: its number, and the powers of the diameters and the radii in it.
struct Formula {
  Product product;
  int diameters = 0, radii = 0;
  int application_factors = 0;
  std::string values;  // "values.P^1 values.n^-1"
};

/// The formula of a load of values, without lengths of another meaning: a moment of F*l/4 is that of a beam.
std::optional<Formula> formula_of(const Operand& operand, const Project& project) {
  auto product = product_of(operand, project);
  if (!product || product->powers.empty()) return std::nullopt;
  Formula formula;
  for (const Product::Power& one : product->powers) {
    if (is_application_factor(one.path)) {
      formula.application_factors += one.exponent;
      continue;
    }
    formula.values += one.path + "^" + std::to_string(one.exponent) + " ";
    if (one.dimension != a_length) continue;
    const bool is_diameter = begins_with_symbol(one.path, "dD");
    if (!is_diameter && !is_arm(one.path)) return std::nullopt;
    (is_diameter ? formula.diameters : formula.radii) += one.exponent;
  }
  for (const std::string& path : product->rest) formula.values += path + " ";
  formula.product = std::move(*product);
  return formula;
}

/// The number in the usual formula of a force, a torque, a power or a stress; NaN if that is not known.
double usual_number(const Formula& formula, const FieldInfo& field) {
  const int D = formula.diameters, R = formula.radii;
  const auto has = [&](int diameters, int radii) { return D == diameters && R == radii; };
  const Dimension dimension = field.dimension.without_angle();
  if (has(0, 0) && (dimension == a_force || dimension == a_torque || dimension == a_power || dimension == a_stress))
    return 1.0;
  if (dimension == a_force) {
    if (has(2, 0)) return pi / 4.0;  // pressure on a circle
    if (has(0, 2)) return pi;
    if (has(-1, 0)) return 2.0;
    if (has(0, -1)) return 1.0;
  }
  if (dimension == a_torque || dimension == a_power) {
    if (has(1, 0)) return 0.5;
    if (has(0, 1)) return 1.0;
  }
  if (dimension == a_torque && has(2, 1)) return pi / 4.0;  // of a pressure on a piston at a crank
  if (dimension == a_stress) {
    const bool is_shear = std::string_view(field.key).starts_with("tau");
    if (has(-2, 0)) return 4.0 / pi;
    if (has(0, -2)) return 1.0 / pi;
    if (has(-3, 0) || has(-3, 1)) return (is_shear ? 16.0 : 32.0) / pi;
  }
  return std::nan("");
}

/// A value of [values] that the load is, or a multiple of: own_names.cpp compares it.
bool is_multiple_of_one(const Formula& formula, const FieldInfo& field) {
  const auto& powers = formula.product.powers;
  return powers.size() == 1 && formula.product.rest.empty() &&
         powers.front().dimension == field.dimension.without_angle();
}

/// The same, with an application factor: stated_loads.cpp compares it.
bool is_of_one_load(const Formula& formula, const FieldInfo& field) {
  const auto is_load = [&](const Product::Power& one) { return one.dimension == field.dimension.without_angle(); };
  const auto& powers = formula.product.powers;
  return std::ranges::all_of(powers, [&](const auto& one) { return is_load(one) || is_application_factor(one.path); });
}

class Formulas {
 public:
  Formulas(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    compare_hollow();
    compare_wall();
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.expression.is_reference() || !loads_a_part(*operand.leaf.field, operand.path)) continue;
      compare_bore(operand);
      const auto formula = formula_of(operand, project_);
      if (formula)
        compare(operand, *formula), compare_pressure(operand, *formula), compare_divisor(operand, *formula),
            compare_pull(operand, *formula);
    }
    return std::move(found_);
  }

 private:
  void compare(const Operand& operand, const Formula& formula) {
    const FieldInfo& field = *operand.leaf.field;
    const double share = std::abs(formula.product.number) / usual_number(formula, field);
    if (formula.application_factors < 0 && compare_cancelled(operand, formula)) return;
    const bool is_compared = share > 0.0 && share < least_share && !is_multiple_of_one(formula, field);
    if (!is_compared || (states_share(operand) && !has_other_count(share) && !cancels_factor(share)) ||
        is_half_of_two(step_, operand, share) || is_count_of_parts(step_, project_, operand, share))
      return;
    if (cancels_factor(share) && compare_cancelled(operand, formula)) return;
    const double whole = std::abs(own_value(step_, project_, operand.path)) / share;
    const auto values_of = [&](const Operand& other) {
      const auto of_other = formula_of(other, project_);
      return of_other ? of_other->values : std::string();
    };
    if (!(whole > 0.0)) return;
    if (taken_in_parts(project_, formula.values, whole, field.dimension, values_of) >= least_share * whole) return;
    if (is_lower_end(operand)) return;
    add(operand.path, say("{1} is {2} times the result of its formula, and no input takes the rest: refer to a value "
                          "that states the share or the number of parts, or justify it: {3} = \"...\"",
                          operand.path, format_number(share, 4), because_key(operand.path)));
  }

  /// Whether the load is a value of [values] with a word of its own, "T_each", which states a share, or a multiple or
  /// half of it.
  [[nodiscard]] bool states_share(const Operand& operand) const {
    const auto typed = step_.input().reading.typed.find(operand.path);
    if (typed == step_.input().reading.typed.end()) return false;
    if (typed->second.shared.find('_') != std::string::npos) return true;
    const double named = number_of_named_value(operand, project_);
    return named >= least_share || is_half_of_two(step_, operand, named);
  }

  /// "T_drum = F*d/2/1.4" next to K_A = 1.4; a whole number is that of parts.
  [[nodiscard]] bool cancels_factor(double share) const {
    const double K_A = own_value(step_, project_, "K_A");
    return is_near(share * K_A, 1.0, 1e-3) && !is_near(K_A, std::round(K_A), 1e-3);
  }

  /// "n_chains = 2" next to a value that is a quarter: its count is another one.
  [[nodiscard]] bool has_other_count(double share) const {
    return std::ranges::any_of(project_.values.unused(), [&](const auto& entry) {
      const auto& [name, value] = entry;
      const double si = value.si.front();
      return name.starts_with("n_") && value.signature.dimension.is_number() && si >= 1.0 && si == std::round(si) &&
             share * si < least_share;
    });
  }

  /// The lower end of a cycle is any part of its peak.
  [[nodiscard]] bool is_lower_end(const Operand& operand) const {
    return means(*step_.input().calculator, operand.path, [](std::string_view what) { return what == "min"; });
  }

  /// A load divided by the application factor that the step applies to it.
  bool compare_cancelled(const Operand& operand, const Formula& formula) {
    const double K_A = own_value(step_, project_, "K_A");
    if (!(K_A > 1.0) || is_of_one_load(formula, *operand.leaf.field)) return false;
    add(operand.path,
        say("{1} is divided by the application factor, which cancels it: do not divide by K_A, or justify "
            "it: {2} = \"...\"",
            operand.path, because_key(operand.path)));
    return true;
  }

  /// A load divided by a count of [values], next to a smaller count of the parts that carry: "n_lugs_loaded".
  void compare_divisor(const Operand& operand, const Formula& formula) {
    for (const Product::Power& one : formula.product.powers) {
      if (one.exponent != -1 || !one.dimension.is_number() || is_application_factor(one.path)) continue;
      const double count = value_of_file(project_, one.path)->si.front();
      const std::string counted = one.path.substr(one.path.find('.') + 1) + "_";
      for (const auto& [name, value] : project_.values.unused()) {
        const bool is_meant =
            name.starts_with(counted) || has_word(name, {"carrying", "loaded", "active", "supporting", "effective"});
        const double si = value.si.front();
        if (!value.signature.dimension.is_number() || !is_meant || !(si >= 1.0 && si < count)) continue;
        return add(operand.path,
                   say("values.{1} = {2} acts on no step, and {3} is divided by '{4}', which is more: refer "
                       "to it, delete it, or justify it: {5} = \"...\"",
                       name, format_number(si, 4), operand.path, one.path, because_key(operand.path)));
      }
    }
  }

  /// "F_pull_max" next to a torque of a smaller force at a diameter or a radius.
  void compare_pull(const Operand& operand, const Formula& formula) {
    constexpr double implausible_ratio = 50.0;  // beyond, it is the force of another machine
    const bool is_at_one = formula.diameters + formula.radii == 1;
    if (operand.leaf.field->dimension.without_angle() != a_torque || !is_at_one) return;
    const auto arm = std::ranges::find_if(formula.product.powers, [](const Product::Power& one) {
      return one.dimension == a_length && one.exponent == 1;
    });
    if (arm == formula.product.powers.end()) return;
    const double size = value_of_file(project_, arm->path)->si.front();
    const double pull =
        std::abs(own_value(step_, project_, operand.path)) / (formula.diameters == 1 ? 0.5 * size : size);
    for (const auto& [name, value] : project_.values.unused()) {
      const double si = std::abs(value.si.front());
      const bool is_meant = is_of_peak(name) && !is_of_other_state(name) && value.signature.dimension == a_force;
      if (!is_meant || !(si > (1.0 + few_digits) * pull) || si > implausible_ratio * pull) continue;
      return add(operand.path,
                 say("values.{1} = {2} acts on no step, and {3} corresponds to a force of {4}: refer to it, delete "
                     "it, or justify it: {5} = \"...\"",
                     name, format_quantity(si, "kN", 4), operand.path, format_quantity(pull, "kN", 4),
                     because_key(operand.path)));
    }
  }

  /// A force by the pressure in a cylinder of the file, on less than the area of its bore. A bar in compression takes
  /// no area of a rod off.
  void compare_pressure(const Operand& operand, const Formula& formula) {
    const FieldInfo& field = *operand.leaf.field;
    const bool is_on_circle = (formula.diameters == 2 && formula.radii == 0) ||  //
                              (formula.diameters == 0 && formula.radii == 2);
    const bool is_ring = !formula.product.rest.empty() && !is_compression_of_bar(field);
    if (field.dimension != a_force || !is_on_circle || is_ring) return;
    for (const auto& wall : project_.steps) {
      const double whole = force_on_bore(*wall, formula);
      const double share = std::abs(own_value(step_, project_, operand.path)) * parts_in(formula) / whole;
      if (!(share < least_share) || is_half_of_two(step_, operand, share) ||
          is_count_of_parts(step_, project_, operand, share))
        continue;
      return add(operand.path,
                 say("{1} is {2} times the force of this pressure on the bore of '{3}': take the diameter "
                     "of the bore, or justify it: {4} = \"...\"",
                     operand.path, format_number(share, 4), wall->name(), because_key(operand.path)));
    }
  }

  /// A typed pressure of a wall below that of [values] whose force on its bore another step takes.
  void compare_wall() {
    const auto typed = step_.input().reading.typed.find("p");
    if (!id_of(step_).starts_with("vessel.") || typed == step_.input().reading.typed.end()) return;
    if (!typed->second.shared.empty()) return;
    for (const auto& other : project_.steps) {
      for (const Operand& operand : other->input().reading.operands) {
        if (operand.leaf.field->dimension != a_force) continue;
        const auto formula = formula_of(operand, project_);
        const bool is_on_circle = formula && formula->diameters == 2 && !std::isnan(pressure_in(*formula));
        if (!is_on_circle || !has_size(*formula, 2.0 * bore_radius(step_)) ||
            !(own_value(step_, project_, "p") < least_share * pressure_in(*formula)))
          continue;
        return add("p",
                   say("p is below the pressure that '{1}' takes on this bore, {2}: correct one of them, or justify "
                       "it: because.p = \"...\"",
                       other->name(), format_quantity(pressure_in(*formula), "MPa", 4)));
      }
    }
  }

  /// The number of parts that the load is divided by: the bolts of a cover; 1 if there is none.
  [[nodiscard]] double parts_in(const Formula& formula) const {
    double parts = 1.0;
    for (const Product::Power& one : formula.product.powers) {
      if (one.exponent < 0 && one.dimension.is_number() && !is_application_factor(one.path))
        parts *= std::pow(value_of_file(project_, one.path)->si.front(), -one.exponent);
    }
    return parts;
  }

  [[nodiscard]] bool has_size(const Formula& formula, double size) const {
    return std::ranges::any_of(formula.product.powers, [&](const Product::Power& one) {
      return one.dimension == a_length && is_near(value_of_file(project_, one.path)->si.front(), size, few_digits);
    });
  }

  /// The pressure of [values] in a formula; NaN if it has none.
  [[nodiscard]] double pressure_in(const Formula& formula) const {
    for (const Product::Power& one : formula.product.powers) {
      if (one.dimension == a_stress && one.exponent == 1) return value_of_file(project_, one.path)->si.front();
    }
    return std::nan("");
  }

  /// The force of the pressure of a wall on its bore, where the formula takes the same value as its pressure; else NaN.
  [[nodiscard]] double force_on_bore(const Step& wall, const Formula& formula) const {
    const auto pressure = wall.input().reading.typed.find("p");
    if (!id_of(wall).starts_with("vessel.") || pressure == wall.input().reading.typed.end()) return std::nan("");
    const bool is_same = std::ranges::any_of(formula.product.powers, [&](const Product::Power& one) {
      return one.exponent == 1 && one.path == pressure->second.shared;
    });
    if (!is_same) return std::nan("");
    const double radius = bore_radius(wall);
    return own_value(wall, project_, "p") * pi * radius * radius;
  }

  /// The inside radius of a wall; NaN if it is not known before the wall is solved.
  [[nodiscard]] double bore_radius(const Step& wall) const {
    const double R = own_value(wall, project_, "R"), delta = own_value(wall, project_, "delta");
    if (std::isnan(R)) return own_value(wall, project_, "d_i") / 2.0;
    const auto measured = wall.input().reading.typed.find("measured");
    const std::string surface = measured == wall.input().reading.typed.end() ? "mean" : measured->second.text;
    if (surface.find("inner") != std::string::npos) return R;
    return surface.find("outer") != std::string::npos ? R - delta : R - delta / 2.0;
  }

  /// A bore of [values] that no step takes, next to a stress of the solid section.
  void compare_bore(const Operand& operand) {
    if (operand.leaf.field->dimension != a_stress || project_.values.unused().empty()) return;
    const auto product = product_of(operand, project_);
    if (!product) return;
    for (const Product::Power& one : product->powers) {
      const bool is_of_area = one.exponent == -1 && one.dimension == a_length * a_length;
      const bool is_of_diameter = one.exponent <= -2 && one.dimension == a_length && begins_with_symbol(one.path, "dD");
      if (!is_of_area && !is_of_diameter) continue;
      const std::string bore = section_within(std::abs(value_of_file(project_, one.path)->si.front()), one.dimension);
      if (bore.empty()) continue;
      return add(operand.path, say("values.{1} acts on no step, and {2} is a stress of a larger section: refer to it, "
                                   "delete it, or justify it: {3} = \"...\"",
                                   bore, operand.path, because_key(operand.path)));
    }
  }

  /// The same next to a part that is given by its outer diameter. The bore of a hub is the diameter of its shaft.
  void compare_hollow() {
    const auto is_bore = [](const auto& entry) { return is_of_bore(entry.first); };
    if (connects(step_) || std::ranges::none_of(project_.values.unused(), is_bore)) return;
    const double d = own_value(step_, project_, "d");
    if (std::isnan(d)) return;
    for (const char* const key : {"d_bore", "d_i"}) {
      const bool is_input = find_field(step_.input().calculator->input->fields, key) != nullptr;
      if (!is_input || own_value(step_, project_, key) > 0.0) continue;
      if (const std::string bore = smaller_value(d, a_length, &is_of_bore); !bore.empty())
        add("d", say("values.{1} acts on no step, and {2} is not given here: refer to it, delete it, or justify it: "
                     "because.d = \"...\"",
                     bore, key));
    }
  }

  /// The bore, the smallest diameter or the area of [values] that leaves less than this section; empty if none does.
  [[nodiscard]] std::string section_within(double size, const Dimension& dimension) const {
    return smaller_value(size, dimension, [&](const std::string& name) {
      return dimension == a_length ? is_of_bore(name) || is_of_neck(name) : name.starts_with("A_");
    });
  }

  /// A value of [values] under such a name that is smaller than a size; empty if there is none.
  template <class Named>
  [[nodiscard]] std::string smaller_value(double size, const Dimension& dimension, const Named& is_meant) const {
    for (const auto& [name, value] : project_.values.unused()) {
      const double si = value.si.front();
      if (value.signature.dimension == dimension && is_meant(name) && si > 0.0 && si < size) return name;
    }
    return {};
  }

  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> parts_of_formulas(const Step& step, const Project& project) {
  return Formulas(step, project).run();
}

}  // namespace loadpath::project
