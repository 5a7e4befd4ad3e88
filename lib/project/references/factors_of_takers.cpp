#include "lib/project/references/factors_of_takers.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::project {

namespace {

/// The factor that a step applies to its loads; 1 if it is not known yet, or not given.
double applied_factor(const Step& step, const Project& project, const std::string& key) {
  static const Value none{{}, {std::nan("")}};
  double factor = std::nan("");
  const auto& operands = step.input().reading.operands;
  const auto operand = std::find_if(operands.begin(), operands.end(), [&](const Operand& o) { return o.path == key; });
  if (operand != operands.end()) {
    const auto si = operand->expression.evaluate([&](const std::string& path) -> const Value& {
      const Value* const value = project.value(path);
      return value == nullptr ? none : *value;
    });
    if (!si.si.empty()) factor = si.si.front();
  } else if (const Leaf leaf = find_leaf(step.input().reading.record, key)) {
    factor = leaf.get();
  }
  return std::isnan(factor) ? 1.0 : factor;
}

bool applies_factor(const Step& step, const std::string& key) {
  const Calculator* const calculator = step.input().calculator;
  const FieldInfo* const field = calculator == nullptr ? nullptr : find_field(calculator->input->fields, key);
  return field != nullptr && field->is_factor;
}

/// The input of the step that is a load of the other one as it is, "post.P"; empty if none is.
std::string load_taken_by(const Step& taker, const Step& step) {
  for (const Operand& operand : taker.input().reading.operands) {
    if (!operand.leaf.field->is_load || !operand.expression.is_reference()) continue;
    const std::string& path = operand.expression.references().front().path;
    const auto [name, rest] = split_step(path);
    const FieldInfo* const field =
        name == step.name() ? find_field(step.input().calculator->input->fields, rest) : nullptr;
    if (field != nullptr && field->is_load) return path;
  }
  return {};
}

}  // namespace

std::vector<ReducedLoad> factors_of_takers(const Step& step, const Project& project) {
  constexpr double rounding = 1e-6;
  std::vector<ReducedLoad> lower;
  for (const char* const key : {"K_A", "gamma_F"}) {
    if (!applies_factor(step, key)) continue;
    const double own = applied_factor(step, project, key);
    for (const auto& taker : project.steps) {
      if (taker.get() == &step || !applies_factor(*taker, key)) continue;
      const double factor = applied_factor(*taker, project, key);
      const std::string load = load_taken_by(*taker, step);
      if (load.empty() || !(factor > own * (1.0 + rounding))) continue;
      lower.push_back(
          {key, say("{1} takes '{2}' with {3} = {4}; here {3} is lower: give it, or say why, because.{3} = \"...\"",
                    taker->name(), load, key, format_number(factor, 4))});
    }
  }
  return lower;
}

}  // namespace loadpath::project
