#include "lib/project/references/machine/left_out.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double implausible_ratio =
    50.0;  // times the load of the step: beyond, it is another quantity of the same dimension

/// Of forces of bars and pins, F, N and P: "N_Ed" next to F.
bool is_same_letter(char a, char b) {
  constexpr std::string_view forces = "FNP";
  return a == b || (forces.find(a) != std::string_view::npos && forces.find(b) != std::string_view::npos);
}

/// The part of a key in front of an index: "M_y" of "M_y_1".
std::string_view stem_of_key(std::string_view key) {
  const std::size_t end = key.rfind('_');
  return end != std::string_view::npos && end + 2 == key.size() && key[end + 1] >= '0' && key[end + 1] <= '9'
             ? key.substr(0, end)
             : key;
}

/// The longest symbol of a given load that a name begins with: "M_z" of "M_z_max"; empty if it has none.
std::string_view symbol_in(const std::string& name, const Record& record) {
  std::string_view longest;
  for (const FieldInfo& field : record.type->fields) {
    const std::string_view stem = stem_of_key(field.key);
    if (field.is_load && field.is_number() && stem.size() > longest.size() && name.size() > stem.size() + 1 &&
        name.starts_with(stem) && name[stem.size()] == '_' && !std::isnan(find_leaf(record, field.key).get()))
      longest = stem;
  }
  return longest;
}

/// Whether a value of [values] is named as such a load in service, at a start, a jam or a test: "F_r", "T_start",
/// "F_Ed", "T_fan" of T and F. Pressures of valves and of a vacuum have rules of their own, as have components: "F_a".
bool is_named_as_load(const std::string& name, const std::string& symbol) {
  const std::size_t end = name.rfind('_');
  if (end == std::string::npos || name == symbol) return name == symbol;
  const bool is_short = name.size() - end <= 3 && !has_word(name.substr(end + 1), {"ed", "sd", "t"});
  const bool is_component = is_short || has_word(name, {"side", "lateral", "transverse"});
  const bool is_other = (is_of_other_state(name) && !is_of_peak(name)) || is_component;
  const bool is_of_valve = symbol == "p" && (is_of_vacuum(name) || has_word(name, {"valve", "fill", "set", "relief"}));
  return is_same_letter(name[0], symbol[0]) && !is_other && !is_of_valve;
}

/// A stress is not a load that another one of [values] could be meant for: that may be a strength.
bool is_comparable(const FieldInfo& field) {
  const Meant kind = kind_of_field({field.key, field.doc, field.unit, field.dimension, field.kind});
  const bool is_stress = kind == Meant::normal_stress || kind == Meant::shear_stress ||
                         kind == Meant::equivalent_stress || kind == Meant::uniaxial_stress;
  return field.is_load && field.is_number() && !is_stress;
}

/// The input with the largest load of a dimension, and that load.
struct LargestLoad {
  std::string path;
  double si = 0.0;
  const char* unit = "";
};

/// A load that is given, or that a search finds: the largest that passes.
double load_at(const Step& step, const Project& project, const std::string& path) {
  double own = std::abs(own_value(step, project, path));
  if (std::isnan(own)) own = std::abs(magnitude_at(project, step.name() + "." + path));
  const bool is_of_power = std::isnan(own) && path == "T";
  return is_of_power ? std::abs(own_value(step, project, "P") / own_value(step, project, "n")) : own;
}

/// Whether the load is computed from this value of [values].
bool is_computed_from(const Step& step, const std::string& path, const std::string& value) {
  const auto typed = step.input().reading.typed.find(path);
  if (typed != step.input().reading.typed.end() && typed->second.shared == value) return true;
  const Operand* const operand = step.input().reading.operand(path);
  return operand != nullptr && std::ranges::any_of(operand->expression.references(),
                                                   [&](const auto& reference) { return reference.path == value; });
}

/// Whether a peak is one of a value that the load is computed from: "Q_test" next to F = "=values.phi*values.Q".
bool is_peak_of_source(const Step& step, const std::string& path, const std::string& name) {
  const std::size_t end = name.rfind('_');
  if (end == std::string::npos) return false;
  const std::string index = name.substr(end + 1);
  return (is_of_peak(index) || index == "test") && is_computed_from(step, path, "values." + name.substr(0, end));
}

/// Whether a step has such a load, or a drive such a torque.
bool carries(const Step& step, const Project& project, const std::string& name, double si, const Dimension& dimension) {
  constexpr double rounded = 0.98;
  bool found = false;
  const double factors = factors_included(name, step, project);
  for_each_leaf(step.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
    const bool is_peak = std::string_view(leaf.field->key).ends_with("_max");
    const bool is_such = is_comparable(*leaf.field) && !is_peak && leaf.field->dimension == dimension;
    found = found || (is_such && load_at(step, project, path) * factors >= rounded * si);
  });
  if (found || !(dimension == Dimension::of(2, 1, -2))) return found;
  const double u = own_value(step, project, "z_2") / own_value(step, project, "z_1");
  if (std::abs(own_value(step, project, "T_1")) * u * factors >= rounded * si) return true;  // of the wheel
  constexpr std::array torques{".T_1", ".T_2", ".T_out"};
  return std::ranges::any_of(torques, [&](const char* key) {
    return std::abs(magnitude_at(project, step.name() + key)) * factors >= rounded * si;
  });
}

/// Whether the load of a value is carried: that of a part of the machine by any step, a largest one by a part of the
/// same kind, as the moment of the edge column of a frame.
bool is_carried(const Step& step, const Project& project, const std::string& name, double si,
                const Dimension& dimension) {
  const bool is_peak = is_of_peak(name);
  return std::ranges::any_of(project.steps, [&](const auto& other) {
    const bool is_alike = other.get() != &step && id_of(*other) == id_of(step);
    return (is_alike || !(is_peak || id_of(step) == "mechanism.planar")) &&
           carries(*other, project, name, si, dimension);
  });
}

LargestLoad largest_load(const Step& step, const Project& project, const std::string& name,
                         const Dimension& dimension) {
  LargestLoad largest;
  const std::string_view symbol = symbol_in(name, step.input().reading.record);
  for_each_leaf(step.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
    const bool is_meant = is_named_as_load(name, leaf.field->key) || is_peak_of_source(step, path, name);
    if (!symbol.empty() && stem_of_key(leaf.field->key) != symbol) return;
    if (!is_comparable(*leaf.field) || !is_meant || !(leaf.field->dimension == dimension)) return;
    const double si = load_at(step, project, path);
    if (si > largest.si) largest = {path, si, leaf.field->unit};
  });
  return largest;
}

/// The application factor under the symbols of other standards: K_o of AGMA, c_B of belts.
bool is_other_symbol_of_application_factor(std::string_view name) {
  constexpr std::array<std::string_view, 9> names{
      "K_o", "K_O", "k_A", "c_B", "f_B", "service_factor", "application_factor", "overload_factor", "duty_factor"};
  return std::ranges::find(names, name) != names.end();
}

/// A factor of the step under the name of the value, with another number: "K_A".
void compare_factor(const Step& step, const Project& project, const std::string& name, double si,
                    std::vector<ReducedLoad>& found) {
  constexpr double same = 1e-6;
  const auto& inputs = step.input().calculator->input->fields;
  const bool is_other_symbol = is_other_symbol_of_application_factor(name) && find_field(inputs, name) == nullptr;
  const std::string key = is_other_symbol ? "K_A" : name;
  const FieldInfo* const field = find_field(inputs, key);
  if (field == nullptr || !field->is_factor || !field->dimension.is_number()) return;
  const double own = own_value(step, project, key);
  if (std::abs(own) >= si * (1.0 - same)) return;
  constexpr double usual_of_walls = 1.5;  // which the allowable stress of a wall includes
  const bool is_included = key == "S" && std::isnan(own) && !std::isnan(own_value(step, project, "sigma_adm")) &&
                           std::string_view(step.input().calculator->id).starts_with("vessel.");
  if (is_included && si <= usual_of_walls) return;
  found.push_back(not_taken(name, format_number(si, 6), key, std::isnan(own) ? "not given" : format_number(own, 6)));
}

/// A component of the load that a step may be given in addition to others: axial forces, bending moments.
bool is_component(std::string_view name) {
  constexpr std::array<std::string_view, 16> names{"F_a", "F_x",   "F_y",   "F_z", "F_r0", "F_a0",   "M_b", "M_y",
                                                   "M_z", "M_y_1", "M_z_1", "q_y", "q_z",  "M_tmax", "N",   "V"};
  return std::ranges::find(names, name) != names.end();
}

/// Bending of a bar that is assessed in compression only.
bool bends_a_bar(std::string_view name, const Dimension& dimension) {
  constexpr std::array<std::string_view, 13> names{"M_b", "M_y", "M_z", "M_y_1", "M_z_1", "q_y", "q_z",
                                                   "F_y", "F_z", "q",   "H",     "F_H",   "V"};
  const bool is_named = std::ranges::find(names, name) != names.end() || name.starts_with("q_") ||
                        name.starts_with("H_") || has_word(name, {"side", "lateral", "transverse"});
  return is_named && (dimension == Dimension::of(2, 1, -2) || dimension == Dimension::of(1, 1, -2) ||
                      dimension == Dimension::of(0, 1, -2));
}

/// "q_wind", "M_bend", "M_b_max" next to a step without such a load.
bool is_component_by_word(std::string_view name) {
  return is_component(name) || name.starts_with("q_") || has_word(name, {"bend", "bending"});
}

/// A component under the name of an input that is not given, if no other step has it; or a bending moment of a shaft
/// that is assessed in torsion only.
void compare_component(const Step& step, const Project& project, const std::string& name, const Value& value,
                       std::vector<ReducedLoad>& found) {
  const double si = std::abs(value.si.front());
  const FieldInfo* const same = find_field(step.input().calculator->input->fields, name);
  const FieldInfo* const line = find_field(step.input().calculator->input->fields, "q_z");
  const FieldInfo* const field = same == nullptr && name.starts_with("q_") ? line : same;
  const bool is_input = field != nullptr && is_comparable(*field) && field->dimension == value.signature.dimension;
  const bool is_bending = (name == "M_b" || has_word(name, {"bend", "bending"})) && id_of(step) == "shaft.torsion" &&
                          value.signature.dimension == Dimension::of(2, 1, -2);
  if (si == 0.0 || !(is_input || is_bending)) return;
  const std::string key = is_input ? field->key : name;
  const auto has_it = [&](const auto& other) {
    if (other.get() == &step) return false;
    if (is_bending && (id_of(*other) == "shaft.design" || id_of(*other) == "shaft.overhung")) return true;
    return std::abs(own_value(*other, project, key)) >= si;
  };
  if (std::ranges::any_of(project.steps, has_it) || std::abs(own_value(step, project, key)) >= si) return;
  if (is_bending)
    return found.push_back({"T", say("values.{1} acts on no step, and bending is not assessed here: replace this with "
                                     "a step of shaft.design or shaft.overhung, or because.T = \"...\"",
                                     name)});
  found.push_back({key, say("values.{1} = {2} acts on no step, and {3} is not given here: refer to it, delete it, or "
                            "justify it: because.{3} = \"...\"",
                            name, format_quantity(si, field->unit, 4), key)});
}

/// "thrust", "F_ax_fan": forces along the axis by their words.
bool is_axial(const std::string& name, const Dimension& dimension) {
  return dimension == Dimension::of(1, 1, -2) &&
         (has_word(name, {"thrust", "axial", "ax"}) || name.starts_with("F_a_")) &&
         !has_word(name, {"adm", "lim", "max", "capacity", "rated", "zul", "perm"});
}

/// The largest axial force that a shaft or a bearing of the file is given.
double axial_force(const Step& shaft, const Project& project) {
  double most = 0.0;
  for_each_leaf(shaft.input().reading.record, [&](const std::string& path, const Leaf&) {
    if (path.starts_with("seats") && path.ends_with(".F_z")) most = std::fmax(most, load_at(shaft, project, path));
  });
  for (const auto& other : project.steps) most = std::fmax(most, std::abs(own_value(*other, project, "F_a")));
  return most * (1.0 + 1e-3);
}

/// Whether a mounted component has a force of this size, or a step finds it under this name.
bool is_on_shaft(const Step& shaft, const Project& project, const std::string& name, double si) {
  constexpr double rounded = 0.02;
  bool found = false;
  for_each_leaf(shaft.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
    const bool is_force = leaf.field->dimension == Dimension::of(1, 1, -2);
    found = found || (path.starts_with("seats") && is_force && is_near(load_at(shaft, project, path), si, rounded));
  });
  return found || std::ranges::any_of(project.steps, [&](const auto& other) {
           return is_near(std::abs(magnitude_at(project, other->name() + "." + name)), si, rounded);
         });
}

bool says_axial(std::string_view doc) { return doc.find("axial force") != std::string_view::npos; }

/// An axial force above those that the mounted components of a shaft have.
void compare_axial(const Step& step, const Project& project, const std::string& name, const Value& value,
                   std::vector<ReducedLoad>& found) {
  const double si = std::abs(value.si.front());
  if (!is_axial(name, value.signature.dimension) || si <= axial_force(step, project)) return;
  for (const FieldInfo& field : step.input().calculator->input->fields) {
    const bool is_along = field.is_load && field.dimension == value.signature.dimension && says_axial(field.doc);
    if (!is_along || load_at(step, project, field.key) > 0.0) continue;
    return found.push_back({field.key, say("values.{1} acts on no step, and {2} is not given here: refer to it, delete "
                                           "it, or justify it: because.{2} = \"...\"",
                                           name, field.key)});
  }
  if (id_of(step) != "shaft.design") return;
  found.push_back({"seats", say("values.{1} acts on no step, and no mounted component has this axial force: refer to "
                                "it, delete it, or justify it: because.seats = \"...\"",
                                name)});
}

/// A bending load next to a bar in compression, or a component that no mounted part of a shaft has.
void compare_bending(const Step& step, const Project& project, const std::string& name, const Value& value,
                     std::vector<ReducedLoad>& found) {
  const std::string_view id = id_of(step);
  const double si = std::abs(value.si.front());
  const Dimension& dimension = value.signature.dimension;
  const auto is_beam = [](const auto& one) {
    return id_of(*one) == "column.beam_column" || id_of(*one) == "link.member";
  };
  const bool is_bar = id == "column.buckling" || id == "column.lightest" || id == "column.stepped";
  if (si == 0.0 || std::ranges::any_of(project.steps, is_beam)) return;
  const std::string load = id == "column.stepped" ? "parts" : "P";
  if (is_bar && bends_a_bar(name, dimension))
    return found.push_back({load, say("values.{1} acts on no step, and bending is not assessed here: replace this with "
                                      "a step of column.beam_column, or because.{2} = \"...\"",
                                      name, load)});
  const bool is_along_axis = name == "F_x" || name == "F_y" || name == "F_z";
  const bool is_pull = name.starts_with("F_") && has_word(name, {"belt", "belts", "chain", "rope", "pull", "pulley"}) &&
                       !is_of_other_state(name);
  const bool is_of_tooth = (name == "F_r" || name == "F_t" || is_pull) && !is_on_shaft(step, project, name, si);
  const bool is_force = dimension == Dimension::of(1, 1, -2) && (is_along_axis || is_of_tooth);
  const bool is_moment = dimension == Dimension::of(2, 1, -2) && name == "M_b";
  if (id == "shaft.design" && (is_force || is_moment))
    found.push_back(
        {"seats", say("values.{1} acts on no step, and no mounted component has it: refer to it, delete it, "
                      "or justify it: because.seats = \"...\"",
                      name)});
  if (id == "shaft.press_fit" && is_moment)
    found.push_back({"T", say("values.{1} acts on no step, and bending may open the joint: assess it separately, "
                              "because.T = \"...\"",
                              name)});
}

}  // namespace

std::vector<ReducedLoad> loads_left_out(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  for (const auto& [name, value] : project.values.unused()) {
    const double si = std::abs(value.si.front());
    if (value.signature.dimension.is_number()) compare_factor(step, project, name, si, found);
    const LargestLoad own = largest_load(step, project, name, value.signature.dimension);
    if (project.values.kind(name) == Meant::work) continue;
    if (std::abs(own_value(step, project, name)) >= si) continue;  // it has the value under its own name
    compare_axial(step, project, name, value, found);
    if (own.path.empty()) compare_bending(step, project, name, value, found);
    if (own.path.empty() && is_component_by_word(name)) compare_component(step, project, name, value, found);
    if (own.path.empty() || !(si > own.si) || si > implausible_ratio * own.si) continue;
    if (name != own.path && is_carried(step, project, name, si, value.signature.dimension)) continue;
    const std::string key = own.path.substr(0, own.path.find_first_of(".["));
    found.push_back(
        {key, say("values.{1} = {2} acts on no step, and {3} is {4}: refer to it, delete it, or justify it: "
                  "because.{5} = \"...\"",
                  name, format_quantity(si, own.unit, 4), own.path, format_quantity(own.si, own.unit, 4), key)});
  }
  return found;
}

}  // namespace loadpath::project
