// All aspects of a planar mechanism.
#pragma once

#include "calculators/mechanism/results/aspect.hpp"

#include <span>
#include <string>
#include <vector>

namespace loadpath::planar {

/// In the order of reports.
std::span<const Aspect* const> all_aspects();

/// Calls one of their functions for each that has it.
template <class... Takes, class... Given>
void ask_all(void (*Aspect::*function)(Takes...), Given&&... given) {
  for (const Aspect* aspect : all_aspects()) {
    if (aspect->*function != nullptr) (aspect->*function)(given...);
  }
}

/// The results of a mechanism; what is read off other results stands behind all that is not.
std::vector<Output> outputs_of(const Mechanism::Input& in, const mechanism::Model& model);

/// The same before there is a mechanism, as they are documented.
std::vector<ResultPattern> result_patterns();

/// What a mechanism cites beyond what every one does: all that it may, and what this one uses.
std::vector<std::string> occasional_sources();
std::vector<std::string> sources_used(const Mechanism::Input& in, const mechanism::Structure& structure);

}  // namespace loadpath::planar
