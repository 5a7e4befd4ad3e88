#include "lib/project/references/factors.hpp"

#include "lib/project/because.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace loadpath::project {

namespace {

/// Factors that a nominal load does not contain.
constexpr std::array factors_of_loads{"K_A", "gamma_F"};

/// A factor of 1 does not count, nor one that is not given.
bool counts(double factor) { return !std::isnan(factor) && factor != 1.0; }

/// The peak torque of a start or a jam, for yielding only: it is stated as it is, with an application factor or
/// without.
bool is_peak(const Operand& operand) { return operand.path == "T_max"; }

/// The first value of a series that is applied.
double factor_in(const std::vector<double>& si) {
  const auto found = std::find_if(si.begin(), si.end(), counts);
  return found == si.end() ? 1.0 : *found;
}

/// The factor that an input of a solved step is.
double input_of(const Step& step, const std::string& key) {
  const Value* const value = step.value(key);
  return value == nullptr ? 1.0 : factor_in(value->si);
}

/// "chain.K_A = 1.4"
Message told(const Factors& factors, const std::string& factor) {
  return say("{1} = {2}", factor, format_number(factors.at(factor), 4));
}

/// A value of [values] that a step has for a factor is that factor: "values.n" the K_A of "chain".
Factors factors_of_shared(const Project& project, const std::string& path) {
  const Value* const value = project.value(path);
  if (value == nullptr || !counts(factor_in(value->si))) return {};
  for (const auto& step : project.steps) {
    for (const auto& [key, typed] : step->input().reading.typed) {
      const FieldInfo* const field = find_field(step->input().calculator->input->fields, key);
      if (typed.shared == path && field != nullptr && field->is_factor)
        return {{step->name() + "." + key, factor_in(value->si)}};
    }
  }
  return {};
}

/// Whether a value of a step includes the factors of its loads: a load, and the corresponding power.
bool carries(const FieldInfo& field) {
  return field.is_load || *field.factors != '\0' || field.dimension == Dimension::of(2, 1, -3);
}

/// The field at a path: of a factor that is both an input and a result, the input, which says that it is one.
const FieldInfo* field_of_factor(const Step& step, const std::string& path) {
  const Calculator* const calculator = step.input().calculator;
  const FieldInfo* const input = calculator == nullptr ? nullptr : find_field(calculator->input->fields, path);
  return input != nullptr && input->is_factor ? input : step.field(path);
}

/// The factors included in the value at a path of another step.
Factors factors_at(const Project& project, const std::string& path) {
  const auto [name, rest] = split_step(path);
  if (name == "values" && project.find(name) == nullptr) return factors_of_shared(project, path);
  const Step* const step = project.find(name);
  if (step == nullptr) return {};
  const FieldInfo* const field = field_of_factor(*step, rest);
  if (field == nullptr) return step->loads().factors;  // mechanism: its reactions include the factors of its loads
  Factors held;
  const auto add = [&](const std::string& key, const std::string& of) {
    if (const double factor = input_of(*step, key); counts(factor)) held[of] = factor;
  };
  if (field->is_factor) {
    add(rest, path);
    return held;
  }
  if (carries(*field)) held = step->loads().factors;
  for (const std::string& key : listed_keys(field->factors)) add(key, std::string(name).append(".").append(key));
  return held;
}

/// A load of a step, as written there, and the factors that it includes.
struct Load {
  std::string path, text;
  Place place;
  Factors held;
  bool is_list = false;
};

class Check {
 public:
  Check(Step& step, const Project& project, std::vector<Issue>& issues)
      : step_(step), project_(project), issues_(issues) {}

  void run() {
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.leaf.field->is_load && !operand.expression.references().empty()) take(operand);
    }
    for (const Taken& taken : step_.input().reading.taken) {
      if (taken.field != nullptr && taken.field->type == FieldInfo::Type::list)
        take_list(taken, taken.field->fields, "[1].");
    }
    refuse_own();
    step_.loads().factors = held_;
    step_.loads().lacking_factor = lacking();
  }

 private:
  /// The factor that a load of another step lacks, and that this step neither takes nor gives: a nominal load does
  /// not include the factor of the step that it comes from.
  Message lacking() {
    if (const Message peak = lacking_peak(); !peak.empty()) return peak;
    if (const Message peak = below_peak(); !peak.empty()) return peak;
    for (const char* const key : factors_of_loads) {
      if (Message lost = lacking(key); !lost.empty()) return lost;
    }
    if (gives("K_A") || !of_kind(held_, "K_A").empty()) return {};
    for (const Taken& taken : step_.input().reading.taken) {
      if (taken.field == nullptr || taken.field->type != FieldInfo::Type::list) continue;
      const Step* const source = project_.find(split_step(taken.source).first);
      if (source != nullptr && !source->loads().lacking_factor.empty()) return source->loads().lacking_factor;
    }
    return {};
  }

  Message lacking(const std::string& key) {
    if (!of_kind(held_, key).empty()) return {};
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.leaf.field->is_load || is_peak(operand)) continue;
      for (const auto& reference : operand.expression.references()) {
        if (Message lost = lost_on_the_way(key, operand.path, reference.path); !lost.empty()) return lost;
      }
    }
    return {};
  }

  Message lost_on_the_way(const std::string& key, const std::string& load, const std::string& path) {
    const auto [name, rest] = split_step(path);
    const Step* const source = project_.find(name);
    const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
    if (field == nullptr || !carries(*field)) return {};
    if (!source->loads().lacking_factor.empty() && !gives(key)) return source->loads().lacking_factor;
    const auto with = listed_keys(field->factors);
    if (std::find(with.begin(), with.end(), key) != with.end())  // divided by it, as no load of the step holds it
      return lower_than(key, load, *source, input_of(*source, key));
    if (source->input().calculator->is_one_drive) return lower_than_in_the_drive(key, load, name);
    return field->is_load ? lower_than(key, load, *source, input_of(*source, key)) : Message{};
  }

  /// The parts of one drive carry its loads with one factor.
  Message lower_than_in_the_drive(const std::string& key, const std::string& load, const std::string& drive) {
    for (const auto& other : project_.steps) {
      if (other.get() == &step_ || !takes_load_of(*other, drive)) continue;
      const double factor = given_factor(other->input(), key);
      if (std::isnan(factor) && is_expression(other->input(), key) && reason_for(step_.input(), key) == nullptr)
        return say("{1}.{2} of the same drive waits for another step; refer to it here, or because.{2} = \"...\"",
                   other->name(), key);
      if (Message lower = lower_than(key, load, *other, factor); !lower.empty()) return lower;
    }
    return {};
  }

  static bool takes_load_of(const Step& step, const std::string& source) {
    const auto& operands = step.input().reading.operands;
    return std::any_of(operands.begin(), operands.end(), [&](const Operand& operand) {
      const auto& references = operand.expression.references();
      return operand.leaf.field->is_load &&
             std::any_of(references.begin(), references.end(),
                         [&](const auto& reference) { return split_step(reference.path).first == source; });
    });
  }

  /// A nominal load whose factor in another step is higher than here, without a reason.
  Message lower_than(const std::string& key, const std::string& load, const Step& other, double factor) {
    const FieldInfo* const theirs = find_field(other.input().calculator->input->fields, key);
    if (theirs == nullptr || !theirs->is_factor || !counts(factor)) return {};
    const FieldInfo* const own = find_field(step_.input().calculator->input->fields, key);
    const Message lacks = say("'{1}' is a nominal load, and {2}.{3} = {4} is not included", load, other.name(), key,
                              format_number(factor, 4));
    if (own == nullptr) return say("{1}; write {2} = \"={3}.{4}*...\"", lacks, load, other.name(), key);
    if (const double given = given_factor(step_.input(), key); gives(key) && given >= factor * (1.0 - 1e-6)) return {};
    if (reason_for(step_.input(), key) != nullptr) {
      step_.loads().justified.insert(key);
      return {};
    }
    return gives(key) ? say("{1}; here {2} is lower: say why, because.{2} = \"...\"", lacks, key)
                      : say("{1}; give {2} here", lacks, key);
  }

  /// A start or a jam raises the load of the shaft, and so that of the key or spline which it names as its part.
  Message lacking_peak() {
    const auto& inputs = step_.input().calculator->input->fields;
    if (find_field(inputs, "T_max") == nullptr || find_field(inputs, "K_A") == nullptr) return {};
    for (const auto& shaft : project_.steps) {
      const FieldInfo* const field = find_field(shaft->input().calculator->input->fields, "k_max");
      if (field == nullptr || !has_part(*shaft)) continue;
      const double k_max = given_factor(shaft->input(), "k_max");
      const bool waits = std::isnan(k_max) && is_expression(shaft->input(), "k_max");
      if (waits && !gives("T_max")) return say("{1}.k_max waits for another step; give T_max", shaft->name());
      if (!counts(k_max)) continue;
      if (bears(k_max, torque_of(*shaft))) continue;
      return say("T_max is missing or below {1}.k_max = {2} times K_A T; give T_max", shaft->name(),
                 format_number(k_max, 4));
    }
    return {};
  }

  static bool is_expression(const StepInput& step, const std::string& key) {
    return std::any_of(step.reading.operands.begin(), step.reading.operands.end(),
                       [&](const Operand& operand) { return operand.path == key; });
  }

  /// The largest torque of the components on a shaft, which its peak factor multiplies; 0 if none is known.
  double torque_of(const Step& shaft) const {
    const auto is_torque = [](const std::string& path) { return path.starts_with("seats[") && path.ends_with("].T"); };
    double most = 0.0;
    for_each_leaf(shaft.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      if (is_torque(path) && !std::isnan(leaf.get())) most = std::max(most, std::abs(leaf.get()));
    });
    for (const Operand& operand : shaft.input().reading.operands) {
      if (is_torque(operand.path)) most = std::max(most, largest_of(operand));
    }
    return most;
  }

  /// Whether T_max covers the peak factor. K_A and k_max are both of one start: with the torque of the shaft known,
  /// the peak is k_max times it, even if K_A T of the step is more.
  bool bears(double k_max, double of_shaft = 0.0) {
    const auto& inputs = step_.input().calculator->input->fields;
    if (find_field(inputs, "T_max") == nullptr || find_field(inputs, "K_A") == nullptr) return false;
    const double nominal = std::abs(largest_own("T")), service = std::abs(own_value("K_A")) * nominal;
    const double T = of_shaft > 0.0 ? std::min(service, std::max(nominal, of_shaft)) : service;
    const double T_max = std::abs(largest_own("T_max"));
    return T_max >= k_max * T * (1.0 - 1e-9);
  }

  /// A service load of a step that has a peak factor, taken without it. Fatigue is assessed under service loads.
  Message below_peak() {
    if (std::string_view(step_.input().calculator->id).starts_with("fatigue.")) return {};
    Message lacks;
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.leaf.field->is_load) continue;
      for (const auto& reference : operand.expression.references()) {
        const auto [name, rest] = split_step(reference.path);
        const Step* const source = project_.find(name);
        const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
        if (field == nullptr || !carries(*field)) continue;
        const FieldInfo* const own = find_field(source->input().calculator->input->fields, "k_max");
        if (own == nullptr || !own->is_factor || !counts(input_of(*source, "k_max"))) continue;
        if (field->is_peak || takes_start_of(name, operand.path)) return {};
        if (bears(input_of(*source, "k_max"))) return {};
        if (lacks.empty())
          lacks =
              say("'{1}' is the service load without {2}.k_max = {3}; use the peak load (bearing: F_r0, F_a0), "
                  "or write {4} = \"={2}.k_max*...\"",
                  reference.path, name, format_number(input_of(*source, "k_max"), 4), operand.path);
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

  /// Whether the user has given an input of the step.
  bool gives(const std::string& key) const {
    const auto& reading = step_.input().reading;
    return reading.typed.contains(key) || std::any_of(reading.operands.begin(), reading.operands.end(),
                                                      [&](const Operand& o) { return o.path == key; });
  }

  void take(const Operand& operand) {
    auto factors = operand.expression.factors([&](const std::string& path) { return factors_at(project_, path); });
    Load load{operand.path, operand.text, operand.place, {}};
    if (!factors) return refuse(load, factors.fault());
    load.held = std::move(*factors);
    if (!is_peak(operand)) take(std::move(load));
  }

  /// All elements of a list come from one step, with the same factors.
  void take_list(const Taken& taken, std::span<const FieldInfo> fields, const std::string& within) {
    for (const FieldInfo& field : fields) {
      const std::string inner = within + field.key;
      if (field.is_load)
        take(Load{taken.path, taken.source, taken.place, factors_at(project_, taken.source + inner), true});
      const bool is_list = field.type == FieldInfo::Type::list;
      if (field.has_fields()) take_list(taken, field.fields, inner + (is_list ? "[1]." : "."));
    }
  }

  void take(Load load) {
    held_.insert(load.held.begin(), load.held.end());
    if (!first_) {
      first_ = std::move(load);
    } else if (const std::string more = without_equal(load.held, first_->held); !more.empty()) {
      refuse_unlike(load, more, *first_);
    } else if (const std::string lost = without_equal(first_->held, load.held); !lost.empty()) {
      refuse_unlike(*first_, lost, load);
    }
  }

  void refuse(const Load& load, const Fault& fault) {
    issues_.push_back({place_in(load.place, load.text, fault.at, fault.length), step_.name() + "." + load.path,
                       fault.message, fault.hint, Severity::error});
  }

  void refuse_unlike(const Load& with, const std::string& factor, const Load& without) {
    const std::string other = of_kind(without.held, kind_of(factor));
    const Message held = told(with.held, factor);
    if (!other.empty())
      return refuse(without, Fault{0, without.text.size(),
                                   say("'{1}' holds {2}, and '{3}' holds {4}", with.path, held, without.path,
                                       told(without.held, other)),
                                   say("divide each by the one that it holds, and give one here")});
    refuse(without,
           Fault{0, without.text.size(), say("'{1}' holds {2}, and '{3}' does not", with.path, held, without.path),
                 without.is_list || with.is_list
                     ? say("take both with it, or both without")
                     : say("write {1} = \"={2}*({3})\", or take both without it", without.path, factor, without.text)});
  }

  /// A factor that the step applies to loads that hold one of its kind.
  void refuse_own() {
    for (const auto& [factor, value] : held_) {
      const std::string key = kind_of(factor);
      const FieldInfo* const own = find_field(step_.input().calculator->input->fields, key);
      if (own == nullptr || !own->is_factor || !counts(own_value(key))) continue;
      issues_.push_back(
          issue_at(step_.input(), key,
                   say("{1} would be applied twice: '{2}' includes {3}", key, first_->path, told(held_, factor)),
                   say("leave out {1} in '{3}', or use '{2}' without it", key, first_->path, step_.name())));
    }
  }

  double own_value(const std::string& key) { return given_factor(step_.input(), key); }

  /// The factor given in a step that may not be solved yet; NaN while its expression waits for other steps.
  double given_factor(const StepInput& step, const std::string& key) const {
    const auto known = [&](const std::string& path) -> const Value& { return value_at(path); };
    for (const Operand& operand : step.reading.operands) {
      if (operand.path != key) continue;
      const std::vector<double> si = operand.expression.evaluate(known).si;
      const bool waits = std::any_of(si.begin(), si.end(), [](double x) { return std::isnan(x); });
      return waits ? std::numeric_limits<double>::quiet_NaN() : factor_in(si);
    }
    const Leaf leaf = find_leaf(step.reading.record, key);
    return leaf ? leaf.get() : 1.0;
  }

  /// The same of a load: over a series the largest.
  double largest_own(const std::string& key) {
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.path == key) return largest_of(operand);
    }
    const double typed = find_leaf(step_.input().reading.record, key).get();
    return std::isnan(typed) ? 0.0 : typed;
  }

  double largest_of(const Operand& operand) const {
    double most = 0.0;
    const auto known = [&](const std::string& path) -> const Value& { return value_at(path); };
    for (const double si : operand.expression.evaluate(known).si) most = std::max(most, std::abs(si));
    return most;
  }

  const Value& value_at(const std::string& path) const {
    static const Value none{{}, {std::numeric_limits<double>::quiet_NaN()}};
    const Value* const value = project_.value(path);
    return value == nullptr ? none : *value;
  }

  Step& step_;
  const Project& project_;
  std::vector<Issue>& issues_;
  std::optional<Load> first_;
  Factors held_;
};

}  // namespace

void check_factors(Step& step, const Project& project, std::vector<Issue>& issues) {
  Check(step, project, issues).run();
}

}  // namespace loadpath::project
