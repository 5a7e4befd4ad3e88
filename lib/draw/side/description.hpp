// A drawn shaft in words, for screen readers.
#pragma once

#include "lib/draw/side/shaft_parts.hpp"

#include <string>
#include <vector>

namespace loadpath::draw::shaft {

std::string description(const std::vector<Cylinder>& cylinders, const std::vector<TorqueSign>& torques,
                        const std::vector<BearingSign>& bearings);

}  // namespace loadpath::draw::shaft
