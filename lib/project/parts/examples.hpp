// Missing inputs as the example of their calculator writes them.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::project {

/// Adds to errors about missing inputs of a step that have no help how the calculator's example writes them, of a list
/// the first element: `for example families = ["IPE"]`. `before`: the number of issues before the step was read.
void show_missing(const Calculator& calculator, const std::string& step, std::size_t before,
                  std::vector<Issue>& issues);

}  // namespace loadpath::project
