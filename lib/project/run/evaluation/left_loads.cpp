#include "lib/project/run/evaluation/left_loads.hpp"

#include "lib/project/references/references.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

constexpr double tolerance = 0.01;  // of a force calculated by hand, with a rounded angle

/// The value of largest magnitude, with its sign; 0 if it is unknown.
double extreme_of(const Value& value) {
  double most = 0.0;
  for (const double x : value.si) {
    if (std::abs(x) > std::abs(most)) most = x;
  }
  return most;
}

double extreme_of(const Inputs& inputs, const std::string& path) {
  const Leaf leaf = inputs.leaf(path);
  return leaf && leaf.field->is_load && leaf.field->is_number() ? extreme_of(inputs.value_of(path, leaf)) : 0.0;
}

/// Whether inputs other than that of the other component have this one, in its direction: F also as F_x and F_y.
bool is_held(const LoadComponent& one, const Inputs& inputs, double component) {
  const std::string prefix = prefix_of(one.input), key = one.path.substr(one.path.rfind('.') + 1);
  const double own = extreme_of(inputs, prefix + key);
  const double least = (1.0 - tolerance) * std::abs(component);
  if (own * component > 0.0 && std::abs(own) >= least) return true;
  return std::hypot(extreme_of(inputs, prefix + key + "_x"), extreme_of(inputs, prefix + key + "_y")) >= least;
}

/// Whether a step takes torque: a rolling bearing and a pin in a loose fit transmit none.
bool takes_moments(const PreparedStep& step) {
  const auto& fields = step.input().calculator->input->fields;
  return std::any_of(fields.begin(), fields.end(), [](const FieldInfo& field) {
    return field.is_load && field.dimension == Dimension::of(2, 1, -2);
  });
}

bool is_torque(const LoadComponent& one) { return one.path.ends_with(".T"); }

}  // namespace

bool acts(const Value& value) {
  return std::any_of(value.si.begin(), value.si.end(), [&](double x) { return !(std::abs(x) <= value.rounding); });
}

std::string left_loads(const PreparedStep& step, const Inputs& inputs, const Known& known) {
  std::string names;
  for (const LoadComponent& one : step.components_not_included()) {
    if (is_torque(one) && !takes_moments(step)) continue;
    const Value& value = known(one.path);
    const double component = extreme_of(value);
    // An unknown component may act.
    if (!acts(value) || (component != 0.0 && is_held(one, inputs, component))) continue;
    names += (names.empty() ? "" : ", ") + one.path;
  }
  return names;
}

}  // namespace loadpath::project
