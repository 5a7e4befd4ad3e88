#include "lib/draw/diagrams.hpp"

#include "lib/draw/canvas/rows.hpp"
#include "lib/draw/plot/strip.hpp"

#include <algorithm>

namespace loadpath::draw {
namespace {

constexpr double depth = 60.0, gap = 35.0;  // height of a diagram, and the gap above it for its title

double at(const figure::Shaft::Place& place, Range along, double length) {
  return along.low + (along.high - along.low) * std::clamp(place.x / length, 0.0, 1.0);
}

/// Writes the names of the sections above the lines, and returns the space needed.
double name_places(const figure::Shaft& shaft, Range along, double length, double top, Canvas& canvas) {
  Rows rows;
  for (const figure::Shaft::Place& place : shaft.places) {
    const Text text = typeset(place.label);
    const double half = 0.5 * width(text, text_size), x = at(place, along, length);
    const double middle = std::clamp(x, half + 4.0, view_width - half - 4.0);
    const double row = static_cast<double>(rows.row_of(middle - half - 5.0, middle + half + 5.0));
    canvas.text("halo f1", {middle, top + row_height * (row + 1.0)}, text, Anchor::middle);
  }
  return shaft.places.empty() ? 0.0 : rows.height() + 4.0;
}

}  // namespace

Picture diagrams(const figure::Shaft& shaft, Range along, double length, double top) {
  Picture all;
  double y = top + name_places(shaft, along, length, top, all.canvas);
  const double bottom = y + (gap + depth) * static_cast<double>(shaft.diagrams.size());
  for (const figure::Shaft::Place& place : shaft.places) {  // below the titles of the diagrams
    const double x = at(place, along, length);
    all.canvas.line("light dash c1", {x, y + 6.0}, {x, bottom});
  }
  for (std::size_t i = 0; i < shaft.diagrams.size(); ++i) {
    const Box area{along.low, y + gap, along.high, y + gap + depth};
    const Strip strip{area, {0.0, length}, i + 1 == shaft.diagrams.size()};
    const Picture drawn = picture(shaft.diagrams[i], strip);
    all.canvas.append(drawn.canvas);
    all.description += "; " + drawn.description;
    all.height = drawn.height;
    y = area.bottom;
  }
  return all;
}

}  // namespace loadpath::draw
