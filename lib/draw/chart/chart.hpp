// A chart as a page shows it whose points can be told: the picture, and what a script needs to find and to tell them.
#pragma once

#include "lib/figure/chart.hpp"

#include <string>

namespace loadpath::draw {

struct ToldChart {
  std::string svg;   // with a circle data-here, hidden
  std::string data;  // JSON, without what could end a script
};

/// `figure` holds a chart.
ToldChart told_chart(const Figure& figure);

/// What is told of a dot: "12.5", a word; a dash where there is nothing.
std::string told_text(const Chart::Told& told, std::size_t dot);

}  // namespace loadpath::draw
