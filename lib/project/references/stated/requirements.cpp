#include "lib/project/references/stated/requirements.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

using stated::in_few_digits;

constexpr std::string_view allowable = "_adm";

/// "p_adm" of "p_adm_1" and of "p_adm_bush"; empty for other names.
std::string stem_of(std::string_view name) {
  const std::size_t at = name.find(allowable);
  const std::size_t end = at + allowable.size();
  if (at == std::string_view::npos || (end < name.size() && name[end] != '_')) return {};
  return std::string(name.substr(0, end));
}

/// "n_st" of "n_st_min"; empty for other names.
std::string required_key(const std::string& name) {
  constexpr std::array<std::string_view, 4> endings{"_min", "_req", "_required", "_target"};
  for (const std::string_view ending : endings) {
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  }
  return {};
}

bool is_safety(std::string_view key) { return key == "S" || key == "n_st" || key.starts_with("S_"); }

class Requirements {
 public:
  Requirements(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) {
      const double si = value.si.front();
      compare_allowable(name, si, value.signature.dimension);
      if (value.signature.dimension.is_number()) compare_safety(name, si);
      compare_range(name, si, value.signature.dimension);
    }
    return std::move(found_);
  }

 private:
  /// "tau_adm" of "tau_zul", "sigma_lim": the usual name of an allowable value under other words.
  [[nodiscard]] static std::string usual_name(const std::string& name) {
    constexpr std::array<std::string_view, 6> endings{"_zul", "_perm", "_allow", "_allowable", "_lim", "_permissible"};
    for (const std::string_view ending : endings) {
      if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size()) + "_adm";
    }
    const bool is_time = name.starts_with("t_") && has_word(name, {"max"});  // of a run-up
    return is_time ? "t_adm" : name;
  }

  [[nodiscard]] double own(const std::string& key) const { return own_value(step_, project_, key); }
  [[nodiscard]] static const FieldInfo* input_of(const Step& step, std::string_view key) {
    return find_field(step.input().calculator->input->fields, key);
  }

  /// The least allowable value of this kind that the step has, and its input.
  [[nodiscard]] std::pair<const FieldInfo*, double> least_allowable(const Step& step, const std::string& stem,
                                                                    const Dimension& dimension) const {
    std::pair<const FieldInfo*, double> least{nullptr, std::nan("")};
    for (const FieldInfo& field : step.input().calculator->input->fields) {
      if (!field.is_number() || !(field.dimension == dimension) || stem_of(field.key) != stem) continue;
      const double here = own_value(step, project_, field.key);
      if (here > 0.0 && !(here >= least.second)) least = {&field, here};
    }
    return least;
  }

  /// "p_adm_bush" below all allowable values of its kind in the file.
  void compare_allowable(const std::string& name, double si, const Dimension& dimension) {
    const std::string stem = stem_of(usual_name(name));
    if (stem.empty() || input_of(step_, name) != nullptr || !(si > 0.0)) return;
    const auto [field, here] = least_allowable(step_, stem, dimension);
    if (field == nullptr || !(si < (1.0 - in_few_digits) * here)) return;
    const auto has_it = [&](const auto& other) {
      return least_allowable(*other, stem, dimension).second <= (1.0 + in_few_digits) * si;
    };
    if (!std::ranges::any_of(project_.steps, has_it)) add(name, si, *field, here);
  }

  /// "n_st_min" above the required safety factor.
  void compare_safety(const std::string& name, double si) {
    const std::string key = required_key(name);
    const FieldInfo* const field = input_of(step_, key);
    if (input_of(step_, name) != nullptr || field == nullptr || !is_safety(key)) return;
    if (si > (1.0 + in_few_digits) * own(key)) add(name, si, *field, own(key));
  }

  /// "U", "U_worn" outside of "U_min" to "U_max".
  void compare_range(const std::string& name, double si, const Dimension& dimension) {
    const std::string symbol = name.substr(0, name.find('_'));
    if (has_word(name, {"min", "max"})) return;
    const FieldInfo* const low = input_of(step_, symbol + "_min");
    const FieldInfo* const high = input_of(step_, symbol + "_max");
    if (low == nullptr || high == nullptr || !(low->dimension == dimension) || low->is_load) return;
    const double least = own(low->key), most = own(high->key);
    if (si < (1.0 - in_few_digits) * least) add(name, si, *low, least);
    if (si > (1.0 + in_few_digits) * most) add(name, si, *high, most);
  }

  void add(const std::string& name, double stated, const FieldInfo& field, double here) {
    const auto shown = [&](double si) {
      return field.dimension.is_number() ? format_number(si, 5) : format_quantity(si, field.unit, 5);
    };
    found_.push_back(not_taken(name, shown(stated), field.key, shown(here)));
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> requirements_stated_otherwise(const Step& step, const Project& project) {
  return Requirements(step, project).run();
}

}  // namespace loadpath::project
