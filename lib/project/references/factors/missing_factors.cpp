#include "lib/project/references/factors/missing_factors.hpp"

#include "lib/project/because.hpp"
#include "lib/project/references/factors/given.hpp"
#include "lib/project/references/factors/peaks.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::project {

namespace {

/// Factors that a nominal load does not contain.
constexpr std::array factors_of_loads{"K_A", "gamma_F"};

class LostFactors {
 public:
  LostFactors(Step& step, const Project& project, const Factors& held) : step_(step), project_(project), held_(held) {}

  Message missing() {
    if (Message peak = missing_peak(step_, project_); !peak.empty()) return peak;
    for (const char* const key : factors_of_loads) {
      if (Message lost = missing(key); !lost.empty()) return lost;
    }
    if (is_given(step_.input(), "K_A") || !of_kind(held_, "K_A").empty()) return {};
    for (const Taken& taken : step_.input().reading.taken) {
      if (taken.field == nullptr || taken.field->type != FieldInfo::Type::list) continue;
      const Step* const source = project_.find(split_step(taken.source).first);
      if (source != nullptr && !source->loads().missing_factor.empty()) return source->loads().missing_factor;
    }
    return {};
  }

 private:
  Message missing(const std::string& key) {
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
    if (field == nullptr || !carries_factors(*field)) return {};
    if (!source->loads().missing_factor.empty() && !is_given(step_.input(), key)) return source->loads().missing_factor;
    const auto with = listed_keys(field->factors);
    if (std::find(with.begin(), with.end(), key) != with.end())  // divided by it, as no load of the step holds it
      return lower_than(key, load, *source, factor_of(*source, key));
    if (source->input().calculator->is_one_drive) return lower_than_in_the_drive(key, load, name);
    return field->is_load ? lower_than(key, load, *source, factor_of(*source, key)) : Message{};
  }

  /// The parts of one drive carry its loads with one factor.
  Message lower_than_in_the_drive(const std::string& key, const std::string& load, const std::string& drive) {
    for (const auto& other : project_.steps) {
      if (other.get() == &step_ || !takes_load_of(*other, drive)) continue;
      const double factor = given_factor(project_, other->input(), key);
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
    if (theirs == nullptr || !theirs->is_factor || !is_applied(factor)) return {};
    const FieldInfo* const own = find_field(step_.input().calculator->input->fields, key);
    const Message lacks = say("'{1}' is a nominal load, and {2}.{3} = {4} is not included", load, other.name(), key,
                              format_number(factor, 4));
    if (own == nullptr) return say("{1}; write {2} = \"={3}.{4}*...\"", lacks, load, other.name(), key);
    if (const double given = given_factor(project_, step_.input(), key);
        is_given(step_.input(), key) && given >= factor * (1.0 - 1e-6))
      return {};
    if (reason_for(step_.input(), key) != nullptr) {
      step_.loads().justified.insert(key);
      return {};
    }
    return is_given(step_.input(), key)
               ? say("{1}; here {2} is lower: give the reason, because.{2} = \"...\"", lacks, key)
               : say("{1}; give {2} here", lacks, key);
  }

  Step& step_;
  const Project& project_;
  const Factors& held_;
};

}  // namespace

Message missing_factor(Step& step, const Project& project, const Factors& held) {
  return LostFactors(step, project, held).missing();
}

}  // namespace loadpath::project
