// What a mechanism cites beyond what every one does: only where it uses it.
#pragma once

#include "calculators/mechanism/words/mechanism.hpp"
#include "lib/mechanism/structure/structure.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// All keys that a mechanism may cite so, of tables/sources.toml.
std::vector<std::string> occasional_sources();

/// Of them those that this one uses.
std::vector<std::string> sources_used(const Mechanism::Input& in, const mechanism::Structure& structure);

}  // namespace loadpath::planar
