#include "lib/project/factors.hpp"

#include "lib/project/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

/// The value of an input of a solved step.
double input_of(const Step& step, const std::string& key) {
  const Value* const value = step.value(key);
  return value == nullptr || value->si.empty() ? std::nan("") : value->si[0];
}

/// A factor of 1 does not count, nor one that is not given.
bool counts(double factor) { return !std::isnan(factor) && factor != 1.0; }

/// "chain.K_A = 1.4"
Message told(const Project& project, const std::string& factor) {
  const Value* const value = project.value(factor);
  return value == nullptr ? say("{1}", factor) : say("{1} = {2}", factor, format_number(value->si[0], 4));
}

/// What the value at a path of another step holds.
Factors factors_at(const Project& project, const std::string& path) {
  const auto [name, rest] = split_step(path);
  const Step* const step = project.find(name);
  const FieldInfo* const field = step == nullptr ? nullptr : step->field(rest);
  if (step == nullptr) return {};
  if (field == nullptr) return step->factors();  // of a mechanism: its reactions hold what its loads do
  if (field->is_factor) return counts(input_of(*step, rest)) ? Factors{path} : Factors{};
  Factors held = field->is_load ? step->factors() : Factors{};
  for (const std::string& key : listed_keys(field->factors)) {
    if (counts(input_of(*step, key))) held.insert(std::string(name).append(".").append(key));
  }
  return held;
}

class Check {
 public:
  Check(Step& step, const Project& project, std::vector<Issue>& issues)
      : step_(step), project_(project), issues_(issues) {}

  void run() {
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.leaf.field->is_load && !operand.expression.references().empty()) take(operand);
    }
    refuse_own();
    step_.hold(held_);
  }

 private:
  void take(const Operand& operand) {
    const auto factors =
        operand.expression.factors([&](const std::string& path) { return factors_at(project_, path); });
    if (!factors) return refuse(operand, factors.fault());
    if (first_ == nullptr) {
      first_ = &operand;
      held_ = *factors;
    } else if (keys_of(*factors) != keys_of(held_)) {
      refuse_unlike(operand, *factors);
    }
  }

  void refuse(const Operand& operand, const Fault& fault) {
    issues_.push_back({place_in(operand.place, operand.text, fault.at, fault.length), step_.name() + "." + operand.path,
                       fault.message, fault.hint, Severity::error});
  }

  void refuse_unlike(const Operand& operand, const Factors& factors) {
    const bool more_here = factors.size() > held_.size();
    const Operand& with = more_here ? operand : *first_;
    const Operand& without = more_here ? *first_ : operand;
    const std::string factor = *(more_here ? factors : held_).begin();
    refuse(without,
           Fault{0, without.text.size(),
                 say("'{1}' holds {2}, and '{3}' does not", with.path, told(project_, factor), without.path),
                 say("write {1} = \"={2}*({3})\", or take both without it", without.path, factor, without.text)});
  }

  /// A factor that the step applies to loads that hold one of its kind.
  void refuse_own() {
    for (const std::string& factor : held_) {
      const std::string key = key_of(factor);
      const FieldInfo* const own = find_field(step_.input().calculator->input->fields, key);
      if (own == nullptr || !own->is_factor || !counts(own_value(key))) continue;
      issues_.push_back(issue_at(
          step_.input(), key, say("{1} would count twice: '{2}' holds {3}", key, first_->path, told(project_, factor)),
          say("leave out {1} here, or take '{2}' without it", key, first_->path)));
    }
  }

  double own_value(const std::string& key) {
    for (const Operand& operand : step_.input().reading.operands) {
      if (operand.path == key) {
        const Value* const value = project_.value(operand.text);
        return value == nullptr ? 0.0 : value->si[0];
      }
    }
    return find_leaf(step_.input().reading.record, key).get();
  }

  Step& step_;
  const Project& project_;
  std::vector<Issue>& issues_;
  const Operand* first_ = nullptr;
  Factors held_;
};

}  // namespace

void check_factors(Step& step, const Project& project, std::vector<Issue>& issues) {
  Check(step, project, issues).run();
}

}  // namespace loadpath::project
