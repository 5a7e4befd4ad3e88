// A chart in a page with data for its points: the picture, and the data that a script needs to find and to show them.
#pragma once

#include "lib/figure/chart.hpp"

#include <string>

namespace loadpath::draw {

struct InteractiveChart {
  std::string svg;   // with a circle data-here, hidden
  std::string data;  // JSON, without characters that could end a script
};

/// `figure` holds a chart.
InteractiveChart interactive_chart(const figure::Figure& figure);

/// The text for a dot: "12.5", a word; a dash if there is nothing.
std::string value_text(const figure::Chart::Column& readout, std::size_t dot);

}  // namespace loadpath::draw
