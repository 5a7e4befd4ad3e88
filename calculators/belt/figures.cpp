#include "calculators/belt/figures.hpp"

#include "lib/quantity/units.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::belt {

namespace {

using figure::Drawing;
using figure::Point;

Point along(double angle) { return {std::cos(angle), std::sin(angle)}; }
Point from(Point at, double by, Point direction) { return {at.x + by * direction.x, at.y + by * direction.y}; }

/// About view units per metre: for what needs a size that is seen.
double page_scale(const TwoWheels& w) { return 400.0 / (w.a + 0.5 * (w.d_1 + w.d_2)); }

/// The direction from the axes to the points where the upper or the lower span touches, at wheel 1.
double contact_angle(const TwoWheels& w, bool upper) {
  const double sine = w.crossed ? (w.d_1 + w.d_2) / (2.0 * w.a) : (w.d_2 - w.d_1) / (2.0 * w.a);
  const double gamma = std::asin(std::clamp(sine, -1.0, 1.0)), lean = 0.5 * pi + (w.crossed ? -gamma : gamma);
  return upper ? lean : -lean;
}

struct Wheel {
  Point at;
  double d, rim, alpha, n;
  bool drives;
  const char *d_symbol, *alpha_symbol, *n_symbol;
  bool clockwise;
};

void add_wheel(const Wheel& wheel, const TwoWheels& w, Drawing::View& view) {
  const double r = 0.5 * wheel.d, page = page_scale(w) * r, middle = wheel.drives ? pi : 0.0;
  const bool has_rim = std::isfinite(wheel.rim);
  view.circles.push_back({wheel.at, has_rim ? 0.5 * wheel.rim : r, Drawing::Line::outline, true});
  if (has_rim) view.circles.push_back({wheel.at, r, Drawing::Line::centre});
  const double cross = std::max(0.12 * r, 8.0 / page_scale(w));
  view.paths.push_back({{{wheel.at.x - cross, wheel.at.y}, {wheel.at.x + cross, wheel.at.y}}, Drawing::Line::thin});
  view.paths.push_back({{{wheel.at.x, wheel.at.y - cross}, {wheel.at.x, wheel.at.y + cross}}, Drawing::Line::thin});
  view.lengths.push_back({{wheel.at.x, -r},
                          {wheel.at.x, r},
                          {wheel.d_symbol, wheel.d, "mm"},
                          wheel.drives ? Drawing::Side::left : Drawing::Side::right});
  // In a small wheel there is no room.
  const bool roomy = page > 44.0;
  if (std::isfinite(wheel.alpha)) {
    const double start = middle - 0.5 * wheel.alpha;
    view.angles.push_back({wheel.at,
                           roomy ? 0.72 * r : r + 9.0 / page_scale(w),
                           start,
                           wheel.alpha,
                           {wheel.alpha_symbol, wheel.alpha, "deg"}});
    for (const double angle : {start, start + wheel.alpha})
      view.paths.push_back({{wheel.at, from(wheel.at, r, along(angle))}, Drawing::Line::thin});
  }
  const double outside = 0.5 * (has_rim ? wheel.rim : wheel.d) + (roomy ? 11.0 : 20.0) / page_scale(w);
  Drawing::Turn turn{wheel.at, outside, !wheel.clockwise, 0.5 * pi};
  if (std::isfinite(wheel.n)) turn.value = Drawing::Value{wheel.n_symbol, std::abs(wheel.n), "rpm"};
  view.turns.push_back(std::move(turn));
}

void add_distance(const TwoWheels& w, Drawing::View& view) {
  const auto from_to = [&](double x_from, double x_to, const char* symbol, double value) {
    if (value > 0.0) view.lengths.push_back({{x_from, 0.0}, {x_to, 0.0}, {symbol, value, "mm"}, Drawing::Side::below});
  };
  from_to(0.0, w.a, "a", w.a);
  from_to(w.a, w.a + w.farther, "Delta_1", w.farther);
  from_to(w.a - w.nearer, w.a, "Delta_2", w.nearer);
}

void add_tensions(const TwoWheels& w, const Pulls& pulls, Drawing::View& view) {
  const auto spans = spans_of(w);
  const auto add_tension = [&](const LoopSpan& span, const std::string& words, const std::string& symbol, double force,
                               double outside) {
    const double share = w.crossed ? 0.75 : 0.5;  // crossed spans have one middle
    const Point middle{span.from.x + share * (span.to.x - span.from.x),
                       span.from.y + share * (span.to.y - span.from.y)};
    const bool known = std::isfinite(force);
    if (known && !pulls.of_one_belt) {
      const Point e = along(span.direction);
      view.forces.push_back({span.from, {force * e.x, force * e.y}, {symbol, force, "N"}, true, outside});
    }
    std::optional<Drawing::Value> value;
    if (known && pulls.of_one_belt) value = Drawing::Value{symbol, force, "N"};
    view.names.push_back({middle, words, value, false});
  };
  const bool one = pulls.of_one_belt && std::isfinite(pulls.tight);
  add_tension(spans[1], say(one ? "tight span, one belt" : "tight span").text(), pulls.tight_symbol, pulls.tight, 1.0);
  add_tension(spans[0], say(one ? "slack span, one belt" : "slack span").text(), pulls.slack_symbol, pulls.slack, -1.0);
}

void add_shaft_loads(const TwoWheels& w, const Pulls& pulls, Drawing::View& view) {
  if (!std::isfinite(pulls.R_x) || !std::isfinite(pulls.R_y) || !(pulls.R > 0.0)) return;
  const Point pull{pulls.R_x, -pulls.R_y};  // the tight span lies below
  view.forces.push_back({{0.0, 0.0}, pull, {pulls.symbol, pulls.R, "N"}, false});
  view.forces.push_back({{w.a, 0.0}, {-pull.x, -pull.y}, {pulls.symbol, pulls.R, "N"}, false});
}

}  // namespace

std::array<LoopSpan, 2> spans_of(const TwoWheels& w) {
  std::array<LoopSpan, 2> spans;
  for (const bool upper : {true, false}) {
    const Point normal = along(contact_angle(w, upper));
    const double sense = w.crossed ? -1.0 : 1.0;
    LoopSpan& span = spans[upper ? 0 : 1];
    span.from = from({0.0, 0.0}, 0.5 * w.d_1, normal);
    span.to = from({w.a, 0.0}, sense * 0.5 * w.d_2, normal);
    span.direction = std::atan2(span.to.y - span.from.y, span.to.x - span.from.x);
    span.length = std::hypot(span.to.x - span.from.x, span.to.y - span.from.y);
  }
  return spans;
}

std::vector<Point> line_of(const TwoWheels& w) {
  constexpr int steps = 120;
  std::vector<Point> line;
  const auto arc = [&](Point at, double r, double start, double sweep) {
    for (int i = 0; i <= steps; ++i) line.push_back(from(at, r, along(start + sweep * i / steps)));
  };
  // Around 1 from the upper to the lower span, by its far side; then around 2, where a crossed belt comes in above.
  const double upper = contact_angle(w, true);
  arc({0.0, 0.0}, 0.5 * w.d_1, upper, 2.0 * (pi - upper));
  const double start = w.crossed ? pi - upper : -upper;
  arc({w.a, 0.0}, 0.5 * w.d_2, start, w.crossed ? -2.0 * start : 2.0 * upper);
  return line;
}

Drawing::View drive_view(const TwoWheels& w, const Pulls& pulls) {
  Drawing::View view;
  view.room = 46.0;
  add_wheel({{0.0, 0.0}, w.d_1, w.d_a1, w.alpha_1, w.n_1, true, "d_1", "alpha_1", "n_1", true}, w, view);
  add_wheel({{w.a, 0.0}, w.d_2, w.d_a2, w.alpha_2, w.n_2, false, "d_2", "alpha_2", "n_2", !w.crossed}, w, view);
  view.paths.push_back({{{0.0, 0.0}, {w.a, 0.0}}, Drawing::Line::centre});
  view.paths.push_back({line_of(w), Drawing::Line::belt, true});
  add_distance(w, view);
  add_shaft_loads(w, pulls, view);
  add_tensions(w, pulls, view);
  return view;
}

figure::Figure drive_figure(const TwoWheels& w, const Pulls& pulls) {
  auto drawing = std::make_shared<Drawing>();
  drawing->views = {drive_view(w, pulls)};
  return {"drive", "The drive to scale: 1 drives, clockwise as drawn, so that its tight span lies below",
          figure::Drawn(std::move(drawing))};
}

}  // namespace loadpath::belt
