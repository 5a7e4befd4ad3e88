// A drawing for CAD: its views side by side, each 1:1, with dimensions as lines and texts.
#include "lib/draw/drawing/clip.hpp"
#include "lib/draw/drawing/fit.hpp"
#include "lib/draw/dxf.hpp"
#include "lib/draw/dxf_writer.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>
#include <numbers>

namespace loadpath::draw {

namespace {

constexpr auto dimensions = "dimensions", names = "names", hatching_layer = "hatching";

const char* layer_of(figure::Drawing::Line line) {
  switch (line) {
    case figure::Drawing::Line::outline:
      return "outlines";
    case figure::Drawing::Line::thin:
    case figure::Drawing::Line::hidden:
      return "thin";
    case figure::Drawing::Line::centre:
      return "centre-lines";
    case figure::Drawing::Line::belt:
      return "belt";
    case figure::Drawing::Line::action:
    case figure::Drawing::Line::contact:
      return "line-of-action";
  }
  return "outlines";
}

std::string words_for_cad(const figure::Drawing::Value& value) {
  const std::string number = format_quantity(value.si, value.unit, digits_of(value));
  return value.symbol.empty() ? number : value.symbol + " = " + number;
}

class ViewDrawing {
 public:
  ViewDrawing(const figure::Drawing::View& view, double left, DxfWriter& dxf) : view_(view), dxf_(dxf) {
    fit_ = fit(view, {0.0, 0.0}, view_width);
    // The fit's page, blown up to mm: rows and heads keep their share of the drawing.
    mm_ = 1e3 / fit_.scale;
    height_ = text_size * mm_ * 0.8;
    shift_ = {left - mm_ * fit_.area.left, 0.0};
  }
  [[nodiscard]] double width() const { return mm_ * view_width; }

  void drawn() {
    for (const auto& area : view_.areas) draw_area(area);
    for (const auto& c : view_.circles) dxf_.circle(layer_of(c.line), at(c.centre), 1e3 * c.radius);
    for (const auto& p : view_.paths)
      p.closed ? dxf_.polygon(layer_of(p.line), at(p.points)) : dxf_.polyline(layer_of(p.line), at(p.points));
    for (const auto& s : view_.surfaces) dxf_.line("thin", at(s.from), at(s.to));
    for (const Row& row : fit_.rows) draw_length(row);
    for (const auto& l : view_.lengths) {
      if (l.side == figure::Drawing::Side::in_place) dimension(at(l.from), at(l.to), l.value, false);
    }
    for (const auto& r : view_.radii) {
      const Point e = 1e3 * r.radius * along(r.angle), c = at(r.centre);
      dimension(r.diameter ? c - e : c, c + e, r.value, false);
    }
    for (const auto& a : view_.angles) draw_angle(a);
    for (const auto& n : view_.names) draw_name(n);
  }

 private:
  [[nodiscard]] Point at(Point p) const { return from_page(fit_.at(p)); }
  [[nodiscard]] Point from_page(Point page) const { return {shift_.x + mm_ * page.x, -mm_ * page.y}; }
  [[nodiscard]] std::vector<Point> at(const std::vector<Point>& points) const {
    std::vector<Point> all;
    all.reserve(points.size());
    for (const Point p : points) all.push_back(at(p));
    return all;
  }

  void draw_area(const figure::Drawing::Area& area) {
    if (area.kind != figure::Drawing::Kind::cut) return;  // others have their outlines as paths
    const double spacing = 6.0 * mm_;
    const std::vector<Point> outline = at(area.outline);
    dxf_.polygon("outlines", outline);
    if (!area.hole.empty()) dxf_.polygon("outlines", at(area.hole));
    if (!area.hole.empty() || mean_thickness(outline) < 0.6 * spacing) return;
    for (const auto& [from, to] : hatching(outline, spacing, true)) dxf_.line(hatching_layer, from, to);
  }

  /// Along a line with short strokes across its ends, as R12 has no heads.
  void dimension(Point from, Point to, const figure::Drawing::Value& value, bool upright) {
    dxf_.line(dimensions, from, to);
    const double tick = 2.0 * mm_;
    for (const Point p : {from, to}) dxf_.line(dimensions, p - Point{tick, tick}, p + Point{tick, tick});
    const Point middle = 0.5 * (from + to), off = upright ? Point{-height_, 0.0} : Point{0.0, height_};
    dxf_.text(dimensions, middle + off, height_, words_for_cad(value), upright ? 90.0 : 0.0);
  }

  void draw_length(const Row& row) {
    const auto& l = view_.lengths[row.length];
    const double out = first_row + dimension_row * static_cast<double>(row.row);
    const Point from = fit_.at(l.from), to = fit_.at(l.to);
    const bool upright = l.side == figure::Drawing::Side::left || l.side == figure::Drawing::Side::right;
    Point a = from, b = to;
    if (upright)
      a.x = b.x = l.side == figure::Drawing::Side::left ? fit_.extent.left - out : fit_.extent.right + out;
    else
      a.y = b.y = l.side == figure::Drawing::Side::above ? fit_.extent.top - out : fit_.extent.bottom + out;
    dxf_.line(dimensions, from_page(from), from_page(a));
    dxf_.line(dimensions, from_page(to), from_page(b));
    dimension(from_page(a), from_page(b), l.value, upright);
  }

  void draw_angle(const figure::Drawing::Angle& a) {
    const double low = std::min(a.start, a.start + a.sweep), high = std::max(a.start, a.start + a.sweep);
    const double radius = 1e3 * a.radius;
    if (!(radius > 0.0)) return;
    dxf_.arc(dimensions, at(a.corner), radius, low, high);
    dxf_.text(dimensions, at(a.corner) + (radius + 1.5 * height_) * along(a.start + 0.5 * a.sweep), height_,
              words_for_cad(a.value));
  }

  void draw_name(const figure::Drawing::Name& name) {
    std::string words = name.words;
    if (name.value) words += (words.empty() ? "" : ", ") + words_for_cad(*name.value);
    dxf_.text(names, at(name.at) + Point{0.0, height_}, height_, words);
  }

  const figure::Drawing::View& view_;
  DxfWriter& dxf_;
  ViewFit fit_;
  double mm_ = 1.0, height_ = 1.0;
  Point shift_;
};

}  // namespace

bool is_to_scale(const figure::Figure& figure) {
  if (const auto* drawing = std::get_if<figure::Drawn>(&figure.content)) {
    const auto& views = (*drawing)->views;
    return std::any_of(views.begin(), views.end(), [](const figure::Drawing::View& view) { return view.is_scaled; });
  }
  return std::holds_alternative<figure::Scheme>(figure.content);
}

std::string dxf_of(const figure::Figure& figure) {
  if (const auto* scheme = std::get_if<figure::Scheme>(&figure.content)) return dxf_of(*scheme);
  const auto* drawing = std::get_if<figure::Drawn>(&figure.content);
  if (drawing == nullptr || !is_to_scale(figure)) return {};
  DxfWriter dxf;
  dxf.begin({"outlines", "thin", "centre-lines", "belt", "line-of-action", hatching_layer, dimensions, names});
  double left = 0.0;
  for (const figure::Drawing::View& given : (*drawing)->views) {
    if (given.window || !given.is_scaled) continue;  // a part of another view, which has it 1:1; or no scale at all
    const figure::Drawing::View view = without_gaps(given);
    ViewDrawing drawn(view, left, dxf);
    drawn.drawn();
    left += drawn.width();
  }
  return dxf.end();
}

}  // namespace loadpath::draw
