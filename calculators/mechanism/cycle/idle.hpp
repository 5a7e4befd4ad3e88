// Fields without effect for the given drive.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/text/issue.hpp"

#include <functional>
#include <string>
#include <vector>

namespace loadpath::planar {

/// `typed`: whether the user has typed the field at a path.
std::vector<FieldFault> idle_fields(const Mechanism::Input& in, const std::function<bool(const std::string&)>& typed);

}  // namespace loadpath::planar
