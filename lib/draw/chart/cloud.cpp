// Dots over two results. Shapes distinguish them without colour: dots pass, crosses fail, rings have no verdict.
#include "lib/draw/chart/picture.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::draw {
namespace {

using Verdict = figure::Chart::Verdict;
using Places = std::vector<std::optional<Point>>;

constexpr double arm = 2.6;     // half size of a cross
constexpr double around = 6.0;  // a dot that is used the most

using Strokes = std::vector<std::pair<Point, Point>>;

void add_cross(Strokes& strokes, Point at) {
  strokes.push_back({at + Point{-arm, -arm}, at + Point{arm, arm}});
  strokes.push_back({at + Point{-arm, arm}, at + Point{arm, -arm}});
}

void draw_ring(Canvas& canvas, const std::vector<Point>& at) {
  canvas.dots("ring", at);
  canvas.dots("hole", at);
}

std::vector<Point> of_verdict(const figure::Chart& chart, const Places& places, Verdict verdict) {
  std::vector<Point> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] && chart.dots[i].verdict == verdict) found.push_back(*places[i]);
  }
  return found;
}

std::vector<Point> of_dots(const std::vector<std::size_t>& which, const Places& places) {
  std::vector<Point> found;
  for (const std::size_t i : which) {
    if (places[i]) found.push_back(*places[i]);
  }
  return found;
}

/// Points between two neighbours of the front that are worse in both results are not feasible: stairs, not a line
/// between them.
std::vector<Point> stairs(const figure::Chart& chart, const std::vector<Point>& front) {
  std::vector<Point> line;
  for (const Point p : front) {
    if (!line.empty()) {
      const Point last = line.back();
      line.push_back({chart.more_x ? std::min(last.x, p.x) : std::max(last.x, p.x),
                      chart.more_y ? std::max(last.y, p.y) : std::min(last.y, p.y)});
    }
    line.push_back(p);
  }
  return line;
}

void draw_worst(Canvas& canvas, Point at) { canvas.rectangle("thin", Box::around(at, 2.0 * around, 2.0 * around)); }

void draw_legend(const figure::Chart& chart, Canvas& canvas, Legend& legend,
                 const std::vector<std::vector<Point>>& groups) {
  if (!groups[0].empty()) canvas.dots("passing", {legend.next(say("passes").text())});
  if (!groups[1].empty()) {
    Strokes cross;
    add_cross(cross, legend.next(say("fails").text()));
    canvas.strokes("failing", cross);
  }
  if (!groups[2].empty()) draw_ring(canvas, {legend.next(say("no result").text())});
  if (!chart.front.empty()) canvas.dots("front", {legend.next(say("Pareto set").text())});
  if (!chart.worst.empty()) draw_worst(canvas, legend.next(say("largest utilisation").text()));
}

/// The captions "less is better" of both scales.
std::string aims(const figure::Chart& chart) {
  const auto aim = [](const figure::Scale& scale, bool more) {
    return (more ? say("more {1} is better", plain(scale.symbol)) : say("less {1} is better", plain(scale.symbol)))
        .text();
  };
  return aim(chart.x, chart.more_x) + ", " + aim(chart.y, chart.more_y);
}

}  // namespace

Picture cloud_picture(const figure::Chart& chart, const PlotFrame& frame, const Places& places) {
  Canvas canvas;
  frame.draw(canvas);
  const std::vector<std::vector<Point>> groups{of_verdict(chart, places, Verdict::passes),
                                               of_verdict(chart, places, Verdict::fails),
                                               of_verdict(chart, places, Verdict::open)};
  draw_ring(canvas, groups[2]);
  Strokes crosses;
  for (const Point at : groups[1]) add_cross(crosses, at);
  canvas.strokes("failing", crosses);
  canvas.dots("passing", groups[0]);
  const std::vector<Point> front = of_dots(chart.front, places);
  if (chart.steps) canvas.polyline("thin", stairs(chart, front));
  canvas.dots("front", front);
  for (const Point at : of_dots(chart.worst, places)) draw_worst(canvas, at);
  Legend legend(canvas, frame.height() + 12.0);
  draw_legend(chart, canvas, legend, groups);
  const std::string description =
      say("{1} over {2}", plain(frame.y().title(0)), plain(frame.x().title(0))).text() + "; " + counts_of(chart) +
      "; " + say("{1} of them in the Pareto set: {2}", std::to_string(chart.front.size()), aims(chart)).text();
  return {std::move(canvas), legend.bottom(), description};
}

}  // namespace loadpath::draw
