// Scale bars of a round length with the value they represent.
#pragma once

#include "lib/draw/canvas/canvas.hpp"

#include <string>

namespace loadpath::draw {

std::string force_text(double newton);
std::string length_text(double metre);

/// A bar from `from` to the right; returns where the next one may begin.
double scale_bar(Canvas& canvas, Point from, double view_per_si, std::string (*written)(double));

}  // namespace loadpath::draw
