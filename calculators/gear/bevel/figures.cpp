// The pair drawn in the plane of its axes: pitch cones with their common apex, teeth and blanks of both gears.
#include "calculators/gear/bevel/bevel.hpp"
#include "lib/figure/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace loadpath::gear {

namespace bevel {

using Input = BevelTypes::Input;
using Result = BevelTypes::Result;

namespace {

using figure::Drawing;
using figure::Point;

/// One gear: angles from its axis, lengths along the pitch cone from the apex at the origin.
struct ConeGear {
  double axis;  // direction of the axis
  double mesh;  // 1: the mesh is on its left, -1: on its right, looking away from the apex
  double delta, delta_a, delta_f;
  double h_a, h_f, bore;
  double R_e, b;

  /// A point at a distance from the apex and a height above the pitch cone, on the side of the mesh or opposite.
  [[nodiscard]] Point at(double along, double above, bool in_mesh) const {
    const double turn = (in_mesh ? mesh : -mesh), angle = axis + turn * delta, out = angle + turn * 0.5 * pi;
    return {along * std::cos(angle) + above * std::cos(out), along * std::sin(angle) + above * std::sin(out)};
  }
  /// Heights at the inner end of the face, where cones of other angles than the pitch cone have come nearer to it.
  [[nodiscard]] double inner_tip() const { return h_a - b * std::tan(delta_a - delta); }
  [[nodiscard]] double inner_root() const { return h_f - b * std::tan(delta - delta_f); }
  /// The blank below the root is about as thick as the tooth is high, and ends before the axis.
  [[nodiscard]] double rim() const { return std::min(h_f + 1.2 * (h_a + h_f), 0.8 * R_e * std::tan(delta)); }
};

Drawing::Path line_from(Point from, Point to, Drawing::Line line) { return {{from, to}, line}; }

void add_gear(const ConeGear& g, const std::string& name, Drawing::View& view) {
  std::vector<Point> outline;
  for (const bool in_mesh : {true, false}) {
    std::vector<Point> side{g.at(g.R_e - g.b, -g.inner_root(), in_mesh), g.at(g.R_e - g.b, g.inner_tip(), in_mesh),
                            g.at(g.R_e, g.h_a, in_mesh), g.at(g.R_e, -g.rim(), in_mesh)};
    if (!in_mesh) std::ranges::reverse(side);
    outline.insert(outline.end(), side.begin(), side.end());
    view.paths.push_back(
        line_from(g.at(g.R_e - g.b, -g.inner_root(), in_mesh), g.at(g.R_e, -g.h_f, in_mesh), Drawing::Line::thin));
    view.paths.push_back(line_from({0.0, 0.0}, g.at(1.06 * g.R_e, 0.0, in_mesh), Drawing::Line::centre));
  }
  const double reach = 1.25 * g.R_e * std::max(std::cos(g.delta), 0.3);
  const Point e{std::cos(g.axis), std::sin(g.axis)};
  view.paths.push_back(
      line_from({-0.06 * e.x * g.R_e, -0.06 * e.y * g.R_e}, {reach * e.x, reach * e.y}, Drawing::Line::centre));
  view.paths.push_back({outline, Drawing::Line::outline, true});
  view.areas.push_back({std::move(outline), Drawing::Kind::body, name});
  if (!std::isfinite(g.bore)) return;
  const double r = 0.5 * g.bore, inner = (g.R_e - g.b) * std::cos(g.delta), outer = g.R_e * std::cos(g.delta);
  for (const double side : {r, -r})
    view.paths.push_back(line_from({inner * e.x - side * e.y, inner * e.y + side * e.x},
                                   {outer * e.x - side * e.y, outer * e.y + side * e.x}, Drawing::Line::hidden));
}

ConeGear first_of(const Input& in, const Result& r) {
  return {0.0,           1.0,           r.delta_1,        r.delta_a1,   r.delta_f1,
          in_si(r.h_a1), in_si(r.h_f1), in_si(in.bore_1), in_si(r.R_e), in_si(in.b)};
}
ConeGear second_of(const Input& in, const Result& r) {
  return {in.Sigma,      -1.0,          r.delta_2,        r.delta_a2,   r.delta_f2,
          in_si(r.h_a2), in_si(r.h_f2), in_si(in.bore_2), in_si(r.R_e), in_si(in.b)};
}

void add_dimensions(const Input& in, const Result& r, const ConeGear& one, const ConeGear& two, Drawing::View& view) {
  const double R_e = one.R_e;
  view.lengths.push_back(
      {one.at(R_e, 0.0, false), one.at(R_e, 0.0, true), {"d_1", in_si(r.d_1), "mm"}, Drawing::Side::right});
  const bool square =
      std::abs(in.Sigma - 0.5 * pi) < 1e-6;  // otherwise the diameter is measured along an inclined line
  view.lengths.push_back({two.at(R_e, 0.0, false),
                          two.at(R_e, 0.0, true),
                          {"d_2", in_si(r.d_2), "mm"},
                          square ? Drawing::Side::above : Drawing::Side::in_place});
  view.lengths.push_back({{0.0, 0.0}, one.at(R_e, 0.0, false), {"R_e", R_e, "mm"}, Drawing::Side::in_place});
  view.lengths.push_back(
      {two.at(R_e - one.b, 0.0, false), two.at(R_e, 0.0, false), {"b", one.b, "mm"}, Drawing::Side::in_place});
  view.angles.push_back({{0.0, 0.0}, 0.5 * (R_e - one.b), 0.0, r.delta_1, {"delta_1", r.delta_1, "deg"}});
  view.angles.push_back({{0.0, 0.0}, 0.4 * (R_e - one.b), r.delta_1, r.delta_2, {"delta_2", r.delta_2, "deg"}});
}

/// Those on gear 1, at the middle of the face.
void add_forces(const Result& r, const ConeGear& one, Drawing::View& view) {
  if (!(std::abs(in_si(r.F_r1)) > 0.0) || !is_set(r.F_a1)) return;
  const Point middle = one.at(in_si(r.R_m), 0.0, true);
  view.forces.push_back({middle, {0.0, -in_si(r.F_r1)}, {"F_r1", in_si(r.F_r1), "N"}, true});
  view.forces.push_back({middle, {in_si(r.F_a1), 0.0}, {"F_a1", in_si(r.F_a1), "N"}, true});
}

}  // namespace

}  // namespace bevel

std::vector<figure::Figure> Bevel::figures(const Input& in, const Result& r) {
  if (!is_set(r.R_e) || !is_set(r.delta_f2)) return {};
  const bevel::ConeGear one = bevel::first_of(in, r), two = bevel::second_of(in, r);
  figure::Drawing::View view;
  view.room = 64.0;
  bevel::add_gear(two, say("gear 2").text(), view);
  bevel::add_gear(one, say("gear 1").text(), view);
  bevel::add_dimensions(in, r, one, two, view);
  bevel::add_forces(r, one, view);
  const double R_e = in_si(r.R_e);
  view.names.push_back({{0.9 * R_e * std::cos(r.delta_1), 0.0}, say("gear 1").text(), {}, false});
  view.names.push_back(
      {{0.9 * R_e * std::cos(r.delta_2) * std::cos(in.Sigma), 0.9 * R_e * std::cos(r.delta_2) * std::sin(in.Sigma)},
       say("gear 2").text(),
       {},
       false});
  if (!view.forces.empty()) view.note = say("tooth forces on gear 1, nominal; F_t is perpendicular to the page").text();
  auto drawing = std::make_shared<figure::Drawing>();
  drawing->views = {std::move(view)};
  return {{"bevel_pair", "The pair in the plane of its axes: pitch cones, teeth and blanks",
           figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::gear
