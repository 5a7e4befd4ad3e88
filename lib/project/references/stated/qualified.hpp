// Values of [values] that are named by the symbol of an input and a word behind it: "sigma_adm_hub", "K_A_crusher".
#pragma once

#include "lib/project/references/references.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: a strength, an allowable value or a rating above a value of [values] that begins with its
/// symbol and that no step takes; a factor or a requirement below one.
std::vector<ReducedLoad> symbols_stated_otherwise(const Step& step, const Project& project);

}  // namespace loadpath::project
