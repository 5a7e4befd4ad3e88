// The steps that a step takes values of, and what both of them say of one part: the teeth of a stage, the diameter of a
// shaft, the pressure in a vessel. lib/project/run compares the two.
#pragma once

#include "lib/project/step.hpp"

#include <functional>
#include <map>
#include <string>

namespace loadpath::project {

/// By the step, the place in a list of it: "2" of "train.shafts[2].T"; "1" where no reference names one, empty where
/// they name several, or what leaves the last: "train.P_out".
std::map<std::string, std::string> sources_of(const Reading& reading);
using Source = std::pair<const std::string, std::string>;

/// The path of a key there, in which '#' is the place; empty where that is not known.
std::string path_in(const Source& source, std::string key);

/// The keys that a field has there; empty where it is not compared.
const char* keys_in_sources(const FieldInfo& field);

/// Paths in other steps that inputs of this one are compared with: of records that have them too, and of sources.
void for_each_compared(const StepInput& step, const std::function<void(const std::string& path)>& visit);

}  // namespace loadpath::project
