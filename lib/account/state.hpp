// The possible states of a check or a failure mode, and the words for them.
#pragma once

#include "lib/text/issue.hpp"

#include <string>

namespace loadpath::account {

enum class State {
  pass,
  accepted,       // by the user, with a reason
  open,           // may concern the part, but nothing states whether it does
  not_judged,     // concerns the part, and has not been assessed
  not_covered,    // outside the validity of the method
  not_available,  // a value is missing
  fail
};

/// Rank from good to bad: the worst of several decides. Independent of the order of the words.
constexpr int rank(State state) {
  switch (state) {
    case State::pass:
      return 0;
    case State::accepted:
      return 1;
    case State::open:
      return 2;
    case State::not_judged:
      return 3;
    case State::not_covered:
      return 4;
    case State::not_available:
      return 5;
    case State::fail:
      return 6;
  }
  return 0;
}
/// The worse of two.
constexpr State worse(State a, State b) { return rank(a) < rank(b) ? b : a; }

constexpr State pass_if(bool holds) { return holds ? State::pass : State::fail; }

/// The word of JSON, CSV and the programming interfaces: "pass", "not covered".
Message word(State state);
/// The word for the terminal and reports: "pass", "method not valid".
Message shown(State state);
/// The word as one name: "not-covered".
std::string slug(State state);
/// A mark of the same meaning without colour.
const char* mark(State state);

}  // namespace loadpath::account
