// How the program ends.
#pragma once

namespace loadpath::cli {

/// Exit codes, as in the help text.
enum Exit : int { passed = 0, not_passed = 1, wrong_input = 2, fault = 3, incomplete = 4, interrupted = 130 };

}  // namespace loadpath::cli
