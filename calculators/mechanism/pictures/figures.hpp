// The figures of a planar mechanism.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/account/account.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::planar {

/// The mechanism at the first position, at each of up to 12 given angles, and where the drive is largest; drive and
/// reactions over the cycle.
std::vector<draw::Figure> mechanism_figures(const Mechanism::Input& in, const mechanism::Model& model,
                                            const Cycle& cycle, const account::Account& account, const Axis* axis);

}  // namespace loadpath::planar
