#include "lib/draw/canvas/labels.hpp"
#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/plot/curve.hpp"
#include "lib/draw/plot/strip.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>

namespace loadpath::draw {
namespace {

std::string curve_style(std::size_t i) { return "curve c" + std::to_string(i % 3) + " d" + std::to_string(i % 4); }
std::string fill_style(std::size_t i) { return "f" + std::to_string(i % 3); }

constexpr double dot_radius = 2.5;
constexpr std::size_t most_levels = 16;  // curves with labelled values
/// Whether the points of a curve are not connected: points of a test.
bool is_dots(const DrawnCurve& curve) {
  return !curve.pieces.empty() &&
         std::all_of(curve.pieces.begin(), curve.pieces.end(), [](const auto& piece) { return piece.size() == 1; });
}

class PlotPicture {
 public:
  explicit PlotPicture(const figure::Plot& plot, const std::optional<Strip>& strip = {});
  Picture drawn();

 private:
  void draw_piece(std::size_t i, const std::vector<Point>& piece);
  void draw_bounds();
  void draw_marks();
  void label_bound(const figure::Bound& bound);
  void label_mark(const figure::Mark& mark);
  [[nodiscard]] std::string style_of(const figure::Mark& mark) const;
  void keep_near(Point dot, std::vector<Candidate>& places) const;
  void add_far_places(Point dot, double wide, std::vector<Candidate>& places) const;
  void label_level(const Level& level, std::size_t of_curve);
  [[nodiscard]] bool is_marked(const Level& level, const std::string& label) const;
  void label_curves();
  [[nodiscard]] std::vector<Candidate> places_along_curve(const DrawnCurve& drawn, double width) const;
  void draw_legend();
  [[nodiscard]] std::string description() const;

  const figure::Plot& plot_;
  PlotFrame frame_;
  bool is_strip_;
  std::vector<DrawnCurve> curves_;
  Labels labels_;
  Canvas canvas_;
  double height_;
};

PlotPicture::PlotPicture(const figure::Plot& plot, const std::optional<Strip>& strip)
    : plot_(plot), frame_(plot, strip), is_strip_(strip), labels_(frame_.area().grown(1.0)), height_(frame_.height()) {
  for (const figure::Curve& curve : plot.curves) curves_.push_back(drawn_curve(curve, frame_));
}

void PlotPicture::draw_piece(std::size_t i, const std::vector<Point>& piece) {
  if (piece.size() == 1) return canvas_.circle(fill_style(i), piece.front(), dot_radius);
  std::vector<Point> outline = piece;
  if (plot_.curves[i].filled) {
    outline.insert(outline.begin(), {piece.front().x, frame_.zero_line()});
    outline.push_back({piece.back().x, frame_.zero_line()});
    canvas_.polygon("area " + fill_style(i), outline);
  }
  canvas_.polyline(curve_style(i), outline);
  labels_.keep_off(outline, 1.5);
}

void PlotPicture::draw_bounds() {
  for (const figure::Bound& bound : plot_.bounds) {
    const auto from = frame_.left_end(bound.y);
    if (!from) continue;
    const Point to{frame_.area().right, from->y};
    canvas_.line("bound", *from, to);
    labels_.keep_off({*from, to});
  }
}

void PlotPicture::label_bound(const figure::Bound& bound) {
  const auto end = frame_.left_end(bound.y);
  if (!end) return;
  const Text text = typeset(symbol(bound.label) + " " + with_minus(frame_.y_quantity(bound.y)));
  const double wide = width(text, text_size), room = frame_.area().width() - wide - 8.0;
  std::vector<Candidate> places;
  for (int eighth = 0; eighth <= 8; ++eighth) {
    const double share = 0.125 * eighth;
    const double x = frame_.area().right - 4.0 - 0.5 * wide - share * room;
    places.push_back({Box::around({x, end->y - 10.0}, wide, 14.0), share});
    places.push_back({Box::around({x, end->y + 10.0}, wide, 14.0), share + 0.1});
  }
  canvas_.centred_text("halo", labels_.place(places), text);
}

void PlotPicture::draw_marks() {
  for (const figure::Mark& mark : plot_.marks) {
    const auto dot = frame_.place(mark.x, mark.y);
    if (!dot) continue;
    canvas_.circle("solid", *dot, 3.2);
    labels_.keep_off(Box::around(*dot, 9.0, 9.0));
  }
}

void PlotPicture::label_mark(const figure::Mark& mark) {
  const auto dot = frame_.place(mark.x, mark.y);
  if (!dot) return;
  const std::string value = symbol(mark.label) + " " + with_minus(frame_.y_quantity(mark.y));
  // The title of a strip has the unit; its axis is that of the drawing above it, and shows where the dot is.
  const Text text = typeset(is_strip_ ? symbol(mark.label) + " " + with_minus(frame_.y().number(mark.y))
                                      : say("{1} at {2}", value, with_minus(frame_.x_quantity(mark.x))).text());
  const double wide = width(text, text_size);
  std::vector<Candidate> places = around(*dot, 7.0, wide);
  if (is_strip_) {
    add_far_places(*dot, wide, places);
    keep_near(*dot, places);
  }
  canvas_.centred_text("halo" + style_of(mark), labels_.place(places), text);
}

/// Of several curves the value of one is in its colour.
std::string PlotPicture::style_of(const figure::Mark& mark) const {
  const auto of = std::ranges::find(plot_.curves, mark.label, &figure::Curve::label);
  if (plot_.curves.size() < 2 || of == plot_.curves.end()) return "";
  return " " + fill_style(static_cast<std::size_t>(of - plot_.curves.begin()));
}

/// In a low strip: a label next to the dot of another one would be read as its value.
void PlotPicture::keep_near(Point dot, std::vector<Candidate>& places) const {
  constexpr double misread = 12.0;
  for (Candidate& place : places) {
    const Point middle{0.5 * (place.box.left + place.box.right), 0.5 * (place.box.top + place.box.bottom)};
    for (const figure::Mark& other : plot_.marks) {
      const auto at = frame_.place(other.x, other.y);
      if (at && length(*at - middle) < length(dot - middle)) place.cost += misread;
    }
  }
}

/// In a low strip a peak may have no room next to it: then any free place does, for the label has its symbol.
void PlotPicture::add_far_places(Point dot, double wide, std::vector<Candidate>& places) const {
  constexpr double spacing = 4.0, of_distance = 0.1;
  constexpr double far = 8.0;  // costs less than a curve
  const Box& area = frame_.area();
  for (double y = area.top + 0.5 * line_height; y < area.bottom; y += spacing) {
    for (double x = area.left + 0.5 * wide; x < area.right - 0.5 * wide; x += spacing)
      places.push_back({Box::around({x, y}, wide, line_height), far + of_distance * length(Point{x, y} - dot)});
  }
}

bool PlotPicture::is_marked(const Level& level, const std::string& label) const {
  return std::ranges::any_of(plot_.marks,
                             [&](const figure::Mark& mark) { return mark.label == label && mark.y == level.si; });
}

/// The value in the middle of its stretch: in the area, or beyond it where the area is too low. A zero says nothing.
/// Where there are several curves, with the symbol of its own, if there is room for it; their peaks are marked.
void PlotPicture::label_level(const Level& level, std::size_t of_curve) {
  constexpr double least = 2.0, beyond = 11.0;
  const std::string& label = plot_.curves[of_curve].label;
  if (level.si == 0.0 || level.to.x - level.from.x < least || is_marked(level, label)) return;
  const bool is_named = curves_.size() > 1 && !label.empty();
  const std::string name = is_named ? symbol(label) + " " : "";
  const Text text = typeset(name + with_minus(frame_.y().number(level.si)));
  const double wide = width(text, text_size), zero = frame_.zero_line();
  const Box& area = frame_.area();  // the numbers of the axis are beyond it
  const double low = area.left + 0.5 * wide + 2.0, high = std::max(low, area.right - 0.5 * wide);
  const double middle = std::clamp(0.5 * (level.from.x + level.to.x), low, high);
  const double outward = level.from.y < zero ? -1.0 : 1.0;
  std::vector<Candidate> places;
  for (const double y : {0.5 * (zero + level.from.y), level.from.y + outward * beyond, zero - outward * beyond}) {
    places.push_back({Box::around({middle, y}, wide, line_height), static_cast<double>(places.size())});
  }
  if (!is_named) return canvas_.centred_text("halo", labels_.place(places), text);
  if (const auto free = labels_.place_free(places)) canvas_.centred_text("halo " + fill_style(of_curve), *free, text);
}

/// Places on both sides all along the curve; level stretches on the right first.
std::vector<Candidate> PlotPicture::places_along_curve(const DrawnCurve& drawn, double width) const {
  constexpr double spacing = 12.0, low = 15.0;  // with room for a subscript
  std::vector<Candidate> places;
  const auto add = [&](Point foot, Point direction) {
    const double bias = 6.0 * std::fabs(direction.y) + 4.0 * (frame_.area().right - foot.x) / frame_.area().width();
    for (const double gap : {3.0, 8.0}) {
      for (const Box& box : both_sides(foot, direction, gap, width, low)) places.push_back({box, gap + bias});
    }
  };
  for (const auto& piece : drawn.pieces) {
    for (std::size_t i = 1; i < piece.size(); ++i) {
      const Point step = piece[i] - piece[i - 1];
      const int parts = 1 + static_cast<int>(length(step) / spacing);
      for (int k = 0; k < parts; ++k) add(piece[i - 1] + ((k + 0.5) / parts) * step, unit(step));
    }
  }
  return places;
}

void PlotPicture::label_curves() {
  std::vector<std::pair<Box, std::size_t>> found;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const std::string& label = plot_.curves[i].label;
    const bool said_by_axis = curves_.size() == 1 && label == plot_.y.symbol;
    if (label.empty() || curves_[i].pieces.empty() || said_by_axis) continue;
    const auto box = labels_.place_free(places_along_curve(curves_[i], width(typeset(label), text_size)));
    if (!box) return draw_legend();
    found.emplace_back(*box, i);
  }
  for (const auto& [box, i] : found) {
    canvas_.centred_text("halo " + fill_style(i), box, typeset(plot_.curves[i].label));
  }
}

void PlotPicture::draw_legend() {
  constexpr double sample = 34.0, gap = 8.0, spacing = 18.0, row = 20.0;
  const double left = is_strip_ ? 0.5 * view_width : 8.0;
  double x = left, y = is_strip_ ? frame_.area().top - 6.0 : height_ + gap;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const Text text = typeset(plot_.curves[i].label);
    const double wide = sample + gap + width(text, text_size) + spacing;
    if (x > left && x + wide > view_width) x = left, y += row;
    if (is_dots(curves_[i])) {
      canvas_.circle(fill_style(i), {x + 0.5 * sample, y - 4.5}, dot_radius);
    } else {
      canvas_.line(curve_style(i), {x, y - 4.5}, {x + sample, y - 4.5});
    }
    canvas_.text(fill_style(i), {x + sample + gap, y}, text);
    x += wide;
  }
  height_ = std::max(height_, y + 10.0);
}

std::string PlotPicture::description() const {
  const Display &x = frame_.x(), &y = frame_.y();
  std::string text = say("{1} over {2}", plain(y.title(0)), plain(x.title(0))).text();
  for (const figure::Curve& curve : plot_.curves) {
    Extent seen;
    for (const double v : curve.y) seen.see(v);
    if (seen.empty()) continue;
    const std::string name = plain(curve.label.empty() ? plot_.y.symbol : curve.label);
    text += "; " + say("{1}: {2} to {3}", name, y.quantity(seen.range().low), y.quantity(seen.range().high)).text();
  }
  for (const figure::Mark& mark : plot_.marks) {
    if (!frame_.place(mark.x, mark.y)) continue;
    text += "; " + say("{1}: {2} at {3}", plain(mark.label), y.quantity(mark.y), x.quantity(mark.x)).text();
  }
  for (const figure::Bound& bound : plot_.bounds) {
    if (frame_.left_end(bound.y)) text += "; " + say("{1}: {2}", plain(bound.label), y.quantity(bound.y)).text();
  }
  return text;
}

Picture PlotPicture::drawn() {
  frame_.draw(canvas_);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    for (const auto& piece : curves_[i].pieces) draw_piece(i, piece);
  }
  draw_bounds();
  draw_marks();
  for (const figure::Mark& mark : plot_.marks) label_mark(mark);
  for (const figure::Bound& bound : plot_.bounds) label_bound(bound);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    if (curves_[i].levels.size() > most_levels) continue;  // a histogram
    for (const Level& level : curves_[i].levels) label_level(level, i);
  }
  label_curves();
  if (frame_.empty()) canvas_.centred_text("quiet", frame_.area(), typeset(say("not available").text()));
  return {std::move(canvas_), height_, description()};
}

}  // namespace

Picture picture(const figure::Plot& plot) { return PlotPicture(plot).drawn(); }
Picture picture(const figure::Plot& plot, const Strip& strip) { return PlotPicture(plot, strip).drawn(); }

}  // namespace loadpath::draw
