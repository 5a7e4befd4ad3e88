// A key in the section across the shaft, with the depths of both keyways and its forces, and along the shaft.
#include "calculators/shaft/key.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace loadpath::shaft {

namespace {

using figure::Drawing;
using figure::Point;
using Points = std::vector<Point>;

/// Sizes in SI; the hub's own where the root circle of its teeth gives them.
struct KeySizes {
  double R, b, h, t_1, t_2, R_hub;
  bool two;
};

KeySizes sizes_of(const Key::Input& in) {
  const double R = 0.5 * in_si(in.d), h = in_si(in.h), t_1 = in_si(in.t_1);
  const double t_2 = is_set(in.t_2) ? in_si(in.t_2) : h - t_1;
  const double R_hub = is_set(in.d_f) ? 0.5 * in_si(in.d_f) : 1.25 * R + 1.5 * t_2;
  return {R, in_si(in.b), h, t_1, t_2, R_hub, in.i > 1};
}

/// A circle with slots at the top, and at the bottom if there are two, whose bottoms lie at a distance from its axis.
Points slotted(const KeySizes& s, double bottom) {
  constexpr int steps = 60;
  const double half = std::asin(std::min(1.0, 0.5 * s.b / s.R)), side = 0.5 * s.b;
  const double end = s.two ? 1.5 * pi - half : 2.5 * pi - half;  // the left half, or all around
  Points outline{{side, bottom}, {-side, bottom}};
  for (int k = 0; k <= steps; ++k) {
    const double angle = 0.5 * pi + half + (end - 0.5 * pi - half) * k / steps;
    outline.push_back({s.R * std::cos(angle), s.R * std::sin(angle)});
  }
  if (!s.two) return outline;
  const Points upper = outline;  // the same, turned by half a revolution
  for (const Point p : upper) outline.push_back({-p.x, -p.y});
  return outline;
}

Points circle_points(double radius) { return figure::polygon_of_circle({}, radius, 90); }

void add_box(double left, double right, double low, double high, Drawing::Kind kind, const std::string& name,
             Drawing::View& view) {
  const Points outline{{left, low}, {right, low}, {right, high}, {left, high}};
  view.areas.push_back({outline, kind, name});
  if (kind == Drawing::Kind::body) view.paths.push_back({outline, Drawing::Line::outline, true});
}

void add_depths(const Key::Input& in, const KeySizes& s, Drawing::View& view) {
  const double side = 0.5 * s.b, low = s.R - s.t_1;
  view.lengths.push_back({{-side, s.R + s.t_2}, {side, s.R + s.t_2}, {"b", s.b, "mm"}, Drawing::Side::above});
  view.lengths.push_back({{side, low}, {side, s.R}, {"t_1", s.t_1, "mm"}, Drawing::Side::right});
  if (is_set(in.t_2))
    view.lengths.push_back({{side, s.R}, {side, s.R + s.t_2}, {"t_2", s.t_2, "mm"}, Drawing::Side::right});
  view.lengths.push_back({{-side, low}, {-side, low + s.h}, {"h", s.h, "mm"}, Drawing::Side::left});
  view.radii.push_back({{0.0, 0.0}, s.R, -0.25 * pi, {"d", 2.0 * s.R, "mm"}, true});
}

/// Across the shaft; the force of the hub on the key, and that of the shaft.
Drawing::View across(const Key::Input& in, const Key::Result& r, const KeySizes& s) {
  const double bore = 0.5 * in_si(in.d_bore), low = s.R - s.t_1, beyond = 1.12 * s.R_hub;
  Drawing::View view;
  view.share = is_set(in.l) ? 0.58 : 1.0, view.room = 40.0;
  view.areas.push_back({circle_points(s.R_hub), Drawing::Kind::cut, say("hub").text(), slotted(s, s.R + s.t_2)});
  view.areas.push_back(
      {slotted(s, low), Drawing::Kind::cut, say("shaft").text(), bore > 0.0 ? circle_points(bore) : Points()});
  add_box(-0.5 * s.b, 0.5 * s.b, low, low + s.h, Drawing::Kind::body, say("key").text(), view);
  if (s.two) add_box(-0.5 * s.b, 0.5 * s.b, -low - s.h, -low, Drawing::Kind::body, say("key").text(), view);
  view.paths.push_back({{{0.0, -beyond}, {0.0, beyond}}, Drawing::Line::centre});
  view.paths.push_back({{{-beyond, 0.0}, {beyond, 0.0}}, Drawing::Line::centre});
  add_depths(in, s, view);
  if (const double F_t = in_si(r.F_t); is_set(r.F_t) && F_t > 0.0 && !s.two) {
    view.forces.push_back({{0.5 * s.b, 0.5 * (s.R + low + s.h)}, {-F_t, 0.0}, {"F_t", F_t, "N"}, true, 0.0, true});
    view.forces.push_back({{-0.5 * s.b, 0.5 * (s.R + low)}, {F_t, 0.0}, {"F_t", F_t, "N"}, false, 0.0, true});
  }
  if (!is_set(in.d_f)) view.note = say("outside of the hub: sketch").text();
  return view;
}

/// Along the shaft: the length of the key in its hub.
Drawing::View along(const Key::Input& in, const KeySizes& s) {
  const double l = in_si(in.l), l_n = is_set(in.l_n) ? in_si(in.l_n) : l, low = s.R - s.t_1;
  const double beyond = 0.6 * std::max(l, l_n) + 0.1 * l;
  Drawing::View view;
  view.share = 0.42;
  for (const double side : {1.0, -1.0}) {
    const double from = side > 0.0 ? s.R : -s.R_hub, to = side > 0.0 ? s.R_hub : -s.R;
    add_box(-0.5 * l_n, 0.5 * l_n, from, to, Drawing::Kind::cut, side > 0.0 ? say("hub").text() : "", view);
  }
  add_box(-beyond, beyond, -s.R, s.R, Drawing::Kind::body, say("shaft").text(), view);
  add_box(-0.5 * l, 0.5 * l, low, low + s.h, Drawing::Kind::body, say("key").text(), view);
  view.paths.push_back({{{-1.1 * beyond, 0.0}, {1.1 * beyond, 0.0}}, Drawing::Line::centre});
  view.lengths.push_back({{-0.5 * l, s.R_hub}, {0.5 * l, s.R_hub}, {"l", l, "mm"}, Drawing::Side::above});
  if (is_set(in.l_n))
    view.lengths.push_back({{-0.5 * l_n, -s.R_hub}, {0.5 * l_n, -s.R_hub}, {"l_n", l_n, "mm"}, Drawing::Side::below});
  return view;
}

}  // namespace

std::vector<figure::Figure> Key::figures(const Input& in, const Result& r) {
  if (!sizes_given(in) || !is_set(in.d)) return {};
  const KeySizes s = sizes_of(in);
  auto drawing = std::make_shared<Drawing>();
  drawing->views = {across(in, r, s)};
  if (is_set(in.l)) drawing->views.push_back(along(in, s));
  return {{"key", "Section through shaft, hub and key, with the forces on the key", figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::shaft
