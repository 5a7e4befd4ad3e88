// Eight positions of a chain of dyads side by side.
#pragma once

#include "lib/mechanism/groups/chain_state.hpp"

#include <cstddef>

namespace loadpath::mechanism {

inline constexpr std::size_t lane_count = 8;

/// Motion and forces by drives, loads and sides that are set in `now`. False if some lane is near a change point;
/// there are no forces then.
bool solve_lanes(const Chain& chain, ChainState<lane_count>& now, bool statics);

}  // namespace loadpath::mechanism
