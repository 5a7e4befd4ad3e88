#include "lib/project/references/stated/results.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double rounded = 0.05;  // of a result that the file states with few digits
constexpr double kept = 1e-3;     // of a limit

using stated::duration;
using stated::speed;

const FieldInfo* field_of(const Step& step, const std::string& name, bool of_results) {
  const Calculator* const calculator = step.input().calculator;
  if (!of_results) return find_field(calculator->input->fields, name);
  return calculator->result == nullptr ? nullptr : find_field(calculator->result->fields, name);
}

bool is_of_rotation(const Dimension& dimension) {
  return dimension.without_angle() == stated::rate && !(dimension == stated::rate);
}

/// Sizes, speeds, times; loads, stresses, masses and energies under such names may be those of another state.
bool is_comparable(const Dimension& dimension) {
  return dimension == stated::length || dimension == speed || dimension == duration || is_of_rotation(dimension);
}

double input_at(const Step& step, const Project& project, const std::string& name, const Dimension& dimension) {
  const FieldInfo* const field = field_of(step, name, false);
  const bool is_of_it = field != nullptr && field->is_number() && field->dimension == dimension;
  if (!is_of_it) return std::nan("");
  const double own = std::abs(own_value(step, project, name));
  return std::isnan(own) ? std::abs(magnitude_at(project, step.name() + "." + name)) : own;  // of a row
}

double result_at(const Step& step, const Project& project, const std::string& name, const Dimension& dimension) {
  const FieldInfo* const field = field_of(step, name, true);
  const bool is_of_it = field != nullptr && field->is_number() && field->dimension == dimension;
  return is_of_it ? std::abs(magnitude_at(project, step.name() + "." + name)) : std::nan("");
}

/// Whether a step has the ratio i, as a belt or a whole train; otherwise i is the ratio u of gears.
bool has_ratio(const Project& project) {
  return std::ranges::any_of(project.steps, [](const auto& step) { return field_of(*step, "i", true) != nullptr; });
}

/// The value of a step that a result of [values] means. Inputs under the names of ratios and speeds are others: the
/// number of keys i, the last speed n_2 of a start.
double meant_result(const Step& step, const Project& project, const std::string& name, const Dimension& dimension) {
  const double own = input_at(step, project, name, dimension), found = result_at(step, project, name, dimension);
  if (dimension.is_number()) return has_ratio(project) ? found : result_at(step, project, "u", dimension);
  return is_of_rotation(dimension) || std::isnan(own) ? found : own;
}

double limited_value(const Step& step, const Project& project, const std::string& name, const Dimension& dimension) {
  const double own = input_at(step, project, name, dimension);
  return std::isnan(own) ? result_at(step, project, name, dimension) : own;
}

using ValueOf = double (*)(const Step&, const Project&, const std::string&, const Dimension&);

/// Whether all steps with a value of this name have the same one: a size of several parts is that of any of them.
bool is_one(const Project& project, const std::string& name, const Dimension& dimension, double here,
            ValueOf value_of) {
  return std::ranges::all_of(project.steps, [&](const auto& step) {
    const double there = value_of(*step, project, name, dimension);
    return std::isnan(there) || is_near(there, here, rounded);
  });
}

/// The input that a reason belongs to: the first load that is given, or else the first quantity.
std::string reason_for(const Step& step, const Project& project) {
  std::string first;
  for (const FieldInfo& field : step.input().calculator->input->fields) {
    if (!field.is_number() || std::isnan(own_value(step, project, field.key))) continue;
    if (field.is_load && !field.dimension.is_number()) return field.key;
    if (first.empty() && step.input().reading.typed.contains(field.key)) first = field.key;
  }
  return first;
}

class Results {
 public:
  Results(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) {
      const Dimension& dimension = value.signature.dimension;
      const double si = std::abs(value.si.front());
      const bool is_input = field_of(step_, name, false) != nullptr && !is_of_rotation(dimension) && name != "i";
      if (si == 0.0 || is_input) continue;  // compared as an input
      compare_result(name, si, dimension);
      const bool is_speed = has_only_words(name, {"n", "omega", "speed", "strokes", "spm"});
      if (is_of_rotation(dimension) && is_speed) compare_speed(name, si);
      if (is_comparable(dimension)) compare_limit(name, si, dimension);
    }
    return std::move(found_);
  }

 private:
  void compare_result(const std::string& name, double stated, const Dimension& dimension) {
    const bool is_ratio = dimension.is_number() && name == "i";
    if (!is_ratio && (!is_comparable(dimension) || dimension == duration)) return;
    const double here = meant_result(step_, project_, name, dimension);
    if (std::isnan(here) || is_near(here, stated, rounded) || !is_one(project_, name, dimension, here, &meant_result))
      return;
    add(name, stated, name, here, dimension);
  }

  /// "n = 3000 rpm" next to a crank at another speed, if no step has this one.
  void compare_speed(const std::string& name, double stated) {
    const double here = own_value(step_, project_, "crank.speed");
    if (std::isnan(here) || std::ranges::any_of(project_.steps, [&](const auto& step) { return turns(*step, stated); }))
      return;
    found_.push_back(
        {"crank", say("values.{1} = {2} acts on no step, and crank.speed is {3} here: correct one of them, "
                      "delete the value, or justify it: because.crank = \"...\"",
                      name, format_quantity(stated, "rpm", 4), format_quantity(here, "rpm", 4))});
  }

  /// Whether an input or a result of the step is this speed.
  [[nodiscard]] bool turns(const Step& step, double stated) const {
    const auto is_it = [&](double si) { return is_near(std::abs(si), stated, rounded); };
    bool found = false;
    for_each_leaf(step.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      found = found || (is_of_rotation(leaf.field->dimension) && is_it(own_value(step, project_, path)));
    });
    return found;
  }

  /// "v_max = 10 m/s" next to v = 12 m/s, "d_min" next to a smaller d.
  void compare_limit(const std::string& name, double stated, const Dimension& dimension) {
    const bool is_upper = name.ends_with("_max") || name.ends_with("_lim");
    if (!is_upper && !name.ends_with("_min")) return;
    const std::string limited = name.substr(0, name.size() - 4);
    const double here = limited.empty() ? std::nan("") : limited_value(step_, project_, limited, dimension);
    const bool is_broken = is_upper ? here > (1.0 + kept) * stated : here < (1.0 - kept) * stated;
    if (is_broken && is_one(project_, limited, dimension, here, &limited_value))
      add(name, stated, limited, here, dimension);
  }

  void add(const std::string& name, double stated, const std::string& key, double here, const Dimension& dimension) {
    const std::string reason = reason_for(step_, project_);
    if (reason.empty()) return;
    const FieldInfo* field = field_of(step_, key, false);
    if (field == nullptr) field = field_of(step_, key, true);
    if (field == nullptr && !dimension.is_number()) return;
    const auto shown = [&](double si) {
      return dimension.is_number() ? format_number(si, 4) : format_quantity(si, field->unit, 4);
    };
    found_.push_back({reason, say("values.{1} = {2} acts on no step, and {3} is {4} here: correct one of them, delete "
                                  "the value, or justify it: because.{5} = \"...\"",
                                  name, shown(stated), key, shown(here), reason)});
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> results_stated_otherwise(const Step& step, const Project& project) {
  return Results(step, project).run();
}

}  // namespace loadpath::project
