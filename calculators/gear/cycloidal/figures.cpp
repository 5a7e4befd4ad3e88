// Pinion and wheel in the plane of rotation, at the moment at which a flank of the wheel drives on the line of centres.
#include "calculators/gear/cycloidal/cycloidal.hpp"
#include "calculators/gear/cycloidal/flank.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::gear {

namespace cycloidal {

namespace {

using figure::at_angle;
using figure::Drawing;
using figure::Point;
using Input = Cycloidal::Input;
using Result = Cycloidal::Result;

constexpr double full_turn = 2.0 * std::numbers::pi;

/// The pinion at the origin, the wheel at the right; the wheel turns clockwise.
struct Scene {
  const Input& in;
  const Result& r;
  CycloidFlank flank;
  double r_1, r_2, a, m, theta_a;
  bool lantern;

  Scene(const Input& input, const Result& result)
      : in(input),
        r(result),
        flank(flank_of(input)),
        r_1(0.5 * in_si(result.d_1)),
        r_2(0.5 * in_si(result.d_2)),
        a(in_si(result.a)),
        m(in_si(input.m)),
        theta_a(tip_angle(input, 0.5 * in_si(result.d_a2))),
        lantern(Cycloidal::is_lantern(input)) {}

  [[nodiscard]] Point of_wheel(double angle, double radius) const { return Point{a, 0.0} + at_angle(angle, radius); }
  /// The point of contact: on the line from the pitch point to the point of the rolling circle.
  [[nodiscard]] Point contact(double theta) const {
    return Point{r_1, 0.0} + flank.distance(theta) * Point{-std::sin(0.5 * theta), std::cos(0.5 * theta)};
  }
  /// Depth of the spaces of the wheel, which no input gives: it clears the pins, or the tops of the leaves as drawn.
  [[nodiscard]] double depth() const { return lantern ? 0.55 * in_si(in.d_p) : 0.5 * in_si(r.s_1) + 0.4 * m; }
};

/// From root to tip on the first flank of a tooth, then down on the other.
void add_tooth(const Scene& s, double middle, std::vector<Point>& outline) {
  constexpr int steps = 10;
  const double half = middle_of(s.in), from = s.flank.start();
  if (!s.lantern) outline.push_back(s.of_wheel(middle - half, s.r_2 - s.depth()));
  for (int i = 0; i <= steps; ++i) {
    const double theta = from + (s.theta_a - from) * i / steps;
    outline.push_back(s.of_wheel(middle - half + s.flank.polar(theta), s.flank.radius(theta)));
  }
  for (int i = steps; i >= 0; --i) {
    const double theta = from + (s.theta_a - from) * i / steps;
    outline.push_back(s.of_wheel(middle + half - s.flank.polar(theta), s.flank.radius(theta)));
  }
  if (!s.lantern) outline.push_back(s.of_wheel(middle + half, s.r_2 - s.depth()));
}

/// The round bottom of a space for pins, about the place of the pin.
void add_bottom(const Scene& s, double middle, std::vector<Point>& outline) {
  constexpr int steps = 8;
  const double inner = s.r_2 - s.depth(), half = 0.8 * 0.5 * in_si(s.in.d_p) / s.r_2;
  for (int i = 0; i <= steps; ++i) {
    const double share = 2.0 * i / steps - 1.0;
    const double rise = (1.0 - std::sqrt(1.0 - 0.75 * share * share)) * s.depth();
    outline.push_back(s.of_wheel(middle + share * half, inner + rise));
  }
}

std::vector<Point> wheel(const Scene& s) {
  std::vector<Point> outline;
  const double first = std::numbers::pi + middle_of(s.in), pitch = full_turn / s.in.z_2;
  for (int k = 0; k < s.in.z_2; ++k) {
    add_tooth(s, first + k * pitch, outline);
    if (s.lantern) add_bottom(s, first + (k + 0.5) * pitch, outline);
  }
  return outline;
}

/// Leaves with radial flanks and round tops, the first with its flank on the line of centres.
std::vector<Point> leaves(const Scene& s) {
  constexpr int steps = 10;
  const double half = 0.5 * in_si(s.r.s_1), turn = half / s.r_1, root = std::max(s.r_1 - in_si(s.r.h_f1), 0.2 * s.r_1);
  std::vector<Point> outline;
  for (int k = 0; k < s.in.z_1; ++k) {
    const double middle = turn + full_turn * k / s.in.z_1;
    outline.push_back(at_angle(middle - turn, root));
    for (int i = 0; i <= steps; ++i) {
      const double around = std::numbers::pi * (static_cast<double>(i) / steps - 0.5);
      const Point top{s.r_1 * std::cos(turn) + half * std::cos(around), s.r_1 * std::sin(turn) * std::sin(around)};
      const double tilt = std::atan2(top.y, top.x);
      outline.push_back(at_angle(middle + tilt, figure::length(top)));
    }
    outline.push_back(at_angle(middle + turn, root));
  }
  return outline;
}

void add_body(std::vector<Point> outline, const std::string& name, Drawing::View& view) {
  view.areas.push_back({outline, Drawing::Kind::body, name});
  view.paths.push_back({std::move(outline), Drawing::Line::outline, true});
}

void add_pinion(const Scene& s, Drawing::View& view) {
  if (!s.lantern) return add_body(leaves(s), say("pinion").text(), view);
  const double r_p = 0.5 * in_si(s.in.d_p);
  view.circles.push_back({{}, s.r_1 + 1.5 * r_p, Drawing::Line::thin});
  for (int k = 0; k < s.in.z_1; ++k)
    view.circles.push_back({at_angle(full_turn * k / s.in.z_1, s.r_1), r_p, Drawing::Line::outline, true});
}

void add_pitch_lines(const Scene& s, Drawing::View& view) {
  view.circles.push_back({{}, s.r_1, Drawing::Line::centre});
  view.circles.push_back({{s.a, 0.0}, s.r_2, Drawing::Line::centre});
  view.paths.push_back({{{0.0, 0.0}, {s.a, 0.0}}, Drawing::Line::centre});
}

/// Teeth so fine that they would be a black band: the tip circle of the wheel, that of the pinion as drawn.
void add_circles_for_teeth(const Scene& s, Drawing::View& view) {
  const double top = s.lantern ? 0.5 * in_si(s.in.d_p) : 0.5 * in_si(s.r.s_1);
  view.circles.push_back({{}, s.r_1 + top, Drawing::Line::outline, true});
  view.circles.push_back({{s.a, 0.0}, 0.5 * in_si(s.r.d_a2), Drawing::Line::outline, true});
}

Drawing::View whole(const Scene& s) {
  constexpr double page = 400.0, finest = 3.5;  // view units: of the page, of a pitch
  Drawing::View view;
  view.most_height = 380.0;
  if (std::numbers::pi * s.m * page / (s.a + s.r_1 + s.r_2) > finest) {
    add_body(wheel(s), say("wheel").text(), view);
    add_pinion(s, view);
  } else {
    add_circles_for_teeth(s, view);
  }
  add_pitch_lines(s, view);
  const auto diameter = [&](double x, double d, const char* symbol, Drawing::Side side) {
    view.lengths.push_back({{x, -0.5 * d}, {x, 0.5 * d}, {symbol, d, "mm"}, side});
  };
  view.lengths.push_back({{0.0, 0.0}, {s.a, 0.0}, {"a", s.a, "mm"}, Drawing::Side::below});
  diameter(0.0, 2.0 * s.r_1, "d_1", Drawing::Side::left);
  diameter(s.a, 2.0 * s.r_2, "d_2", Drawing::Side::right);
  diameter(s.a, in_si(s.r.d_a2), "d_a2", Drawing::Side::right);
  const Drawing::Value z_1{"z_1", static_cast<double>(s.in.z_1), ""};
  view.names.push_back({{-0.6 * s.r_1, 1.5 * s.r_1}, say("pinion").text(), z_1, false});
  view.names.push_back({{s.a, 0.0}, say("wheel").text(), Drawing::Value{"z_2", static_cast<double>(s.in.z_2), ""}});
  view.turns.push_back({{s.a, 0.0}, 0.5 * s.r_2, false, 0.5 * std::numbers::pi});
  return view;
}

/// The path of contact, on the rolling circle or, for pins, nearer to the pitch point by their radius.
std::vector<Point> path_of_contact(const Scene& s) {
  constexpr int steps = 24;
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(s.contact(s.flank.start() + (s.theta_a - s.flank.start()) * i / steps));
  return points;
}

Drawing::View mesh(const Scene& s) {
  Drawing::View view;
  view.title = say("the mesh, a flank at the line of centres").text();
  const double p = in_si(s.r.p), height = std::max(1.3 * p, s.contact(s.theta_a).y + 0.4 * p);
  view.window = Drawing::View::Window{{s.r_1 - 1.9 * p, -1.3 * p}, {s.r_1 + 1.9 * p, height}};
  add_body(wheel(s), say("wheel").text(), view);
  add_pinion(s, view);
  add_pitch_lines(s, view);
  view.circles.push_back({{s.a, 0.0}, 0.5 * in_si(s.r.d_a2), Drawing::Line::thin});
  if (!s.lantern) view.circles.push_back({{s.r_1 - s.flank.rho, 0.0}, s.flank.rho, Drawing::Line::hidden});
  std::vector<Point> path = path_of_contact(s);
  view.names.push_back({{s.r_1, 0.0}, "C"});
  view.names.push_back({path.back(), "E"});
  view.names.push_back({path[path.size() / 2], say("path of contact").text(), {}, false});
  view.paths.push_back({std::move(path), Drawing::Line::contact});
  view.note =
      s.lantern ? say("pitch circles; contact ends at E; the bottoms of the spaces are drawn to clear the pins").text()
                : say("pitch circles, rolling circle dashed; contact ends at E; the round tops of the leaves and "
                      "the depth of the spaces are assumed")
                      .text();
  return view;
}

}  // namespace

}  // namespace cycloidal

std::vector<figure::Figure> Cycloidal::figures(const Input& in, const Result& r) {
  if (!is_set(r.d_a2) || !is_set(r.K_g) || !has_teeth(in)) return {};
  const cycloidal::Scene scene(in, r);
  auto drawing = std::make_shared<figure::Drawing>();
  drawing->views = {cycloidal::whole(scene), cycloidal::mesh(scene)};
  return {{"cycloidal_pair", "Pinion and wheel, which drives, and their mesh", figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::gear
