// How a check can come out, and the words for it.
#pragma once

#include "lib/text/issue.hpp"

#include <string>

namespace loadpath::account {

/// From good to bad: the larger of two is the worse.
enum class State { pass, not_covered, not_available, fail };
constexpr State pass_if(bool holds) { return holds ? State::pass : State::fail; }

/// "pass", "not covered".
Message word(State state);
/// The same for a set of checks: "every check passes".
Message overall(State state);
/// The word as one name: "not-covered".
std::string slug(State state);
/// A sign that says the same without colour.
const char* mark(State state);

}  // namespace loadpath::account
