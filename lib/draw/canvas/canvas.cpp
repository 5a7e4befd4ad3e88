#include "lib/draw/canvas/canvas.hpp"

namespace loadpath::draw {

void Canvas::path(std::string_view style, std::vector<Point> points, bool closed) {
  if (points.size() > 1) elements_.emplace_back(Path{std::string(style), std::move(points), closed});
}

void Canvas::strokes(std::string_view style, std::vector<Stroke> strokes) {
  if (!strokes.empty()) elements_.emplace_back(Strokes{std::string(style), std::move(strokes)});
}

void Canvas::dots(std::string_view style, std::vector<Point> places) {
  if (!places.empty()) elements_.emplace_back(Dots{std::string(style), std::move(places)});
}

void Canvas::circle(std::string_view style, Point centre, double radius) {
  elements_.emplace_back(Circle{std::string(style), centre, radius});
}

void Canvas::arc(std::string_view style, Point centre, double radius, double start, double sweep) {
  elements_.emplace_back(Arc{std::string(style), centre, radius, start, sweep});
}

void Canvas::rectangle(std::string_view style, const Box& box) {
  elements_.emplace_back(Rectangle{std::string(style), box});
}

void Canvas::text(std::string_view style, Point at, Text text, Anchor anchor, bool turned) {
  if (!text.empty()) elements_.emplace_back(Words{std::string(style), at, std::move(text), anchor, turned});
}

void Canvas::centred_text(std::string_view style, const Box& box, Text words) {
  constexpr double cap_half = 4.6;  // half the height of a capital
  text(style, box.centre() + Point{0.0, cap_half}, std::move(words), Anchor::middle);
}

void Canvas::append(const Canvas& other) {
  elements_.insert(elements_.end(), other.elements_.begin(), other.elements_.end());
}

void Canvas::begin_group(Attributes attributes) { elements_.emplace_back(GroupBegin{std::move(attributes)}); }
void Canvas::end_group() { elements_.emplace_back(GroupEnd{}); }

}  // namespace loadpath::draw
