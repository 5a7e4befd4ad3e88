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

Picture picture(const figure::Plot& plot);
Picture picture(const figure::Scheme& scheme);
Picture picture(const figure::Shaft& shaft);
Picture picture(const figure::Plans& plans);
/// At the position that is printed.
Picture picture(const figure::Motion& motion);
/// The chart that it holds.
Picture picture(const figure::Charted& chart);
/// The drawing that it holds.
Picture picture(const figure::Drawn& drawing);
/// The bounds of its content.
Picture picture(const figure::Figure& figure);

}  // namespace loadpath::draw
