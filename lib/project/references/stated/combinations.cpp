#include "lib/project/references/stated/combinations.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/factors/given.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

namespace {

const Dimension moment = Dimension::of(2, 1, -2);

class Combinations {
 public:
  Combinations(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.leaf.field->is_load && operand.leaf.field->dimension == stated::force) compare_moments(operand);
    }
    for (const auto& [name, value] : project_.values.unused()) {
      const double si = std::abs(value.si.front());
      if (value.signature.dimension == stated::force && si > 0.0) compare_action(name);
      if (value.signature.dimension.is_number()) compare_factor(name, si), compare_notch(name, si);
      if (value.signature.dimension == stated::pressure) compare_range(name, si);
      if (value.signature.dimension == stated::mass && si > 0.0) compare_attachment(name), compare_rim(name);
      if (value.signature.dimension == stated::length && si > 0.0) compare_hole(name);
      if (!value.signature.dimension.is_number()) compare_end(name), compare_peak(name, si, value.signature.dimension);
      if (value.si.front() < 0.0) compare_reversal(name, value.signature.dimension);
      if (value.signature.dimension == moment && si > 0.0) compare_moment(name);
      if (value.signature.dimension == stated::force && si > 0.0) compare_across(name);
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  /// A vertical action in the moment of the eccentric forces of a column, and not among these forces.
  void compare_moments(const Operand& operand) {
    const std::set<std::string> forces = values_in(operand, stated::force, project_);
    for (const Operand& other : step_.input().reading.operands) {
      if (!other.leaf.field->is_load || other.leaf.field->dimension != moment) continue;
      const std::set<std::string> bending = values_in(other, stated::force, project_);
      const bool is_shared = std::ranges::any_of(bending, [&](const auto& path) { return forces.contains(path); });
      for (const std::string& path : bending) {
        const std::string name = path.substr(path.find('.') + 1);
        const bool is_vertical = name[0] != 'W' && is_action(name);
        if (!is_shared || !is_vertical || forces.contains(path)) continue;
        return add(operand.path, say("{1} is computed from '{2}', and {3} is not: add it, or justify it: {4} = \"...\"",
                                     other.path, path, operand.path, because_key(operand.path)));
      }
    }
  }

  /// "m_blades" on a disc, whose forces at the rim are not assessed.
  void compare_rim(const std::string& name) {
    const bool is_on_rim = has_word(name, {"blade", "blades", "bucket", "buckets", "shells", "segments", "magnets",
                                           "ring", "rings", "hammers", "vanes"});
    if (id_of(step_) == "machine.disc" && is_on_rim)
      add("D", say("values.{1} acts on no step, and forces at the rim are not assessed: assess them separately, "
                   "because.D = \"...\", or delete the value",
                   name));
  }

  /// "d_hole" next to a cycle of nominal stresses.
  void compare_hole(const std::string& name) {
    const bool is_cycle = id_of(step_).starts_with("fatigue.") && !std::isnan(own_value(step_, project_, "sigma_max"));
    if (is_cycle && has_word(name, {"hole", "holes"}))
      add("sigma_max", say("values.{1} acts on no step: the cycle must include its stress concentration, "
                           "because.sigma_max = \"...\", or delete the value",
                           name));
  }

  /// "m_block" next to a load that is the weight of another mass of [values].
  void compare_attachment(const std::string& name) {
    if (!has_word(name, {"grab", "hook", "block", "spreader", "sling", "slings", "bucket", "cage", "tare", "pallet",
                         "fork", "gripper", "tool"}))
      return;
    for (const Operand& operand : step_.input().reading.operands) {
      const FieldInfo& field = *operand.leaf.field;
      const bool is_weight = field.is_load && (field.dimension == stated::force || field.dimension == moment) &&
                             std::ranges::any_of(operand.expression.references(), [&](const auto& one) {
                               const Value* const value = project_.value(one.path);
                               return value != nullptr && value->signature.dimension == stated::mass;
                             });
      if (is_weight)
        return add(operand.path,
                   say("values.{1} acts on no step, and {2} is computed from another mass: add it, delete "
                       "it, or justify it: {3} = \"...\"",
                       name, operand.path, because_key(operand.path)));
    }
  }

  /// "F_reverse = -40 kN" next to a cycle of positive forces.
  void compare_reversal(const std::string& name, const Dimension& dimension) {
    if (!id_of(step_).starts_with("fatigue.") || is_of_other_state(name)) return;
    for (const Operand& operand : step_.input().reading.operands) {
      const bool is_of_positive =
          operand.leaf.field->is_load && std::ranges::any_of(operand.expression.references(), [&](const auto& one) {
            const Value* const value = project_.value(one.path);
            return value != nullptr && value->signature.dimension == dimension && value->si.front() >= 0.0;
          });
      if (is_of_positive)
        return add(operand.path, say("values.{1} acts on no step, and reverses the load of this cycle: refer to it, "
                                     "delete it, or justify it: {2} = \"...\"",
                                     name, because_key(operand.path)));
    }
  }

  /// "M_b" next to a cycle of stresses by other loads.
  void compare_moment(const std::string& name) {
    const bool is_bending = name == "M_b" || name.starts_with("M_b_") || has_word(name, {"bend", "bending"});
    const bool is_assessed = std::ranges::any_of(project_.steps, [](const auto& one) {
      return id_of(*one) == "shaft.design" || id_of(*one) == "shaft.overhung" || id_of(*one) == "link.member";
    });
    if (!is_bending || is_assessed || !id_of(step_).starts_with("fatigue.") || has_input("M_ba")) return;
    for (const char* const key : {"sigma_max", "sigma_a"}) {
      if (std::isnan(own_value(step_, project_, key))) continue;
      return add(key, say("values.{1} acts on no step: add its stress to the cycle, delete it, or justify it: "
                          "because.{2} = \"...\"",
                          name, key));
    }
  }

  /// "H_braking" next to a column with end moments only.
  void compare_across(const std::string& name) {
    const bool is_horizontal = name.starts_with("H_") || name.starts_with("F_H_");
    if (!is_horizontal || id_of(step_) != "column.beam_column" || is_of_other_state(name)) return;
    add("P", say("values.{1} acts on no step, and bends the column: refer to it, delete it, or justify it: because.P = "
                 "\"...\"",
                 name));
  }

  /// The first force of the step that is computed from forces of [values]; empty if it has none.
  [[nodiscard]] std::string combined_force() const {
    for (const Operand& operand : step_.input().reading.operands) {
      const FieldInfo& field = *operand.leaf.field;
      if (!field.is_load || field.dimension.is_number()) continue;
      const auto& references = operand.expression.references();
      const bool is_of_actions =
          std::ranges::any_of(references, [&](const auto& reference) { return is_value_of_action(reference.path); });
      if (is_of_actions) return operand.path;
    }
    return {};
  }

  [[nodiscard]] static bool is_value_of_action(const std::string& path) {
    return path.starts_with("values.") && is_action(path.substr(path.find('.') + 1));
  }

  /// A permanent or variable action by its symbol: "G", "Q_snow", "S_k", "W".
  [[nodiscard]] static bool is_action(const std::string& name) {
    const bool is_symbol = name.size() == 1 || name[1] == '_';
    if (name.starts_with("F_") && has_word(name, {"live", "imposed", "permanent", "variable"})) return true;
    return is_symbol && std::string_view("GQSW").find(name[0]) != std::string_view::npos && !is_of_other_state(name);
  }

  void compare_action(const std::string& name) {
    if (!is_action(name) && !has_word(name, {"wind", "gust", "snow", "ice", "live", "crane", "impact"})) return;
    const std::string path = is_of_other_state(name) ? std::string() : combined_force();
    if (!path.empty())
      add(path, say("values.{1} acts on no step, and {2} is combined of other actions: add it, delete it, or justify "
                    "it: {3} = \"...\"",
                    name, path, because_key(path)));
  }

  /// Whether an input of the step is computed from this value; its path, or an empty text.
  [[nodiscard]] std::string taker_of(const std::string& value) const {
    for (const auto& [path, typed] : step_.input().reading.typed) {
      if (typed.shared == value) return path;
    }
    for (const Operand& operand : step_.input().reading.operands) {
      const auto& references = operand.expression.references();
      if (std::ranges::any_of(references, [&](const auto& reference) { return reference.path == value; }))
        return operand.path;
    }
    return {};
  }

  /// "f_F = 1.25" next to a load that is F of [values].
  void compare_factor(const std::string& name, double si) {
    constexpr double most = 5.0;
    const bool is_factor = name.starts_with("f_") || name.starts_with("k_") || name.starts_with("phi_");
    if (!is_factor || !(si > 1.0 + stated::in_few_digits && si <= most)) return;
    const std::string loaded = name.substr(name.find('_') + 1), path = taker_of("values." + loaded);
    if (path.empty() || project_.value("values." + loaded) == nullptr) return;
    const FieldInfo* const field = find_leaf(step_.input().reading.record, path).field;
    if (field != nullptr && field->is_load)
      add(path, say("values.{1} = {2} acts on no step, and {3} is computed from values.{4} without it: multiply by it, "
                    "delete it, or justify it: {5} = \"...\"",
                    name, format_number(si, 4), path, loaded, because_key(path)));
  }

  /// "K_t_thread = 3", "beta_k" next to a cycle whose fatigue limit is typed: that of which part is not known.
  void compare_notch(const std::string& name, double si) {
    const bool is_notch = name.starts_with("K_t") || name.starts_with("K_f") || name.starts_with("alpha_k") ||
                          name.starts_with("beta_k") || has_word(name, {"notch"});
    const bool is_fatigue = id_of(step_).starts_with("fatigue.");
    if (!is_notch || !(si > 1.0 + stated::in_few_digits) || !is_fatigue || has_input("K_t")) return;
    const bool is_typed =
        !std::isnan(own_value(step_, project_, "sigma_D")) && step_.input().reading.typed.contains("sigma_D");
    const bool is_found = std::ranges::any_of(step_.input().reading.operands,
                                              [](const Operand& operand) { return operand.path == "sigma_D"; });
    if (!is_typed || is_found || own_value(step_, project_, "K_sigma") >= si) return;
    add("sigma_D",
        say("values.{1} = {2} acts on no step: the fatigue limit must include it: refer to it, delete it, or "
            "justify it: because.sigma_D = \"...\"",
            name, format_number(si, 4)));
  }

  [[nodiscard]] bool has_input(std::string_view key) const {
    return find_field(step_.input().calculator->input->fields, key) != nullptr;
  }

  /// "sigma_range" that a step takes for an amplitude.
  void compare_range(const std::string& name, double si) {
    if (!has_word(name, {"range", "double", "dsigma"})) return;
    for (const char* const key : {"sigma_D", "tau_D", "sigma_a"}) {
      if (has_input(key) && is_near(own_value(step_, project_, key), si, stated::rounded))
        add(key, say("{1} is values.{2}, a range by its name, and an amplitude is half of it: correct it, rename the "
                     "value, or justify it: because.{1} = \"...\"",
                     key, name));
    }
  }

  /// The largest sum of values of [values] of this dimension that a load of the step is computed from.
  [[nodiscard]] double largest_taken(const Dimension& dimension) const {
    double largest = 0.0;
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.leaf.field->is_load) continue;
      double sum = 0.0;
      for (const std::string& path : values_in(operand, dimension, project_))
        sum += std::abs(magnitude_at(project_, path));
      largest = std::fmax(largest, sum);
    }
    return largest;
  }

  /// "F_abuse": an index is a word; "F_t" is a component.
  [[nodiscard]] static bool is_word_behind(const std::string& name) { return name.size() > name.rfind('_') + 3; }

  /// "p_relief" next to a force that is computed from "p_oil".
  void compare_peak(const std::string& name, double si, const Dimension& dimension) {
    const std::string symbol = "values." + name.substr(0, name.find('_') + 1);
    const bool is_peak =
        is_of_peak(name) || has_word(name, {"relief", "test", "surge", "hammer"}) ||
        (dimension == stated::force && (symbol == "values.F_" || symbol == "values.N_") && is_word_behind(name));
    if (!is_peak || is_of_other_state(name) || !symbol.ends_with('_')) return;
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.leaf.field->is_load || operand.leaf.field->dimension == dimension) continue;
      for (const auto& reference : operand.expression.references()) {
        const Value* const value = project_.value(reference.path);
        if (!reference.path.starts_with(symbol) || value == nullptr || value->signature.dimension != dimension)
          continue;
        if (!(si > (1.0 + stated::rounded) * largest_taken(dimension))) continue;
        return add(operand.path,
                   say("values.{1} acts on no step, and {2} is computed from '{3}', which is lower: refer "
                       "to it, delete it, or justify it: {4} = \"...\"",
                       name, operand.path, reference.path, because_key(operand.path)));
      }
    }
  }

  /// "F_min" next to a cycle that is computed from F_max only.
  void compare_end(const std::string& name) {
    const bool is_low = name.ends_with("_min");
    if (!id_of(step_).starts_with("fatigue.") || !(is_low || name.ends_with("_max"))) return;
    const std::string other = name.substr(0, name.size() - 3) + (is_low ? "max" : "min");
    const std::string path = taker_of("values." + other);
    const FieldInfo* const field = path.empty() ? nullptr : find_leaf(step_.input().reading.record, path).field;
    if (field == nullptr || !field->is_load) return;
    add(path, say("values.{1} acts on no step, and values.{2} gives an end of the cycle: refer to both, delete it, or "
                  "justify it: {3} = \"...\"",
                  name, other, because_key(path)));
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> values_left_out_of_loads(const Step& step, const Project& project) {
  return Combinations(step, project).run();
}

}  // namespace loadpath::project
