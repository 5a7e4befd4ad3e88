#include "lib/project/references/origins.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/references/notches.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace loadpath::project {

namespace {

thread_local NotedReads* noting = nullptr;

/// The value of largest magnitude; NaN if there is none.
double magnitude(const Value& value) {
  double most = std::nan("");
  for (const double si : value.si) {
    if (!std::isnan(si) && !(std::abs(si) <= std::abs(most))) most = si;
  }
  return most;
}

}  // namespace

NotedReads::NotedReads() { noting = this; }
NotedReads::~NotedReads() { noting = nullptr; }
void NotedReads::note(const std::string& path) {
  if (noting != nullptr) noting->paths_.insert(path);
}

std::string because_key(const std::string& path) {
  const bool is_plain = path.find_first_of(".[") == std::string::npos;
  return is_plain ? "because." + path : "because.\"" + path + "\"";
}

double magnitude_at(const Project& project, const std::string& path) {
  NotedReads::note(path);
  const Value* const value = project.value(path);
  return value == nullptr ? std::nan("") : magnitude(*value);
}

namespace {

double magnitude_of(const Operand& operand, const Project& project) {
  static const Value none{{}, {std::nan("")}};
  return magnitude(operand.expression.evaluate([&](const std::string& path) -> const Value& {
    const Value* const value = project.value(path);
    return value == nullptr ? none : *value;
  }));
}

/// Whether an input at this path may have a value at some point: elements of a list may come with another point.
bool is_of_input(const Step& step, const std::string& path) {
  return find_field_at(step.input().calculator->input->fields, path) != nullptr;
}

}  // namespace

double own_value(const Step& step, const Project& project, const std::string& path) {
  const auto& operands = step.input().reading.operands;
  const Leaf leaf = find_leaf(step.input().reading.record, path);
  const auto fills = [&](const Operand& o) {  // of a named element the path has the name, or the number
    return o.path == path || (leaf && o.leaf.field == leaf.field && o.leaf.owner == leaf.owner);
  };
  const auto operand = std::find_if(operands.begin(), operands.end(), fills);
  if (leaf || operand != operands.end() || is_of_input(step, path)) NotedReads::note(step.name() + "." + path);
  if (operand != operands.end()) return magnitude_of(*operand, project);
  return leaf && leaf.field->is_number() ? leaf.get() : std::nan("");
}

bool is_strength(std::string_view what) { return strength_bound_of(what) != nullptr; }

bool means(const Calculator& calculator, const std::string& path, bool (*is_it)(std::string_view what)) {
  return std::any_of(calculator.meanings.begin(), calculator.meanings.end(), [&](const Meaning& meaning) {
    const auto fields = listed_keys(meaning.fields);
    return is_it(meaning.what) &&
           std::any_of(fields.begin(), fields.end(), [&](const std::string& field) { return names_row(field, path); });
  });
}

bool connects(const Step& step) {
  const Calculator* const calculator = step.input().calculator;
  if (calculator->result == nullptr) return false;
  const FieldInfo* const connection = find_field(calculator->result->fields, "connection");
  return makes_notch(&step) || (connection != nullptr && connection->is_handed_over);
}

std::string material_of(const Step& step) {
  const auto row = step.input().rows.find("material");
  return row == step.input().rows.end() ? "" : row->second.text;
}

namespace {

constexpr double most_apart = 1e-3;
constexpr int most_stages = 12;

const Dimension of_stress = Dimension::of(-1, 1, -2);

bool is_strength_of_metal(std::string_view what) {
  return strength_bound_of(what) != nullptr && what != crushing_stress;
}
bool is_limit_of_part(std::string_view what) { return what == limit_in_normal || what == limit_in_shear; }
bool is_fatigue_limit(std::string_view what) {
  return is_strength_of_metal(what) && !is_allowable(what) && what != yield_strength;
}
bool is_speed_ratio(std::string_view what) { return what == ratio_of_speeds; }

/// The shaft with the diameter of a connection: "sh" of d = "=sh.d"; empty if it names none.
std::string shaft_of(const Step& step) {
  if (!connects(step)) return {};
  for (const Operand& operand : step.input().reading.operands) {
    const bool is_diameter = operand.path == "d" || operand.path == "d_1" || operand.path == "d_w";
    if (!is_diameter || !operand.expression.is_reference()) continue;
    const auto [name, rest] = split_step(operand.expression.references().front().path);
    if (rest == "d") return std::string(name);
  }
  return {};
}

}  // namespace

bool is_compression_of_bar(const FieldInfo& field) { return field.shared_as == std::string_view("compression"); }

bool is_one_of_outputs(const Step& step, const Project& project, const std::string& shaft) {
  constexpr double least_efficiency = 0.85;
  if (shaft.empty() || shaft_of(step) != shaft) return false;
  const double all = std::abs(magnitude_at(project, shaft + ".T"));
  double outputs = 0.0;
  bool has_input = false;
  for (const auto& other : project.steps) {
    if (shaft_of(*other) != shaft) continue;
    const double T = std::abs(own_value(*other, project, "T"));
    if (T >= all * (1.0 - most_apart))
      has_input = true;
    else if (!std::isnan(T))
      outputs += T;
  }
  return has_input && outputs >= least_efficiency * all;
}

namespace {

class OriginCheck {
 public:
  OriginCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const Operand& operand : step_.input().reading.operands) {
      compare_strength(operand);
      compare_limit(operand);
      compare_ratio(operand);
      compare_torque(operand);
      compare_component(operand);
      compare_joint(operand);
    }
    for (const auto* all : {&step_.input().reading.operands, &step_.input().reading.whole}) {
      for (const Operand& operand : *all) compare_part(operand);
    }
    compare_direction();
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  const Calculator& calculator() const { return *step_.input().calculator; }

  /// A strength above those of other steps that it is computed from.
  void compare_strength(const Operand& operand) {
    if (operand.expression.is_reference() || !means(calculator(), operand.path, &is_strength_of_metal)) return;
    std::string highest;
    double most = 0.0;
    for (const auto& reference : operand.expression.references()) {
      const Step* const source = project_.find(split_step(reference.path).first);
      const Value* const value = project_.value(reference.path);
      if (source == nullptr || value == nullptr || value->signature.dimension != of_stress) continue;
      const double si = std::abs(magnitude(*value));
      if (si > most) most = si, highest = reference.path;
    }
    if (!highest.empty() && magnitude_of(operand, project_) > most * (1.0 + most_apart))
      add(operand.path, say("{1} is above '{2}', from which it is computed; justify it: because.{1} = \"...\"",
                            operand.path, highest));
  }

  /// A fatigue limit of another material, or of a part of another diameter at heat treatment.
  void compare_limit(const Operand& operand) {
    if (!means(calculator(), operand.path, &is_fatigue_limit)) return;
    for (const auto& reference : operand.expression.references()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const source = project_.find(name);
      if (source == nullptr || source == &step_) continue;
      if (!means(*source->input().calculator, rest, &is_fatigue_limit)) continue;
      compare_materials(operand.path, *source, reference.path);
      if (means(calculator(), operand.path, &is_limit_of_part)) compare_sizes(operand.path, *source, reference.path);
    }
  }

  void compare_materials(const std::string& path, const Step& source, const std::string& limit) {
    const std::string own = named_material(step_, project_), theirs = named_material(source, project_);
    if (own.empty() || theirs.empty() || own == theirs) return;
    add(path, say("'{2}' is a fatigue limit of {3}, and the material here is {4}: because.{1} = \"...\"", path, limit,
                  theirs, own));
  }

  void compare_sizes(const std::string& path, const Step& source, const std::string& limit) {
    const double own = own_value(step_, project_, "d_h");
    const double treated = magnitude_at(project_, source.name() + ".d_h"),
                 d = magnitude_at(project_, source.name() + ".d");
    const double theirs = std::isnan(treated) ? d : treated;
    if (std::isnan(own) || std::isnan(theirs) || !has_other_strength(own, theirs)) return;
    add(path, say("'{2}' is a fatigue limit for a diameter at heat treatment of {3}, and d_h here is {4}: "
                  "because.{1} = \"...\"",
                  path, limit, format_quantity(theirs, "mm", 4), format_quantity(own, "mm", 4)));
  }

  /// Whether the material of the step has another strength at another size; without a row any size counts.
  bool has_other_strength(double size, double other) const {
    if (is_near(other, size, most_apart)) return false;
    const auto row = step_.input().tables->find_row("material", material_of(step_));
    if (!row) return true;
    const auto differs = [&](const char* column) {
      const auto here = table::property(*row, column, size), there = table::property(*row, column, other);
      return !here || !there ? !here != !there : here->si != there->si;
    };
    return differs("R_m") || differs("R_e");
  }

  /// A ratio of speeds computed from one ratio is that or its reciprocal.
  void compare_ratio(const Operand& operand) {
    if (!means(calculator(), operand.path, &is_speed_ratio)) return;
    std::set<std::string> paths;
    for (const auto& reference : operand.expression.references()) paths.insert(reference.path);
    if (paths.size() != 1 || project_.find(split_step(*paths.begin()).first) == nullptr) return;
    const Value* const source = project_.value(*paths.begin());
    if (source == nullptr || !source->signature.dimension.is_number()) return;  // not a ratio
    const double ratio = std::abs(magnitude_at(project_, *paths.begin())),
                 own = std::abs(magnitude_of(operand, project_));
    const auto is = [&](double other) { return is_near(own, other, most_apart); };
    if (!(ratio > 0.0) || std::isnan(own) || is(ratio) || is(1.0 / ratio)) return;
    add(operand.path, say("{1} = {2} is neither '{3}' = {4} nor its reciprocal; justify it: because.{1} = \"...\"",
                          operand.path, format_number(own, 4), *paths.begin(), format_number(ratio, 4)));
  }

  /// A connection on the shaft of another step, and a torque below that of this shaft.
  void compare_torque(const Operand& operand) {
    if (operand.path != "d" && operand.path != "d_1" && operand.path != "d_w") return;
    const std::string name = shaft_of(step_);
    const Step* const shaft = project_.find(name);
    if (shaft == nullptr || connects(*shaft) || is_one_of_outputs(step_, project_, name)) return;
    const double theirs = std::abs(magnitude_at(project_, name + ".T")),
                 own = std::abs(own_value(step_, project_, "T"));
    if (!(own < theirs * (1.0 - most_apart))) return;
    add("T", say("T is less than '{1}.T' of the shaft with this diameter; justify it: because.T = \"...\"", name));
  }

  /// A belt that turns its second shaft the other way than the stage of the train with its pulleys.
  void compare_direction() {
    const Leaf arrangement = find_leaf(step_.input().reading.record, "arrangement");
    if (!arrangement || arrangement.field->type != FieldInfo::Type::choice) return;
    const bool is_crossed = word_of(arrangement) == "crossed";
    const double d_1 = own_value(step_, project_, "d_1"), d_2 = own_value(step_, project_, "d_2");
    std::set<std::string> trains;
    for_each_reference(step_.input().reading, [&](const std::string& path) { trains.insert(split_step(path).first); });
    for (const std::string& train : trains) {
      for (int k = 1; k <= most_stages; ++k) {
        const std::string stage = train + ".stages[" + std::to_string(k) + "].";
        const double i = magnitude_at(project_, stage + "i");
        if (std::isnan(i)) break;
        if (magnitude_at(project_, stage + "d_1") != d_1 || magnitude_at(project_, stage + "d_2") != d_2) continue;
        if ((i < 0.0) == is_crossed) continue;
        add("arrangement",
            say("arrangement = \"{1}\" contradicts the direction of '{2}i' = {3}: correct one of them, or "
                "because.arrangement = \"...\"",
                word_of(arrangement), stage, format_number(i, 4)));
      }
    }
  }

  /// A stress that acts together with another one at the same point, which the step leaves out.
  void compare_part(const Operand& operand) {
    constexpr double negligible = 0.02;
    for (const auto& reference : operand.expression.references()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const source = project_.find(name);
      const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
      if (field == nullptr || field->dimension != of_stress || operand.leaf.field->dimension != of_stress) continue;
      const double own = std::abs(magnitude_at(project_, reference.path));
      for (const std::string& key : listed_keys(field->companions)) {
        const std::string other = std::string(name).append(".").append(key);
        if (refers_to(other) || !(std::abs(magnitude_at(project_, other)) > negligible * own)) continue;
        return add(operand.path, say("'{2}' acts together with '{3}': use the stresses that include both, or "
                                     "because.{1} = \"...\"",
                                     operand.path, reference.path, other));
      }
    }
  }

  bool refers_to(const std::string& path) const {
    bool found = false;
    for_each_reference(step_.input().reading, [&](const std::string& one) { found = found || one == path; });
    return found;
  }

  /// One component of a force whose magnitude the source has, too.
  void compare_component(const Operand& operand) {
    if (!operand.leaf.field->is_load || operand.leaf.field->key != std::string_view("F")) return;
    for (const auto& reference : operand.expression.references()) {
      const std::string prefix = prefix_of(reference.path), key = reference.path.substr(prefix.size());
      if (key != "F_x" && key != "F_y" && key != "x" && key != "y") continue;
      const double whole = std::abs(magnitude_at(project_, prefix + "F"));
      if (!(std::abs(magnitude_of(operand, project_)) < whole * (1.0 - most_apart))) continue;
      add(operand.path, say("{1} is only a component of '{2}F'; write ={2}F, or justify it: because.{1} = \"...\"",
                            operand.path, prefix));
      return;
    }
  }

  /// The force of a guide or a rigid joint, which hold the angle of their links, for a pin.
  void compare_joint(const Operand& operand) {
    if (!operand.leaf.field->is_load || !std::string_view(calculator().id).starts_with("pin.")) return;
    for (const auto& reference : operand.expression.references()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const source = project_.find(name);
      if (source == nullptr || !rest.starts_with("joints.") || !source->signature(prefix_of(rest) + "M")) continue;
      add(operand.path, say("'{2}' is the force of a joint without a pin; justify it: because.{1} = \"...\"",
                            operand.path, reference.path));
      return;
    }
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

namespace {

bool is_of_step(const Expression::Reference& reference) { return !reference.path.starts_with("values."); }

/// Whether an operand is one value of a series.
bool is_reduced_series(const Operand& operand, const Project& project) {
  static const Value none{{}, {std::nan("")}};
  const auto known = [&](const std::string& path) -> const Value& {
    const Value* const value = project.value(path);
    return value == nullptr ? none : *value;
  };
  const auto& references = operand.expression.references();
  return std::any_of(references.begin(), references.end(),
                     [&](const auto& reference) { return known(reference.path).is_series(); }) &&
         !operand.expression.evaluate(known).is_series();
}

/// Whether an input is one that an OriginCheck compares with other steps by its number.
bool compares_number(const Step& step, const Operand& operand, const Project& project) {
  const Calculator& calculator = *step.input().calculator;
  const auto& references = operand.expression.references();
  if (std::none_of(references.begin(), references.end(), &is_of_step)) return false;
  const auto is_part = [&](const Expression::Reference& reference) {
    const auto [name, rest] = split_step(reference.path);
    const Step* const source = project.find(name);
    const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
    const std::string key = rest.substr(rest.rfind('.') + 1);
    return (field != nullptr && field->dimension == of_stress && *field->companions != '\0') ||
           (operand.leaf.field->is_load && (key == "F_x" || key == "F_y" || key == "x" || key == "y"));
  };
  return connects(step) || (is_compression_of_bar(*operand.leaf.field) && is_reduced_series(operand, project)) ||
         means(calculator, operand.path, &is_strength_of_metal) || means(calculator, operand.path, &is_fatigue_limit) ||
         means(calculator, operand.path, &is_speed_ratio) ||
         means(calculator, operand.path, [](std::string_view what) { return what == speed_of_run; }) ||
         std::any_of(references.begin(), references.end(), is_part);
}

}  // namespace

bool compares_numbers(const Step& step, const Project& project) {
  const auto& operands = step.input().reading.operands;
  return find_leaf(step.input().reading.record, "arrangement") ||
         std::any_of(operands.begin(), operands.end(),
                     [&](const Operand& operand) { return compares_number(step, operand, project); });
}

std::vector<ReducedLoad> values_of_others(const Step& step, const Project& project) {
  return OriginCheck(step, project).run();
}

}  // namespace loadpath::project
