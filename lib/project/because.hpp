// The reason why a typed value is better than the row of a table or a record for the same field: because.R_e =
// "certificate 4711". It justifies the value, while `accept` accepts a failure mode; no verdict improves by it.
#pragma once

#include "lib/project/step.hpp"
#include "lib/toml/tree.hpp"

#include <vector>

namespace loadpath::project {

/// Whether a text justifies anything: one line with a word or a number in it.
bool is_reason(const toml::Tree& tree);

/// An input that the calculator does not have, or no reason, is an issue.
void read_because(const toml::Tree& table, StepInput& input, std::vector<Issue>& issues);

/// The reason for the value at a path, or for the list or group that it is in; null if there is none.
const Typed* reason_for(const StepInput& input, const std::string& path);

}  // namespace loadpath::project
