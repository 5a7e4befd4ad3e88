#include "lib/project/references/drives/efficiencies.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/drives/products.hpp"
#include "lib/project/references/origins.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

const Dimension power_here = Dimension::of(2, 1, -3), torque_here = Dimension::of(2, 1, -2),
                force_here = Dimension::of(1, 1, -2), pressure_here = Dimension::of(-1, 1, -2),
                length_here = Dimension::of(1, 0, 0), flow_here = Dimension::of(3, 0, -1),
                velocity_here = Dimension::of(1, 0, -1), mass_here = Dimension::of(0, 1, 0);

std::string_view name_in(const std::string& path) { return std::string_view(path).substr(path.find('.') + 1); }

/// "eta", "eta_gear", "efficiency"; not that of a load which drives, or of a seam.
bool is_efficiency(const std::string& path) {
  const std::string_view name = name_in(path);
  return path.starts_with("values.") && has_word(name, {"eta", "efficiency"}) &&
         !has_word(name, {"back", "backdriving", "reverse", "lowering", "brake", "braking", "seam", "weld", "joint"});
}

/// Machines whose shaft takes power out of a force or a flow.
bool is_driven_by_load(const Project& project) {
  constexpr std::array words{"turbine",  "generator", "brake",    "braking", "lowering",
                             "windmill", "expander",  "downhill", "rotor",   "recuperation"};
  return std::ranges::any_of(words, [&](const char* word) { return is_named(project, word); });
}

/// Machines whose pressure is an output: that of a hydraulic motor is its input.
bool delivers_flow(const Project& project) {
  constexpr std::array words{"pump", "pumps", "fan", "blower", "compressor", "ventilator"};
  return std::ranges::any_of(words, [&](const char* word) { return is_named(project, word); });
}

/// What a product contains besides its efficiency.
class Output {
 public:
  Output(const Operand& operand, const Product& product, const Project& project)
      : operand_(operand), product_(product), project_(project) {}

  /// Whether it is what the machine delivers.
  [[nodiscard]] bool is_useful() const {
    if (has(power_here, 1)) return false;
    const Dimension dimension = operand_.leaf.field->dimension.without_angle();
    return dimension == power_here ? is_work_of_load() : is_on_screw() || is_behind_ratio();
  }

 private:
  [[nodiscard]] bool has(const Dimension& dimension, int exponent) const {
    return std::ranges::any_of(product_.powers, [&](const Product::Power& one) {
      return one.exponent == exponent && one.dimension.without_angle() == dimension;
    });
  }

  [[nodiscard]] bool has_text(const char* text) const { return operand_.text.find(text) != std::string::npos; }

  [[nodiscard]] bool is_work_of_load() const {
    const bool is_of_pressure = has(pressure_here, 1) || (has_text("Pa") && product_.of_numbers == power_here) ||
                                (has_text("Pa") && has(flow_here, 1));
    if (is_of_pressure) return delivers_flow(project_);
    return (has(force_here, 1) || has(mass_here, 1)) && has(velocity_here, 1);
  }

  /// A thrust times the lead of a screw: the torque without friction.
  [[nodiscard]] bool is_on_screw() const {
    return has(force_here, 1) && std::ranges::any_of(product_.powers, [](const Product::Power& one) {
             const std::string_view name = name_in(one.path);
             return one.exponent == 1 && one.dimension == length_here &&
                    (has_word(name, {"pitch", "lead", "ph"}) || name == "p" || name == "p_h" || name == "P_h");
           });
  }

  /// A torque of the driven side, divided by the ratio of a drive.
  [[nodiscard]] bool is_behind_ratio() const {
    const bool is_divided = std::ranges::any_of(product_.powers, [&](const Product::Power& one) {
      const std::string_view name = name_in(one.path);
      return one.exponent == -1 && one.dimension.is_number() && (name[0] == 'i' || has_word(name, {"ratio"})) &&
             value_of_file(project_, one.path)->si.front() > 1.0;
    });
    return is_divided && std::ranges::any_of(product_.powers, [](const Product::Power& one) {
             const std::string_view name = name_in(one.path);
             return one.exponent == 1 && one.dimension.without_angle() == torque_here &&
                    has_word(name, {"2", "out", "output", "drum", "winch", "load", "mixer", "conveyor", "crusher"});
           });
  }

  const Operand& operand_;
  const Product& product_;
  const Project& project_;
};

}  // namespace

std::vector<ReducedLoad> efficiencies_of_outputs(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  for (const Operand& operand : step.input().reading.operands) {
    const Dimension dimension = operand.leaf.field->dimension.without_angle();
    const auto& references = operand.expression.references();
    const auto efficiency = std::ranges::find_if(references, [](const auto& one) { return is_efficiency(one.path); });
    if ((dimension != power_here && dimension != torque_here) || efficiency == references.end()) continue;
    const std::optional<Product> product = product_with_sizes(operand, project);
    if (!product) continue;
    const bool multiplies = std::ranges::any_of(product->powers, [&](const Product::Power& one) {
      return one.path == efficiency->path && one.exponent == 1 && one.dimension.is_number() &&
             value_of_file(project, one.path)->si.front() < 1.0;
    });
    if (!multiplies || !Output(operand, *product, project).is_useful() || is_driven_by_load(project)) continue;
    found.push_back({operand.path, say("{1} is the useful output times '{2}', and a drive needs more than its output: "
                                       "divide by the efficiency, or justify it: {3} = \"...\"",
                                       operand.path, efficiency->path, because_key(operand.path))});
  }
  return found;
}

}  // namespace loadpath::project
