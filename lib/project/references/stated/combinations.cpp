#include "lib/project/references/stated/combinations.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

namespace {

constexpr double least_partial = 1.1, most_partial = 2.0;  // partial factors of unfavourable actions

/// The terms of a sum without parentheses around terms; a subtracted one acts against the others.
std::vector<std::string> added_terms(const std::string& text) {
  std::vector<std::string> terms;
  int depth = 0;
  bool is_added = true;
  std::string term;
  for (const char c : text + "+") {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth != 0 || (c != '+' && c != '-')) {
      term += c;
      continue;
    }
    if (is_added && term.find_first_not_of(' ') != std::string::npos) terms.push_back(term);
    is_added = c == '+', term.clear();
  }
  return terms;
}

/// The largest bare number that a product begins with or is multiplied with; 1 if it has none.
double bare_factor(const std::string& term) {
  double largest = std::nan("");
  const std::size_t divided = term.find('/');
  if (divided != std::string::npos && std::atof(term.c_str() + divided + 1) > 1.0) return 1.0;  // a part of the action
  for (std::size_t at = 0; at < term.size();) {
    const std::size_t end = std::min(term.find('*', at), term.size());
    char* rest = nullptr;
    const std::string factor = term.substr(at, end - at);
    const double number = std::strtod(factor.c_str(), &rest);
    const bool is_number =
        rest != factor.c_str() && std::string_view(rest).find_first_not_of(' ') == std::string_view::npos;
    if (is_number) largest = std::fmax(largest, number);
    at = end + 1;
  }
  return std::isnan(largest) ? 1.0 : largest;
}

class Combinations {
 public:
  Combinations(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.leaf.field->is_load && !operand.leaf.field->dimension.is_number()) compare_terms(operand);
    }
    for (const auto& [name, value] : project_.values.unused()) {
      const double si = std::abs(value.si.front());
      if (value.signature.dimension == stated::force && si > 0.0) compare_action(name);
      if (value.signature.dimension.is_number()) compare_factor(name, si), compare_notch(name, si);
      if (value.signature.dimension == stated::pressure) compare_range(name, si);
      if (!value.signature.dimension.is_number()) compare_end(name), compare_peak(name, si, value.signature.dimension);
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  /// A term of values without a partial factor, next to one with it.
  void compare_terms(const Operand& operand) {
    const auto terms = added_terms(operand.text);
    const auto is_partial = [](const std::string& term) {
      const double factor = bare_factor(term);
      return factor >= least_partial && factor <= most_partial;
    };
    if (terms.size() < 2 || std::ranges::none_of(terms, is_partial)) return;
    for (const std::string& term : terms) {
      const std::size_t first = term.find("values.");
      const bool is_of_one_value = first != std::string::npos && term.find("values.", first + 1) == std::string::npos;
      if (!is_of_one_value || is_partial(term)) continue;
      return add(operand.path, say("{1} adds a term without a partial factor to one with it: give the factor, refer to "
                                   "a value that states it, or justify it: {2} = \"...\"",
                                   operand.path, because_key(operand.path)));
    }
  }

  /// The first force of the step that is computed from forces of [values]; empty if it has none.
  [[nodiscard]] std::string combined_force() const {
    for (const Operand& operand : step_.input().reading.operands) {
      const FieldInfo& field = *operand.leaf.field;
      if (!field.is_load || !(field.dimension == stated::force)) continue;
      const auto& references = operand.expression.references();
      const bool is_of_actions = std::ranges::any_of(references, [&](const auto& reference) {
        return reference.path.starts_with("values.") && is_action(reference.path.substr(7));
      });
      if (is_of_actions) return operand.path;
    }
    return {};
  }

  /// A permanent or variable action by its symbol: "G", "Q_snow", "S_k", "W".
  [[nodiscard]] static bool is_action(const std::string& name) {
    const bool is_symbol = name.size() == 1 || name[1] == '_';
    return is_symbol && std::string_view("GQSW").find(name[0]) != std::string_view::npos && !is_of_other_state(name);
  }

  void compare_action(const std::string& name) {
    if (!is_action(name) && !has_word(name, {"wind", "snow", "live", "crane", "impact"})) return;
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

  /// "p_relief" next to a force that is computed from "p_oil".
  void compare_peak(const std::string& name, double si, const Dimension& dimension) {
    const std::string symbol = "values." + name.substr(0, name.find('_') + 1);
    const bool is_peak = is_of_peak(name) || has_word(name, {"relief", "test", "surge", "hammer"});
    if (!is_peak || is_of_other_state(name) || !symbol.ends_with('_')) return;
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.leaf.field->is_load || operand.leaf.field->dimension == dimension) continue;
      for (const auto& reference : operand.expression.references()) {
        const Value* const value = project_.value(reference.path);
        if (!reference.path.starts_with(symbol) || value == nullptr || value->signature.dimension != dimension)
          continue;
        if (!(si > (1.0 + stated::rounded) * std::abs(magnitude_at(project_, reference.path)))) continue;
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
