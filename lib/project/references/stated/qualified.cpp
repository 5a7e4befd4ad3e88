#include "lib/project/references/stated/qualified.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

/// Of which side the step is unsafe: where it has less than a demand of [values], or more than is available.
enum class Kind { other, demand, capacity };

/// The symbol of a key without the index of one of several parts: "H" of "H_1", "H_B" of "H_B2", "S_F" of "S_Fmin"; of
/// strengths that of other standards.
std::string_view symbol_of(std::string_view key) {
  if (key == "sigma_B" || key == "R_mN") return "R_m";
  if (key == "sigma_S" || key == "R_eN") return "R_e";
  if (key.starts_with("S_") && key.ends_with("min")) return key.substr(0, key.size() - 3);
  if (key.size() < 2 || key.back() < '1' || key.back() > '9') return key;
  key.remove_suffix(1);
  return key.ends_with('_') ? key.substr(0, key.size() - 1) : key;
}

bool is_one_of(std::string_view symbol, std::initializer_list<std::string_view> symbols) {
  return std::ranges::find(symbols, symbol) != symbols.end();
}

Kind kind_of(const Step& step, const FieldInfo& field) {
  const std::string_view symbol = symbol_of(field.key), id = id_of(step);
  const bool is_number = field.dimension.is_number();
  const bool is_strong =
      symbol.ends_with("_adm") || is_one_of(symbol, {"R_e", "R_m", "f_y", "f_u", "H_B", "F_B", "F_u", "P_R", "P_b",
                                                     "C_0", "z_l", "Q_v", "delta", "A_h"});
  const bool is_stiff = symbol == "E" && find_field(step.input().calculator->input->fields, "n_st") != nullptr;
  if (is_strong || is_stiff || (symbol == "H" && id.starts_with("gear.")) ||
      (symbol == "C" && id == "bearing.rolling") || means(*step.input().calculator, field.key, &is_strength))
    return Kind::capacity;
  const bool is_safety = symbol == "S" || symbol == "n_st" || symbol == "s_0" || symbol.starts_with("S_");
  const bool is_required = symbol == "L_h" || symbol == "L_req" || symbol == "n_req" || symbol == "grade" ||
                           (symbol == "c" && id.starts_with("vessel.")) || symbol == "R_z" ||
                           (field.is_factor && is_number) ||
                           (field.is_load && (symbol.starts_with("sigma_") || symbol.starts_with("tau_")));
  return is_required || (is_safety && is_number) ? Kind::demand : Kind::other;
}

/// The words behind the symbol of a name; empty if it does not begin with it.
std::string_view words_behind(std::string_view name, std::string_view symbol) {
  const bool is_meant = name.size() > symbol.size() + 2 && name.starts_with(symbol) && name[symbol.size()] == '_';
  return is_meant ? name.substr(symbol.size() + 1) : std::string_view();
}

/// Whether the words mean another value than that of the part: the hardness of a core, a required rating.
bool is_of_another(std::string_view words, Kind kind) {
  if (kind == Kind::demand) return is_of_other_state(words) && !has_word(words, {"min", "least"});
  return has_word(words, {"core", "max", "upper", "ultimate"});
}

/// The input of a step with this symbol that is furthest on the safe side.
struct Safest {
  const FieldInfo* field = nullptr;
  double si = std::nan("");
};

class Qualified {
 public:
  Qualified(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) compare(name, value);
    return std::move(found_);
  }

 private:
  /// The longest symbol of an input that the name begins with, and its kind.
  [[nodiscard]] std::pair<std::string_view, Kind> symbol_in(const std::string& name, const Dimension& dimension) const {
    std::pair<std::string_view, Kind> longest{{}, Kind::other};
    for (const FieldInfo& field : step_.input().calculator->input->fields) {
      const std::string_view symbol = symbol_of(field.key);
      if (!(field.is_number() || field.type == FieldInfo::Type::count) || !(field.dimension == dimension)) continue;
      const bool is_meant = !words_behind(name, symbol).empty() || !words_behind(name, field.key).empty();
      if (symbol.size() > longest.first.size() && is_meant) longest = {symbol, kind_of(step_, field)};
    }
    return longest;
  }

  [[nodiscard]] Safest safest(const Step& step, std::string_view symbol, Kind kind, const Dimension& dimension) const {
    Safest safest;
    for (const FieldInfo& field : step.input().calculator->input->fields) {
      if (symbol_of(field.key) != symbol || !(field.dimension == dimension)) continue;
      const double own = own_value(step, project_, field.key);
      const double si = std::isnan(own) ? magnitude_at(project_, step.name() + "." + field.key) : own;
      const bool is_safer = kind == Kind::demand ? !(si <= safest.si) : !(si >= safest.si);
      if (!std::isnan(si) && is_safer) safest = {&field, si};
    }
    return safest;
  }

  [[nodiscard]] static bool covers(const Safest& one, double stated, Kind kind) {
    return kind == Kind::demand ? one.si >= (1.0 - stated::rounded) * stated
                                : one.si <= (1.0 + stated::rounded) * stated;
  }

  /// The strength of the part by its word, under the index that it has in the step: "R_e_key" next to R_e_k.
  bool compare_part(const std::string& name, std::string_view symbol, double stated, const Dimension& dimension,
                    Kind kind) {
    if (!connects(step_) || kind != Kind::capacity) return false;
    for (const auto& [word, index] : {std::pair{"shaft", "_1"}, {"hub", "_2"}, {"key", "_k"}}) {
      const std::string key = std::string(symbol) + index;
      const FieldInfo* const field = find_field(step_.input().calculator->input->fields, key);
      const double here = own_value(step_, project_, key);
      if (!has_word(name, {word}) || field == nullptr || !(field->dimension == dimension)) continue;
      if (stated < (1.0 - ::loadpath::project::stated::rounded) * here) add(name, stated, *field, here);
      return true;
    }
    return false;
  }

  void add(const std::string& name, double stated, const FieldInfo& field, double here) {
    const auto shown = [&](double si) {
      return field.dimension.is_number() ? format_number(si, 5) : format_quantity(si, field.unit, 5);
    };
    found_.push_back(not_taken(name, shown(stated), field.key, shown(here)));
  }

  void compare(const std::string& name, const Value& value) {
    const Dimension& dimension = value.signature.dimension;
    const auto is_input = [&](const auto& one) {
      return find_field(one->input().calculator->input->fields, name) != nullptr;
    };
    const bool is_hardness = has_word(name, {"hardness"});
    const auto [symbol, kind] = symbol_in(is_hardness ? "H_" + name : name, dimension);
    const bool is_required_rating = symbol != "delta" && kind == Kind::capacity && has_word(name, {"req", "required"});
    if (is_required_rating || (symbol == "delta" && !dimension.is_number())) return;
    const double stated = value.si.front();
    if (kind == Kind::other || std::ranges::any_of(project_.steps, is_input) || !(stated > 0.0)) return;
    if (is_of_another(is_hardness ? name : name.substr(symbol.size()), kind)) return;
    if (compare_part(name, symbol, stated, dimension, kind)) return;
    const Safest here = safest(step_, symbol, kind, dimension);
    const auto has_it = [&, symbol = symbol, kind = kind](const auto& one) {
      return covers(safest(*one, symbol, kind, dimension), stated, kind);
    };
    if (here.field == nullptr || std::ranges::any_of(project_.steps, has_it)) return;
    add(name, stated, *here.field, here.si);
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> symbols_stated_otherwise(const Step& step, const Project& project) {
  return Qualified(step, project).run();
}

}  // namespace loadpath::project
