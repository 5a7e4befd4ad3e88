// The calculator that the keys of a step belong to, where it names none or another one.
#pragma once

#include "lib/project/catalogue.hpp"
#include "lib/toml/tree.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::project {

/// The calculator that has most of the keys of a step; shaft.torsion if at most one key matches.
std::string calculator_with(const toml::Tree& step, Catalogue catalogue);

/// Several keys that the calculator of a step does not have and another one has: one error names that, in place of
/// those about the keys and the missing inputs. `before`: the number of issues before the step was read.
void name_calculator(const toml::Tree& step, StepInput& input, Catalogue catalogue, std::size_t before,
                     std::vector<Issue>& issues);

}  // namespace loadpath::project
