#include "lib/draw/drawing/view.hpp"

#include "lib/draw/canvas/scale_bar.hpp"
#include "lib/draw/canvas/thin.hpp"
#include "lib/draw/drawing/clip.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/text/issue.hpp"

#include <numbers>

namespace loadpath::draw {
namespace {

using Line = figure::Drawing::Line;

constexpr double least_hatched = 4.0;  // sections of thinner walls are filled, as ISO 128 permits
constexpr double thinnest_seen = 0.7;  // thinner walls are drawn as lines

std::string_view style_of(Line line) {
  switch (line) {
    case Line::outline:
      return "outline";
    case Line::thin:
      return "light";
    case Line::hidden:
      return "thin dash";
    case Line::centre:
      return "centre";
    case Line::belt:
      return "belt";
    case Line::action:
      return "level";
    case Line::contact:
      return "contact";
  }
  return "outline";
}

std::vector<Point> closed(std::vector<Point> outline) {
  outline.push_back(outline.front());
  return outline;
}

/// The half width of a label's clearance.
double half_width(Line line) { return line == Line::belt || line == Line::contact ? 3.0 : 1.5; }

/// A circle as closely as it is seen.
std::vector<Point> fine_ring(Point centre, double radius) {
  const int corners = static_cast<int>(std::clamp(8.0 * std::sqrt(radius), 24.0, 1440.0));
  std::vector<Point> points;
  for (int i = 0; i <= corners; ++i) points.push_back(centre + radius * along(2.0 * std::numbers::pi * i / corners));
  return points;
}

}  // namespace

std::vector<Point> ViewPicture::at(const std::vector<Point>& points) const {
  std::vector<Point> page;
  page.reserve(points.size());
  for (const Point p : points) page.push_back(at(p));
  return page;
}

bool ViewPicture::is_in_window(Point page) const {
  return !view_.window || fit_.extent.grown(0.5).contains(Box::around(page, 0.0, 0.0));
}

/// Cut faces are hatched, thin walls filled, to scale too where they are thinner than a line could show.
void ViewPicture::draw_cut(const std::vector<Point>& face, const std::vector<Point>& outline,
                           const std::vector<Point>& hole) {
  for (const auto* edge : {&outline, &hole}) {
    if (!edge->empty()) labels_.keep_off(closed(*edge), 1.5);
  }
  const double thickness = mean_thickness(face);
  if (thickness < least_hatched) {
    canvas_.polygon("solid", face);
    if (thickness < thinnest_seen) canvas_.polyline("thin", closed(outline));
    return;
  }
  canvas_.polygon("body", face);
  canvas_.strokes("light", hatching(face, 6.0));
  canvas_.polygon("outline", outline);
  if (!hole.empty()) canvas_.polygon("outline", hole);
}

/// Whether a body is drawn with its outline as one element: two would repeat the hundreds of points of a gear.
bool ViewPicture::is_outline_of(const figure::Drawing::Path& path, const figure::Drawing::Area& area) const {
  const auto same = [](Point p, Point q) { return p.x == q.x && p.y == q.y; };
  return !view_.window && area.kind == figure::Drawing::Kind::body && area.hole.empty() && path.closed &&
         path.line == Line::outline && std::ranges::equal(path.points, area.outline, same);
}

bool ViewPicture::is_outlined(const figure::Drawing::Area& area) const {
  return std::ranges::any_of(view_.paths, [&](const auto& path) { return is_outline_of(path, area); });
}

void ViewPicture::draw_areas() {
  for (const auto& area : view_.areas) {
    const std::vector<Point> outline = simplified(at(area.outline)), hole = simplified(at(area.hole));
    std::vector<Point> face = outline;
    if (!hole.empty()) {  // around it along a seam
      face.push_back(outline.front());
      face.insert(face.end(), hole.rbegin(), hole.rend());
      face.push_back(hole.back());
    }
    if (view_.window) face = clipped_area(face, fit_.extent);
    if (face.size() < 3) continue;
    switch (area.kind) {
      case figure::Drawing::Kind::cut:
        draw_cut(face, outline, hole);
        break;
      case figure::Drawing::Kind::body:
        canvas_.polygon(is_outlined(area) ? "body outline" : "body", face);
        break;
      case figure::Drawing::Kind::liquid:
        canvas_.polygon("liquid", face);
        break;
      case figure::Drawing::Kind::lost:
        canvas_.polygon("worn", face);
        break;
    }
  }
}

void ViewPicture::stroke(Line line, const std::vector<Point>& page) {
  const auto draw = [&](const std::vector<Point>& piece) {
    const std::vector<Point> kept = simplified(piece);
    canvas_.polyline(style_of(line), kept);
    labels_.keep_off(kept, half_width(line), line == Line::thin ? 0.3 : 1.0);
  };
  if (!view_.window) return draw(page);
  for (const auto& piece : clipped(page, fit_.extent)) draw(piece);
}

void ViewPicture::draw_circles() {
  for (const auto& circle : view_.circles) {
    const Point centre = at(circle.centre);
    const double radius = fit_.scale * circle.radius;
    if (view_.window) {
      stroke(circle.line, fine_ring(centre, radius));
      continue;
    }
    if (circle.filled) canvas_.circle("body", centre, radius);
    canvas_.circle(style_of(circle.line), centre, radius);
    labels_.keep_off(fine_ring(centre, radius), 1.5);
  }
}

void ViewPicture::draw_paths() {
  for (const auto& path : view_.paths) {
    std::vector<Point> page = at(path.points);
    if (path.closed) page.push_back(page.front());
    if (std::ranges::any_of(view_.areas, [&](const auto& area) { return is_outline_of(path, area); })) {
      labels_.keep_off(simplified(page), half_width(path.line));
    } else {
      stroke(path.line, page);
    }
  }
}

/// The sign of a level: a triangle on the surface, and lines under it.
void ViewPicture::draw_surfaces() {
  for (const auto& surface : view_.surfaces) {
    const Point from = at(surface.from), to = at(surface.to);
    canvas_.line("level", from, to);
    labels_.keep_off({from, to}, 2.0);
    const double wide = std::fabs(to.x - from.x);
    if (wide < 40.0) continue;
    const double x = std::min(from.x, to.x) + 0.3 * wide, half = 5.0, high = 8.0;
    canvas_.polygon("pin", {{x, from.y - 0.6}, {x - half, from.y - high}, {x + half, from.y - high}});
    canvas_.strokes("light", {{{x - 6.0, from.y + 3.5}, {x + 6.0, from.y + 3.5}},
                              {{x - 3.5, from.y + 6.5}, {x + 3.5, from.y + 6.5}}});
    labels_.keep_off({x - 8.0, from.y - 10.0, x + 8.0, from.y + 8.0});
  }
}

void ViewPicture::draw_frame() {
  if (view_.window) canvas_.rectangle("light", fit_.extent);
}

void ViewPicture::fixed_text(Point centre, const Text& text, bool turned) {
  constexpr double cap_half = 4.6;
  const double wide = width(text, text_size);
  if (turned) {
    canvas_.text("halo", centre + Point{cap_half, 0.0}, text, Anchor::middle, true);
    labels_.keep_off(Box::around(centre, line_height, wide));
  } else {
    canvas_.text("halo", centre + Point{0.0, cap_half}, text, Anchor::middle);
    labels_.keep_off(Box::around(centre, wide, line_height));
  }
}

void ViewPicture::free_text(std::string_view style, const std::vector<Candidate>& places, const Text& text) {
  canvas_.centred_text(style, labels_.place(places), text);
}

void ViewPicture::draw_words() {
  if (!view_.title.empty()) {
    const Point top{0.5 * (fit_.area.left + fit_.area.right), fit_.area.top + 12.0};
    canvas_.text("quiet", top, typeset(view_.title), Anchor::middle);
  }
  double y = fit_.area.bottom - 9.0;
  if (!view_.note.empty()) {
    canvas_.text("quiet", {fit_.area.left + 8.0, y}, typeset(view_.note));
    y -= 16.0;
  }
  if (view_.is_scaled) scale_bar(canvas_, {fit_.area.left + 8.0, y - 4.0}, fit_.scale, length_text);
}

void ViewPicture::drawn() {
  draw_areas();
  draw_circles();
  draw_paths();
  draw_surfaces();
  draw_frame();
  for (const auto& support : view_.supports) draw_support(support);
  for (const auto& turn : view_.turns) draw_turn(turn);
  draw_forces();
  draw_lengths();
  for (const auto& radius : view_.radii) draw_radius(radius);
  for (const auto& angle : view_.angles) draw_angle(angle);
  name_turns();
  name_forces();
  for (const auto& pressure : view_.pressures) draw_pressure(pressure);
  draw_names();
  draw_words();
}

std::string description(const figure::Drawing::View& view) {
  std::string text = view.title;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  };
  const auto text_of = [](const figure::Drawing::Value& value) { return plain(words_of(value)); };
  for (const auto& area : view.areas) add(plain(area.name));
  for (const auto& length : view.lengths) add(text_of(length.value));
  for (const auto& radius : view.radii) add(text_of(radius.value));
  for (const auto& angle : view.angles) add(text_of(angle.value));
  for (const auto& force : view.forces) add(say("force {1}", text_of(force.value)).text());
  for (const auto& turn : view.turns) {
    const std::string way = say(turn.counter_clockwise ? "turns counter-clockwise" : "turns clockwise").text();
    add(turn.value ? text_of(*turn.value) + ", " + way : way);
  }
  for (const auto& pressure : view.pressures) add(say("pressure {1}", text_of(pressure.value)).text());
  for (const auto& name : view.names)
    add(plain(name.words) + (name.value ? (name.words.empty() ? "" : ": ") + text_of(*name.value) : std::string()));
  add(plain(view.note));
  return text;
}

Picture picture(const figure::Drawn& drawing) {
  Picture out;
  double left = 0.0, row_end = 0.0;
  for (const figure::Drawing::View& given : drawing->views) {
    const figure::Drawing::View view = without_gaps(given);
    const double wide = view_width * std::clamp(view.share, 0.2, 1.0);
    if (left + wide > view_width + 0.5) left = 0.0, out.height = row_end;
    const ViewFit placed = fit(view, {left, out.height}, wide);
    ViewPicture(view, placed, out.canvas).drawn();
    row_end = std::max(row_end, placed.area.bottom);
    left += wide;
    out.description += (out.description.empty() ? "" : ". ") + description(view);
  }
  out.height = std::max(row_end, 20.0);
  return out;
}

}  // namespace loadpath::draw
