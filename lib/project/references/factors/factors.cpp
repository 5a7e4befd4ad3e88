#include "lib/project/references/factors/factors.hpp"

#include "lib/project/references/factors/given.hpp"
#include "lib/project/references/factors/missing_factors.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace loadpath::project {

namespace {

/// "chain.K_A = 1.4"
Message text_of(const Factors& factors, const std::string& factor) {
  return say("{1} = {2}", factor, format_number(factors.at(factor), 4));
}

/// A value of [values] that a step has for a factor is that factor: "values.n" the K_A of "chain".
Factors factors_of_shared(const Project& project, const std::string& path) {
  const Value* const value = project.value(path);
  if (value == nullptr || !is_applied(applied_factor(value->si))) return {};
  for (const auto& step : project.steps) {
    for (const auto& [key, typed] : step->input().reading.typed) {
      const FieldInfo* const field = find_field(step->input().calculator->input->fields, key);
      if (typed.shared == path && field != nullptr && field->is_factor)
        return {{step->name() + "." + key, applied_factor(value->si)}};
    }
  }
  return {};
}

/// The field at a path: of a factor that is both an input and a result, the input, which says that it is one.
const FieldInfo* field_of_factor(const Step& step, const std::string& path) {
  const Calculator* const calculator = step.input().calculator;
  const FieldInfo* const input = find_field(calculator->input->fields, path);
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
    if (const double factor = factor_of(*step, key); is_applied(factor)) held[of] = factor;
  };
  if (field->is_factor) {
    add(rest, path);
    return held;
  }
  if (carries_factors(*field)) held = step->loads().factors;
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
      if (operand.leaf.field->is_load && comes_from_load(operand)) take(operand);
    }
    for (const Taken& taken : step_.input().reading.taken) {
      if (taken.field != nullptr && taken.field->type == FieldInfo::Type::list)
        take_list(taken, taken.field->fields, "[1].");
    }
    refuse_own();
    step_.loads().factors = held_;
    step_.loads().missing_factor = missing_factor(step_, project_, held_);
  }

 private:
  /// Whether a load, a factor, or a value of [values] is taken: lengths and numbers hold no factor.
  [[nodiscard]] bool comes_from_load(const Operand& operand) const {
    return std::ranges::any_of(operand.expression.references(), [&](const auto& reference) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const step = project_.find(name);
      const FieldInfo* const field = step == nullptr ? nullptr : field_of_factor(*step, rest);
      if (field == nullptr || field->is_factor || carries_factors(*field)) return true;
      const auto& exponents = field->dimension.twelfths;
      return exponents[Dimension::mass] != 0 || exponents[Dimension::time] != 0;
    });
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
    const Message held = text_of(with.held, factor);
    if (!other.empty())
      return refuse(without, Fault{0, without.text.size(),
                                   say("'{1}' includes {2}, and '{3}' includes {4}", with.path, held, without.path,
                                       text_of(without.held, other)),
                                   say("divide each by the factor it includes, and give one here")});
    refuse(without,
           Fault{0, without.text.size(), say("'{1}' includes {2}, and '{3}' does not", with.path, held, without.path),
                 without.is_list || with.is_list
                     ? say("take both with it, or both without")
                     : say("write {1} = \"={2}*({3})\", or take both without it", without.path, factor, without.text)});
  }

  /// A factor that the step applies to loads that hold one of its kind.
  void refuse_own() {
    for (const auto& [factor, value] : held_) {
      const std::string key = kind_of(factor);
      const FieldInfo* const own = find_field(step_.input().calculator->input->fields, key);
      if (own == nullptr || !own->is_factor || !is_applied(given_factor(project_, step_.input(), key))) continue;
      issues_.push_back(
          issue_at(step_.input(), key,
                   say("{1} would be applied twice: '{2}' includes {3}", key, first_->path, text_of(held_, factor)),
                   say("leave out {1} in '{3}', or use '{2}' without it", key, first_->path, step_.name())));
    }
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
