// What a search over the inputs of a project, or a look at their influence, has found as JSON, in SI.
#pragma once

#include "lib/project/sweep/studies/best.hpp"
#include "lib/project/sweep/studies/influence.hpp"

#include <string>

namespace loadpath::exports {

std::string json_of(const project::Project& project, const project::Best& best);
std::string json_of(const project::Project& project, const project::SoughtValue& sought);
std::string json_of(const project::Project& project, const project::Influence& influence);

}  // namespace loadpath::exports
