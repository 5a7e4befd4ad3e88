// Worm and wheel seen along the axis of the wheel, and in section through it.
#include "calculators/gear/worm/worm.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace loadpath::gear {

namespace worm_figure {

namespace {

using figure::Drawing;
using figure::Point;
using Input = WormTypes::Input;
using Result = WormTypes::Result;

std::vector<Point> box(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

void add_box(double left, double right, double low, double high, const std::string& name, Drawing::View& view) {
  view.areas.push_back({box(left, right, low, high), Drawing::Kind::body, name});
  view.paths.push_back({box(left, right, low, high), Drawing::Line::outline, true});
}

/// The crests of the threads on the visible half of the worm: half a lead from edge to edge.
void add_threads(const Input& in, const Result& r, Drawing::View& view) {
  const double length = in_si(r.L_1), half = 0.5 * in_si(r.p_z), y = in_si(r.a), radius = 0.5 * in_si(r.d_a1);
  const double pitch = in_si(r.p_x), top = in.hand == Hand::left ? half : -half;
  const int count = static_cast<int>(std::floor(0.5 * std::max(0.0, length - half) / pitch));
  for (int i = -count; i <= count; ++i) {
    const double x = i * pitch;
    view.paths.push_back({{{x + 0.5 * top, y + radius}, {x - 0.5 * top, y - radius}}, Drawing::Line::thin});
  }
}

void add_worm(const Input& in, const Result& r, Drawing::View& view) {
  const double y = in_si(r.a), end = 0.5 * in_si(r.L_1), shaft = 0.35 * in_si(r.d_f1), stub = end + 0.6 * in_si(r.d_f1);
  for (const double side : {-1.0, 1.0})
    add_box(std::min(side * stub, side * end), std::max(side * stub, side * end), y - shaft, y + shaft,
            say("shaft of the worm").text(), view);
  add_box(-end, end, y - 0.5 * in_si(r.d_a1), y + 0.5 * in_si(r.d_a1), say("worm").text(), view);
  add_threads(in, r, view);
  const double d = 0.5 * in_si(in.d_1);
  for (const double at : {y - d, y, y + d})
    view.paths.push_back({{{-1.04 * stub, at}, {1.04 * stub, at}}, Drawing::Line::centre});
  view.lengths.push_back({{-end, y - d}, {-end, y + d}, {"d_1", in_si(in.d_1), "mm"}, Drawing::Side::left});
  view.lengths.push_back({{-end, y + 0.5 * in_si(r.d_a1)},
                          {end, y + 0.5 * in_si(r.d_a1)},
                          {"L_1", 2.0 * end, "mm"},
                          Drawing::Side::above});
}

void add_cross(double reach, Drawing::View& view) {
  view.paths.push_back({{{-reach, 0.0}, {reach, 0.0}}, Drawing::Line::centre});
  view.paths.push_back({{{0.0, -reach}, {0.0, reach}}, Drawing::Line::centre});
}

Drawing::View along_wheel(const Input& in, const Result& r) {
  Drawing::View view;
  view.share = 0.6;
  view.room = 40.0;
  // As an area, which the worm in front of it covers.
  const std::vector<Point> disc = figure::polygon_of_circle({0.0, 0.0}, 0.5 * in_si(r.d_a2), 180);
  view.areas.push_back({disc, Drawing::Kind::body, say("wheel").text()});
  view.paths.push_back({disc, Drawing::Line::outline, true});
  view.circles.push_back({{0.0, 0.0}, 0.5 * in_si(r.d_2), Drawing::Line::centre});
  view.circles.push_back({{0.0, 0.0}, 0.5 * in_si(r.d_f2), Drawing::Line::thin});
  if (is_set(in.bore_2)) view.circles.push_back({{0.0, 0.0}, 0.5 * in_si(in.bore_2), Drawing::Line::outline});
  add_cross(0.54 * in_si(r.d_a2), view);
  add_worm(in, r, view);
  view.lengths.push_back({{0.0, 0.0}, {0.0, in_si(r.a)}, {"a", in_si(r.a), "mm"}, Drawing::Side::right});
  view.radii.push_back({{0.0, 0.0}, 0.5 * in_si(r.d_2), -0.25 * pi, {"d_2", in_si(r.d_2), "mm"}, true});
  if (in_si(r.F_r) > 0.0) {
    const Point pitch{0.0, 0.5 * in_si(r.d_2)};
    view.forces.push_back({pitch, {0.0, -in_si(r.F_r)}, {"F_r", in_si(r.F_r), "N"}, true});
    view.note = say("radial force on the wheel, nominal; F_t2 acts along the worm").text();
  }
  return view;
}

Drawing::View along_worm(const Input& in, const Result& r) {
  Drawing::View view;
  view.share = 0.36;
  const double half = 0.5 * in_si(in.b_2), tip = 0.5 * in_si(r.d_a2);
  add_box(-half, half, -tip, tip, say("wheel").text(), view);
  const Point worm{0.0, in_si(r.a)};
  view.circles.push_back({worm, 0.5 * in_si(r.d_a1), Drawing::Line::outline, true});
  view.circles.push_back({worm, 0.5 * in_si(in.d_1), Drawing::Line::centre});
  view.circles.push_back({worm, 0.5 * in_si(r.d_f1), Drawing::Line::thin});
  view.paths.push_back({{{0.0, -1.06 * tip}, {0.0, in_si(r.a) + 0.6 * in_si(r.d_a1)}}, Drawing::Line::centre});
  view.paths.push_back({{{-1.3 * half, 0.0}, {1.3 * half, 0.0}}, Drawing::Line::centre});
  view.lengths.push_back({{-half, -tip}, {half, -tip}, {"b_2", in_si(in.b_2), "mm"}, Drawing::Side::below});
  view.lengths.push_back({{half, -tip}, {half, tip}, {"d_a2", 2.0 * tip, "mm"}, Drawing::Side::right});
  return view;
}

}  // namespace

}  // namespace worm_figure

std::vector<figure::Figure> Worm::figures(const Input& in, const Result& r) {
  if (!is_set(r.a) || !is_set(r.L_1) || !is_set(in.b_2)) return {};
  auto drawing = std::make_shared<figure::Drawing>();
  drawing->views = {worm_figure::along_wheel(in, r), worm_figure::along_worm(in, r)};
  return {{"worm_gear", "Worm and wheel, seen along the axis of the wheel and along that of the worm",
           figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::gear
