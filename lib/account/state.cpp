#include "lib/account/state.hpp"

#include <algorithm>

namespace loadpath::account {
namespace {

struct Words {
  const char *word, *shown, *mark;
};

Words words(State state) {
  switch (state) {
    case State::pass:
      return {"pass", "pass", "✓"};
    case State::accepted:
      return {"accepted", "accepted by user", "≈"};
    case State::open:
      return {"open", "not considered", "○"};
    case State::not_judged:
      return {"not judged", "not assessed", "?"};
    case State::not_covered:
      return {"not covered", "method not valid", "◇"};
    case State::not_available:
      return {"not available", "no result", "–"};
    case State::fail:
      return {"fail", "fail", "✗"};
  }
  return {"", "", ""};
}

}  // namespace

Message word(State state) { return say(words(state).word); }

Message shown(State state) { return say(words(state).shown); }

std::string slug(State state) {
  std::string name = words(state).word;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

const char* mark(State state) { return words(state).mark; }

}  // namespace loadpath::account
