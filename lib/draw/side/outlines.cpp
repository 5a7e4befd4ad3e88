#include "lib/draw/side/outlines.hpp"

#include "lib/draw/canvas/typeset.hpp"
#include "lib/draw/side/shaft_parts.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::draw {

namespace {

constexpr double beyond_shaft = 24.0, least_cut = 62.0;  // radius at which large hubs are cut off
constexpr double of_unknown = 14.0;                      // height of a hub of unknown diameter over the shaft

/// From left to right, at a height: the line of a part that goes on.
std::vector<Point> break_line(double left, double right, double y, double side) {
  constexpr double pitch = 9.0, depth = 3.0;
  const int teeth = std::max(2, static_cast<int>((right - left) / pitch));
  std::vector<Point> points{{left, y}};
  for (int i = 0; i < teeth; ++i)
    points.push_back({left + (right - left) * (i + 0.5) / teeth, y + (i % 2 == 0 ? side : -side) * depth});
  points.push_back({right, y});
  return points;
}

std::string newtons(double value) { return with_minus(format_quantity(value, "N", 4)); }

}  // namespace

void Outlines::add(const SideOutline& outline) {
  const double surface = std::max(outline.left_surface, outline.right_surface);
  Drawn drawn{outline, outline.radius, false};
  if (outline.is_bearing) {
    if (outline.radius > surface) all_.push_back(drawn);
    return;
  }
  if (outline.radius > 0.0 && outline.radius <= surface) return;
  const double most = outline.radius > 0.0 ? std::max(surface + beyond_shaft, least_cut) : surface + of_unknown;
  drawn.is_cut = !(outline.radius > 0.0) || outline.radius > most;
  if (drawn.is_cut) drawn.radius = most;
  all_.push_back(drawn);
}

double Outlines::reach() const {
  double most = 0.0;
  for (const Drawn& drawn : all_) most = std::max(most, drawn.radius);
  return most;
}

double Outlines::radius_at(double x) const {
  double most = 0.0;
  for (const Drawn& drawn : all_) {
    if (x >= drawn.of.left && x <= drawn.of.right) most = std::max(most, drawn.radius);
  }
  return most;
}

void Outlines::draw_hub(const Drawn& hub, double axis, double side, Canvas& canvas) {
  const double left = hub.of.left, right = hub.of.right, y = axis + side * hub.radius;
  std::vector<Point> points{{left, axis + side * hub.of.left_surface}};
  if (hub.is_cut) {
    for (const Point& point : break_line(left, right, y, side)) points.push_back(point);
  } else {
    points.insert(points.end(), {{left, y}, {right, y}});
  }
  points.push_back({right, axis + side * hub.of.right_surface});
  canvas.polyline("image", std::move(points));
}

/// The cross is upright, and does not touch the box.
void Outlines::draw_bearing(const Drawn& bearing, double axis, double side, Canvas& canvas) {
  constexpr double share = 0.3;
  const double surface = std::min(bearing.of.left_surface, bearing.of.right_surface);
  const double inner = axis + side * surface, outer = axis + side * bearing.radius;
  canvas.rectangle("pin", {bearing.of.left, std::min(inner, outer), bearing.of.right, std::max(inner, outer)});
  const Point centre{0.5 * (bearing.of.left + bearing.of.right), 0.5 * (inner + outer)};
  const double across = share * (bearing.of.right - bearing.of.left), up = share * std::fabs(outer - inner);
  canvas.strokes("thin", {{{centre.x - across, centre.y}, {centre.x + across, centre.y}},
                          {{centre.x, centre.y - up}, {centre.x, centre.y + up}}});
}

void Outlines::draw(double axis, Canvas& canvas) const {
  for (const Drawn& drawn : all_) {
    for (const double side : {-1.0, 1.0}) {
      if (drawn.of.is_bearing)
        draw_bearing(drawn, axis, side, canvas);
      else
        draw_hub(drawn, axis, side, canvas);
    }
  }
}

bool is_outlined(const figure::Shaft::Bearing& bearing) {
  return bearing.outline.width > 0.0 && bearing.outline.diameter > 0.0;
}

double largest_bearing(const figure::Shaft& shaft) {
  double most = 0.0;
  for (const auto& bearing : shaft.bearings) {
    if (is_outlined(bearing) && drawable(bearing.outline.diameter)) most = std::max(most, bearing.outline.diameter);
  }
  return most;
}

std::string bearing_words(const figure::Shaft::Bearing& bearing) {
  if (bearing.type.empty()) return bearing.label;
  const Message type = bearing.fixed ? say("{1}, locating", bearing.type) : say("{1}", bearing.type);
  return say("{1}: {2}", bearing.label, type).text();
}

std::string reaction_words(const figure::Shaft::Bearing& bearing) {
  const std::string radial = newtons(bearing.force);
  if (!shaft::acts(std::fabs(bearing.axial))) return radial;
  return say("{1}, axial {2}", radial, newtons(bearing.axial)).text();
}

std::string load_words(const figure::Shaft::Torque& torque) {
  std::string words;
  const auto add = [&](const std::string& part) { words += (words.empty() ? "" : ", ") + part; };
  if (torque.value != 0.0) add(with_minus(format_quantity(torque.value, "N*m", 4)));
  if (shaft::acts(torque.force)) add(newtons(torque.force));
  if (shaft::acts(std::fabs(torque.axial))) add(say("axial {1}", newtons(torque.axial)).text());
  return words;
}

}  // namespace loadpath::draw
