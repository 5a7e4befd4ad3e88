#include <limits>

#include "lib/draw/display.hpp"
#include "lib/draw/labels.hpp"
#include "lib/draw/picture.hpp"
#include "lib/draw/thin.hpp"
#include "lib/draw/ticks.hpp"
#include "lib/issue.hpp"

namespace loadpath::draw {
namespace {

constexpr double plot_top = 30.0, plot_depth = 232.0, plot_right = 466.0;

/// Smallest range that holds all that was seen; empty when nothing was.
class Extent {
 public:
  void see(double v) {
    if (drawable(v)) low_ = std::min(low_, v), high_ = std::max(high_, v);
  }
  [[nodiscard]] bool empty() const { return low_ > high_; }
  [[nodiscard]] Range range() const { return empty() ? Range{0.0, 1.0} : Range{low_, high_}; }

 private:
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

/// A part of a filled curve along which the value does not change.
struct Level {
  Point from, to;
  double si = 0.0;
};

struct DrawnCurve {
  const Curve* curve;
  std::vector<std::vector<Point>> pieces;
  std::vector<Level> levels;
};

std::string curve_style(std::size_t i) { return "curve c" + std::to_string(i % 3) + " d" + std::to_string(i % 4); }
std::string fill_style(std::size_t i) { return "f" + std::to_string(i % 3); }

class PlotPicture {
 public:
  explicit PlotPicture(const Plot& plot);
  Picture drawn();

 private:
  void see(const Plot& plot);
  [[nodiscard]] Point at(double x, double y) const;
  [[nodiscard]] DrawnCurve cut(const Curve& curve) const;

  void draw_axes();
  void draw_ticks();
  void draw_titles();
  void draw_curves();
  void draw_bounds();
  void draw_marks();
  void label_levels();
  void label_curves();
  [[nodiscard]] std::vector<Candidate> along_curve(const DrawnCurve& drawn, double width) const;
  void draw_legend();
  void write(std::string_view style, const Box& box, const Text& text) { svg_.text(style, box, text); }
  [[nodiscard]] std::string description() const;

  const Plot& plot_;
  Display x_, y_;
  Axis across_, up_;
  Box area_;
  bool empty_ = false;
  std::vector<DrawnCurve> curves_;
  Labels labels_{{}};
  SvgWriter svg_;
  double height_ = 0.0;
};

PlotPicture::PlotPicture(const Plot& plot) : plot_(plot), x_(plot.x), y_(plot.y) {
  see(plot);
  for (const Curve& curve : plot.curves) curves_.push_back(cut(curve));
  labels_ = Labels(area_.grown(1.0));
}

void PlotPicture::see(const Plot& plot) {
  Extent x, y;
  bool filled = false;
  const auto see_point = [&](double px, double py) {
    if (!drawable(Point{x_.value(px), y_.value(py)})) return;
    x.see(x_.value(px)), y.see(y_.value(py));
  };
  for (const Curve& curve : plot.curves) {
    filled = filled || curve.filled;
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) see_point(curve.x[i], curve.y[i]);
  }
  for (const Mark& mark : plot.marks) see_point(mark.x, mark.y);
  empty_ = x.empty();
  for (const Bound& bound : plot.bounds) y.see(y_.value(bound.y));

  Range up = y.range();
  const double near = 0.5 * std::max(std::fabs(up.low), std::fabs(up.high));
  if (filled || up.low < near) up.low = std::min(up.low, 0.0);
  if (filled || up.high > -near) up.high = std::max(up.high, 0.0);
  up_ = axis(up, 6, y_.in_degrees() ? Steps::degrees : Steps::decimal, Ends::ticks);
  across_ = axis(x.range(), 8, x_.in_degrees() ? Steps::degrees : Steps::decimal, Ends::data);

  double widest = 0.0;
  for (const double tick : up_.ticks) widest = std::max(widest, width(typeset(up_.text(tick)), text_size));
  area_ = {widest + 10.0, plot_top, plot_right, plot_top + plot_depth};
  height_ = area_.bottom + 44.0;
}

Point PlotPicture::at(double x, double y) const {
  return {area_.left + across_.fraction(x) * area_.width(), area_.bottom - up_.fraction(y) * area_.height()};
}

DrawnCurve PlotPicture::cut(const Curve& curve) const {
  DrawnCurve drawn{&curve, {}, {}};
  std::vector<Point> piece;
  const auto end_piece = [&] {
    if (!piece.empty()) drawn.pieces.push_back(thin(piece));
    piece.clear();
  };
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
    const Point p{x_.value(curve.x[i]), y_.value(curve.y[i])};
    if (!drawable(p)) {
      end_piece();
      continue;
    }
    const Point here = at(p.x, p.y);
    const bool level = !piece.empty() && std::fabs(here.y - piece.back().y) < 1e-6 && here.x > piece.back().x;
    if (curve.filled && level) {
      const bool goes_on = !drawn.levels.empty() && length(drawn.levels.back().to - piece.back()) < 1e-6;
      goes_on ? void(drawn.levels.back().to = here) : drawn.levels.push_back({piece.back(), here, curve.y[i]});
    }
    piece.push_back(here);
  }
  end_piece();
  return drawn;
}

void PlotPicture::draw_axes() {
  std::vector<std::pair<Point, Point>> grid;
  for (const double t : across_.ticks) grid.push_back({at(t, up_.range.low), at(t, up_.range.high)});
  for (const double t : up_.ticks) grid.push_back({at(across_.range.low, t), at(across_.range.high, t)});
  svg_.strokes("grid", grid);
  svg_.strokes("axis", {{{area_.left, area_.top}, {area_.left, area_.bottom}},
                        {{area_.left, area_.bottom}, {area_.right, area_.bottom}}});
  if (up_.range.low <= 0.0 && up_.range.high >= 0.0) {
    svg_.line("zero", at(across_.range.low, 0.0), at(across_.range.high, 0.0));
  }
}

void PlotPicture::draw_ticks() {
  for (const double t : up_.ticks) {
    svg_.text("", at(across_.range.low, t) + Point{-6.0, 4.5}, typeset(up_.text(t)), Anchor::end);
  }
  double free_from = -1e9;
  for (const double t : across_.ticks) {
    const Text text = typeset(across_.text(t));
    const double half = 0.5 * width(text, text_size);
    const double x = std::min(at(t, 0.0).x, view_width - 2.0 - half);
    if (x - half < free_from) continue;
    svg_.text("", {x, area_.bottom + 17.0}, text, Anchor::middle);
    free_from = x + half + 6.0;
  }
}

void PlotPicture::draw_titles() {
  const auto fitting = [](const Display& display, int power) {
    const Text text = typeset(display.title(power));
    return width(text, text_size) < view_width - 8.0 ? text : typeset(display.title(power, false));
  };
  svg_.text("", {4.0, 16.0}, fitting(y_, up_.power));
  svg_.text("", {area_.right, area_.bottom + 36.0}, fitting(x_, across_.power), Anchor::end);
}

void PlotPicture::draw_curves() {
  const double zero = at(0.0, std::clamp(0.0, up_.range.low, up_.range.high)).y;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    for (const auto& piece : curves_[i].pieces) {
      if (piece.size() == 1) {
        svg_.circle(fill_style(i), piece.front(), 2.5);
        continue;
      }
      std::vector<Point> outline = piece;
      if (curves_[i].curve->filled) {
        outline.insert(outline.begin(), {piece.front().x, zero});
        outline.push_back({piece.back().x, zero});
        svg_.polygon("area " + fill_style(i), outline);
      }
      svg_.polyline(curve_style(i), outline);
      labels_.keep_off(outline, 2.0);
    }
  }
}

void PlotPicture::draw_bounds() {
  for (const Bound& bound : plot_.bounds) {
    const double value = y_.value(bound.y);
    if (!drawable(value)) continue;
    const Point from = at(across_.range.low, value), to = at(across_.range.high, value);
    svg_.line("bound", from, to);
    labels_.keep_off(from, to, 1.0);
  }
  for (const Bound& bound : plot_.bounds) {
    const double value = y_.value(bound.y);
    if (!drawable(value)) continue;
    const Text text = typeset(symbol(bound.label) + " " + y_.quantity(bound.y));
    const double wide = width(text, text_size);
    std::vector<Candidate> places;
    for (double share = 0.0; share <= 1.0; share += 0.125) {
      const double x = area_.right - 4.0 - 0.5 * wide - share * (area_.width() - wide - 8.0);
      const double y = at(across_.range.low, value).y;
      places.push_back({Box::around({x, y - 10.0}, wide, line_height - 2.0), share});
      places.push_back({Box::around({x, y + 10.0}, wide, line_height - 2.0), share + 0.1});
    }
    write("halo", labels_.place(places), text);
  }
}

void PlotPicture::draw_marks() {
  for (const Mark& mark : plot_.marks) {
    const Point p{x_.value(mark.x), y_.value(mark.y)};
    if (!drawable(p)) continue;
    const Point dot = at(p.x, p.y);
    svg_.circle("solid", dot, 3.2);
    labels_.keep_off(Box::around(dot, 9.0, 9.0));
  }
  for (const Mark& mark : plot_.marks) {
    const Point p{x_.value(mark.x), y_.value(mark.y)};
    if (!drawable(p)) continue;
    const std::string value = symbol(mark.label) + " " + y_.quantity(mark.y);
    const Text text = typeset(say("{1} at {2}", value, x_.quantity(mark.x)).text());
    write("halo", labels_.place(around(at(p.x, p.y), 7.0, width(text, text_size))), text);
  }
}

void PlotPicture::label_levels() {
  for (const DrawnCurve& drawn : curves_) {
    for (const Level& level : drawn.levels) {
      const Text text = typeset(y_.number(level.si));
      const double wide = width(text, text_size);
      if (level.to.x - level.from.x < 2.0) continue;
      const double zero = at(0.0, 0.0).y, middle = 0.5 * (level.from.x + level.to.x);
      const double outward = level.from.y < zero ? -1.0 : 1.0;
      write("halo",
            labels_.place({{Box::around({middle, 0.5 * (zero + level.from.y)}, wide, line_height), 0.0},
                           {Box::around({middle, level.from.y + outward * 11.0}, wide, line_height), 1.0},
                           {Box::around({middle, zero - outward * 11.0}, wide, line_height), 2.0}}),
            text);
    }
  }
}

/// Places at the side of the curve, clear of its own slope.
std::vector<Candidate> PlotPicture::along_curve(const DrawnCurve& drawn, double width) const {
  std::vector<Candidate> places;
  for (const auto& piece : drawn.pieces) {
    for (std::size_t i = 1; i < piece.size(); ++i) {
      const Point d = piece[i] - piece[i - 1];
      const int parts = 1 + static_cast<int>(length(d) / 12.0);
      for (int k = 0; k < parts; ++k) {
        const Point foot = piece[i - 1] + ((k + 0.5) / parts) * d;
        const double turned = std::fabs(unit(d).y);
        for (const double far : {4.0, 9.0}) {
          const auto sides = beside(foot, foot + 1e-3 * unit(d), far, width);
          for (std::size_t s = 0; s < 2; ++s) {
            places.push_back({sides[s].box, far + 6.0 * turned + 4.0 * (area_.right - foot.x) / area_.width()});
          }
        }
      }
    }
  }
  return places;
}

void PlotPicture::label_curves() {
  std::vector<std::pair<Box, std::size_t>> found;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const std::string& label = curves_[i].curve->label;
    if (label.empty() || (curves_.size() == 1 && label == plot_.y.symbol)) continue;
    const auto box = labels_.place_free(along_curve(curves_[i], width(typeset(label), text_size)));
    if (!box) return draw_legend();
    found.push_back({*box, i});
  }
  for (const auto& [box, i] : found) write("halo " + fill_style(i), box, typeset(curves_[i].curve->label));
}

void PlotPicture::draw_legend() {
  constexpr double sample = 34.0, left = 8.0;
  double x = left, y = height_ + 8.0;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const Text text = typeset(curves_[i].curve->label);
    const double wide = sample + 8.0 + width(text, text_size) + 18.0;
    if (x > left && x + wide > view_width) x = left, y += 20.0;
    svg_.line(curve_style(i), {x, y - 4.5}, {x + sample, y - 4.5});
    svg_.text(fill_style(i), {x + sample + 8.0, y}, text);
    x += wide;
  }
  height_ = y + 10.0;
}

std::string PlotPicture::description() const {
  std::string text = say("{1} over {2}", plain(y_.title(0)), plain(x_.title(0))).text();
  for (const Curve& curve : plot_.curves) {
    Extent y;
    for (const double v : curve.y) y.see(v);
    if (y.empty()) continue;
    const std::string name = curve.label.empty() ? plot_.y.symbol : curve.label;
    text += "; " + say("{1}: {2} to {3}", plain(name), y_.quantity(y.range().low), y_.quantity(y.range().high)).text();
  }
  for (const Mark& mark : plot_.marks) {
    if (!drawable(y_.value(mark.y)) || !drawable(x_.value(mark.x))) continue;
    text += "; " + say("{1}: {2} at {3}", plain(mark.label), y_.quantity(mark.y), x_.quantity(mark.x)).text();
  }
  for (const Bound& bound : plot_.bounds) {
    if (drawable(y_.value(bound.y))) text += "; " + plain(bound.label) + ": " + y_.quantity(bound.y);
  }
  return text;
}

Picture PlotPicture::drawn() {
  draw_axes();
  draw_ticks();
  draw_titles();
  draw_curves();
  draw_bounds();
  draw_marks();
  label_levels();
  label_curves();
  if (empty_) svg_.text("quiet", area_, typeset(say("not available").text()));
  return {svg_, height_, description()};
}

}  // namespace

Picture picture(const Plot& plot) { return PlotPicture(plot).drawn(); }

}  // namespace loadpath::draw
