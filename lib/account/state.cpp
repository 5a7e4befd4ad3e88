#include "lib/account/state.hpp"

#include <algorithm>

namespace loadpath::account {
namespace {

struct Words {
  const char *word, *overall, *mark;
};

Words words(State state) {
  switch (state) {
    case State::pass:
      return {"pass", "every check passes", "✓"};
    case State::not_covered:
      return {"not covered", "something is not covered", "◇"};
    case State::not_available:
      return {"not available", "something is not available", "–"};
    case State::fail:
      return {"fail", "a check fails", "✗"};
  }
  return {"", "", ""};
}

}  // namespace

Message word(State state) { return say(words(state).word); }

Message overall(State state) { return say(words(state).overall); }

std::string slug(State state) {
  std::string name = words(state).word;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

const char* mark(State state) { return words(state).mark; }

}  // namespace loadpath::account
