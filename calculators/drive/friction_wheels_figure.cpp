// Friction wheels to scale: both wheels with the forces between them, and the contact; bevel wheels by their cones.
#include "calculators/drive/friction_wheels.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace loadpath::drive {

namespace {

using figure::at_angle;
using figure::Drawing;
using figure::Point;

void add_wheel(Point centre, double d, const char* symbol, Drawing::Side side, Drawing::Turn turn,
               Drawing::View& view) {
  const double r = 0.5 * d, cross = 0.12 * r;
  view.circles.push_back({centre, r, Drawing::Line::outline, true});
  view.paths.push_back({{{centre.x - cross, 0.0}, {centre.x + cross, 0.0}}, Drawing::Line::thin});
  view.paths.push_back({{{centre.x, -cross}, {centre.x, cross}}, Drawing::Line::thin});
  view.lengths.push_back({{centre.x, -r}, {centre.x, r}, {symbol, d, "mm"}, side});
  view.turns.push_back(std::move(turn));
}

/// The wheels from the side, the driving one turning clockwise; the forces are those on the driven wheel, with the
/// pressing force at the driving one.
Drawing::View wheels_view(const FrictionWheels::Input& in, const FrictionWheels::Result& r) {
  const double d_1 = in_si(in.d_1), d_2 = in_si(in.d_2), a = in_si(r.a), n_2 = in_si(r.n_2);
  const double off = 14.0 * (d_1 + d_2) / 400.0;  // of the arcs of rotation from the rims
  Drawing::View view;
  view.share = 0.64, view.room = 46.0;
  add_wheel({0.0, 0.0}, d_1, "d_1", Drawing::Side::left,
            {{0.0, 0.0}, 0.5 * d_1 + off, false, 0.5 * pi, Drawing::Value{"n_1", in_si(in.n_1), "rpm"}}, view);
  add_wheel({a, 0.0}, d_2, "d_2", Drawing::Side::right,
            {{a, 0.0}, 0.5 * d_2 + off, true, 0.5 * pi, Drawing::Value{"n_2", n_2, "rpm"}}, view);
  view.paths.push_back({{{0.0, 0.0}, {a, 0.0}}, Drawing::Line::centre});
  view.lengths.push_back({{0.0, 0.0}, {a, 0.0}, {"a", a, "mm"}, Drawing::Side::below});
  const double F_p = in_si(r.F_p), F_t = in_si(r.F_t), F_r = in_si(r.F_r2);
  view.forces.push_back({{0.0, 0.0}, {F_p, 0.0}, {"F_p", F_p, "N"}, true});
  view.forces.push_back({{0.5 * d_1, 0.0}, {0.0, -F_t}, {"F_t", F_t, "N"}, true});
  view.forces.push_back({{a, 0.0}, {-F_r, 0.0}, {"F_r2", F_r, "N"}, false, 0.0, true});
  return view;
}

void add_body(std::vector<Point> outline, std::string name, Drawing::View& view) {
  view.areas.push_back({outline, Drawing::Kind::body, std::move(name)});
  view.paths.push_back({std::move(outline), Drawing::Line::outline, true});
}

std::vector<Point> rectangle(double half_width, double low, double high) {
  return {{-half_width, low}, {half_width, low}, {half_width, high}, {-half_width, high}};
}

/// The rims across their axes, with the line of contact.
Drawing::View rims_view(const FrictionWheels::Input& in) {
  const double d_1 = in_si(in.d_1), d_2 = in_si(in.d_2), half = 0.5 * in_si(in.b);
  Drawing::View view;
  view.share = 0.36;
  add_body(rectangle(half, 0.0, d_1), say("driving wheel").text(), view);
  add_body(rectangle(half, -d_2, 0.0), say("driven wheel").text(), view);
  for (const double y : {0.5 * d_1, -0.5 * d_2})
    view.paths.push_back({{{-1.3 * half, y}, {1.3 * half, y}}, Drawing::Line::centre});
  view.paths.push_back({{{-half, 0.0}, {half, 0.0}}, Drawing::Line::contact});
  view.lengths.push_back({{-half, d_1}, {half, d_1}, {"b", 2.0 * half, "mm"}, Drawing::Side::above});
  return view;
}

/// One groove with the ridge in it; the flanks touch over b, above the bottom of the groove.
Drawing::View groove_view(const FrictionWheels::Input& in) {
  constexpr double begins = 0.2, ends = 1.2;  // of the contact along the flank, over b
  const double b = in_si(in.b), alpha = in.alpha, up = 0.5 * pi;
  const Point low = at_angle(up - alpha, begins * b), top = at_angle(up - alpha, ends * b);
  const double wide = 2.0 * top.x + 0.2 * b, deep = -0.4 * b, high = top.y + 0.4 * b;
  Drawing::View view;
  view.share = 0.36;
  view.areas.push_back({{{-wide, deep}, {wide, deep}, {wide, top.y}, top, {0.0, 0.0}, {-top.x, top.y}, {-wide, top.y}},
                        Drawing::Kind::cut,
                        say("grooved wheel").text()});
  add_body({low, top, {top.x, high}, {-top.x, high}, {-top.x, top.y}, {-low.x, low.y}}, say("ridge").text(), view);
  view.paths.push_back({{low, top}, Drawing::Line::contact});
  view.paths.push_back({{{-low.x, low.y}, {-top.x, top.y}}, Drawing::Line::contact});
  view.paths.push_back({{{0.0, deep}, {0.0, high}}, Drawing::Line::centre});
  view.angles.push_back({{0.0, 0.0}, 0.75 * b, up - alpha, alpha, {"alpha", alpha, "deg"}});
  view.lengths.push_back({low, top, {"b", b, "mm"}, Drawing::Side::in_place});
  return view;
}

/// A wheel as the part of a cone between two distances from the apex.
std::vector<Point> frustum(double axis, double half_angle, double from, double to) {
  return {at_angle(axis - half_angle, from), at_angle(axis - half_angle, to), at_angle(axis + half_angle, to),
          at_angle(axis + half_angle, from)};
}

/// Both cones in the plane of their axes, the apex at the origin and the driving shaft level.
Drawing::View cones_view(const FrictionWheels::Input& in, const FrictionWheels::Result& r) {
  const double Sigma = in.Sigma, delta_1 = r.delta_1, delta_2 = r.delta_2, d_1 = in_si(in.d_1);
  const double R = 0.5 * d_1 / std::sin(delta_1), half = 0.5 * in_si(in.b);
  const double from = std::max(R - half, 0.05 * R), to = R + half, corner = 0.8 * std::min(from, 0.5 * R);
  Drawing::View view;
  view.room = 46.0;
  add_body(frustum(0.0, delta_1, from, to), say("driving wheel").text(), view);
  add_body(frustum(Sigma, delta_2, from, to), say("driven wheel").text(), view);
  for (const double axis : {0.0, Sigma})
    view.paths.push_back({{at_angle(axis, 0.0), at_angle(axis, 1.15 * to)}, Drawing::Line::centre});
  view.paths.push_back({{{0.0, 0.0}, at_angle(delta_1, from)}, Drawing::Line::thin});
  view.paths.push_back({{at_angle(delta_1, from), at_angle(delta_1, to)}, Drawing::Line::contact});
  view.angles.push_back({{0.0, 0.0}, corner, 0.0, delta_1, {"delta_1", delta_1, "deg"}});
  view.angles.push_back({{0.0, 0.0}, corner, delta_1, delta_2, {"delta_2", delta_2, "deg"}});
  const Point mean = at_angle(delta_1, R);
  view.lengths.push_back({{mean.x, -mean.y}, mean, {"d_1", d_1, "mm"}, Drawing::Side::right});
  view.lengths.push_back({mean, at_angle(Sigma + delta_2, R), {"d_2", in_si(in.d_2), "mm"}, Drawing::Side::in_place});
  view.names.push_back({mean, say("contact").text(), Drawing::Value{"b", 2.0 * half, "mm"}});
  const double F_n = in_si(r.F_n), F_p = in_si(r.F_p);
  view.forces.push_back({mean, at_angle(delta_1 + 0.5 * pi, F_n), {"F_n", F_n, "N"}, true});
  view.forces.push_back({{to * std::cos(delta_1), 0.0}, {-F_p, 0.0}, {"F_p", F_p, "N"}, true, 0.0, true});
  return view;
}

}  // namespace

std::vector<figure::Figure> FrictionWheels::figures(const Input& in, const Result& r) {
  if (!is_set(in.b) || !is_set(r.F_p)) return {};
  auto drawing = std::make_shared<Drawing>();
  if (in.shape == Shape::bevel) {
    drawing->views = {cones_view(in, r)};
    return {{"wheels", "The wheels to scale in the plane of their axes, pressing force and normal force",
             figure::Drawn(std::move(drawing))}};
  }
  drawing->views = {wheels_view(in, r), in.shape == Shape::grooved ? groove_view(in) : rims_view(in)};
  const char* const caption = in.shape == Shape::grooved
                                  ? "The wheels to scale, forces on the driven wheel, and a groove with its ridge"
                                  : "The wheels to scale, forces on the driven wheel, and the line of contact";
  return {{"wheels", caption, figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::drive
