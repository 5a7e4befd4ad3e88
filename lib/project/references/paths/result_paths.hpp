// Paths of a step's results that a wrong one can have been meant for.
#pragma once

#include "lib/project/step.hpp"

#include <string>
#include <vector>

namespace loadpath::project {

/// "bearings.left", "seats.gear": elements of result lists, by the names that the lists of the input give.
std::vector<std::string> named_elements(const StepInput& input);

/// "shaft.bearings.left", "shaft.bearings.right" for "shaft.bearings"; of a list without names "shaft.pieces[1]".
std::vector<std::string> elements_of(const Step& step, const std::string& list);

/// The fault that a step has no such result, with the nearest path, or the element of that name.
Fault unknown_path(const StepInput& input, const std::string& path);

/// "shaft.bearings.left" for "shaft.supports.left", where the latter does not have the key: the record of the same
/// element that has it; empty if none has.
std::string record_with(const Step& step, const std::string& source, const std::string& key);

}  // namespace loadpath::project
