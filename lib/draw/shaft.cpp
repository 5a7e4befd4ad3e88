#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/canvas/rows.hpp"
#include "lib/draw/diagrams.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/shaft_parts.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::draw {
namespace {

using namespace shaft;

/// "T_1 = 900 N·m" of a symbol, "pulley: 900 N·m" of a component.
std::string labelled(const std::string& label, const std::string& value) {
  constexpr std::size_t longest_symbol = 2;
  if (label.empty()) return value;
  const bool is_symbol = std::min(label.find('_'), label.size()) <= longest_symbol;
  return say(is_symbol ? "{1} = {2}" : "{1}: {2}", symbol(label), value).text();
}

class ShaftPicture {
 public:
  explicit ShaftPicture(const figure::Shaft& shaft);
  Picture drawn();

 private:
  void place_cylinders();
  void place_torques(const figure::Shaft& shaft);
  void place_labels_above(Rows& rows);
  void place_bearings(const figure::Shaft& shaft);
  void draw_cylinders();
  void draw_bores();
  void draw_diameter(const Cylinder& c);
  void draw_raised(const RaisedSign& sign);
  void draw_torque(const TorqueSign& sign);
  void draw_bearing(const BearingSign& sign);
  void draw_lengths();
  void draw_length(double left, double right, double y);
  void draw_note();
  void draw_place(const figure::Shaft::Place& place);
  [[nodiscard]] double at(double x) const { return 0.5 * (left_ + right_) + scale_ * (x - 0.5 * length_); }
  [[nodiscard]] double radius_at(double x) const;
  /// The base line of a row of labels above the shaft.
  [[nodiscard]] double row_above(std::size_t row) const;
  /// The extent of the symbols below the thickest part.
  [[nodiscard]] double reach_below() const;
  [[nodiscard]] std::string description() const;

  const figure::Shaft& shaft_;
  std::vector<Cylinder> cylinders_;
  std::vector<TorqueSign> torques_;
  std::vector<RaisedSign> raised_;
  std::vector<BearingSign> bearings_;
  double length_ = 0.0, thickest_ = 0.0;  // m
  double left_ = shaft_left, right_ = shaft_right, scale_ = 1.0, radial_scale_ = 1.0;
  double radius_ = 0.0, axis_ = 0.0, height_ = 60.0;
  Canvas canvas_;
};

ShaftPicture::ShaftPicture(const figure::Shaft& shaft) : shaft_(shaft) {
  for (const auto& part : shaft.parts) {
    const bool real = drawable(part.length) && drawable(part.diameter) && part.length > 1e-9 && part.diameter > 1e-9 &&
                      drawable(part.right);
    if (!real) continue;
    cylinders_.push_back({&part, length_, length_ + part.length, 0.0, 0.0, 0.0});
    length_ += part.length;
    thickest_ = std::max({thickest_, part.diameter, part.right_diameter()});
  }
  if (cylinders_.empty()) return;
  place_cylinders();
  Rows rows;
  place_torques(shaft);
  place_labels_above(rows);
  const double signs = torques_.empty() ? 10.0 : torque_reach + 2.0 * torque_radius + 2.0;
  axis_ = rows.height() + signs + 2.0 + radius_;
  place_bearings(shaft);
}

/// True to scale where that gives a readable drawing; a slender shaft is drawn thicker, a disc longer. Above diagrams
/// it is as long as they are.
void ShaftPicture::place_cylinders() {
  if (!shaft_.diagrams.empty()) left_ = diagrams_left, right_ = diagrams_right;
  const double longest = right_ - left_;
  scale_ = longest / length_;
  if (shaft_.diagrams.empty()) scale_ = std::min(scale_, std::max(most_depth / thickest_, least_length / length_));
  radius_ = 0.5 * std::clamp(scale_ * thickest_, least_depth, most_depth);
  radial_scale_ = 2.0 * radius_ / thickest_;
  for (Cylinder& c : cylinders_) {
    c.left = at(c.left), c.right = at(c.right);
    c.radius = 0.5 * radial_scale_ * c.part->diameter;
    c.right_radius = 0.5 * radial_scale_ * c.part->right_diameter();
    c.bore = drawable(c.part->bore) ? 0.5 * radial_scale_ * std::clamp(c.part->bore, 0.0, c.part->diameter) : 0.0;
  }
}

void ShaftPicture::place_torques(const figure::Shaft& shaft) {
  for (const auto& torque : shaft.torques) {
    if (!drawable(torque.x) || !drawable(torque.value) || torque.value == 0.0) continue;
    const std::string value = with_minus(format_quantity(torque.value, "N*m", 4));
    std::string words = labelled(torque.label, value);
    if (acts(torque.force)) words = say("{1}, {2}", words, format_quantity(torque.force, "N", 4)).text();
    const Text text = typeset(words);
    const double half = 0.5 * width(text, text_size);
    const double x = at(std::clamp(torque.x, 0.0, length_));
    torques_.push_back({&torque, text, x, half, 0});
  }
}

/// In the rows next to the shaft, off the signs of torques, whose labels come above: no leader crosses them.
void ShaftPicture::place_labels_above(Rows& rows) {
  constexpr double off_sign = torque_radius + 3.0;
  for (const Cylinder& c : cylinders_) {
    if (lies_inside(c) || stands_inside(c)) continue;
    Text text = diameter_label(c);
    if (c.bore > 0.0) text.push_back({say(", bore {1}", diameter_text(c.part->bore)).text(), Run::Face::words});
    const double half = 0.5 * width(text, text_size), middle = 0.5 * (c.left + c.right);
    double x = middle;
    for (const TorqueSign& sign : torques_) {
      if (std::fabs(x - sign.x) < off_sign) x = sign.x + (x < sign.x ? -off_sign : off_sign);
    }
    const double centre = std::clamp(x, half + 4.0, view_width - half - 4.0);
    raised_.push_back({&c, text, centre, rows.row_of(centre - half - 5.0, centre + half + 5.0)});
  }
  for (TorqueSign& sign : torques_) {
    const double centre = std::clamp(sign.x, sign.half_width + 4.0, view_width - sign.half_width - 4.0);
    sign.row = rows.row_of(centre - sign.half_width - 5.0, centre + sign.half_width + 5.0);
  }
}

double ShaftPicture::row_above(std::size_t row) const {
  const double signs = torques_.empty() ? 8.0 : torque_reach + 2.0 * torque_radius;
  return axis_ - radius_ - signs - row_height * static_cast<double>(row);
}

void ShaftPicture::place_bearings(const figure::Shaft& shaft) {
  for (const auto& bearing : shaft.bearings) {
    if (drawable(bearing.x))
      bearings_.push_back({&bearing, typeset(bearing.label), at(std::clamp(bearing.x, 0.0, length_))});
  }
}

double ShaftPicture::reach_below() const {
  const double torques = torques_.empty() ? 0.0 : torque_reach + torque_radius;
  const bool has_force = std::any_of(bearings_.begin(), bearings_.end(),
                                     [](const BearingSign& sign) { return acts(sign.bearing->force); });
  const double rows = has_force ? 2.0 : 1.0;
  return std::max(torques, bearings_.empty() ? 0.0 : support_depth + rows * row_height);
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
  const bool lies = lies_inside(c);
  if (!lies && !stands_inside(c)) return;
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
  canvas_.polyline("thin", {{middle, axis_ - c.radius_at(middle)}, {sign.x, axis_ - radius_ - 4.0}, {sign.x, y + 4.0}});
  canvas_.text("halo", {sign.x, y}, sign.text, Anchor::middle);
}

/// The couple as the two forces that turn the shaft: out of the page (dot) and into it (cross).
void ShaftPicture::draw_torque(const TorqueSign& sign) {
  const double surface = radius_at(sign.x), level = radius_ + torque_reach;
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
  const double middle = std::clamp(sign.x, sign.half_width + 4.0, view_width - sign.half_width - 4.0);
  canvas_.text("halo f1", {middle, row_above(sign.row)}, sign.text, Anchor::middle);
}

/// A triangle on hatched ground; above a line on which it slides, if axial displacement is free.
void ShaftPicture::draw_bearing(const BearingSign& sign) {
  constexpr double depth = 15.0, half = 8.5, slide = 3.0;
  const Point foot{sign.x, axis_ + radius_at(sign.x)};
  if (sign.bearing->fixed) {
    support(canvas_, foot, {0.0, 1.0});
  } else {
    const Point left{foot.x - half, foot.y + depth}, right{foot.x + half, foot.y + depth}, down{0.0, slide};
    canvas_.polygon("pin", {foot, right, left});
    canvas_.line("outline", left + down, right + down);
  }
  const double half_text = 0.5 * width(sign.text, text_size);
  const double middle = std::clamp(sign.x, half_text + 4.0, view_width - half_text - 4.0);
  const double line = axis_ + radius_ + support_depth + row_height - 4.0;
  canvas_.text("halo", {middle, line}, sign.text, Anchor::middle);
  if (acts(sign.bearing->force))
    canvas_.text("halo f0", {middle, line + row_height}, typeset(format_quantity(sign.bearing->force, "N", 4)),
                 Anchor::middle);
}

void ShaftPicture::draw_place(const figure::Shaft::Place& place) {
  constexpr double beyond = 5.0;
  const double x = at(std::clamp(place.x, 0.0, length_)), reach = radius_at(x) + beyond;
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
  const double first = axis_ + radius_ + (reach > 0.0 ? reach + 26.0 : 28.0);
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
    const double start = axis_ + (reach > 0.0 ? radius_ + reach : c.largest()) + 3.0;
    canvas_.line("light", {c.right, start}, {c.right, &c == &cylinders_.back() ? last + 4.0 : first + 4.0});
    if (&c == &cylinders_.front()) canvas_.line("light", {c.left, start}, {c.left, last + 4.0});
  }
  height_ = last + 14.0;
}

void ShaftPicture::draw_note() {
  const bool true_to_scale = std::fabs(radial_scale_ - scale_) < 1e-6 * scale_;
  const auto note = true_to_scale ? say("in mm") : say("in mm; diameters not to the scale of the lengths");
  canvas_.text("quiet", {view_width - 6.0, height_ + 8.0}, typeset(note.text()), Anchor::end);
  height_ += 16.0;
}

std::string ShaftPicture::description() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const Cylinder& c : cylinders_) {
    const std::string length = format_quantity(c.part->length, "mm", 5), d = diameters(*c.part);
    add(c.bore > 0.0
            ? say("length {1}, diameter {2}, bore {3}", length, d, format_quantity(c.part->bore, "mm", 5)).text()
            : say("length {1}, diameter {2}", length, d).text());
  }
  for (const TorqueSign& sign : torques_) {
    add(say("torque {1} = {2} at {3}", plain(sign.torque->label), format_quantity(sign.torque->value, "N*m", 4),
            format_quantity(sign.torque->x, "mm", 5))
            .text());
  }
  for (const BearingSign& sign : bearings_) {
    const Message place =
        say("bearing {1} at {2}", plain(sign.bearing->label), format_quantity(sign.bearing->x, "mm", 5));
    const double force = sign.bearing->force;
    add(acts(force) ? say("{1}: {2}", place, format_quantity(force, "N", 4)).text() : place.text());
  }
  return text;
}

Picture ShaftPicture::drawn() {
  if (cylinders_.empty()) {
    canvas_.centred_text("quiet", {0.0, 0.0, view_width, height_}, typeset(say("not available").text()));
    return {std::move(canvas_), height_, say("not available").text()};
  }
  draw_cylinders();
  draw_bores();
  for (const Cylinder& c : cylinders_) draw_diameter(c);
  for (const RaisedSign& sign : raised_) draw_raised(sign);
  for (const TorqueSign& sign : torques_) draw_torque(sign);
  for (const BearingSign& sign : bearings_) draw_bearing(sign);
  draw_lengths();
  draw_note();
  if (shaft_.diagrams.empty()) return {std::move(canvas_), height_, description()};
  for (const figure::Shaft::Place& place : shaft_.places) draw_place(place);
  const Picture below = diagrams(shaft_, {at(0.0), at(length_)}, length_, height_ + 8.0);
  canvas_.append(below.canvas);
  return {std::move(canvas_), below.height, description() + below.description};
}

}  // namespace

Picture picture(const figure::Shaft& shaft) { return ShaftPicture(shaft).drawn(); }

}  // namespace loadpath::draw
