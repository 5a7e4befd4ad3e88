#include "lib/draw/chart/picture.hpp"

#include "lib/text/issue.hpp"

namespace loadpath::draw {
namespace {

using Verdict = figure::Chart::Verdict;

/// The ends, and in a cloud a little more, so that no dot lies on the frame.
Extent extent_of(const figure::Chart& chart, double figure::Chart::Dot::*value, bool logarithmic) {
  constexpr double room = 0.03;
  Extent seen;
  for (const figure::Chart::Dot& dot : chart.dots) {
    const bool has_place = drawable(dot.x) && drawable(dot.y) && (!logarithmic || dot.*value > 0.0);
    if (has_place && (chart.columns > 0 || dot.verdict != Verdict::none)) seen.see(dot.*value);
  }
  if (seen.empty() || chart.columns > 0) return seen;
  const Range data = seen.range();
  if (logarithmic) {
    const double wider = std::pow(data.high / data.low, room);
    seen.see(data.low / wider);
    seen.see(data.high * wider);
    return seen;
  }
  const double wider = room * (data.high - data.low);
  seen.see(data.low >= 0.0 ? std::max(0.0, data.low - wider) : data.low - wider);
  seen.see(data.high + wider);
  return seen;
}

}  // namespace

PlotFrame frame_of(const figure::Chart& chart) {
  return {chart.x, chart.y, extent_of(chart, &figure::Chart::Dot::x, chart.x.logarithmic),
          extent_of(chart, &figure::Chart::Dot::y, chart.y.logarithmic)};
}

std::string counts_of(const figure::Chart& chart) {
  std::size_t passing = 0, open = 0, none = 0;
  std::vector<std::size_t> failing(chart.modes.size());
  for (const figure::Chart::Dot& dot : chart.dots) {
    passing += static_cast<std::size_t>(dot.verdict == Verdict::passes);
    open += static_cast<std::size_t>(dot.verdict == Verdict::open);
    none += static_cast<std::size_t>(dot.verdict == Verdict::none);
    if (dot.verdict == Verdict::fails) ++failing[dot.mode];
  }
  std::string text =
      say("{1} points drawn: {2} pass", std::to_string(chart.dots.size()), std::to_string(passing)).text();
  for (std::size_t m = 0; m < failing.size(); ++m) {
    if (failing[m] == 0) continue;
    const std::string count = std::to_string(failing[m]), mode = plain(chart.modes[m]);
    text += "; " + (mode.empty() ? say("{1} fail", count) : say("{1} fail by {2}", count, mode)).text();
  }
  if (open > 0) text += "; " + say("{1} have no result", std::to_string(open)).text();
  if (none > 0) text += "; " + say("{1} are invalid designs", std::to_string(none)).text();
  return text;
}

Point Legend::next(std::string_view words) {
  constexpr double left = 14.0, sign = 12.0, spacing = 20.0, row = 20.0;
  const Text text = typeset(words);
  const double wide = sign + width(text, text_size);
  if (x_ > left && x_ + wide > view_width) x_ = left, y_ += row;
  const Point middle{x_, y_ - 4.5};
  canvas_.text("", {x_ + sign, y_}, text);
  x_ += wide + spacing;
  return middle;
}

ChartPicture chart_picture(const figure::Chart& chart) {
  const PlotFrame frame = frame_of(chart);
  std::vector<std::optional<Point>> places;
  for (const figure::Chart::Dot& dot : chart.dots)
    places.push_back(chart.columns == 0 && dot.verdict == Verdict::none ? std::nullopt : frame.place(dot.x, dot.y));
  Picture drawn = chart.columns == 0 ? cloud_picture(chart, frame, places) : field_picture(chart, frame);
  if (frame.empty()) drawn.canvas.centred_text("quiet", frame.area(), typeset(say("not available").text()));
  return {std::move(drawn), std::move(places)};
}

Picture picture(const figure::Charted& chart) { return chart_picture(*chart).picture; }

}  // namespace loadpath::draw
