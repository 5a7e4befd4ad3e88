// Help for an input that violates a rule, if the rule itself has none.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/project/step.hpp"

#include <string>
#include <string_view>

namespace loadpath::project {

/// The noun of a field, from its meaning: "yield strength, with S in place of tau_adm".
std::string noun_of(std::string_view doc);

/// Names the row of the step that does not have the missing input, and the values of a choice that must be given.
void add_help(const StepInput& input, const RuleInfo& rule, const Record& record, FieldFault& fault);

}  // namespace loadpath::project
