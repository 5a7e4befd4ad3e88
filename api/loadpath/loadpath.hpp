// All of the library: machines from project files and from calculators, one or a million of them.
#pragma once

#include <loadpath/calculator.hpp>
#include <loadpath/project.hpp>
#include <loadpath/units.hpp>

namespace loadpath::api {

/// "0.2.0"
const char* version();

}  // namespace loadpath::api
