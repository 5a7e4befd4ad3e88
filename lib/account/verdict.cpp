#include "lib/account/verdict.hpp"

namespace loadpath::account {

State worst(const std::vector<Verdict>& verdicts) {
  State state = State::pass;
  for (const Verdict& row : verdicts) state = worse(state, row.state);
  return state;
}

}  // namespace loadpath::account
