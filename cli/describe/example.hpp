// The example of a calculator, as its step says it in the file and as the shell takes it.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/toml/tree.hpp"

#include <string>
#include <string_view>

namespace loadpath::cli {

/// The step of the example that is of this calculator; an empty table where there is none.
toml::Tree example_step(const Calculator& calculator);

/// A value as the example says it, `"0.004 rad/m"`, with its quotes; empty where it is more than one line.
std::string as_typed(const toml::Tree& value);

/// The command line that does what the example does, in lines of at most `width` characters which the shell takes as
/// one; empty where the example has several steps, or lists and tables.
std::string shell_example(const Calculator& calculator, std::size_t width);

}  // namespace loadpath::cli
