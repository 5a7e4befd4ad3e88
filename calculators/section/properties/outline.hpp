// Contours of sections in the plane of the sketch: for the distances of extreme fibres and for drawing.
#pragma once

#include "calculators/section/properties/properties.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::section {

struct Place {
  Length y = unset<Length>, z = unset<Length>;
};
/// A closed contour; arcs are followed by a few points.
using Outline = List<Place, 64>;

Outline circle(Length d);
Outline rectangle(Length b, Length h, Length r = from_si<Length>(0.0));
Outline i_outline(Length h, Length b, Length t_w, Length t_f, Length r);
Outline channel_outline(Length h, Length b, Length t_w, Length t_f, Length r = from_si<Length>(0.0));
Outline angle_outline(Length h, Length b, Length t, Length r = from_si<Length>(0.0), Length r_2 = from_si<Length>(0.0));
Outline tee_outline(Length h, Length b, Length t_w, Length t_f, Length r = from_si<Length>(0.0));

Extremes disc(Length d);
Extremes box(Length b, Length h);
Extremes rounded_box(Length b, Length h, Length r);
Extremes corners_of(const Outline& outline);

/// The contours of one shape.
struct Contours {
  Outline outline;
  Outline hole;  // empty where it has none
};

/// Drawn contours: of material, and of holes in it.
struct Sketch {
  std::vector<Outline> material;
  std::vector<Outline> holes;
};

/// The section with its centroid and its axes.
std::vector<figure::Figure> figures(const Sketch& sketch, const Properties& properties);
std::vector<figure::Figure> figures(const Contours& contours, const Properties& properties);

}  // namespace loadpath::section
