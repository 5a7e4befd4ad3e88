// The signs of a mechanism scheme, in view units: supports, blocks, hatched lines, arrows.
#pragma once

#include "lib/draw/canvas/canvas.hpp"

namespace loadpath::draw {

inline constexpr double pin_radius = 4.6;
inline constexpr double block_length = 26.0, block_width = 14.0;
inline constexpr double couple_radius = 19.0;
inline constexpr double coil_radius = 13.0;
inline constexpr double spring_half = 6.0;  // across

/// A closed polygon close to the circle.
std::vector<Point> ring(Point centre, double radius);

std::vector<Point> convex_hull(std::vector<Point> points);

/// A rectangle of the slider's size, its length along `direction`.
std::vector<Point> block(Point centre, Point direction);

/// Short strokes on the right-hand side going from `from` to `to`: the side of the ground.
void hatch(Canvas& canvas, Point from, Point to);

/// A triangle with its tip in the pin, on hatched ground that lies in `direction`.
void support(Canvas& canvas, Point pin, Point direction);

/// A triangle filled between two directions from a corner: links that are one piece.
void weld(Canvas& canvas, Point corner, Point along, Point other);
/// A link that is built into hatched ground; `direction` from the ground into the link.
void clamp(Canvas& canvas, Point end, Point direction);

/// A spring, a damper, or both in parallel, from point to point.
void spring(Canvas& canvas, Point from, Point to, bool pulls, bool damps);
/// A spring, or damper, that turns about a point.
void coil(Canvas& canvas, Point at, bool pulls);

/// A filled head with its tip at `tip`.
void arrow_head(Canvas& canvas, std::string_view fill, Point tip, Point direction, double size);
/// `colour`: the number of the accent.
void arrow(Canvas& canvas, int colour, Point from, Point to);
/// Three quarters of a turn around the point, open towards `opening`, counter-clockwise on the page when positive.
void couple(Canvas& canvas, Point at, Point opening, bool positive);

}  // namespace loadpath::draw
