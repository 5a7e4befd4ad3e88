// A figure's content drawn: what lib/draw/svg.cpp puts into one element.
#pragma once

#include "lib/draw/canvas/svg_writer.hpp"
#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

struct Picture {
  SvgWriter svg;
  double height = 0.0;
  std::string description;  // for screen readers
};

Picture picture(const Plot& plot);
Picture picture(const Scheme& scheme);
Picture picture(const Shaft& shaft);
Picture picture(const Plans& plans);
/// At the position that is printed.
Picture picture(const Motion& motion);
/// The chart that it holds.
Picture picture(const Charted& chart);

}  // namespace loadpath::draw
