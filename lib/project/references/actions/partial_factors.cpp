#include "lib/project/references/actions/partial_factors.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/factors/given.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

namespace {

constexpr double least_partial = 1.1, most_partial = 2.0;  // partial factors of unfavourable actions
const Dimension moment_of_column = Dimension::of(2, 1, -2);

struct Term {
  std::string text;
  bool is_added = true;
};

/// The terms of a sum without parentheses around terms.
std::vector<Term> terms_of(const std::string& text) {
  std::vector<Term> terms;
  int depth = 0;
  Term term;
  for (const char c : text + "+") {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth != 0 || (c != '+' && c != '-')) {
      term.text += c;
      continue;
    }
    if (term.text.find_first_not_of(' ') != std::string::npos) terms.push_back(term);
    term = {{}, c == '+'};
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

/// The names of [values] in a part of a formula: "gamma_Q", "Q_k".
std::vector<std::string> names_in(const std::string& text) {
  constexpr std::string_view prefix = "values.";
  std::vector<std::string> names;
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at + 1)) {
    const std::size_t begin = at + prefix.size();
    const auto is_of_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    const auto end = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), is_of_name);
    names.emplace_back(text.begin() + static_cast<std::ptrdiff_t>(begin), end);
  }
  return names;
}

bool is_component(const std::string& name) { return has_word(name, {"x", "y", "z", "h", "v", "horizontal", "H"}); }

bool is_symbol(const std::string& name, std::string_view letters) {
  return letters.find(name[0]) != std::string_view::npos && (name.size() == 1 || name[1] == '_');
}

/// A weight, or a load on a floor or a roof: they act downwards.
bool is_vertical_action(const std::string& name) {
  const bool is_load = is_symbol(name, "GQS") || has_word(name, {"dead", "live", "snow", "imposed", "permanent"});
  return is_load && !is_component(name) && !has_word(name, {"gamma", "psi", "phi", "wind", "uplift"});
}

bool is_horizontal_action(const std::string& name) {
  return !has_word(name, {"gamma", "psi"}) && (is_symbol(name, "HW") || has_word(name, {"wind", "gust"}));
}

/// A value before its partial factor, by its name.
bool is_characteristic_value(const std::string& path) {
  if (has_word(path.substr(path.find('.') + 1), {"ed", "d", "sd", "design", "uls"})) return false;
  return path.ends_with("_k") ||
         has_word(path.substr(path.find('.') + 1), {"dead", "live", "snow", "imposed", "permanent", "wind", "traffic"});
}

class PartialFactors {
 public:
  PartialFactors(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const Operand& operand : step_.input().reading.operands) {
      const FieldInfo& field = *operand.leaf.field;
      if (!field.is_load || field.dimension.is_number()) continue;
      compare_terms(operand);
      compare_root(operand);
      compare_combination(operand);
      if (field.dimension == stated::force) compare_characteristic(operand);
      if (field.dimension == moment_of_column) compare_moment_of_characteristic(operand);
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  [[nodiscard]] double value_of(const std::string& name) const {
    return std::abs(magnitude_at(project_, "values." + name));
  }

  /// "gamma_G", not "gamma_inf" of a favourable action.
  [[nodiscard]] bool is_partial_name(const std::string& name) const {
    if (!has_word(name, {"gamma"}) || has_word(name, {"inf", "fav", "favourable", "m0", "m1", "m2", "m"})) return false;
    return value_of(name) >= least_partial;
  }

  [[nodiscard]] bool is_partial(const Term& term) const {
    const double factor = bare_factor(term.text);
    return (factor >= least_partial && factor <= most_partial) ||
           std::ranges::any_of(names_in(term.text), [&](const std::string& name) { return is_partial_name(name); });
  }

  /// A term of values without a partial factor, next to one with it; an action that is subtracted with a factor.
  void compare_terms(const Operand& operand) {
    const auto terms = terms_of(operand.text);
    if (terms.size() < 2) return;
    const auto is_with_factor = [&](const Term& term) { return term.is_added && is_partial(term); };
    if (std::ranges::none_of(terms, is_with_factor)) return;
    for (const Term& term : terms) {
      const auto names = names_in(term.text);
      const bool is_of_force = std::ranges::any_of(names, [&](const auto& name) {
        return is_vertical_action(name) && project_.value("values." + name) != nullptr;
      });
      if (!term.is_added && is_of_force && is_partial(term))
        return add(operand.path, say("{1} is reduced by an action with a partial factor above 1: a favourable action "
                                     "takes none; add it, take the factor away, or justify it: {2} = \"...\"",
                                     operand.path, because_key(operand.path)));
      if (!term.is_added || names.size() != 1 || is_partial(term)) continue;
      return add(operand.path, say("{1} adds a term without a partial factor to one with it: give the factor, refer to "
                                   "a value that states it, or justify it: {2} = \"...\"",
                                   operand.path, because_key(operand.path)));
    }
  }

  /// "hypot(values.G_k, values.Q_k)": the root of the squares of forces in one direction.
  void compare_root(const Operand& operand) {
    constexpr std::string_view call = "hypot(";
    const std::size_t at = operand.text.find(call);
    if (at == std::string::npos) return;
    std::vector<std::string> parts(1);
    int depth = 1;
    for (std::size_t i = at + call.size(); i < operand.text.size() && depth > 0; ++i) {
      const char c = operand.text[i];
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (depth == 1 && c == ',')
        parts.emplace_back();
      else
        parts.back() += c;
    }
    const auto is_vertical = [](const std::string& part) {
      return std::ranges::any_of(names_in(part), is_vertical_action);
    };
    if (parts.size() > 1 && std::ranges::all_of(parts, is_vertical))
      add(operand.path,
          say("{1} is the root of the squares of actions in one direction: add them, or justify it: {2} = "
              "\"...\"",
              operand.path, because_key(operand.path)));
  }

  /// "psi_snow" on a wind force.
  void compare_combination(const Operand& operand) {
    for (const Term& term : terms_of(operand.text)) {
      const auto names = names_in(term.text);
      for (const std::string& psi : names) {
        if (!has_word(psi, {"psi"})) continue;
        const bool is_of_snow = has_word(psi, {"snow", "live", "imposed"}), is_of_wind = has_word(psi, {"wind"});
        const auto is_of_other = [&](const std::string& name) {
          if (is_of_snow) return is_horizontal_action(name);
          return is_of_wind && is_vertical_action(name) && !is_symbol(name, "Q");
        };
        const auto other = std::ranges::find_if(names, is_of_other);
        if (other == names.end()) continue;
        return add(operand.path, say("'values.{1}' is the combination factor of another action than 'values.{2}': "
                                     "take that of this action, or justify it: {3} = \"...\"",
                                     psi, *other, because_key(operand.path)));
      }
    }
  }

  /// By how much an input of all parts grows with a value, 1.5 of Q in "=1.35*values.G + 1.5*values.Q".
  [[nodiscard]] double factor_of(const Operand& operand, const std::string& path) const {
    std::map<std::string, Value> values;
    for (const auto& reference : operand.expression.references()) {
      const Value* const value = project_.value(reference.path);
      if (value == nullptr || value->is_series()) return std::nan("");
      values[reference.path] = *value;
    }
    const auto known = [&](const std::string& name) -> const Value& { return values.at(name); };
    const auto result = [&] { return operand.expression.evaluate(known).si.front(); };
    const double one = result();
    values.at(path).si.front() *= 2.0;
    double count = 1.0;  // of the parts that share it
    for (const auto& [name, value] : values)
      count *= value.signature.dimension.is_number() ? std::fmax(1.0, std::floor(value.si.front())) : 1.0;
    return count * (result() - one) / magnitude_at(project_, path);
  }

  /// "P = =values.G_k + values.Q_k" next to gamma_F = 1.
  void compare_characteristic(const Operand& operand) {
    const std::set<std::string> forces = values_in(operand, stated::force, project_);
    if (forces.empty() || !std::ranges::all_of(forces, is_characteristic_value) || !has_input("gamma_F")) return;
    const double gamma_F = own_value(step_, project_, "gamma_F");
    const bool is_by_symbol = std::ranges::all_of(forces, [](const auto& path) { return path.ends_with("_k"); });
    if (std::isnan(gamma_F) && !is_by_symbol) return;
    const auto has_factor = [&](const std::string& path) {
      const double factor = factor_of(operand, path) * std::fmax(1.0, gamma_F);
      return !(factor >= 1.0 - stated::rounded && factor < least_partial);  // below, it is divided by a count
    };
    if (std::ranges::any_of(forces, has_factor)) return;
    add_missing(operand, gamma_F);
  }

  /// "M_y = =values.H_k*values.L/4" next to gamma_F = 1.
  void compare_moment_of_characteristic(const Operand& operand) {
    constexpr std::array shares{1.0, 0.5, 1.0 / 3.0, 0.25, 0.125, 1.0 / 12.0};  // of beams, without a factor
    if (!has_input("gamma_F")) return;
    const auto names = names_in(operand.text);
    const std::set<std::string> forces = values_in(operand, stated::force, project_);
    const std::set<std::string> lengths = values_in(operand, stated::length, project_);
    const bool is_of_these = forces.size() == 1 && lengths.size() == 1 && names.size() == 2 &&
                             operand.expression.references().size() == 2 && is_characteristic_value(*forces.begin());
    if (!is_of_these) return;
    const double whole = magnitude_at(project_, *forces.begin()) * magnitude_at(project_, *lengths.begin());
    const double share = std::abs(own_value(step_, project_, operand.path) / whole);
    if (std::ranges::none_of(shares, [&](double one) { return is_near(share, one, stated::in_few_digits); })) return;
    const double gamma_F = own_value(step_, project_, "gamma_F");
    if (!std::isnan(gamma_F) && gamma_F < least_partial) add_missing(operand, gamma_F);
  }

  void add_missing(const Operand& operand, double gamma_F) {
    add(operand.path,
        say("{1} is computed from characteristic values without partial factors, and gamma_F is {2}: give "
            "the factors, or justify it: {3} = \"...\"",
            operand.path, std::isnan(gamma_F) ? "not given" : format_number(gamma_F, 4), because_key(operand.path)));
  }

  [[nodiscard]] bool has_input(std::string_view key) const {
    return find_field(step_.input().calculator->input->fields, key) != nullptr;
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> partial_factors_of_loads(const Step& step, const Project& project) {
  return PartialFactors(step, project).run();
}

}  // namespace loadpath::project
