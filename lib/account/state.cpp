#include "lib/account/state.hpp"

#include <algorithm>

namespace loadpath::account {
namespace {

struct Words {
  const char *word, *mark;
};

Words words(State state) {
  switch (state) {
    case State::pass:
      return {"pass", "✓"};
    case State::accepted:
      return {"accepted", "≈"};
    case State::open:
      return {"open", "○"};
    case State::not_judged:
      return {"not judged", "?"};
    case State::not_covered:
      return {"not covered", "◇"};
    case State::not_available:
      return {"not available", "–"};
    case State::fail:
      return {"fail", "✗"};
  }
  return {"", ""};
}

}  // namespace

Message word(State state) { return say(words(state).word); }

std::string slug(State state) {
  std::string name = words(state).word;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

const char* mark(State state) { return words(state).mark; }

}  // namespace loadpath::account
