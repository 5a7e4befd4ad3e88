// Acceptance by the user: failure modes of a step that are accepted with a reason, in place of an assessment.
#pragma once

#include "lib/account/mode.hpp"
#include "lib/project/step.hpp"
#include "lib/toml/tree.hpp"

#include <vector>

namespace loadpath::project {

/// accept.pitting = "rated by the manufacturer, drawing 12". A mode that the calculator does not have, or no reason, is
/// an issue.
void read_accepted(const toml::Tree& table, StepInput& input, std::vector<Issue>& issues);

/// Applies the acceptances of the step to the mode: never to a failure, nor outside the validity of a method.
void accept(const StepInput& input, account::Mode& mode);
/// Whether a mode of this state is accepted.
bool is_accepted(const StepInput& input, const std::string& mode, account::State state);

/// A warning for every mode that a solved step accepts in vain: it passes, fails, or does not concern the part.
void warn_of_idle_acceptances(const Step& step, std::vector<Issue>& issues);

}  // namespace loadpath::project
