#include "lib/project/references/agreement/column_lengths.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

/// The step that finds an effective length and that an expression refers to; null if it refers to none.
const Step* effective_length_in(const Operand& operand, const Project& project) {
  for (const auto& reference : operand.expression.references()) {
    const Step* const source = project.find(split_step(reference.path).first);
    if (source == nullptr || source->input().calculator == nullptr) continue;
    if (std::string_view(source->input().calculator->id) == "column.effective_length") return source;
  }
  return nullptr;
}

/// The lower of the factors that multiply a length; 1 if none is given.
double least_factor(const Step& step, const Project& project) {
  const double beta = std::fmin(own_value(step, project, "beta_y"), own_value(step, project, "beta_z"));
  return std::isnan(beta) ? 1.0 : std::fmin(1.0, beta);
}

}  // namespace

std::vector<ReducedLoad> lengths_of_columns(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (find_field(step.input().calculator->input->fields, "ends") == nullptr) return found;
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path != "l" || operand.expression.is_reference()) continue;
    const Step* const source = effective_length_in(operand, project);
    if (source == nullptr) continue;
    const double l = own_value(step, project, "l") * least_factor(step, project);
    const double s = magnitude_at(project, source->name() + ".s");
    if (!(l < (1.0 - 1e-3) * s)) continue;
    found.push_back({"l", say("l makes an effective length of {1}, and '{2}.s' is {3}, with which the column buckles "
                              "first: write l = \"={2}.l\" with beta_y and beta_z = \"={2}.beta\", or because.l = "
                              "\"...\" if it is braced",
                              format_quantity(l, "mm", 4), source->name(), format_quantity(s, "mm", 4))});
  }
  return found;
}

}  // namespace loadpath::project
