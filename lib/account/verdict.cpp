#include "lib/account/verdict.hpp"

#include <algorithm>

namespace loadpath::account {

State worst(const std::vector<Verdict>& verdicts) {
  State state = State::pass;
  for (const Verdict& row : verdicts) state = std::max(state, row.state);
  return state;
}

}  // namespace loadpath::account
