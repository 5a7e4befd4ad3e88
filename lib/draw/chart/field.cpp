// Contour lines over two inputs, the failing region hatched: rising or falling strokes distinguish neighbouring modes
// without colour. Regions without a verdict are speckled.
#include "lib/draw/canvas/labels.hpp"
#include "lib/draw/chart/hatching.hpp"
#include "lib/draw/chart/picture.hpp"
#include "lib/draw/chart/regions.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::draw {
namespace {

using Verdict = figure::Chart::Verdict;
using Lines = std::vector<std::vector<Point>>;

constexpr double hatch_spacing = 8.0, speckle_spacing = 11.0;

Lattice lattice_of(const figure::Chart& chart, const PlotFrame& frame) {
  Lattice lattice;
  const Point origin{frame.area().left, frame.area().bottom};
  for (std::size_t i = 0; i < chart.columns; ++i)
    lattice.x.push_back(frame.place(chart.dots[i].x, chart.dots[i].y).value_or(origin).x);
  for (std::size_t i = 0; i < chart.dots.size(); i += chart.columns)
    lattice.y.push_back(frame.place(chart.dots[i].x, chart.dots[i].y).value_or(origin).y);
  return lattice;
}

/// Levels to draw, SI: round ones, at equal steps, or doubling where the values go through decades.
std::vector<double> levels_of(const figure::Chart& chart, const Display& display) {
  Extent seen;
  bool positive = true;
  for (const double level : chart.levels) {
    seen.see(display.value(level));
    positive = positive && !(level <= 0.0);
  }
  if (seen.empty()) return {};
  constexpr double decades = 12.0;
  const Range range = seen.range();
  const bool wide = positive && range.high > decades * range.low;
  std::vector<double> levels;
  if (!wide) return axis(range, 8, Steps::decimal, Ends::data).ticks;
  for (double level = round_below(range.low); level <= range.high && levels.size() < 12;) {
    levels.push_back(level);
    const double next = round_below(2.5 * level);  // 1, 2, 5, 10
    level = next > level ? next : 2.0 * level;
  }
  return levels;
}

class FieldPicture {
 public:
  FieldPicture(const figure::Chart& chart, const PlotFrame& frame)
      : chart_(chart),
        frame_(frame),
        display_(figure::Scale{chart.level, "", chart.level_unit}),
        lattice_(lattice_of(chart, frame)),
        regions_(chart, lattice_),
        area_{lattice_.x.front(), lattice_.y.back(), lattice_.x.back(), lattice_.y.front()},
        labels_(area_) {}
  Picture drawn();

 private:
  [[nodiscard]] bool fails_by(Point at, std::size_t mode) const;
  [[nodiscard]] bool is_open(Point at) const;
  void hatch();
  void speckle();
  void draw_lines(std::string_view style, const Lines& lines);
  void label_region(const std::string& words, const std::function<bool(Point)>& holds);
  void draw_levels();
  void label_level(double level, const Lines& lines);
  void draw_legend(Legend& legend);

  const figure::Chart& chart_;
  const PlotFrame& frame_;
  Display display_;
  Lattice lattice_;
  Regions regions_;
  Box area_;
  Labels labels_;
  Canvas canvas_;
};

bool FieldPicture::fails_by(Point at, std::size_t mode) const {
  const figure::Chart::Dot& dot = regions_.at(at);
  return dot.verdict == Verdict::fails && dot.mode == mode;
}

bool FieldPicture::is_open(Point at) const {
  const Verdict verdict = regions_.at(at).verdict;
  return verdict == Verdict::open || verdict == Verdict::none;
}

void FieldPicture::hatch() {
  for (const std::size_t odd : {0U, 1U}) {
    const auto holds = [&](Point at) {
      const figure::Chart::Dot& dot = regions_.at(at);
      return dot.verdict == Verdict::fails && dot.mode % 2 == odd;
    };
    canvas_.strokes("hatch", hatching(area_, hatch_spacing, odd == 0, holds));
  }
}

void FieldPicture::speckle() {
  std::vector<Point> specks;
  bool shifted = false;
  for (double y = area_.top + 0.5 * speckle_spacing; y < area_.bottom; y += 0.6 * speckle_spacing) {
    shifted = !shifted;
    for (double x = area_.left + (shifted ? 0.75 : 0.25) * speckle_spacing; x < area_.right; x += speckle_spacing) {
      if (is_open({x, y})) specks.push_back({x, y});
    }
  }
  canvas_.dots("speckle", specks);
}

void FieldPicture::draw_lines(std::string_view style, const Lines& lines) {
  for (const auto& line : lines) canvas_.polyline(style, line);
}

/// Places a label in the middle of its region, if a position is entirely inside.
void FieldPicture::label_region(const std::string& words, const std::function<bool(Point)>& holds) {
  constexpr double step = 9.0, high = 18.0;
  const Text text = typeset(words);
  const double wide = width(text, text_size) + 8.0;
  Point sum;
  std::vector<Point> inside;
  for (double y = area_.top + 0.5 * step; y < area_.bottom; y += step) {
    for (double x = area_.left + 0.5 * step; x < area_.right; x += step) {
      if (holds({x, y})) inside.push_back({x, y}), sum = sum + Point{x, y};
    }
  }
  if (inside.empty()) return;
  const Point middle = (1.0 / static_cast<double>(inside.size())) * sum;
  std::vector<Candidate> places;
  for (const Point at : inside) {
    const Box box = Box::around(at, wide, high);
    bool whole = true;
    for (const double x : {box.left, 0.5 * (box.left + at.x), at.x, 0.5 * (box.right + at.x), box.right})
      whole = whole && holds({x, box.top}) && holds({x, box.bottom});
    if (whole) places.push_back({box, length(at - middle)});
  }
  if (const auto box = labels_.place_free(places)) canvas_.centred_text("halo", *box, text);
}

/// On the line, where it is long, away from other labels.
void FieldPicture::label_level(double level, const Lines& lines) {
  constexpr std::size_t shortest = 3;
  const Text text = typeset(display_.number(level));
  std::vector<Candidate> places;
  for (const auto& line : lines) {
    if (line.size() < shortest) continue;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(line.size() - 1);
      places.push_back({Box::around(line[i], width(text, text_size) + 4.0, 13.0), std::fabs(share - 0.5)});
    }
  }
  if (const auto box = labels_.place_free(places)) canvas_.centred_text("halo", *box, text);
}

void FieldPicture::draw_levels() {
  const double slope = display_.value(1.0) - display_.value(0.0);
  std::vector<std::pair<double, Lines>> levels;
  for (const double shown : levels_of(chart_, display_)) {
    const double si = (shown - display_.value(0.0)) / slope;
    levels.emplace_back(si, regions_.level(si));
    draw_lines("level", levels.back().second);
  }
  draw_lines("limit", regions_.limit());
  draw_lines("light dash", regions_.unknown());
  for (const auto& [si, lines] : levels) label_level(si, lines);
}

void FieldPicture::draw_legend(Legend& legend) {
  if (!chart_.level.empty()) {
    const Point at = legend.next(display_.title(0));
    canvas_.line("level", at + Point{-9.0, 0.0}, at + Point{9.0, 0.0});
  }
  const auto has = [&](Verdict verdict) {
    return std::any_of(chart_.dots.begin(), chart_.dots.end(), [&](const auto& dot) { return dot.verdict == verdict; });
  };
  if (has(Verdict::fails)) {
    const Point at = legend.next(say("fails").text());
    const Box box = Box::around(at, 18.0, 10.0);
    canvas_.strokes("hatch", hatching(box, 0.5 * hatch_spacing, true, [](Point) { return true; }));
    canvas_.rectangle("thin", box);
  }
  if (has(Verdict::open) || has(Verdict::none)) {
    const Point at = legend.next(say("no result, or invalid design").text());
    canvas_.dots("speckle", {at + Point{-6.0, 2.0}, at + Point{0.0, -2.0}, at + Point{6.0, 2.0}});
  }
}

Picture FieldPicture::drawn() {
  frame_.draw(canvas_);
  hatch();
  speckle();
  draw_lines("thin", regions_.between_modes());
  for (std::size_t mode = 0; mode < chart_.modes.size(); ++mode)
    label_region(chart_.modes[mode], [&](Point at) { return fails_by(at, mode); });
  label_region(say("passes").text(), [&](Point at) { return regions_.at(at).verdict == Verdict::passes; });
  Canvas labels = std::move(canvas_);  // above the lines
  canvas_ = Canvas();
  draw_levels();
  Legend legend(canvas_, frame_.height() + 12.0);
  draw_legend(legend);
  labels.append(canvas_);
  const std::string what = chart_.level.empty() ? say("Passing region").text() : plain(display_.title(0));
  const std::string over =
      say("{1} over {2} and {3}", what, plain(frame_.x().title(0)), plain(frame_.y().title(0))).text();
  return {std::move(labels), legend.bottom(), over + "; " + counts_of(chart_)};
}

}  // namespace

Picture field_picture(const figure::Chart& chart, const PlotFrame& frame) { return FieldPicture(chart, frame).drawn(); }

}  // namespace loadpath::draw
