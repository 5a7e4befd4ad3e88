#include "lib/draw/side/end_view.hpp"

#include "lib/draw/canvas/labels.hpp"
#include "lib/draw/canvas/typeset.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/side/shaft_parts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace loadpath::draw {
namespace {

struct Transverse {
  Point force;
  std::string name;
  bool is_load;
};

double magnitude(Point p) { return std::hypot(p.x, p.y); }

/// What is small compared with the largest would be an arrow without length.
std::vector<Transverse> transverse_forces(const figure::Shaft& shaft) {
  constexpr double least_share = 0.04;
  std::vector<Transverse> all;
  for (const auto& torque : shaft.torques) all.push_back({torque.across, torque.label, true});
  for (const auto& bearing : shaft.bearings) all.push_back({bearing.across, bearing.label, false});
  double largest = 0.0;
  for (const Transverse& one : all) {
    if (drawable(one.force)) largest = std::max(largest, magnitude(one.force));
  }
  std::erase_if(all, [&](const Transverse& one) {
    return !drawable(one.force) || !(magnitude(one.force) > least_share * largest);
  });
  return all;
}

class EndView {
 public:
  EndView(const figure::Shaft& shaft, double axis)
      : forces_(transverse_forces(shaft)),
        centre_{0.5 * (end_view_left + end_view_right), axis},
        labels_({end_view_left + 4.0, axis - end_view_reach, end_view_right - 2.0, axis + end_view_reach}) {}

  Canvas drawn() {
    draw_axes();
    double largest = 0.0;
    for (const Transverse& one : forces_) largest = std::max(largest, magnitude(one.force));
    std::vector<Point> tips;
    for (const Transverse& one : forces_) {
      const double scale = longest / largest;
      tips.push_back(centre_ + Point{scale * one.force.x, -scale * one.force.y});
      labels_.keep_off({centre_, tips.back()}, 2.0);
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) draw_force(forces_[i], tips[i]);
    canvas_.text("quiet", {centre_.x, centre_.y + end_view_reach + 20.0},
                 typeset(say("seen from the right end").text()), Anchor::middle);
    return std::move(canvas_);
  }

 private:
  static constexpr double longest = 52.0, of_shaft = 8.0;

  /// At the lower left, off the arrows.
  void draw_axes() {
    constexpr double margin = 14.0, reach = 18.0;
    canvas_.circle("plate outline", centre_, of_shaft);
    labels_.keep_off(Box::around(centre_, 2.0 * of_shaft, 2.0 * of_shaft));
    const Point corner{end_view_left + margin, centre_.y + end_view_reach - 2.0};
    const Point right = corner + Point{reach, 0.0}, up = corner - Point{0.0, reach};
    canvas_.strokes("light", {{corner, right}, {corner, up}});
    canvas_.text("quiet", right + Point{6.0, 4.0}, typeset("X"), Anchor::middle);
    canvas_.text("quiet", up - Point{0.0, 3.0}, typeset("Y"), Anchor::middle);
    constexpr double letters = 12.0;
    labels_.keep_off(Box{corner.x - letters, up.y - letters, right.x + letters, corner.y + letters});
  }

  /// A reaction is dashed: in grey print its colour is that of a load.
  void draw_arrow(bool is_load, Point tip) {
    if (is_load) return arrow(canvas_, 1, centre_, tip);
    constexpr double head = 10.0;
    const Point way = tip - centre_;
    const double longer = std::max(length(way), 1e-6), size = std::min(head, 0.7 * longer);
    canvas_.line("force dash c0", centre_, tip - (0.8 * size / longer) * way);
    arrow_head(canvas_, "f0", tip, (1.0 / longer) * way, size);
  }

  /// Its name, and the value below.
  void draw_force(const Transverse& one, Point tip) {
    constexpr double gap = 5.0, of_line = 14.0, base = 11.0;
    draw_arrow(one.is_load, tip);
    const Text name = typeset(one.name), value = typeset(format_quantity(magnitude(one.force), "N", 4));
    const double wide = std::max(width(name, text_size), width(value, text_size));
    const Box box = labels_.place(around(tip, gap, wide, 2.0 * of_line));
    const char* const style = one.is_load ? "halo f1" : "halo f0";
    canvas_.text(style, {box.centre().x, box.top + base}, name, Anchor::middle);
    canvas_.text(style, {box.centre().x, box.top + base + of_line}, value, Anchor::middle);
  }

  std::vector<Transverse> forces_;
  Point centre_;
  Labels labels_;
  Canvas canvas_;
};

}  // namespace

bool has_end_view(const figure::Shaft& shaft) {
  constexpr double least_sine = 0.02;
  if (!shaft.seen_from_end || !shaft.diagrams.empty()) return false;
  const std::vector<Transverse> all = transverse_forces(shaft);
  return std::any_of(all.begin(), all.end(), [&](const Transverse& one) {
    const Point a = all.front().force, b = one.force;
    return std::fabs(a.x * b.y - a.y * b.x) > least_sine * magnitude(a) * magnitude(b);
  });
}

Canvas end_view(const figure::Shaft& shaft, double axis) { return EndView(shaft, axis).drawn(); }

}  // namespace loadpath::draw
