// A calculator on one screen: what it is for, what it needs, what it gives, what it assesses, and how it is called.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <string>

namespace loadpath::cli {

/// At most 30 lines of 80 characters.
std::string short_form(const Calculator& calculator);

}  // namespace loadpath::cli
