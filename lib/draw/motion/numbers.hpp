// The numbers displayed next to a motion, as text.
#pragma once

#include "lib/figure/figure.hpp"

#include <cstddef>
#include <string>

namespace loadpath::draw {

/// The text of a number of the motion at a frame, in its unit: "-1234.5"; a dash if there is none.
std::string number_text(const figure::Motion::Number& number, std::size_t frame);
/// The same as it is printed, with a minus sign.
std::string printed(std::string number);

}  // namespace loadpath::draw
