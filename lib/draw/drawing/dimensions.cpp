// Dimension lines, angles, forces and names of a view.
#include "lib/draw/canvas/typeset.hpp"
#include "lib/draw/drawing/view.hpp"
#include "lib/draw/scheme/parts.hpp"

#include <numbers>

namespace loadpath::draw {
namespace {

constexpr double head = 7.0;
constexpr double overshoot = 3.5;  // overhang of an extension line beyond its dimension line
constexpr double clear = 3.0;      // between the part and its extension line

constexpr double shift = 7.0;  // offset of an arrow from its reference line

Point turned_to(double angle) { return {std::cos(angle), -std::sin(angle)}; }

Text text_of(const figure::Drawing::Value& value) { return typeset(words_of(value)); }

}  // namespace

void ViewPicture::headed(Point from, Point to) {
  const Point e = unit(to - from);
  const bool from_outside = length(to - from) < short_dimension;
  const double lead = from_outside ? short_lead : 0.0;
  if (from_outside) {
    canvas_.line("thin", from - lead * e, to + lead * e);
    arrow_head(canvas_, "solid", from, e, head);
    arrow_head(canvas_, "solid", to, -1.0 * e, head);
  } else {
    canvas_.line("thin", from, to);
    arrow_head(canvas_, "solid", from, -1.0 * e, head);
    arrow_head(canvas_, "solid", to, e, head);
  }
  labels_.keep_off({from - lead * e, to + lead * e}, 3.0);
}

/// A dimension line above or below the parts.
void ViewPicture::draw_level(const Row& row, Point from, Point to, double y, bool above) {
  const double side = above ? -1.0 : 1.0;
  for (const Point p : {from, to}) {
    const Point start{p.x, p.y + side * clear}, end{p.x, y + side * overshoot};
    canvas_.line("light", start, end);
    labels_.keep_off({start, end}, 1.0, 0.9);
  }
  headed({from.x, y}, {to.x, y});
  const Text text = text_of(view_.lengths[row.length].value);
  const double half = 0.5 * width(text, text_size), beyond = row.narrow && !above ? 12.0 : -8.0;
  const double middle = std::clamp(0.5 * (from.x + to.x), fit_.words.left + half, fit_.words.right - half);
  fixed_texts_.push_back({{middle, y + beyond}, text, false});
}

/// One on the left or the right of them.
void ViewPicture::draw_upright(const Row& row, Point from, Point to, double x, bool left) {
  const double side = left ? -1.0 : 1.0;
  for (const Point p : {from, to}) {
    const Point start{p.x + side * clear, p.y}, end{x + side * overshoot, p.y};
    canvas_.line("light", start, end);
    labels_.keep_off({start, end}, 1.0, 0.9);
  }
  headed({x, from.y}, {x, to.y});
  const Text text = text_of(view_.lengths[row.length].value);
  const double half = 0.5 * width(text, text_size), beyond = row.narrow && !left ? 12.0 : -8.0;
  const double middle = std::clamp(0.5 * (from.y + to.y), fit_.words.top + half, fit_.words.bottom - half);
  fixed_texts_.push_back({{x + beyond, middle}, text, true});
}

void ViewPicture::draw_row(const Row& row) {
  const auto& l = view_.lengths[row.length];
  const Point from = at(l.from), to = at(l.to);
  const double out = first_row + dimension_row * static_cast<double>(row.row);
  switch (l.side) {
    case figure::Drawing::Side::below:
      return draw_level(row, from, to, fit_.extent.bottom + out, false);
    case figure::Drawing::Side::above:
      return draw_level(row, from, to, fit_.extent.top - out, true);
    case figure::Drawing::Side::left:
      return draw_upright(row, from, to, fit_.extent.left - out, true);
    case figure::Drawing::Side::right:
      return draw_upright(row, from, to, fit_.extent.right + out, false);
    case figure::Drawing::Side::in_place:
      return;
  }
}

void ViewPicture::draw_in_place(const figure::Drawing::Length& l) {
  const Point from = at(l.from), to = at(l.to);
  const Text text = text_of(l.value);
  headed(from, to);
  free_text("halo", along_segment(from, to, 3.0, width(text, 1.05 * text_size)), text);
}

void ViewPicture::draw_lengths() {
  for (const Row& row : fit_.rows) draw_row(row);
  // Over the extension lines of dimensions farther out.
  for (const Fixed& fixed : fixed_texts_) fixed_text(fixed.centre, fixed.text, fixed.turned);
  for (const auto& l : view_.lengths) {
    if (l.side == figure::Drawing::Side::in_place) draw_in_place(l);
  }
}

void ViewPicture::draw_radius(const figure::Drawing::Radius& radius) {
  constexpr double reach = 16.0;
  const Point centre = at(radius.centre), e = turned_to(radius.angle);
  const double r = fit_.scale * radius.radius;
  const Point tip = centre + r * e, start = radius.diameter ? centre - r * e : centre;
  const Text text = text_of(radius.value);
  const double wide = width(text, 1.05 * text_size);
  if (length(tip - start) < 30.0) {  // from the outside, the text at the end of its leader
    const Point end = tip + reach * e;
    canvas_.line("thin", end, tip);
    arrow_head(canvas_, "solid", tip, -1.0 * e, head);
    labels_.keep_off({tip, end}, 2.0);
    return free_text("halo", around(end, 2.0, wide), text);
  }
  canvas_.line("thin", start, tip);
  arrow_head(canvas_, "solid", tip, e, head);
  if (radius.diameter) arrow_head(canvas_, "solid", start, -1.0 * e, head);
  labels_.keep_off({start, tip}, 2.0);
  std::vector<Candidate> places = along_segment(start, tip, 3.0, wide);
  for (Candidate& c : around(tip, 6.0, wide)) places.push_back({c.box, 8.0 + c.cost});
  free_text("halo", places, text);
}

void ViewPicture::draw_angle(const figure::Drawing::Angle& angle) {
  const Point corner = at(angle.corner);
  const double r = std::max(fit_.scale * angle.radius, 12.0), sweep = angle.sweep;
  const double end = angle.start + sweep;
  if (angle.legs) {
    canvas_.strokes("light", {{corner, corner + (r + 6.0) * turned_to(angle.start)},
                              {corner, corner + (r + 6.0) * turned_to(end)}});
  }
  canvas_.arc("thin", corner, r, angle.start, sweep);
  const double lead_angle = std::min(head / r, 0.5 * std::fabs(sweep)), side = sweep > 0.0 ? 1.0 : -1.0;
  if (r * std::fabs(sweep) > 3.0 * head) {
    for (const bool at_end : {false, true}) {
      const double tip = at_end ? end : angle.start, back = tip + (at_end ? -1.0 : 1.0) * side * lead_angle;
      const Point p = corner + r * turned_to(tip);
      arrow_head(canvas_, "solid", p, unit(p - (corner + r * turned_to(back))), head);
    }
  }
  std::vector<Point> arc;
  for (int i = 0; i <= 16; ++i) arc.push_back(corner + r * turned_to(angle.start + sweep * i / 16.0));
  labels_.keep_off(arc, 2.0);
  const Text text = text_of(angle.value);
  const double wide = width(text, 1.05 * text_size);
  std::vector<Candidate> places;
  for (const double share : {0.5, 0.4, 0.6, 0.25, 0.75}) {
    const double to = angle.start + share * sweep;
    for (const Candidate& c : around(corner + r * turned_to(to), 3.0, wide))
      places.push_back({c.box, c.cost + 10.0 * std::fabs(share - 0.5)});
  }
  free_text("halo", places, text);
}

std::pair<Point, Point> ViewPicture::placed(const figure::Drawing::Force& f) const {
  const Point way = fit_.newton * Point{f.force.x, -f.force.y};
  const Point start = at(f.at) + shift * f.offset * across(unit(way));
  return f.towards ? std::pair{start - way, start} : std::pair{start, start + way};
}

void ViewPicture::draw_forces() {
  for (const auto& f : view_.forces) {
    const auto [from, to] = placed(f);
    arrow(canvas_, f.load ? 1 : 0, from, to);
    labels_.keep_off({from, to}, 3.5);
  }
}

void ViewPicture::name_forces() {
  constexpr double far_from_arrow = 30.0;
  for (const auto& f : view_.forces) {
    const auto [from, to] = placed(f);
    const Text text = text_of(f.value);
    const double wide = width(text, 1.05 * text_size);
    const Point end = f.towards ? from : to;  // the one that is free
    std::vector<Candidate> places = around(end, 4.0, wide);
    for (const Candidate& c : along_segment(from, to, 5.0, wide)) places.push_back({c.box, 1.0 + c.cost});
    for (const double far : {44.0, 62.0}) {
      for (const Candidate& c : around(end, far, wide)) places.push_back({c.box, 8.0 + c.cost});
    }
    const Box box = labels_.place(places);
    canvas_.centred_text(f.load ? "halo f1" : "halo f0", box, text);
    const Point edge{std::clamp(end.x, box.left, box.right), std::clamp(end.y, box.top, box.bottom)};
    if (length(edge - end) > far_from_arrow && length(edge - 0.5 * (from + to)) > far_from_arrow)
      canvas_.line("light", end, edge);  // short arrows have no room next to them
  }
}

/// An arc of a third of a turn with a head at its end.
void ViewPicture::draw_turn(const figure::Drawing::Turn& turn) {
  const double r = std::max(fit_.scale * turn.radius, 8.0), side = turn.counter_clockwise ? 1.0 : -1.0;
  const double sweep = side * std::clamp(46.0 / r, 0.5, 2.2), start = turn.around - 0.5 * sweep, end = start + sweep;
  const Point centre = at(turn.centre);
  canvas_.arc("outline", centre, r, start, sweep - 0.6 * side * 9.0 / r);
  const Point tip = centre + r * turned_to(end), back = centre + r * turned_to(end - side * 9.0 / r);
  arrow_head(canvas_, "solid", tip, unit(tip - back), 9.0);
  std::vector<Point> arc;
  for (int i = 0; i <= 12; ++i) arc.push_back(centre + r * turned_to(start + sweep * i / 12.0));
  labels_.keep_off(arc, 3.5);
}

void ViewPicture::name_turns() {
  for (const auto& turn : view_.turns) {
    if (!turn.value) continue;
    const Point middle = at(turn.centre) + std::max(fit_.scale * turn.radius, 8.0) * turned_to(turn.around);
    const Text text = text_of(*turn.value);
    free_text("halo", around(middle, 4.0, width(text, 1.05 * text_size)), text);
  }
}

void ViewPicture::draw_pressure(const figure::Drawing::Pressure& pressure) {
  constexpr double reach = 13.0, size = 5.0;
  std::vector<std::pair<Point, Point>> shafts;
  for (const auto& a : pressure.arrows) {
    const Point tip = at(a.foot), way = unit(Point{a.direction.x, -a.direction.y});
    if (!is_in_window(tip)) continue;
    shafts.emplace_back(tip - reach * way, tip - size * way);
    arrow_head(canvas_, "f1", tip - 1.0 * way, way, size);
    labels_.keep_off({tip - reach * way, tip}, 1.0, 0.4);
  }
  canvas_.strokes("thin c1", shafts);
  const Text text = text_of(pressure.value);
  free_text("halo f1", around(at(pressure.label), 0.0, width(text, 1.05 * text_size)), text);
}

void ViewPicture::draw_names() {
  for (const auto& name : view_.names) {
    if (!name.dot) continue;
    canvas_.circle("solid", at(name.at), 2.6);
    labels_.keep_off(Box::around(at(name.at), 6.0, 6.0));
  }
  for (const auto& name : view_.names) {
    Text text = typeset(name.words);
    if (name.value) {
      const Text value = text_of(*name.value);
      if (!text.empty()) text.push_back({", "});
      text.insert(text.end(), value.begin(), value.end());
    }
    if (text.empty()) continue;
    const double gap = name.dot ? 5.0 : 0.0;
    free_text("halo", around(at(name.at), gap, width(text, 1.05 * text_size)), text);
  }
}

}  // namespace loadpath::draw
