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
    if (source == nullptr) continue;
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

namespace {

/// A column with the length of a frame's member, without its effective length factor, which is above that of the ends.
void compare_factor(const Step& step, const Operand& length, const Step& source, const Project& project,
                    std::vector<ReducedLoad>& found) {
  const auto takes_factor = [&](const Operand& operand) {
    const auto& references = operand.expression.references();
    return std::ranges::any_of(references, [&](const auto& one) { return one.path == source.name() + ".beta"; });
  };
  if (std::ranges::any_of(step.input().reading.operands, takes_factor)) return;
  const double there = magnitude_at(project, source.name() + ".beta");
  double own = std::nan("");
  for (const char* const key : {"beta_y", "beta_z"}) {
    const double typed = own_value(step, project, key), known = magnitude_at(project, step.name() + "." + key);
    own = std::fmax(own, std::isnan(typed) ? known : typed);
  }
  const double here = std::isnan(own) ? 1.0 : own;
  if (!(there > (1.0 + 1e-3) * here)) return;
  found.push_back({length.path, say("'{1}' has the effective length factor {2}, and this column {3}: give beta_y or "
                                    "beta_z = \"={1}.beta\", or because.{4} = \"...\" if it is braced",
                                    source.name(), format_number(there, 4), format_number(here, 4), length.path)});
}

}  // namespace

std::vector<ReducedLoad> lengths_of_columns(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (find_field(step.input().calculator->input->fields, "ends") == nullptr) return found;
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path != "l") continue;
    const Step* const source = effective_length_in(operand, project);
    if (source == nullptr) continue;
    if (operand.expression.is_reference()) {
      compare_factor(step, operand, *source, project, found);
      continue;
    }
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
