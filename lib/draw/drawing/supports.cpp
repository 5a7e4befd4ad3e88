// The symbols of supports.
#include "lib/draw/drawing/view.hpp"
#include "lib/draw/scheme/parts.hpp"

namespace loadpath::draw {
namespace {

constexpr double half_ground = 13.0;  // half width of the ground
constexpr double depth = 15.0, gap = 4.0;

/// Hatched ground across `into`, its surface through the point.
void ground(Canvas& canvas, Point at, Point into) {
  const Point side = half_ground * across(into);
  canvas.line("outline", at + side, at - side);
  hatch(canvas, at + side, at - side);
}

/// A triangle on a line, and the ground below on which it slides.
void roller(Canvas& canvas, Point at, Point into) {
  const Point foot = at + depth * into, side = 8.5 * across(into);
  canvas.polygon("pin", {at, foot + side, foot - side});
  ground(canvas, foot + gap * into, into);
}

/// Two walls along the part, which permit neither rotation nor transverse displacement.
void sleeve(Canvas& canvas, Point at, Point into) {
  constexpr double clear = 5.0, long_half = 12.0;
  const Point out = across(into), along = long_half * into;
  for (const double side : {1.0, -1.0}) {
    const Point wall = at + side * clear * out;
    const Point from = wall + along, to = wall - along;
    canvas.line("outline", from, to);
    side > 0.0 ? hatch(canvas, to, from) : hatch(canvas, from, to);
  }
}

/// A plate on two wheels.
void plate(Canvas& canvas, Point at, Point into) {
  constexpr double wheel = 2.6;
  const Point side = half_ground * across(into), below = (1.2 + wheel) * into;
  canvas.line("bar", at + side, at - side);
  for (const double share : {0.6, -0.6}) canvas.circle("pin", at + share * side + below, wheel);
  ground(canvas, at + 2.0 * below, into);
}

}  // namespace

void ViewPicture::draw_support(const figure::Drawing::Support& given) {
  using Kind = figure::Drawing::Support::Kind;
  const Point place = at(given.at), into = unit(Point{given.into.x, -given.into.y});
  switch (given.kind) {
    case Kind::hinge:
      support(canvas_, place, into);
      canvas_.circle("pin", place, pin_radius);
      break;
    case Kind::clamp:
      ground(canvas_, place, into);
      break;
    case Kind::roller:
      roller(canvas_, place, into);
      canvas_.circle("pin", place, pin_radius);
      break;
    case Kind::sleeve:
      sleeve(canvas_, place, into);
      break;
    case Kind::plate:
      plate(canvas_, place, into);
      break;
  }
  const Point middle = given.kind == Kind::sleeve ? place : place + 13.0 * into;
  labels_.keep_off(Box::around(middle, 28.0, 28.0));
}

}  // namespace loadpath::draw
