#include "lib/draw/shaft.hpp"

#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/canvas/rows.hpp"
#include "lib/draw/diagrams.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/side/description.hpp"
#include "lib/draw/side/end_view.hpp"
#include "lib/draw/side/outlines.hpp"
#include "lib/draw/side/shaft_parts.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::draw {
namespace {

using namespace shaft;

class ShaftPicture {
 public:
  ShaftPicture(const figure::Shaft& shaft, bool has_outlines);
  Picture drawn();

 private:
  void place_cylinders();
  void place_outlines();
  void place_torques(const figure::Shaft& shaft);
  void place_labels_above(Rows& rows);
  void place_bearings(const figure::Shaft& shaft);
  void draw_cylinders();
  void draw_bores();
  void draw_diameter(const Cylinder& c);
  void draw_raised(const RaisedSign& sign);
  void draw_torque(const TorqueSign& sign);
  void draw_leader(const TorqueSign& sign);
  void draw_bearing(const BearingSign& sign);
  void draw_lengths();
  void draw_length(double left, double right, double y);
  void draw_note();
  void draw_place(const figure::Shaft::Place& place);
  [[nodiscard]] double at(double x) const { return 0.5 * (left_ + right_) + scale_ * (x - 0.5 * length_); }
  [[nodiscard]] double radius_at(double x) const;
  /// The base line of a row of labels above the shaft.
  [[nodiscard]] double row_above(std::size_t row) const;
  /// Its name, and its reaction below.
  [[nodiscard]] double lines_of_bearing() const;
  /// The extent of the symbols below the thickest part.
  [[nodiscard]] double reach_below() const;

  const figure::Shaft& shaft_;
  bool has_outlines_;
  std::vector<Cylinder> cylinders_;
  std::vector<TorqueSign> torques_;
  std::vector<RaisedSign> raised_;
  std::vector<BearingSign> bearings_;
  double length_ = 0.0, thickest_ = 0.0;  // m
  double left_ = shaft_left, right_ = shaft_right, scale_ = 1.0, radial_scale_ = 1.0;
  double words_right_ = view_width;  // right edge of its labels
  double radius_ = 0.0, axis_ = 0.0, height_ = 60.0;
  double reach_ = 0.0;         // radius of the largest outline
  double bearing_rows_ = 0.0;  // rows of their labels
  Outlines outlines_;
  Canvas canvas_;
};

ShaftPicture::ShaftPicture(const figure::Shaft& shaft, bool has_outlines) : shaft_(shaft), has_outlines_(has_outlines) {
  for (const auto& part : shaft.parts) {
    const bool real = drawable(part.length) && drawable(part.diameter) && part.length > 1e-9 && part.diameter > 1e-9 &&
                      drawable(part.right);
    if (!real) continue;
    cylinders_.push_back({&part, length_, length_ + part.length, 0.0, 0.0, 0.0});
    length_ += part.length;
    thickest_ = std::max({thickest_, part.diameter, part.right_diameter()});
  }
  if (cylinders_.empty()) return;
  if (has_end_view(shaft)) words_right_ = end_view_left;
  place_cylinders();
  place_outlines();
  Rows rows;
  place_torques(shaft);
  place_labels_above(rows);
  const double signs = torques_.empty() ? 10.0 : torque_reach + 2.0 * torque_radius + 2.0;
  axis_ = rows.height() + signs + 2.0 + reach_;
  if (has_end_view(shaft)) axis_ = std::max(axis_, end_view_reach + row_height);
  place_bearings(shaft);
}

/// True to scale where that gives a readable drawing; a slender shaft is drawn thicker, a disc longer. Above diagrams
/// it is as long as they are.
void ShaftPicture::place_cylinders() {
  if (!shaft_.diagrams.empty()) left_ = diagrams_left, right_ = diagrams_right;
  const double longest = right_ - left_;
  scale_ = longest / length_;
  if (shaft_.diagrams.empty()) {
    const double most = std::min(most_depth / thickest_, most_outline / std::max(thickest_, largest_bearing(shaft_)));
    scale_ = std::min(scale_, std::max(most, least_length / length_));
  }
  radius_ = 0.5 * std::clamp(scale_ * thickest_, least_depth, most_depth);
  radial_scale_ = 2.0 * radius_ / thickest_;
  for (Cylinder& c : cylinders_) {
    c.left = at(c.left), c.right = at(c.right);
    c.radius = 0.5 * radial_scale_ * c.part->diameter;
    c.right_radius = 0.5 * radial_scale_ * c.part->right_diameter();
    c.bore = drawable(c.part->bore) ? 0.5 * radial_scale_ * std::clamp(c.part->bore, 0.0, c.part->diameter) : 0.0;
  }
}

void ShaftPicture::place_outlines() {
  reach_ = radius_;
  if (!has_outlines_) return;
  const auto place = [&](const figure::Shaft::Outline& outline, bool is_bearing) {
    const double width = scale_ * outline.width, x = at(std::clamp(outline.x, 0.0, length_));
    if (!drawable(width) || !drawable(outline.diameter) || !(outline.width > 0.0)) return;
    const double left = x - 0.5 * width, right = x + 0.5 * width;
    outlines_.add({left, right, radius_at(left), radius_at(right), 0.5 * radial_scale_ * outline.diameter, is_bearing});
  };
  for (const auto& torque : shaft_.torques) place(torque.outline, false);
  for (const auto& bearing : shaft_.bearings) place(bearing.outline, true);
  reach_ = std::max(reach_, outlines_.reach());
}

void ShaftPicture::place_torques(const figure::Shaft& shaft) {
  for (const auto& torque : shaft.torques) {
    if (!drawable(torque.x) || !drawable(torque.value) || (torque.value == 0.0 && !acts(torque.force))) continue;
    const Text text = typeset(labelled(torque.label, load_words(torque)));
    const double half = 0.5 * width(text, text_size);
    const double x = at(std::clamp(torque.x, 0.0, length_));
    torques_.push_back({&torque, text, x, half, 0});
  }
}

/// In the rows next to the shaft, off the signs of torques, whose labels come above: no leader crosses them.
void ShaftPicture::place_labels_above(Rows& rows) {
  constexpr double off_sign = torque_radius + 3.0;
  for (const Cylinder& c : cylinders_) {
    if (fits_along(c) || fits_upright(c)) continue;
    Text text = diameter_label(c);
    if (c.bore > 0.0) text.push_back({say(", bore {1}", diameter_text(c.part->bore)).text(), Run::Face::words});
    const double half = 0.5 * width(text, text_size), middle = 0.5 * (c.left + c.right);
    double x = middle;
    for (const TorqueSign& sign : torques_) {
      if (sign.torque->value != 0.0 && std::fabs(x - sign.x) < off_sign)
        x = sign.x + (x < sign.x ? -off_sign : off_sign);
    }
    const double centre = std::clamp(x, half + 4.0, words_right_ - half - 4.0);
    raised_.push_back({&c, text, centre, rows.row_of(centre - half - 5.0, centre + half + 5.0)});
  }
  for (TorqueSign& sign : torques_) {
    const double centre = std::clamp(sign.x, sign.half_width + 4.0, words_right_ - sign.half_width - 4.0);
    sign.row = rows.row_of(centre - sign.half_width - 5.0, centre + sign.half_width + 5.0);
  }
}

double ShaftPicture::row_above(std::size_t row) const {
  const double signs = torques_.empty() ? 8.0 : torque_reach + 2.0 * torque_radius;
  return axis_ - reach_ - signs - row_height * static_cast<double>(row);
}

void ShaftPicture::place_bearings(const figure::Shaft& shaft) {
  Rows rows;
  for (const auto& bearing : shaft.bearings) {
    if (!drawable(bearing.x)) continue;
    BearingSign sign{&bearing, typeset(bearing_words(bearing)), {}, at(std::clamp(bearing.x, 0.0, length_)), 0.0, 0};
    if (acts(bearing.force)) sign.reaction = typeset(reaction_words(bearing));
    const double half = 0.5 * std::max(width(sign.text, text_size), width(sign.reaction, text_size));
    sign.middle = std::clamp(sign.x, half + 4.0, words_right_ - half - 4.0);
    sign.row = rows.row_of(sign.middle - half - 5.0, sign.middle + half + 5.0);
    bearings_.push_back(std::move(sign));
  }
  bearing_rows_ = rows.height() / row_height;
}

double ShaftPicture::lines_of_bearing() const {
  const auto is_loaded = [](const BearingSign& sign) { return !sign.reaction.empty(); };
  return std::any_of(bearings_.begin(), bearings_.end(), is_loaded) ? 2.0 : 1.0;
}

double ShaftPicture::reach_below() const {
  const double torques = torques_.empty() ? 0.0 : torque_reach + torque_radius;
  return std::max(torques, bearings_.empty() ? 0.0 : support_depth + lines_of_bearing() * bearing_rows_ * row_height);
}

double ShaftPicture::radius_at(double x) const {
  double radius = 0.0;
  for (const Cylinder& c : cylinders_) {
    if (x >= c.left - 0.01 && x <= c.right + 0.01) radius = std::max(radius, c.radius_at(x));
  }
  return radius;
}

void ShaftPicture::draw_cylinders() {
  for (const Cylinder& c : cylinders_) {
    if (c.tapers()) {
      canvas_.polygon("plate outline", {{c.left, axis_ - c.radius},
                                        {c.right, axis_ - c.right_radius},
                                        {c.right, axis_ + c.right_radius},
                                        {c.left, axis_ + c.radius}});
    } else {
      canvas_.rectangle("plate outline", {c.left, axis_ - c.radius, c.right, axis_ + c.radius});
    }
  }
  canvas_.line("centre", {cylinders_.front().left - 14.0, axis_}, {cylinders_.back().right + 14.0, axis_});
}

void ShaftPicture::draw_bores() {
  std::vector<std::pair<Point, Point>> hidden;
  double before = cylinders_.front().bore;
  for (const Cylinder& c : cylinders_) {
    for (const double side : {-1.0, 1.0}) {
      if (c.bore > 0.0) hidden.push_back({{c.left, axis_ + side * c.bore}, {c.right, axis_ + side * c.bore}});
      if (c.bore != before) hidden.push_back({{c.left, axis_ + side * before}, {c.left, axis_ + side * c.bore}});
    }
    before = c.bore;
  }
  canvas_.strokes("thin dash", hidden);
}

void ShaftPicture::draw_diameter(const Cylinder& c) {
  constexpr double head = 7.0, gap = 5.0;
  const bool lies = fits_along(c);
  if (!lies && !fits_upright(c)) return;
  const Text text = diameter_label(c);
  const std::string bore = diameter_text(c.part->bore);
  const double wide = width(text, text_size), middle = 0.5 * (c.left + c.right);
  const double x = lies ? middle - 0.5 * (wide + gap) : middle + 7.0;
  const double radius = c.radius_at(x);
  canvas_.line("thin", {x, axis_ - radius}, {x, axis_ + radius});
  arrow_head(canvas_, "solid", {x, axis_ - radius}, {0.0, -1.0}, head);
  arrow_head(canvas_, "solid", {x, axis_ + radius}, {0.0, 1.0}, head);
  if (!lies) {
    canvas_.text("", {x - 4.0, axis_ - 4.0}, text, Anchor::start, true);
    if (c.bore > 0.0) canvas_.text("quiet", {x - 4.0, axis_ + 4.0}, typeset(bore), Anchor::end, true);
    return;
  }
  constexpr double least_radius = 17.0;  // of a part that surrounds its text
  canvas_.text(radius < least_radius ? "halo" : "", {x + gap, axis_ - 5.0}, text);
  if (c.bore > 0.0) {
    const Text named = typeset(say("bore {1}", bore).text());
    const bool fits = x + gap + width(named, text_size) < c.right;
    canvas_.text("quiet", {x + gap, axis_ + 14.0}, fits ? named : typeset(bore));
  }
}

/// With a line to the surface of its part.
void ShaftPicture::draw_raised(const RaisedSign& sign) {
  const Cylinder& c = *sign.cylinder;
  const double middle = 0.5 * (c.left + c.right), y = row_above(sign.row);
  canvas_.polyline("thin", {{middle, axis_ - c.radius_at(middle)}, {sign.x, axis_ - reach_ - 4.0}, {sign.x, y + 4.0}});
  canvas_.text("halo", {sign.x, y}, sign.text, Anchor::middle);
}

/// The couple as the two forces that turn the shaft: out of the page (dot) and into it (cross).
void ShaftPicture::draw_torque(const TorqueSign& sign) {
  if (sign.torque->value == 0.0) return draw_leader(sign);
  const double surface = std::max(radius_at(sign.x), outlines_.radius_at(sign.x)), level = reach_ + torque_reach;
  const double dot_side = sign.torque->value > 0.0 ? -1.0 : 1.0;
  for (const double side : {-1.0, 1.0}) {
    const Point centre{sign.x, axis_ + side * level};
    canvas_.line("force c1", {sign.x, axis_ + side * surface}, {sign.x, centre.y - side * torque_radius});
    canvas_.circle("pin c1", centre, torque_radius);
    if (side == dot_side) {
      canvas_.circle("f1", centre, 2.4);
    } else {
      const double r = torque_radius * std::sqrt(0.5);
      const Point down{r, r}, up{r, -r};
      canvas_.strokes("outline c1", {{centre - down, centre + down}, {centre - up, centre + up}});
    }
  }
  const double middle = std::clamp(sign.x, sign.half_width + 4.0, words_right_ - sign.half_width - 4.0);
  canvas_.text("halo f1", {middle, row_above(sign.row)}, sign.text, Anchor::middle);
}

/// From a component without torque to its label.
void ShaftPicture::draw_leader(const TorqueSign& sign) {
  const double middle = std::clamp(sign.x, sign.half_width + 4.0, words_right_ - sign.half_width - 4.0);
  const double surface = std::max(radius_at(sign.x), outlines_.radius_at(sign.x)), y = row_above(sign.row);
  canvas_.line("thin c1", {sign.x, axis_ - surface}, {sign.x, y + 4.0});
  canvas_.text("halo f1", {middle, y}, sign.text, Anchor::middle);
}

/// A triangle on hatched ground; above a line on which it slides, if axial displacement is free.
void ShaftPicture::draw_bearing(const BearingSign& sign) {
  constexpr double depth = 15.0, half = 8.5, slide = 3.0;
  const Point foot{sign.x, axis_ + radius_at(sign.x)};
  if (is_outlined(*sign.bearing)) {
    canvas_.line("light", {sign.x, axis_ + outlines_.radius_at(sign.x)}, {sign.x, axis_ + reach_ + support_depth});
  } else if (sign.bearing->fixed) {
    support(canvas_, foot, {0.0, 1.0});
  } else {
    const Point left{foot.x - half, foot.y + depth}, right{foot.x + half, foot.y + depth}, down{0.0, slide};
    canvas_.polygon("pin", {foot, right, left});
    canvas_.line("outline", left + down, right + down);
  }
  const double row = lines_of_bearing() * static_cast<double>(sign.row);
  const double line = axis_ + reach_ + support_depth + (row + 1.0) * row_height - 4.0;
  canvas_.text("halo", {sign.middle, line}, sign.text, Anchor::middle);
  if (!sign.reaction.empty()) canvas_.text("halo f0", {sign.middle, line + row_height}, sign.reaction, Anchor::middle);
}

void ShaftPicture::draw_place(const figure::Shaft::Place& place) {
  constexpr double beyond = 5.0;
  const double x = at(std::clamp(place.x, 0.0, length_));
  const double reach = std::max(radius_at(x), outlines_.radius_at(x)) + beyond;
  canvas_.line("light dash c1", {x, axis_ - reach}, {x, axis_ + reach});
}

void ShaftPicture::draw_length(double left, double right, double y) {
  constexpr double head = 7.0;
  canvas_.line("thin", {left, y}, {right, y});
  if (right - left > 3.0 * head) {
    arrow_head(canvas_, "solid", {left, y}, {-1.0, 0.0}, head);
    arrow_head(canvas_, "solid", {right, y}, {1.0, 0.0}, head);
  } else {
    const Point stroke{3.0, -3.0};
    canvas_.strokes("thin", {{Point{left, y} - stroke, Point{left, y} + stroke},
                             {Point{right, y} - stroke, Point{right, y} + stroke}});
  }
}

void ShaftPicture::draw_lengths() {
  const double reach = reach_below();
  const double first = axis_ + reach_ + (reach > 0.0 ? reach + 26.0 : 28.0);
  Rows below;
  for (const Cylinder& c : cylinders_) {
    const Text text = typeset(millimetres(c.part->length));
    const double half = 0.5 * width(text, text_size), middle = 0.5 * (c.left + c.right);
    draw_length(c.left, c.right, first);
    const bool inside = c.right - c.left > 2.0 * half + 4.0;
    const double drop =
        inside ? -5.0 : 15.0 + row_height * static_cast<double>(below.row_of(middle - half - 4.0, middle + half + 4.0));
    canvas_.text("", {middle, first + drop}, text, Anchor::middle);
  }
  const double from = cylinders_.front().left, to = cylinders_.back().right;
  const bool several = cylinders_.size() > 1;
  const double last = several ? first + below.height() + 26.0 : first;
  if (several) {
    draw_length(from, to, last);
    canvas_.text("", {0.5 * (from + to), last - 5.0}, typeset(millimetres(length_)), Anchor::middle);
  }
  for (const Cylinder& c : cylinders_) {
    const double start = axis_ + (reach > 0.0 ? reach_ + reach : c.largest()) + 3.0;
    canvas_.line("light", {c.right, start}, {c.right, &c == &cylinders_.back() ? last + 4.0 : first + 4.0});
    if (&c == &cylinders_.front()) canvas_.line("light", {c.left, start}, {c.left, last + 4.0});
  }
  height_ = last + 14.0;
}

void ShaftPicture::draw_note() {
  const bool true_to_scale = std::fabs(radial_scale_ - scale_) < 1e-6 * scale_;
  const auto note = true_to_scale ? say("in mm") : say("in mm; diameters not to the scale of the lengths");
  canvas_.text("quiet", {words_right_ - 6.0, height_ + 8.0}, typeset(note.text()), Anchor::end);
  height_ += 16.0;
}

Picture ShaftPicture::drawn() {
  if (cylinders_.empty()) {
    canvas_.centred_text("quiet", {0.0, 0.0, view_width, height_}, typeset(say("not available").text()));
    return {std::move(canvas_), height_, say("not available").text()};
  }
  outlines_.draw(axis_, canvas_);
  draw_cylinders();
  draw_bores();
  for (const Cylinder& c : cylinders_) draw_diameter(c);
  for (const RaisedSign& sign : raised_) draw_raised(sign);
  for (const TorqueSign& sign : torques_) draw_torque(sign);
  for (const BearingSign& sign : bearings_) draw_bearing(sign);
  draw_lengths();
  draw_note();
  if (has_end_view(shaft_)) {
    canvas_.append(end_view(shaft_, axis_));
    height_ = std::max(height_, axis_ + end_view_reach + 1.5 * row_height);
    return {std::move(canvas_), height_, description(cylinders_, torques_, bearings_), end_view_right};
  }
  if (shaft_.diagrams.empty()) return {std::move(canvas_), height_, description(cylinders_, torques_, bearings_)};
  for (const figure::Shaft::Place& place : shaft_.places) draw_place(place);
  const Picture below = diagrams(shaft_, {at(0.0), at(length_)}, length_, height_ + 8.0);
  canvas_.append(below.canvas);
  return {std::move(canvas_), below.height, description(cylinders_, torques_, bearings_) + below.description};
}

}  // namespace

/// On a page it is as low as can be above its diagrams.
Picture picture(const figure::Shaft& shaft) { return ShaftPicture(shaft, shaft.diagrams.empty()).drawn(); }

Picture picture_in_file(const figure::Shaft& shaft) { return ShaftPicture(shaft, true).drawn(); }

}  // namespace loadpath::draw
