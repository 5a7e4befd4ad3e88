// A figure's content drawn, for the writers (svg_writer.hpp, lib/draw/tikz).
#pragma once

#include "lib/draw/canvas/canvas.hpp"
#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

struct Picture {
  Canvas canvas;
  double height = 0.0;
  std::string description;  // for screen readers
  double width = view_width;
};

Picture picture(const Plot& plot);
Picture picture(const Scheme& scheme);
Picture picture(const Shaft& shaft);
Picture picture(const Plans& plans);
/// At the position that is printed.
Picture picture(const Motion& motion);
/// The chart that it holds.
Picture picture(const Charted& chart);
/// The drawing that it holds.
Picture picture(const Drawn& drawing);
/// The bounds of its content.
Picture picture(const Figure& figure);

}  // namespace loadpath::draw
