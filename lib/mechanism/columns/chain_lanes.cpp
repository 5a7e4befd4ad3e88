#include "lib/mechanism/columns/chain_lanes.hpp"

#include "lib/mechanism/groups/chain_forces.hpp"
#include "lib/mechanism/groups/chain_motion.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

LOADPATH_LANES void move(const Chain& chain, ChainState<lane_count>& now) { ChainMover<lane_count>(chain, now).move(); }

LOADPATH_LANES void find_forces(const Chain& chain, ChainState<lane_count>& now, bool statics) {
  ChainForces<lane_count>(chain, now).find(statics);
}

}  // namespace

bool solve_lanes(const Chain& chain, ChainState<lane_count>& now, bool statics) {
  move(chain, now);
  if (!std::ranges::all_of(now.clear, [](double c) { return c != 0.0; })) return false;
  find_forces(chain, now, statics);
  return true;
}

}  // namespace loadpath::mechanism
