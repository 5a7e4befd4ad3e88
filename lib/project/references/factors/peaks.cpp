#include "lib/project/references/factors/peaks.hpp"

#include "lib/project/references/factors/given.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

class Peaks {
 public:
  Peaks(const Step& step, const Project& project) : step_(step), project_(project) {}

  Message missing() const {
    Message peak = missing_peak();
    return peak.empty() ? below_peak() : peak;
  }

 private:
  /// A start or a jam raises the load of the shaft, and so that of the key or spline which it names as its part.
  Message missing_peak() const {
    const auto& inputs = step_.input().calculator->input->fields;
    if (find_field(inputs, "T_max") == nullptr || find_field(inputs, "K_A") == nullptr) return {};
    for (const auto& shaft : project_.steps) {
      const FieldInfo* const field = find_field(shaft->input().calculator->input->fields, "k_max");
      if (field == nullptr || !has_part(*shaft)) continue;
      const double k_max = given_factor(project_, shaft->input(), "k_max");
      const bool waits = std::isnan(k_max) && is_expression(shaft->input(), "k_max");
      if (waits && !is_given(step_.input(), "T_max"))
        return say("{1}.k_max waits for another step; give T_max", shaft->name());
      if (!is_applied(k_max)) continue;
      if (bears(k_max, torque_of(*shaft))) continue;
      return say("T_max is missing or below {1}.k_max = {2} times K_A T; give T_max", shaft->name(),
                 format_number(k_max, 4));
    }
    return {};
  }

  /// The largest torque of the components on a shaft, which its peak factor multiplies; 0 if none is known.
  double torque_of(const Step& shaft) const {
    const auto is_torque = [](const std::string& path) { return path.starts_with("seats[") && path.ends_with("].T"); };
    double most = 0.0;
    for_each_leaf(shaft.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      if (is_torque(path) && !std::isnan(leaf.get())) most = std::max(most, std::abs(leaf.get()));
    });
    for (const Operand& operand : shaft.input().reading.operands) {
      if (is_torque(operand.path)) most = std::max(most, largest_of(project_, operand));
    }
    return most;
  }

  /// Whether T_max covers the peak factor. K_A and k_max are both of one start: with the torque of the shaft known,
  /// the peak is k_max times it, even if K_A T of the step is more.
  bool bears(double k_max, double of_shaft = 0.0) const {
    const auto& inputs = step_.input().calculator->input->fields;
    if (find_field(inputs, "T_max") == nullptr || find_field(inputs, "K_A") == nullptr) return false;
    const double nominal = std::abs(largest_given(project_, step_.input(), "T")),
                 service = std::abs(given_factor(project_, step_.input(), "K_A")) * nominal;
    const double T = of_shaft > 0.0 ? std::min(service, std::max(nominal, of_shaft)) : service;
    const double T_max = std::abs(largest_given(project_, step_.input(), "T_max"));
    return T_max >= k_max * T * (1.0 - 1e-9);
  }

  /// A service load of a step that has a peak factor, taken without it. Fatigue is assessed under service loads.
  Message below_peak() const {
    if (std::string_view(step_.input().calculator->id).starts_with("fatigue.")) return {};
    Message lacks;
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.leaf.field->is_load) continue;
      for (const auto& reference : operand.expression.references()) {
        const auto [name, rest] = split_step(reference.path);
        const Step* const source = project_.find(name);
        const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
        if (field == nullptr || !carries_factors(*field)) continue;
        const FieldInfo* const own = find_field(source->input().calculator->input->fields, "k_max");
        if (own == nullptr || !own->is_factor || !is_applied(factor_of(*source, "k_max"))) continue;
        if (field->is_peak || takes_start_of(name, operand.path)) return {};
        if (bears(factor_of(*source, "k_max"))) return {};
        if (lacks.empty())
          lacks =
              say("'{1}' is the service load without {2}.k_max = {3}; use the peak load (bearing: F_r0, F_a0), "
                  "or write {4} = \"={2}.k_max*...\"",
                  reference.path, name, format_number(factor_of(*source, "k_max"), 4), operand.path);
      }
    }
    return lacks;
  }

  /// Whether the load, or T_max in the same step, includes k_max of that step.
  bool takes_start_of(const std::string& step, const std::string& load) const {
    const std::string k_max = step + ".k_max";
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.path != load && operand.path != "T_max") continue;
      const auto& references = operand.expression.references();
      if (std::any_of(references.begin(), references.end(), [&](const auto& r) { return r.path == k_max; }))
        return true;
    }
    return false;
  }

  /// Whether a record of this step is a part of the other: "=seat.notch".
  bool has_part(const Step& other) const {
    const auto& records = other.input().reading.records;
    return std::any_of(records.begin(), records.end(),
                       [&](const Taken& taken) { return split_step(taken.source).first == step_.name(); });
  }

  const Step& step_;
  const Project& project_;
};

}  // namespace

Message missing_peak(const Step& step, const Project& project) { return Peaks(step, project).missing(); }

}  // namespace loadpath::project
