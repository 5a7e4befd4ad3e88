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

/// The results of a mechanism; results derived from others come after all others.
std::vector<Output> outputs_of(const Mechanism::Input& in, const mechanism::Model& model);

/// The same before there is a mechanism, as they are documented.
std::vector<ResultPattern> result_patterns();

/// Sources cited in addition to the common ones: all possible ones, and those of this mechanism.
std::vector<std::string> occasional_sources();
std::vector<std::string> sources_used(const Mechanism::Input& in, const mechanism::Structure& structure);

}  // namespace loadpath::planar
