// Descent without slopes: looking around in all directions, closer and closer.
#pragma once

#include "lib/sweep/search/trials.hpp"

namespace loadpath::sweep {

/// The best of polls around `best` over the free variables, from steps of `size` of their ranges on down to 1e-8, in
/// orthogonal directions that are turned from poll to poll (mesh adaptive direct search with an extreme barrier after
/// Audet and Dennis 2006, as recalled).
[[nodiscard]] Trial polled(Trials& trials, Trial best, std::span<const std::size_t> free, double size);

}  // namespace loadpath::sweep
