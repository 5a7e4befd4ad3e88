// Numbers of a picture: at most two decimals, finite for any figure.
#pragma once

#include <string>

namespace loadpath::draw {

/// "-12.5", ".25"; a value beyond `limit` is moved to it, one that is not finite to 0.
void append_number(std::string& out, double value, double limit = 1e6);

}  // namespace loadpath::draw
