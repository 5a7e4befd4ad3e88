#include "lib/project/references/reductions.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/because.hpp"
#include "lib/project/references/notches.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/reasons.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/turning.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace loadpath::project {

namespace {

using Left = Reduced::Left;

/// A force, a moment, a stress, a power, an energy, and each of them per length.
bool is_of_loads(const Dimension& dimension) {
  return dimension.twelfths[1] == Dimension::one && dimension.twelfths[2] <= -2 * Dimension::one;
}

const Dimension inertia = Dimension::of(2, 1, 0);

/// The speed at which a part turns or slides: of a series, its wear, its life or its centrifugal forces follow from the
/// largest one.
bool is_speed_of_part(const Operand& operand) {
  const Dimension dimension = operand.leaf.field->dimension.without_angle();
  const std::string key = operand.path.substr(operand.path.rfind('.') + 1);
  return (key == "n" && dimension == Dimension::of(0, 0, -1)) || (key == "v" && dimension == Dimension::of(1, 0, -1));
}

/// The same, and a moment of inertia to be accelerated.
bool is_of_demand(const Dimension& dimension) { return is_of_loads(dimension) || dimension == inertia; }

/// The last name of a path: "sigma_max" of "others[2].sigma_max".
std::string last_of(const std::string& path) { return path.substr(path.rfind('.') + 1); }

/// The reduction that a field is by its definition: "amplitude"; empty if it is the load itself.
std::string reduction_of(const Calculator& calculator, const std::string& path) {
  const std::string key = last_of(path);
  for (const Meaning& meaning : calculator.meanings) {
    if (!is_reduction(meaning)) continue;
    const auto fields = listed_keys(meaning.fields);
    if (std::any_of(fields.begin(), fields.end(), [&](const std::string& f) { return last_of(f) == key; }))
      return meaning.what;
  }
  return {};
}

bool is_negative(const Value& value) {
  const double most = std::abs(largest(value).value);
  return std::any_of(value.si.begin(), value.si.end(),
                     [&](double x) { return x < -std::max(value.rounding, 1e-12 * most); });
}

bool holds_entry(const std::vector<Entry>& entries, const std::string& path) {
  return std::any_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.path == path; });
}

/// Whether a value of a step comes from a load smaller than its series.
bool is_reduced(const Step& step, const std::string& rest) {
  const auto& loads = step.loads().reduced;
  if (loads.empty()) return false;
  if (std::any_of(loads.begin(), loads.end(), [&](const ReducedLoad& load) { return load.path == rest; })) return true;
  return !holds_entry(step.account().inputs, rest);
}

/// The remaining dependence of another step's value on its series.
Reduced reduced_at(const Project& project, const std::string& path) {
  const Value* const value = project.value(path);
  Reduced reduced;
  if (value == nullptr) return reduced;
  const auto [name, rest] = split_step(path);
  const Step* const step = project.find(name);
  reduced.of_load = is_of_loads(value->signature.dimension);
  reduced.is_signed = is_negative(*value);
  if (value->is_series()) reduced.left = Left::whole;
  if (step == nullptr) return reduced;
  const bool is_result = rest.find('.') == std::string::npos && !holds_entry(step->account().inputs, rest);
  const std::string own = is_result ? reduction_of(*step->input().calculator, rest) : "";
  const bool is_less = is_reduced(*step, rest);
  if (is_less || own == "mean" || own == "amplitude") {
    reduced.left = Left::less;
    reduced.function = is_less ? "" : own;
    reduced.text = path;
  }
  return reduced;
}

std::string without_spaces(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  return text;
}

class ReductionCheck {
 public:
  ReductionCheck(Step& step, const Project& project) : step_(step), project_(project) {}

  void run() {
    for (const Operand& operand : step_.input().reading.operands) {
      if (!operand.expression.references().empty()) take(operand);
    }
    for (const Taken& taken : step_.input().reading.taken) take(taken);
    for (const Operand& operand : step_.input().reading.whole) {
      if (is_share(operand) && !is_reduction_justified(step_, operand.path))
        loads_.push_back({operand.path, share_message(operand)});
    }
    for (auto& [path, message] : missed_notches(step_, project_)) {
      if (!is_reduction_justified(step_, path)) loads_.push_back({path, std::move(message)});
    }
    step_.loads().reduced = std::move(loads_);
    hold_unless_justified(step_, values_of_others(step_, project_));
  }

 private:
  [[nodiscard]] Reduced reduced(const Operand& operand) const {
    return operand.expression.reduced([&](const std::string& path) { return reduced_at(project_, path); });
  }

  void take(const Operand& operand) {
    if (auto turning = turning_message(step_, operand, project_);
        turning && !is_reduction_justified(step_, operand.path))
      loads_.push_back({operand.path, std::move(*turning)});
    const Reduced r = reduced(operand);
    if (r.left == Left::whole && is_turned_over(operand) && !is_reduction_justified(step_, operand.path))
      loads_.push_back({operand.path, turned_over_message(operand)});
    if (is_accepted(operand, r) && is_share(operand) && !is_reduction_justified(step_, operand.path))
      loads_.push_back({operand.path, share_message(operand)});
    const bool is_reduced_here = r.text.find('(') != std::string::npos;
    const bool is_speed = is_speed_of_part(operand) && is_reduced_here && r.left != Left::peak;
    const bool concerned = operand.leaf.field->is_load || is_speed || (r.of_load && r.left != Left::peak);
    if (!concerned || is_accepted(operand, r) || is_reduction_justified(step_, operand.path)) return;
    loads_.push_back({operand.path, message(operand, r)});
  }

  /// An entire list: its loads are those of the other step.
  void take(const Taken& taken) {
    if (taken.field == nullptr || taken.field->type != FieldInfo::Type::list) return;
    const auto [name, rest] = split_step(taken.source);
    const Step* const source = project_.find(name);
    if (source == nullptr || !is_reduced(*source, rest) || is_reduction_justified(step_, taken.path)) return;
    loads_.push_back({taken.path, source->loads().reduced.front().message});
  }

  [[nodiscard]] bool is_accepted(const Operand& operand, const Reduced& r) const {
    switch (r.left) {
      case Left::no_series:
        return true;
      case Left::whole:
        return !is_extreme(operand) || is_alternating(operand);
      case Left::peak:
        return !operand.leaf.field->signed_load || is_largest_magnitude(operand);
      case Left::once:
        return is_that_reduction(operand, r) || is_largest_magnitude(operand);
      case Left::less:
        return is_same_part_of_cycle(operand, r);
      case Left::square:
        return false;
    }
    return false;
  }

  /// Whether one value of a compressive force is as large as the force ever is: "-max(press.joints.B.F)",
  /// "min(press.links.rod.N)" of a rod that is never pulled as much. In tension a bar does not buckle.
  [[nodiscard]] bool is_largest_magnitude(const Operand& operand) const {
    const FieldInfo& field = *operand.leaf.field;
    if (!is_compression_of_bar(field)) return false;
    const auto pair = pair_of(operand);
    if (!pair || pair->taken.is_series()) return false;
    const double taken = largest(pair->taken).value, most = std::abs(largest(pair->source).value);
    const bool is_compression = field.signed_load ? taken < 0.0 : taken > 0.0;
    return is_compression && std::abs(taken) >= most * (1.0 - 1e-9);
  }

  /// Whether the amplitude or mean that another step has of its full cycle is taken as such: "=filling.sigma_a",
  /// with "=filling.sigma_m" where both are needed.
  [[nodiscard]] bool is_same_part_of_cycle(const Operand& operand, const Reduced& r) const {
    if (!operand.expression.is_reference() || r.function.empty()) return false;
    const Calculator& calculator = *step_.input().calculator;
    const std::string own = reduction_of(calculator, operand.path);
    if (own == "amplitude" || own == "mean") return own == r.function;
    const bool is_amplitude = own == paired_amplitude && r.function == "amplitude";
    if (!is_amplitude && !(own == paired_middle && r.function == "mean")) return false;
    const std::string source = split_step(operand.expression.references().front().path).first;
    return std::any_of(
        step_.input().reading.operands.begin(), step_.input().reading.operands.end(), [&](const Operand& other) {
          return prefix_of(other.path) == prefix_of(operand.path) &&
                 reduction_of(calculator, other.path) == (is_amplitude ? paired_middle : paired_amplitude) &&
                 other.expression.is_reference() &&
                 split_step(other.expression.references().front().path).first == source;
        });
  }

  /// A load of another step and the value derived from it; apart from entries of [values] and one count, the number of
  /// belts, nothing else is referred to. A ratio of numbers of teeth converts a torque.
  struct Pair {
    std::string path;  // of the load
    Value source, taken;
  };
  [[nodiscard]] std::optional<Pair> pair_of(const Operand& operand) const {
    static const Value none{{}, {std::nan("")}};
    std::set<std::string> paths;
    for (const auto& reference : operand.expression.references()) {
      if (!reference.path.starts_with("values.")) paths.insert(reference.path);
    }
    const auto count =
        std::find_if(paths.begin(), paths.end(), [&](const std::string& path) { return is_count(path); });
    if (paths.size() == 2 && count != paths.end()) paths.erase(count);
    if (paths.size() != 1) return std::nullopt;
    const auto value_at = [&](const std::string& path) -> const Value& {
      const Value* const value = project_.value(path);
      return value == nullptr ? none : *value;
    };
    Pair pair{*paths.begin(), value_at(*paths.begin()), operand.expression.evaluate(value_at)};
    const Dimension& dimension = pair.source.signature.dimension;
    if (!is_of_demand(dimension) || dimension != operand.leaf.field->dimension) return std::nullopt;
    return pair;
  }

  [[nodiscard]] bool is_count(const std::string& path) const {
    const auto [name, rest] = split_step(path);
    const Step* const source = project_.find(name);
    const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
    return field != nullptr && field->type == FieldInfo::Type::count;
  }

  /// Whether a field with a significant sign takes the negative of a load: tension for compression. A load with a sign
  /// of its own, such as that of a cylinder that pushes, may have to be turned over.
  [[nodiscard]] bool is_turned_over(const Operand& operand) const {
    if (!operand.leaf.field->signed_load) return false;
    const auto pair = pair_of(operand);
    if (!pair || pair->source.signature.other_sign || pair->source.si.size() != pair->taken.si.size()) return false;
    const auto& series = pair->source.si;
    const auto most =
        std::max_element(series.begin(), series.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    return *most * pair->taken.si[static_cast<std::size_t>(most - series.begin())] < 0.0;
  }

  /// Whether a load is less than the load of another step that it is computed from, by numbers only: 0.3 times it. A
  /// divisor of a step, such as a number of teeth, is free, and so are the losses of a drive.
  [[nodiscard]] bool is_share(const Operand& operand) const {
    constexpr double least_efficiency = 0.85;
    const std::string own = reduction_of(*step_.input().calculator, operand.path);
    const FieldInfo& field = *operand.leaf.field;
    const bool is_demand = field.is_load || field.dimension == inertia;
    if (!is_demand || operand.expression.is_reference()) return false;
    const auto pair = pair_of(operand);
    const bool is_whole = own.empty() || own == "max" || (own == "mean" && pair && is_mean_power(*pair));
    if (!is_whole) return false;  // of a cycle: its middle or amplitude may be a part of it
    if (pair && operand.path == "T" && is_one_of_outputs(step_, project_, shaft_of_torque(pair->path))) return false;
    if (!pair) return false;
    const double taken = std::abs(largest(pair->taken).value) * factor_applied_again(pair->path);
    return taken < least_efficiency * std::abs(largest(pair->source).value);
  }

  /// The power of another drive that is not a series: it is a mean over the cycle too.
  [[nodiscard]] bool is_mean_power(const Pair& pair) const {
    const auto [name, rest] = split_step(pair.path);
    const Step* const source = project_.find(name);
    if (source == nullptr || pair.source.is_series()) return false;
    const std::string own = reduction_of(*source->input().calculator, rest);
    return pair.source.signature.dimension == Dimension::of(2, 1, -3) && (own.empty() || own == "mean");
  }

  /// The application factor that a load holds, and that this step applies, as far as both agree: "=belts.shaft_2.T /
  /// values.K_A" with K_A = "=values.K_A" is the full load. A load that still holds it is refused with a K_A.
  [[nodiscard]] double factor_applied_again(const std::string& load) const {
    const auto [name, rest] = split_step(load);
    const Step* const source = project_.find(name);
    const FieldInfo* const field = source == nullptr ? nullptr : source->field(rest);
    const auto factors = listed_keys(field == nullptr ? "" : field->factors);
    if (std::ranges::find(factors, "K_A") == factors.end()) return 1.0;
    const double held = magnitude_at(project_, name + ".K_A"), own = own_value(step_, project_, "K_A");
    return held > 1.0 && own > 1.0 ? std::min(held, own) : 1.0;
  }

  /// "sh" of "sh.T".
  static std::string shaft_of_torque(const std::string& path) {
    const auto [name, rest] = split_step(path);
    return rest == "T" ? std::string(name) : "";
  }

  [[nodiscard]] Message share_message(const Operand& operand) const {
    return say("{1} is less than '{2}', from which it is computed; justify it: because.{1} = \"...\"", operand.path,
               pair_of(operand)->path);
  }

  [[nodiscard]] static Message turned_over_message(const Operand& operand) {
    return say("{1} is the negative of '{2}', tension for compression: write ={2}, or because.{1} = \"...\"",
               operand.path, operand.expression.references().front().path);
  }

  [[nodiscard]] bool is_extreme(const Operand& operand) const {
    const std::string own = reduction_of(*step_.input().calculator, operand.path);
    return own == "max" || own == "min";
  }

  /// One end of a cycle with r = -1 is safe for any sign of the series; another ratio is not that of the series.
  [[nodiscard]] bool is_alternating(const Operand& operand) const {
    return has_reversed_ratio(step_, prefix_of(operand.path), project_);
  }

  /// A field defined as this reduction: an amplitude; one extreme of a cycle, if the other is given too.
  [[nodiscard]] bool is_that_reduction(const Operand& operand, const Reduced& r) const {
    const std::string own = reduction_of(*step_.input().calculator, operand.path);
    if (own == "amplitude" || own == "mean") return own == r.function;
    if (own == paired_amplitude)
      return r.function == "amplitude" && has_counterpart(operand, r, "amplitude", "midrange");
    if (own == paired_middle) return r.function == "midrange" && has_counterpart(operand, r, "midrange", "amplitude");
    if (own != "max" && own != "min") return false;
    return has_counterpart(operand, r, "max", "min") || has_counterpart(operand, r, "min", "max");
  }

  /// Whether "max(rod.N)/A" has its counterpart "min(rod.N)/A", in an input that is a reduction of a cycle.
  [[nodiscard]] bool has_counterpart(const Operand& operand, const Reduced& r, std::string_view own,
                                     std::string_view other) const {
    std::string text = operand.text;
    const std::size_t at = text.find(r.text);
    if (!r.text.starts_with(own) || at == std::string::npos) return false;
    text.replace(at, own.size(), other);
    const Calculator& calculator = *step_.input().calculator;
    return std::any_of(step_.input().reading.operands.begin(), step_.input().reading.operands.end(),
                       [&](const Operand& partner) {
                         return &partner != &operand && !reduction_of(calculator, partner.path).empty() &&
                                prefix_of(partner.path) == prefix_of(operand.path) &&
                                without_spaces(partner.text) == without_spaces(text);
                       });
  }

  [[nodiscard]] Message message(const Operand& operand, const Reduced& r) const {
    const std::string& path = operand.path;
    const std::string reason = "because." + path + " = \"...\"";
    if (r.left == Left::peak)
      return say("{1} has a sign that decides, and peak(...) loses it: write the series itself, or {2}", path, reason);
    if (r.text.find('(') == std::string::npos && r.left == Left::less && r.text.find('.') != std::string::npos &&
        r.function.empty())
      return say("{1} depends on '{2}', which is less than a load over its cycle: see there, or {3}", path, r.text,
                 reason);
    const std::string own = reduction_of(*step_.input().calculator, path);
    if (own == "max" || own == "min")
      return say(
          "{1} is only {2}: give the maximum and minimum stress, max(...) and min(...) of one "
          "series, or {3}",
          path, r.text.empty() ? operand.text : r.text, reason);
    if (own == paired_amplitude || own == paired_middle)
      return say(
          "{1} = {2} does not cover the load cycle: use amplitude({3}) and midrange({3}) for the pair, "
          "or {4}",
          path, r.text.empty() ? operand.text : r.text, r.argument.empty() ? operand.text : r.argument, reason);
    const std::string series = r.argument.empty() ? "the series itself" : "=" + r.argument;
    const std::string taken = r.text.empty() ? operand.text : r.text;
    if (is_speed_of_part(operand))
      return say("{1} is {2}, less than the speed over the cycle: write {3}, or {4}", path, taken, series, reason);
    return say("{1} is {2}, less than the load over the cycle: write {3}, or {4}", path, taken, series, reason);
  }

  Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> loads_;
};

}  // namespace

bool is_reduction_justified(const Step& step, const std::string& path) {
  return reason_for(step.input(), path) != nullptr;
}

void check_reductions(Step& step, const Project& project) { ReductionCheck(step, project).run(); }

}  // namespace loadpath::project
