// Both gears seen along the axis of gear 1, and along the line of centres from the side of gear 2.
#include "calculators/gear/crossed/crossed.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::gear {

namespace crossed_figure {

namespace {

using figure::Drawing;
using figure::Point;
using Input = CrossedTypes::Input;
using Result = CrossedTypes::Result;
using std::numbers::pi;

void add_body(std::vector<Point> outline, const std::string& name, Drawing::View& view) {
  view.areas.push_back({outline, Drawing::Kind::body, name});
  view.paths.push_back({std::move(outline), Drawing::Line::outline, true});
}

void add_line(Point from, Point to, Drawing::Line line, Drawing::View& view) {
  view.paths.push_back({{from, to}, line});
}

Length width_of_second(const Input& in) { return is_set(in.b_2) ? in.b_2 : in.b_1; }

bool is_square(const Input& in) { return std::abs(std::abs(in.beta_1 + in.beta_2) - 0.5 * pi) < 1e-6; }

/// A gear seen across its axis: its cylinders about a point, `along` its axis.
struct Side {
  Point along;
  double d, d_a, b, beta;
  int z;

  [[nodiscard]] Point at(double s, double x) const { return s * along + x * Point{along.y, -along.x}; }
  [[nodiscard]] std::vector<Point> outline() const {
    const double half = 0.5 * b, r = 0.5 * d_a;
    return {at(-half, -r), at(-half, r), at(half, r), at(half, -r)};
  }
  [[nodiscard]] bool covers(Point p) const {
    const double inside = 1.0 - 1e-9;
    return std::abs(figure::dot(p, along)) < inside * 0.5 * b && std::abs(figure::cross(p, along)) < inside * 0.5 * d_a;
  }
};

/// The parts of a line that the gear in front, if any, does not cover.
void add_visible(const std::vector<Point>& line, Drawing::Line style, const Side* front, Drawing::View& view) {
  std::vector<Point> part;
  const auto end_part = [&] {
    if (part.size() > 1) view.paths.push_back({part, style});
    part.clear();
  };
  for (const Point p : line) {
    if (front != nullptr && front->covers(p))
      end_part();
    else
      part.push_back(p);
  }
  end_part();
}

/// The crests of the teeth on the visible half: right-hand teeth lean to the right of the axis. At most some twenty.
void add_teeth(const Side& g, const Side* front, Drawing::View& view) {
  constexpr int steps = 24, most = 40;
  const int stride = g.z / most + 1;
  const double r = 0.5 * g.d_a, lead = std::tan(g.beta) / (0.5 * g.d);
  for (int k = 0; k < g.z; k += stride) {
    std::vector<Point> crest;
    for (int i = 0; i <= steps; ++i) {
      const double s = g.b * (static_cast<double>(i) / steps - 0.5);
      const double angle = std::remainder(2.0 * pi * k / g.z + s * lead, 2.0 * pi);
      if (std::abs(angle) < 0.5 * pi) crest.push_back(g.at(s, r * std::sin(angle)));
    }
    add_visible(crest, Drawing::Line::thin, front, view);
  }
}

void add_edges(const Side& g, const Side* front, Drawing::View& view) {
  constexpr int steps = 200;
  std::vector<Point> corners = g.outline();
  corners.push_back(corners.front());
  std::vector<Point> edges;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    for (int i = 0; i <= steps; ++i)
      edges.push_back(corners[k] + static_cast<double>(i) / steps * (corners[k + 1] - corners[k]));
  }
  add_visible(edges, Drawing::Line::outline, front, view);
}

/// Gear 2 seen along the axis of gear 1: its cylinder is inclined to the page by the shaft angle.
std::vector<Point> inclined(double radius, double b, double Sigma, Point centre) {
  constexpr int steps = 24;
  const double reach = 0.5 * b * std::abs(std::sin(Sigma)), cap = radius * std::abs(std::cos(Sigma));
  std::vector<Point> outline;
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i <= steps; ++i) {
      const double angle = side * pi * (static_cast<double>(i) / steps - 0.5);
      outline.push_back(centre + Point{radius * std::sin(angle), side * (reach + cap * std::cos(angle))});
    }
  }
  return outline;
}

/// On gear 1: against its rotation, for it drives, and away from gear 2.
void add_forces(const Input& in, const Result& r, Drawing::View& view) {
  if (!is_set(r.F_t1) || !(in_si(r.F_n) > 0.0)) return;
  const Point pitch{0.5 * in_si(r.d_1), 0.0};
  const double sense = in.turns == Turns::ccw ? -1.0 : 1.0;
  view.forces.push_back({pitch, {0.0, sense * in_si(r.F_t1)}, {"F_t1", in_si(r.F_t1), "N"}, true});
  view.forces.push_back({pitch, {-in_si(r.F_r), 0.0}, {"F_r", in_si(r.F_r), "N"}, true});
  view.note = say("forces on gear 1, nominal").text();
}

void add_first_as_disc(const Input& in, const Result& r, Drawing::View& view) {
  const double tip = 0.5 * in_si(r.d_a1);
  add_body(figure::polygon_of_circle({}, tip, 180), say("gear 1").text(), view);
  view.circles.push_back({{}, 0.5 * in_si(r.d_1), Drawing::Line::centre});
  view.circles.push_back({{}, 0.5 * in_si(r.d_f1), Drawing::Line::thin});
  if (is_set(in.bore_1)) view.circles.push_back({{}, 0.5 * in_si(in.bore_1), Drawing::Line::outline});
  add_line({0.0, -1.08 * tip}, {0.0, 1.08 * tip}, Drawing::Line::centre, view);
  Drawing::Turn turn{{}, 1.3 * tip, in.turns == Turns::ccw, 0.75 * pi};
  if (is_set(in.n_1)) turn.value = Drawing::Value{"n_1", in_si(in.n_1), "rpm"};
  view.turns.push_back(std::move(turn));
}

Drawing::View along_first(const Input& in, const Result& r) {
  Drawing::View view;
  view.title = say("along the axis of gear 1").text();
  view.share = 0.58;
  view.room = 40.0;
  const double a = in_si(r.a), r_1 = 0.5 * in_si(r.d_1), r_2 = 0.5 * in_si(r.d_2), b_2 = in_si(width_of_second(in));
  add_first_as_disc(in, r, view);
  add_body(inclined(0.5 * in_si(r.d_a2), b_2, r.Sigma, {a, 0.0}), say("gear 2").text(), view);
  const double edge = 0.5 * b_2 * std::abs(std::sin(r.Sigma)) + r_2 * std::abs(std::cos(r.Sigma));
  for (const double x : {a - r_2, a, a + r_2})
    add_line({x, -1.15 * edge}, {x, 1.15 * edge}, Drawing::Line::centre, view);
  add_line({-0.54 * in_si(r.d_a1), 0.0}, {a + 0.54 * in_si(r.d_a2), 0.0}, Drawing::Line::centre, view);
  view.lengths.push_back({{0.0, 0.0}, {a, 0.0}, {"a", a, "mm"}, Drawing::Side::below});
  view.lengths.push_back({{0.0, -r_1}, {0.0, r_1}, {"d_1", 2.0 * r_1, "mm"}, Drawing::Side::left});
  view.lengths.push_back({{a - r_2, edge}, {a + r_2, edge}, {"d_2", 2.0 * r_2, "mm"}, Drawing::Side::above});
  const Drawing::Value z_1{"z_1", static_cast<double>(in.z_1), ""};
  view.names.push_back({{-0.3 * in_si(r.d_a1), -0.62 * in_si(r.d_a1)}, say("gear 1").text(), z_1, false});
  view.names.push_back({{a, 0.0}, say("gear 2").text(), Drawing::Value{"z_2", static_cast<double>(in.z_2), ""}});
  add_forces(in, r, view);
  return view;
}

void add_side(const Side& gear, const Side* front, const std::string& name, double reach, Drawing::View& view) {
  view.areas.push_back({gear.outline(), Drawing::Kind::body, name});
  add_edges(gear, front, view);
  add_teeth(gear, front, view);
  add_line(gear.at(-reach, 0.0), gear.at(reach, 0.0), Drawing::Line::centre, view);
}

Drawing::View along_centres(const Input& in, const Result& r) {
  Drawing::View view;
  view.title = say("from the side of gear 2").text();
  view.share = 0.42;
  view.room = 40.0;
  const double b_1 = in_si(in.b_1), b_2 = in_si(width_of_second(in)), d_a1 = in_si(r.d_a1), d_a2 = in_si(r.d_a2);
  const Side one{{0.0, 1.0}, in_si(r.d_1), d_a1, b_1, in.beta_1, static_cast<int>(in.z_1)};
  const Side two{{std::sin(r.Sigma), std::cos(r.Sigma)}, in_si(r.d_2), d_a2, b_2, in.beta_2, static_cast<int>(in.z_2)};
  const double reach = 0.62 * std::max({d_a1, d_a2, b_1, b_2});
  add_side(one, &two, say("gear 1").text(), reach, view);
  add_side(two, nullptr, say("gear 2").text(), reach, view);
  view.lengths.push_back(
      {{-0.5 * d_a1, -0.5 * b_1}, {-0.5 * d_a1, 0.5 * b_1}, {"b_1", b_1, "mm"}, Drawing::Side::left});
  view.lengths.push_back({two.at(-0.5 * b_2, -0.5 * d_a2),
                          two.at(0.5 * b_2, -0.5 * d_a2),
                          {"b_2", b_2, "mm"},
                          is_square(in) ? Drawing::Side::above : Drawing::Side::in_place});
  view.angles.push_back({{0.0, 0.0}, 0.92 * reach, 0.5 * pi, -r.Sigma, {"Sigma", r.Sigma, "deg"}});
  return view;
}

}  // namespace

}  // namespace crossed_figure

std::vector<figure::Figure> Crossed::figures(const Input& in, const Result& r) {
  if (!is_set(r.a) || !is_set(r.d_f1) || !is_set(in.b_1)) return {};
  auto drawing = std::make_shared<figure::Drawing>();
  drawing->views = {crossed_figure::along_first(in, r), crossed_figure::along_centres(in, r)};
  return {{"crossed_pair", "Both gears, along the axis of gear 1 and along the line of centres",
           figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::gear
