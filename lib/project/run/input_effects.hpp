// Typed inputs that have an effect: a user who types one expects it to count.
#pragma once

#include "lib/project/run/governing.hpp"

#include <vector>

namespace loadpath::project {

/// A warning for every typed input that could have been left out and has no effect. Leaves the evaluation at the
/// governing position.
void warn_of_unused(Evaluation& evaluation, const Results& results, const Governing& governing,
                    std::vector<Issue>& issues);

}  // namespace loadpath::project
