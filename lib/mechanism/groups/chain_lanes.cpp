#include "lib/mechanism/groups/chain_lanes.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

LOADPATH_LANES void move(const Chain& chain, ChainState<lane_count>& now) {
  ChainSolver<lane_count>(chain, now).move();
}

LOADPATH_LANES void find_forces(const Chain& chain, ChainState<lane_count>& now, bool statics) {
  ChainSolver<lane_count>(chain, now).find_forces(statics);
}

}  // namespace

bool solve_lanes(const Chain& chain, ChainState<lane_count>& now, bool statics) {
  move(chain, now);
  if (!std::ranges::all_of(now.clear, [](double c) { return c != 0.0; })) return false;
  find_forces(chain, now, statics);
  return true;
}

}  // namespace loadpath::mechanism
