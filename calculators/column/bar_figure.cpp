// The bar with its ends, supports and load, in its buckled shape about each axis, next to its section.
#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/length_factor.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::column {

namespace {

using figure::Drawing;
using figure::Point;
using Kind = Drawing::Support::Kind;
using Points = std::vector<Point>;

/// Support of an end. The upper one is free to come nearer, or the load would not reach the bar.
std::optional<Drawing::Support> support_of(const End& end, Point at, bool is_upper) {
  const bool across = end.across > 0.0, turning = end.turning > 0.0;
  const Point down{0.0, -1.0}, aside{-1.0, 0.0}, up{0.0, 1.0};
  if (across && turning) return Drawing::Support{at, is_upper ? up : down, is_upper ? Kind::sleeve : Kind::clamp};
  if (across) return is_upper ? Drawing::Support{at, aside, Kind::roller} : Drawing::Support{at, down, Kind::hinge};
  if (turning) return Drawing::Support{at, is_upper ? up : down, Kind::plate};
  return std::nullopt;
}

void add_load(const MemberResult& r, Point at, Drawing::View& view) {
  if (!is_set(r.F) || !(r.F > 0.0 * N)) return;
  view.forces.push_back({at, {0.0, -in_si(r.F)}, {"F", in_si(r.F), "kN"}, true, 0.0, true});
}

/// Upright, its start below; the deflection as large as it is well seen. `moment`: the largest about this axis.
Drawing::View bar_view(const BucklingInput& in, const MemberResult& r, AxisName axis, Moment moment) {
  const double l = in_si(in.l), reach = 0.09 * l;
  const Bar bar = bar_of(in, axis);
  const Shape shape = buckled_shape(bar, buckling_parameter(bar));
  Drawing::View view;
  view.is_scaled = false;
  view.room = 34.0;
  view.title = say(axis == AxisName::y ? "buckling about y" : "buckling about z").text();
  view.paths.push_back({{{0.0, 0.0}, {0.0, l}}, Drawing::Line::hidden});
  Points line;
  for (std::size_t i = 0; i < shape.x.size(); ++i) line.push_back({reach * shape.w[i], l * shape.x[i]});
  const Point foot = line.empty() ? Point{} : line.front(), head = line.empty() ? Point{0.0, l} : line.back();
  view.paths.push_back({std::move(line), Drawing::Line::belt});
  for (const bool is_upper : {false, true}) {
    if (const auto held_by = support_of(is_upper ? bar.end : bar.start, is_upper ? head : foot, is_upper))
      view.supports.push_back(*held_by);
  }
  for (const double x : bar.supports) view.supports.push_back({{0.0, l * x}, {-1.0, 0.0}, Kind::roller});
  view.lengths.push_back({{0.0, 0.0}, {0.0, l}, {"l", l, "mm"}, Drawing::Side::right});
  const AxisResult& found = r.axes[axis == AxisName::y ? 0 : 1];
  view.names.push_back({{0.5 * reach, -0.17 * l}, "", Drawing::Value{"s", in_si(found.s), "mm"}, false});
  if (moment > 0.0 * N_m) {
    const char* const symbol = axis == AxisName::y ? "M_yEd" : "M_zEd";
    view.names.push_back({{0.5 * reach, -0.32 * l}, "", Drawing::Value{symbol, in_si(moment), "kN*m"}, false});
  }
  add_load(r, head, view);
  return view;
}

Points mirrored_all(const Points& quarter) {
  Points all = quarter;
  for (auto p = quarter.rbegin(); p != quarter.rend(); ++p) all.push_back({p->x, -p->y});
  for (const Point p : quarter) all.push_back({-p.x, -p.y});
  for (auto p = quarter.rbegin(); p != quarter.rend(); ++p) all.push_back({-p->x, p->y});
  return all;
}

Points circle(double radius) { return figure::polygon_of_circle({}, radius, 180); }

/// An I with its fillets: a quarter, from the tip of the flange to the middle of the web, and the rest of it.
Points i_outline(double h, double b, double t_f, double t_w, double r) {
  constexpr int steps = 12;
  Points quarter{{0.5 * b, 0.5 * h}, {0.5 * b, 0.5 * h - t_f}};
  const Point centre{0.5 * t_w + r, 0.5 * h - t_f - r};
  for (int i = 0; i <= steps; ++i) {
    const double angle = 0.5 * pi * (1.0 + static_cast<double>(i) / steps);
    quarter.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  return mirrored_all(quarter);
}

using Value = Drawing::Value;

/// Two lengths of it, h and b, or one, d.
struct Sides {
  double h, b;
};

/// A section whose outline the input says; nothing of others: of channels, tees, angles their centre is not known.
std::optional<Sides> add_section(const BucklingInput& in, Drawing::View& view) {
  const std::string name = say("section").text();
  const auto level = [&](double x, double y, const char* symbol, double value, Drawing::Side side) {
    view.lengths.push_back({{x, y}, {x + value, y}, {symbol, value, "mm"}, side});
  };
  const auto upright = [&](double x, double y, const char* symbol, double value, Drawing::Side side) {
    view.lengths.push_back({{x, y}, {x, y + value}, {symbol, value, "mm"}, side});
  };
  const double h = in_si(in.h), b = in_si(in.b), t_f = in_si(in.t_f), t_w = in_si(in.t_w);
  if (is_set(in.d)) {
    const double d = in_si(in.d);
    const bool bored = is_set(in.d_bore) && in.d_bore > 0.0 * mm && in.d_bore < in.d;
    const double bore = bored ? in_si(in.d_bore) : t_w > 0.0 ? d - 2.0 * t_w : 0.0;
    if (is_set(in.A) && !(bore > 0.0)) return std::nullopt;  // a tube whose wall is not said
    view.areas.push_back({circle(0.5 * d), Drawing::Kind::cut, name, bore > 0.0 ? circle(0.5 * bore) : Points{}});
    level(-0.5 * d, 0.0, "d", d, Drawing::Side::below);
    if (bored) level(-0.5 * bore, 0.0, "d_bore", bore, Drawing::Side::above);
    if (bore > 0.0 && !bored) level(0.5 * bore, 0.0, "t_w", t_w, Drawing::Side::above);
    return Sides{d, d};
  }
  if (!(h > 0.0) || !(b > 0.0)) return std::nullopt;
  const bool is_I = in.kind == SectionKind::rolled_I || in.kind == SectionKind::welded_I;
  const bool is_hollow = in.kind == SectionKind::hot_hollow || in.kind == SectionKind::cold_hollow ||
                         in.kind == SectionKind::welded_box || is_walled(in);
  if (is_I && t_f > 0.0 && t_w > 0.0 && 2.0 * t_f < h && t_w < b) {
    const double most = std::min(0.5 * (b - t_w), 0.5 * h - t_f);
    const double r = is_set(in.r) ? std::clamp(in_si(in.r), 0.0, most) : 0.0;
    view.areas.push_back({i_outline(h, b, t_f, t_w, r), Drawing::Kind::cut, name});
    level(-0.5 * t_w, 0.0, "t_w", t_w, Drawing::Side::above);
    upright(-0.5 * b, 0.5 * h - t_f, "t_f", t_f, Drawing::Side::left);
  } else if (is_hollow && t_w > 0.0 && 2.0 * t_w < std::min(h, b)) {
    const double top = t_f > 0.0 && 2.0 * t_f < h ? t_f : t_w;
    view.areas.push_back(
        {mirrored_all({{0.5 * b, 0.5 * h}}), Drawing::Kind::cut, name, mirrored_all({{0.5 * b - t_w, 0.5 * h - top}})});
    level(0.5 * b - t_w, 0.0, "t_w", t_w, Drawing::Side::above);
    view.note = say("corners are drawn sharp").text();
  } else if (!is_set(in.A)) {
    view.areas.push_back({mirrored_all({{0.5 * b, 0.5 * h}}), Drawing::Kind::cut, name});
  } else {
    return std::nullopt;
  }
  level(-0.5 * b, -0.5 * h, "b", b, Drawing::Side::below);
  upright(0.5 * b, -0.5 * h, "h", h, Drawing::Side::right);
  return Sides{h, b};
}

std::optional<Drawing::View> section_view(const BucklingInput& in) {
  Drawing::View view;
  view.title = say("section").text();
  view.room = 30.0, view.most_height = 260.0;
  const auto sides = add_section(in, view);
  if (!sides) return std::nullopt;
  const double y = 0.62 * sides->b, z = 0.62 * sides->h;
  view.paths.push_back({{{-y, 0.0}, {y, 0.0}}, Drawing::Line::centre});
  view.paths.push_back({{{0.0, -z}, {0.0, z}}, Drawing::Line::centre});
  view.names.push_back({{y, 0.0}, "y", std::nullopt, false});
  view.names.push_back({{0.0, z}, "z", std::nullopt, false});
  return view;
}

bool is_shown(const BucklingInput& in, const MemberResult& r, AxisName axis) {
  const bool about_y = axis == AxisName::y;
  if (is_set(about_y ? in.beta_y : in.beta_z)) return false;  // the factor does not give the end conditions
  return r.axes.size() == 2 && std::isfinite(buckling_parameter(bar_of(in, axis)));
}

}  // namespace

std::optional<figure::Figure> bar_figure(const BucklingInput& in, const MemberResult& r,
                                         const std::array<Moment, 2>& moments) {
  auto drawing = std::make_shared<Drawing>();
  for (const auto axis : {AxisName::y, AxisName::z}) {
    if (is_shown(in, r, axis)) drawing->views.push_back(bar_view(in, r, axis, moments[axis == AxisName::y ? 0 : 1]));
  }
  if (drawing->views.empty()) return std::nullopt;
  for (auto& view : drawing->views) view.share = 0.3;
  Drawing::View& first = drawing->views.front();
  first.note = say("deflections enlarged").text();
  const char* caption = "The bar as it buckles";
  if (auto section = section_view(in)) {
    caption = "The bar as it buckles, and its section";
    section->share = 1.0 - 0.3 * static_cast<double>(drawing->views.size());
    drawing->views.push_back(std::move(*section));
  }
  return figure::Figure{"bar", caption, figure::Drawn(std::move(drawing))};
}

}  // namespace loadpath::column
