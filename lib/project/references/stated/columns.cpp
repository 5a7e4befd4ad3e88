#include "lib/project/references/stated/columns.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

using stated::in_few_digits;
using stated::length;

constexpr double of_lengths = 0.02;  // of values with few digits

const Dimension bending_moment = Dimension::of(2, 1, -2);

/// The largest of some inputs; 0 if it has none of them.
double largest_of(const Step& step, const Project& project, std::initializer_list<const char*> keys) {
  double most = 0.0;
  for (const char* const key : keys) most = std::fmax(most, std::abs(own_value(step, project, key)));
  return most;
}

bool is_eccentricity(const std::string& name) {
  return name == "e" || name == "e_0" || name == "ecc" ||
         (name.starts_with("e_") && name.size() > 3 && !is_of_other_state(name)) || has_word(name, {"eccentricity"});
}

/// Whether a moment is computed from an eccentricity of [values]: another one acts in addition.
bool takes_eccentricity(const Step& step) {
  return std::ranges::any_of(step.input().reading.operands, [](const Operand& operand) {
    return operand.leaf.field->is_load && std::ranges::any_of(operand.expression.references(), [](const auto& one) {
             return one.path.starts_with("values.") && is_eccentricity(one.path.substr(one.path.find('.') + 1));
           });
  });
}

/// "l_eff", "L_cr": a length with its effective length factor.
bool is_effective_length(const std::string& name) {
  return has_word(name.substr(0, name.find('_')), {"l", "s"}) &&
         has_only_words(name, {"l", "s", "0", "k", "eff", "cr", "e", "fl", "ky", "kz", "buckling"}) && name.size() > 1;
}

/// "L", "height": a length of the bar.
bool is_length_of_bar(const std::string& name) {
  return has_only_words(name, {"l", "height", "length", "span", "clear", "column", "total"}) && name != "total";
}

/// The largest effective length factor, typed, found or, before the step is solved, by the free end.
double largest_factor(const Step& step, const Project& project) {
  constexpr double of_free_end = 2.0;
  double most = std::nan("");
  for (const char* const key : {"beta_y", "beta_z"}) {
    const double typed = own_value(step, project, key);
    most = std::fmax(most, std::isnan(typed) ? magnitude_at(project, step.name() + "." + key) : typed);
  }
  if (!std::isnan(most)) return most;
  const Leaf ends = find_leaf(step.input().reading.record, "ends");
  const bool is_choice = ends && ends.field->type == FieldInfo::Type::choice && !std::isnan(ends.get());
  return is_choice && word_of(ends).ends_with("_free") ? of_free_end : 1.0;
}

/// Whether another bar of the file has this length.
bool is_length_of_other(const Step& step, const Project& project, double si) {
  return std::ranges::any_of(project.steps, [&](const auto& other) {
    return other.get() != &step && std::abs(own_value(*other, project, "l")) >= (1.0 - in_few_digits) * si;
  });
}

bool is_bending_moment(const std::string& name) {
  return name == "M" || name == "M_b" || name == "M_max" || name == "M_Ed" || name == "M_d";
}

/// "N_c", "F_push" of [values] for the axial force, or a step "push rod".
bool is_compressed(const Step& step) {
  const std::initializer_list<std::string_view> words{"c",    "comp",  "compression", "compressive",
                                                      "push", "strut", "prop"};
  const bool is_named_so =
      std::ranges::any_of(words, [&](std::string_view word) { return word.size() > 1 && is_named(step, word); });
  const auto typed = step.input().reading.typed.find("N");
  const Operand* const operand = step.input().reading.operand("N");
  const bool is_shared = typed != step.input().reading.typed.end() && has_word(typed->second.shared, words);
  return is_named_so || is_shared ||
         (operand != nullptr && std::ranges::any_of(operand->expression.references(),
                                                    [&](const auto& one) { return has_word(one.path, words); }));
}

}  // namespace

std::vector<ReducedLoad> columns_stated_otherwise(const Step& step, const Project& project) {
  const Calculator& calculator = *step.input().calculator;
  if (!std::string_view(calculator.id).starts_with("column.") || project.values.unused().empty()) return {};
  if (find_field(calculator.input->fields, "P") == nullptr) return {};
  const double M = largest_of(step, project, {"M_y_1", "M_y_2", "M_z_1", "M_z_2", "M_y", "M_z"});
  const double l = own_value(step, project, "l");
  std::vector<ReducedLoad> found;
  for (const auto& [name, value] : project.values.unused()) {
    const Dimension dimension = value.signature.dimension.without_angle();
    const double si = std::abs(value.si.front());
    const bool is_centric = M == 0.0 && largest_of(step, project, {"e_y", "e_z"}) == 0.0;
    const bool is_off_axis = dimension == length && si > 0.0 && is_eccentricity(name) &&
                             (is_centric || (name.size() > 1 && takes_eccentricity(step)));
    const bool is_bent = dimension == bending_moment && is_bending_moment(name) && si > (1.0 + in_few_digits) * M;
    if (is_off_axis || is_bent)
      found.push_back({"P", say("values.{1} is not used by any step: include it in a load, delete it, or justify it: "
                                "because.P = \"...\"",
                                name)});
    const double beta = largest_factor(step, project);
    const double least = is_effective_length(name) ? beta * l : is_length_of_bar(name) ? l : std::nan("");
    if (dimension == length && si > (1.0 + of_lengths) * least && !is_length_of_other(step, project, si))
      found.push_back({"l", say("values.{1} = {2} acts on no step, and this bar has {3}: refer to it, delete it, or "
                                "justify it: because.l = \"...\"",
                                name, format_quantity(si, "mm", 5), format_quantity(least, "mm", 5))});
    if (dimension.is_number() && (name == "beta" || name == "K") && si > (1.0 + of_lengths) * beta)
      found.push_back({"l", say("values.{1} = {2} acts on no step, and the effective length factor is {3}: refer to "
                                "it, delete it, or justify it: because.l = \"...\"",
                                name, format_number(si, 4), format_number(beta, 4))});
    if (dimension == length && has_word(name, {"stroke"}) && si > (1.0 + in_few_digits) * l)
      found.push_back({"l", say("values.{1} = {2} acts on no step, and l is {3}: refer to it, delete it, or justify "
                                "it: because.l = \"...\"",
                                name, format_quantity(si, "mm", 5), format_quantity(l, "mm", 5))});
  }
  return found;
}

std::vector<ReducedLoad> eccentric_links(const Step& step, const Project& project) {
  if (id_of(step) != "link.member") return {};
  std::vector<ReducedLoad> found;
  for (const auto& [name, value] : project.values.unused()) {
    if (!(value.signature.dimension == length) || !is_eccentricity(name)) continue;
    const double moment = std::abs(own_value(step, project, "N") * value.si.front());
    if (!(moment > std::fmax(0.0, std::abs(own_value(step, project, "M_b"))))) continue;
    found.push_back(
        {"M_b", say("values.{1} acts on no step, and with N it is a moment of {2}: add it to M_b, delete it, "
                    "or justify it: because.M_b = \"...\"",
                    name, format_quantity(moment, "N*m", 4))});
  }
  return found;
}

std::vector<ReducedLoad> bars_in_tension(const Step& step, const Project& project) {
  if (id_of(step) != "link.member" || !is_compressed(step)) return {};
  if (std::isnan(own_value(step, project, "n_st")) || !(own_value(step, project, "N") > 0.0)) return {};
  return {
      {"N", say("N is positive, which is tension, and this bar is compressed by the name of the force or of the step: "
                "write N = \"=-...\", or because.N = \"...\"")}};
}

}  // namespace loadpath::project
