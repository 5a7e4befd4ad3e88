#include "lib/account/state.hpp"

#include <algorithm>

namespace loadpath::account {
namespace {

struct Words {
  const char *word, *mark;
  int rank;
};

Words words(State state) {
  switch (state) {
    case State::pass:
      return {"pass", "✓", 0};
    case State::accepted:
      return {"accepted", "≈", 1};
    case State::open:
      return {"open", "○", 2};
    case State::not_judged:
      return {"not judged", "?", 3};
    case State::not_covered:
      return {"not covered", "◇", 4};
    case State::not_available:
      return {"not available", "–", 5};
    case State::fail:
      return {"fail", "✗", 6};
  }
  return {"", "", 0};
}

}  // namespace

int rank(State state) { return words(state).rank; }

State worse(State a, State b) { return rank(a) < rank(b) ? b : a; }

Message word(State state) { return say(words(state).word); }

std::string slug(State state) {
  std::string name = words(state).word;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

const char* mark(State state) { return words(state).mark; }

}  // namespace loadpath::account
