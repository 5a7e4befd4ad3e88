#include "lib/draw/plot/frame.hpp"

namespace loadpath::draw {
namespace {

constexpr double plot_top = 30.0, plot_depth = 232.0, plot_right = 466.0;

Steps steps_of(const Display& display) { return display.in_degrees() ? Steps::degrees : Steps::decimal; }

/// Zero is shown where the values are not far from it, and always under an area.
Range with_zero(Range range, bool filled) {
  const double far = 0.5 * std::max(std::fabs(range.low), std::fabs(range.high));
  if (filled || range.low < far) range.low = std::min(range.low, 0.0);
  if (filled || range.high > -far) range.high = std::max(range.high, 0.0);
  return range;
}

/// The range of a logarithmic scale; one decade if there are no positive values.
Range positive(const Extent& seen) { return seen.empty() ? Range{1.0, 10.0} : seen.range(); }

Text fitting_title(const Display& display, int power) {
  const Text text = typeset(display.title(power));
  return width(text, text_size) < view_width - 8.0 ? text : typeset(display.title(power, false));
}

}  // namespace

void Extent::see(double value) {
  if (drawable(value)) range_ = {std::min(range_.low, value), std::max(range_.high, value)};
}

PlotFrame::PlotFrame(const figure::Plot& plot, const std::optional<Strip>& strip) : x_(plot.x), y_(plot.y) {
  Extent x_seen, y_seen;
  bool filled = false;
  const auto see = [&](double x_si, double y_si) {
    const Point p{x_.value(x_si), y_.value(y_si)};
    if (x_.has_place(p.x) && y_.has_place(p.y)) x_seen.see(p.x), y_seen.see(p.y);
  };
  for (const figure::Curve& curve : plot.curves) {
    filled = filled || curve.filled;
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) see(curve.x[i], curve.y[i]);
  }
  for (const figure::Mark& mark : plot.marks) see(mark.x, mark.y);
  empty_ = x_seen.empty();
  for (const figure::Bound& bound : plot.bounds) {
    if (y_.has_place(y_.value(bound.y))) y_seen.see(y_.value(bound.y));
  }
  up_ = y_.logarithmic() ? logarithmic_axis(positive(y_seen), Ends::ticks)
                         : axis(with_zero(y_seen.range(), filled), strip ? 3 : 6, steps_of(y_), Ends::ticks);
  across_ = x_.logarithmic() ? logarithmic_axis(positive(x_seen), Ends::data)
                             : axis(x_seen.range(), 8, steps_of(x_), Ends::data);
  if (strip) {
    across_ = axis({x_.value(strip->across.low), x_.value(strip->across.high)}, 8, steps_of(x_), Ends::data);
    across_.range = {x_.value(strip->across.low), x_.value(strip->across.high)};
    std::erase_if(across_.ticks, [&](double t) { return t > across_.range.high; });
    area_ = strip->area, tells_across_ = strip->last;
    return;
  }
  take_page();
}

/// The range in the unit of the display.
static Axis close_axis(const Display& display, const Extent& seen, int most) {
  Extent shown;
  if (!seen.empty()) shown.see(display.value(seen.range().low)), shown.see(display.value(seen.range().high));
  return display.logarithmic() ? logarithmic_axis(positive(shown), Ends::data)
                               : axis(shown.range(), most, steps_of(display), Ends::data);
}

PlotFrame::PlotFrame(const figure::Scale& x, const figure::Scale& y, const Extent& across, const Extent& up)
    : x_(x), y_(y), across_(close_axis(x_, across, 8)), up_(close_axis(y_, up, 6)), empty_(across.empty()) {
  take_page();
}

/// Takes the space to the right of the widest number on the left.
void PlotFrame::take_page() {
  double widest = 0.0;
  for (const double tick : up_.ticks) widest = std::max(widest, width(typeset(with_minus(up_.text(tick))), text_size));
  area_ = {widest + 10.0, plot_top, plot_right, plot_top + plot_depth};
}

Point PlotFrame::at(double x, double y) const {
  return {area_.left + across_.fraction(x) * area_.width(), area_.bottom - up_.fraction(y) * area_.height()};
}

std::optional<Point> PlotFrame::place(double x, double y) const {
  const Point p{x_.value(x), y_.value(y)};
  return x_.has_place(p.x) && y_.has_place(p.y) ? std::optional(at(p.x, p.y)) : std::nullopt;
}

std::optional<Point> PlotFrame::left_end(double y) const {
  const double value = y_.value(y);
  return y_.has_place(value) ? std::optional(at(across_.range.low, value)) : std::nullopt;
}

double PlotFrame::zero_line() const { return at(0.0, std::clamp(0.0, up_.range.low, up_.range.high)).y; }

void PlotFrame::draw_grid(Canvas& canvas) const {
  std::vector<std::pair<Point, Point>> lines;
  for (const double t : across_.ticks) lines.push_back({at(t, up_.range.low), at(t, up_.range.high)});
  for (const double t : up_.ticks) lines.push_back({at(across_.range.low, t), at(across_.range.high, t)});
  canvas.strokes("grid", lines);
  const Point corner{area_.left, area_.bottom};
  canvas.strokes("axis", {{{area_.left, area_.top}, corner}, {corner, {area_.right, area_.bottom}}});
  if (up_.range.low <= 0.0 && up_.range.high >= 0.0) {
    canvas.line("zero", at(across_.range.low, 0.0), at(across_.range.high, 0.0));
  }
}

void PlotFrame::draw_ticks(Canvas& canvas) const {
  for (const double t : up_.ticks) {
    canvas.text("", at(across_.range.low, t) + Point{-6.0, 4.5}, typeset(with_minus(up_.text(t))), Anchor::end);
  }
  double free_from = 0.0;
  for (const double t : across_.ticks) {
    if (!tells_across_) break;
    const Text text = typeset(with_minus(across_.text(t)));
    const double half = 0.5 * width(text, text_size);
    const double x = std::min(at(t, up_.range.low).x, view_width - 2.0 - half);
    if (x - half < free_from) continue;
    canvas.text("", {x, area_.bottom + 17.0}, text, Anchor::middle);
    free_from = x + half + 6.0;
  }
}

void PlotFrame::draw_titles(Canvas& canvas) const {
  canvas.text("halo", {4.0, area_.top - 14.0}, fitting_title(y_, up_.power));
  if (tells_across_) canvas.text("", {area_.right, area_.bottom + 36.0}, fitting_title(x_, across_.power), Anchor::end);
}

void PlotFrame::draw(Canvas& canvas) const {
  draw_grid(canvas);
  draw_ticks(canvas);
  draw_titles(canvas);
}

}  // namespace loadpath::draw
