// Springs, dampers and welds of a mechanism's picture.
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/scheme/picture.hpp"

#include <numbers>

namespace loadpath::draw {
namespace {

constexpr double spring_half = 6.0;  // across
constexpr double least_length = 4.0;
constexpr int windings = 6;

void zigzag(Canvas& canvas, Point from, Point to) {
  const Point d = unit(to - from), side = spring_half * across(d);
  const double whole = length(to - from), lead = std::min(10.0, 0.15 * whole);
  const double pitch = (whole - 2.0 * lead) / windings;
  std::vector<Point> points{from, from + lead * d};
  for (int n = 0; n < windings; ++n) {
    const Point start = from + (lead + n * pitch) * d;
    points.push_back(start + 0.25 * pitch * d + side);
    points.push_back(start + 0.75 * pitch * d - side);
  }
  points.push_back(to - lead * d);
  points.push_back(to);
  canvas.polyline("outline", points);
}

/// A cylinder, open towards `to`, with the piston in its middle.
void dashpot(Canvas& canvas, Point from, Point to) {
  const Point d = unit(to - from), side = spring_half * across(d);
  const double whole = length(to - from), half = std::min(14.0, 0.3 * whole);
  const Point middle = 0.5 * (from + to), bottom = middle - half * d, mouth = middle + half * d;
  canvas.line("outline", from, bottom);
  canvas.polyline("outline", {mouth + side, bottom + side, bottom - side, mouth - side});
  canvas.line("rail", middle + 0.75 * side, middle - 0.75 * side);
  canvas.line("outline", middle, to);
}

}  // namespace

void spring(Canvas& canvas, Point from, Point to, bool pulls, bool damps) {
  if (length(to - from) < least_length) return;
  if (!damps) return zigzag(canvas, from, to);
  if (!pulls) return dashpot(canvas, from, to);
  const Point d = unit(to - from), aside = 1.5 * spring_half * across(d);
  const Point first = from + 0.12 * (to - from), last = to - 0.12 * (to - from);
  canvas.line("outline", from, first);
  canvas.line("outline", last, to);
  canvas.line("outline", first + aside, first - aside);
  canvas.line("outline", last + aside, last - aside);
  zigzag(canvas, first + aside, last + aside);
  dashpot(canvas, first - aside, last - aside);
}

void coil(Canvas& canvas, Point at, bool pulls) {
  constexpr int steps = 40;
  constexpr double turns = 2.25;
  if (!pulls) {  // a damper: a drum
    canvas.circle("outline", at, coil_radius);
    return canvas.circle("outline", at, 0.65 * coil_radius);
  }
  std::vector<Point> points;
  for (int n = 0; n <= steps; ++n) {
    const double part = static_cast<double>(n) / steps, radius = pin_radius + part * (coil_radius - pin_radius);
    points.push_back(at + radius * along(2.0 * std::numbers::pi * turns * part));
  }
  canvas.polyline("outline", points);
}

void weld(Canvas& canvas, Point corner, Point along, Point other) {
  constexpr double leg = 14.0;
  canvas.polygon("solid", {corner, corner + leg * along, corner + leg * other});
}

void clamp(Canvas& canvas, Point end, Point direction) {
  constexpr double half = 14.0;
  const Point side = half * across(direction);
  canvas.line("outline", end + side, end - side);
  hatch(canvas, end - side, end + side);
}

void SchemePicture::draw_springs() {
  for (std::size_t n = 0; n < scheme_.springs.size(); ++n) {
    const auto& s = scheme_.springs[n];
    const Point from = at(s.from), to = at(s.to);
    const bool moves = motion_ != nullptr;
    if (moves) canvas_.begin_group({{"data-between", text_of(motion_->springs[n], from, to)}});
    spring(canvas_, from, to, s.pulls, s.damps);
    if (moves) canvas_.end_group();
    labels_.keep_off({from, to}, (s.pulls && s.damps ? 2.5 : 1.0) * spring_half);
  }
  for (std::size_t n = 0; n < scheme_.coils.size(); ++n) {
    const auto& c = scheme_.coils[n];
    carried(carrier(&Motion::coils, n), c.at, [&] { coil(canvas_, at(c.at), c.pulls); });
    labels_.keep_off(ring(at(c.at), coil_radius), 2.0);
  }
}

/// From a joint along its links to their other points, in view units; a link's first one is enough.
std::vector<Point> SchemePicture::directions_at(const Scheme::Joint& joint) const {
  std::vector<Point> directions;
  for (const auto& body : scheme_.bodies) {
    const auto near = [&](Point p) { return length(at(p) - at(joint.at)) < 1.0; };
    if (!std::any_of(body.points.begin(), body.points.end(), near)) continue;
    const auto other = std::find_if_not(body.points.begin(), body.points.end(), near);
    if (other != body.points.end()) directions.push_back(unit(at(*other) - at(joint.at)));
  }
  return directions;
}

void SchemePicture::draw_weld(const Scheme::Joint& joint) {
  const std::vector<Point> directions = directions_at(joint);
  const Point between{std::cos(joint.angle), -std::sin(joint.angle)};
  Point first = between, second = between;  // of the links that meet here, those with the weld between them
  double most = -1.0;
  for (std::size_t a = 0; a < directions.size(); ++a) {
    for (std::size_t b = joint.fixed ? a : a + 1; b < (joint.fixed ? a + 1 : directions.size()); ++b) {
      const Point sum = directions[a] + directions[b];
      const double fit = length(sum) > 0.1 ? dot(unit(sum), between) : 0.0;
      if (fit > most) most = fit, first = directions[a], second = directions[b];
    }
  }
  if (joint.fixed) return clamp(canvas_, at(joint.at), first);
  if (std::fabs(cross(first, second)) > 0.1) return weld(canvas_, at(joint.at), first, second);
  const Point side = 6.0 * across(first);  // in one line: a seam across
  canvas_.line("rail", at(joint.at) + side, at(joint.at) - side);
}

void SchemePicture::label_springs() {
  for (std::size_t n = 0; n < scheme_.springs.size(); ++n) {
    const auto& s = scheme_.springs[n];
    const Text text = typeset(s.name);
    const auto places = beside(at(s.from), at(s.to), 3.0 + spring_half, width(text, text_size));
    const int by = motion_ == nullptr ? -1 : motion_->springs[n].from;
    const Box place = labels_.place(places);
    carried({by, -1}, fit_.back(place.centre()), [&] { canvas_.centred_text("quiet halo", place, text); });
  }
  for (std::size_t n = 0; n < scheme_.coils.size(); ++n) {
    const auto& c = scheme_.coils[n];
    const Text text = typeset(c.name);
    carried({carrier(&Motion::coils, n).place, -1}, c.at,
            [&] { label("quiet halo", around(at(c.at), coil_radius + 2.0, width(text, text_size)), text); });
  }
}

}  // namespace loadpath::draw
