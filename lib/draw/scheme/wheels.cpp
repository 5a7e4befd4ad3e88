// Wheels, belts, racks and cams of a mechanism's picture.
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/scheme/picture.hpp"

namespace loadpath::draw {
namespace {

using Span = std::pair<Point, Point>;

/// The two straight spans of a belt between its wheels, in the plane of the mechanism.
std::vector<Span> spans(const figure::Scheme::Belt& belt) {
  const Point apart = belt.to - belt.from;
  const double distance = length(apart), sense = belt.crossed ? -1.0 : 1.0;
  const double sine = (belt.radius_from - sense * belt.radius_to) / distance;
  if (!(std::fabs(sine) < 1.0)) return {};
  const double cosine = std::sqrt(1.0 - sine * sine);
  std::vector<Span> both;
  for (const double side : {1.0, -1.0}) {
    const Point e = unit(apart), outward = sine * e + side * cosine * across(e);
    both.emplace_back(belt.from + belt.radius_from * outward, belt.to + sense * belt.radius_to * outward);
  }
  return both;
}

}  // namespace

void SchemePicture::draw_belts() {
  for (const auto& belt : scheme_.belts) {
    for (const auto& [from, to] : spans(belt)) {
      canvas_.line("outline", at(from), at(to));
      labels_.keep_off({at(from), at(to)}, 2.0);
    }
  }
}

void SchemePicture::draw_racks() {
  for (std::size_t n = 0; n < scheme_.racks.size(); ++n) {
    const auto& rack = scheme_.racks[n];
    const Point from = at(rack.from), to = at(rack.to);
    const Point away = (rack.left ? 1.0 : -1.0) * across(unit(to - from));  // the page counts downwards
    carried(carrier(&figure::Motion::racks, n), rack.from, [&] {
      if (rack.toothed) canvas_.line("centre", from, to);
      const Point shift = (rack.toothed ? 4.0 : 0.0) * away;
      canvas_.line("outline", from + shift, to + shift);
      if (rack.fixed) rack.left ? hatch(canvas_, from + shift, to + shift) : hatch(canvas_, to + shift, from + shift);
    });
    labels_.keep_off({from, to}, 8.0);
  }
}

void SchemePicture::draw_wheel(const figure::Scheme::Wheel& wheel) {
  const Point centre = at(wheel.at);
  const double radius = fit_.scale * std::fabs(wheel.radius);
  canvas_.circle("wheel", centre, radius);
  if (wheel.fixed) return;
  const Point towards{std::cos(wheel.angle), -std::sin(wheel.angle)};
  canvas_.line("light", centre, centre + radius * towards);
}

void SchemePicture::draw_outlines() {
  for (std::size_t n = 0; n < scheme_.outlines.size(); ++n) {
    const auto& outline = scheme_.outlines[n];
    std::vector<Point> points;
    for (const Point p : outline.points) points.push_back(at(p));
    carried(carrier(&figure::Motion::outlines, n), outline.at, [&] { canvas_.polygon("wheel", points); });
    labels_.keep_off(points, 2.0);
  }
}

void SchemePicture::draw_wheels() {
  for (std::size_t n = 0; n < scheme_.wheels.size(); ++n) {
    const auto& wheel = scheme_.wheels[n];
    carried(carrier(&figure::Motion::wheels, n), wheel.at, [&] { draw_wheel(wheel); });
    labels_.keep_off(ring(at(wheel.at), fit_.scale * std::fabs(wheel.radius)), 2.0, 0.6);
  }
}

}  // namespace loadpath::draw
