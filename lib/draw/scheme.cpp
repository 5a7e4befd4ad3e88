#include "lib/draw/labels.hpp"
#include "lib/draw/picture.hpp"
#include "lib/draw/scheme_fit.hpp"
#include "lib/draw/scheme_parts.hpp"
#include "lib/draw/thin.hpp"
#include "lib/draw/ticks.hpp"
#include "lib/issue.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <set>

namespace loadpath::draw {
namespace {

std::string force_text(double newton) {
  return newton >= 1e6 ? format_quantity(newton, "MN", 4) : format_quantity(newton, newton >= 1e3 ? "kN" : "N", 4);
}
std::string length_text(double metre) { return format_quantity(metre, metre >= 1.0 ? "m" : "mm", 4); }

class SchemePicture {
 public:
  explicit SchemePicture(const Scheme& scheme)
      : scheme_(without_gaps(scheme)), fit_(fit(scheme_)), labels_({2.0, 2.0, view_width - 2.0, fit_.height - 30.0}) {}
  Picture drawn();

 private:
  void draw_guides();
  void draw_paths();
  void draw_bodies();
  void draw_supports();
  void draw_block(const Scheme::Joint& joint);
  void draw_pins();
  void draw_forces();
  void label_points();
  void label_forces();
  void label_moments();
  void label_bodies();
  void draw_scales();

  [[nodiscard]] Point at(Point p) const { return fit_.at(p); }
  [[nodiscard]] std::vector<Point> outline(const Scheme::Body& body) const;
  [[nodiscard]] Point couple_opening(Point p) const;
  [[nodiscard]] Point support_direction(const Scheme::Joint& joint) const;
  [[nodiscard]] bool lies_on(Point p, const Scheme::Guide& guide) const;
  [[nodiscard]] bool carries_block(const Scheme::Guide& guide) const;
  void label(std::string_view style, const std::vector<Candidate>& places, const Text& text) {
    svg_.centred_text(style, labels_.place(places), text);
  }
  double draw_scale(double x, double view_per_si, std::string (*written)(double));
  [[nodiscard]] std::string description() const;

  Scheme scheme_;
  Fit fit_;
  Labels labels_;
  SvgWriter svg_;
};

std::vector<Point> SchemePicture::outline(const Scheme::Body& body) const {
  std::vector<Point> points;
  for (const Point p : body.points) points.push_back(at(p));
  return convex_hull(points);
}

void SchemePicture::draw_guides() {
  for (const auto& guide : scheme_.guides) {
    Point from = at(guide.from), to = at(guide.to);
    if (from.x > to.x) std::swap(from, to);
    if (guide.fixed && carries_block(guide)) {
      const Point below = (0.5 * block_width + 1.0) * across(unit(to - from));
      from = from + below, to = to + below;
    }
    svg_.line(guide.fixed ? "outline" : "light", from, to);
    if (guide.fixed) hatch(svg_, from, to);
    labels_.keep_off({from, to}, guide.fixed ? 5.0 : 2.0);
  }
}

void SchemePicture::draw_paths() {
  for (const auto& path : scheme_.paths) {
    std::vector<Point> points;
    for (const Point p : path.points) points.push_back(at(p));
    points = thin(points);
    svg_.polyline("light dash", points);
    labels_.keep_off(points, 1.0, 0.1);
  }
}

void SchemePicture::draw_bodies() {
  for (const auto& body : scheme_.bodies) {
    std::vector<Point> points = outline(body);
    if (points.size() == 2) svg_.line("bar", points[0], points[1]);
    if (points.size() > 2) svg_.polygon("plate", points);
    if (points.size() > 2) points.push_back(points.front());
    labels_.keep_off(points, 3.0);
  }
}

/// Downwards, or the side that is freest of links and forces.
Point SchemePicture::support_direction(const Scheme::Joint& joint) const {
  struct Side {
    Point direction;
    double reluctance;
  };
  constexpr std::array<Side, 4> sides{{{{0, 1}, 0.0}, {{1, 0}, 0.3}, {{-1, 0}, 0.3}, {{0, -1}, 0.4}}};
  std::vector<Point> taken;
  const auto take = [&](Point to) {
    if (length(to - at(joint.at)) > 1.0) taken.push_back(unit(to - at(joint.at)));
  };
  for (const auto& body : scheme_.bodies) {
    const bool joined = std::any_of(body.points.begin(), body.points.end(),
                                    [&](Point p) { return length(at(p) - at(joint.at)) < 1.0; });
    for (const Point p : body.points) joined ? take(at(p)) : void();
  }
  for (const auto& arrow : scheme_.arrows) {
    if (length(at(arrow.at) - at(joint.at)) < 1.0) take(fit_.tip(arrow));
  }
  Point best{0.0, 1.0};
  double most = -1e9;
  for (const Side& side : sides) {
    double nearest = 1.2;  // wider than this is free enough
    for (const Point t : taken) nearest = std::min(nearest, std::acos(std::clamp(dot(t, side.direction), -1.0, 1.0)));
    if (nearest - side.reluctance > most) most = nearest - side.reluctance, best = side.direction;
  }
  return best;
}

void SchemePicture::draw_supports() {
  for (const auto& joint : scheme_.joints) {
    if (joint.pin == Scheme::Pin::slider) {
      draw_block(joint);
    } else if (joint.fixed) {
      const Point direction = support_direction(joint);
      support(svg_, at(joint.at), direction);
      labels_.keep_off(Box::around(at(joint.at) + 13.0 * direction, 26.0, 26.0));
    }
  }
}

bool SchemePicture::lies_on(Point p, const Scheme::Guide& guide) const {
  return std::fabs(cross(unit(at(guide.to) - at(guide.from)), at(p) - at(guide.from))) < 1.0;
}

bool SchemePicture::carries_block(const Scheme::Guide& guide) const {
  return std::any_of(scheme_.joints.begin(), scheme_.joints.end(), [&](const Scheme::Joint& joint) {
    return joint.pin == Scheme::Pin::slider && lies_on(joint.at, guide);
  });
}

void SchemePicture::draw_block(const Scheme::Joint& joint) {
  const double angle = std::isfinite(joint.angle) ? joint.angle : 0.0;
  Point direction{std::cos(angle), -std::sin(angle)};
  if (direction.x < 0.0) direction = -1.0 * direction;
  const Point centre = at(joint.at);
  const auto corners = block(centre, direction);
  const bool guided = std::any_of(scheme_.guides.begin(), scheme_.guides.end(),
                                  [&](const Scheme::Guide& guide) { return guide.fixed && lies_on(joint.at, guide); });
  if (joint.fixed && !guided) {
    const Point below = centre + (0.5 * block_width + 1.0) * across(direction), half = 1.3 * block_length * direction;
    svg_.line("outline", below - half, below + half);
    hatch(svg_, below - half, below + half);
    labels_.keep_off({below - half, below + half}, 6.0);
  }
  svg_.polygon("pin", corners);
  labels_.keep_off({corners[0], corners[1], corners[2], corners[3], corners[0]}, 2.0);
}

void SchemePicture::draw_pins() {
  for (const auto& joint : scheme_.joints) {
    if (joint.pin == Scheme::Pin::revolute) svg_.circle("pin", at(joint.at), pin_radius);
    labels_.keep_off(Box::around(at(joint.at), 2.0 * pin_radius, 2.0 * pin_radius));
  }
  for (const auto& point : scheme_.points) {
    svg_.circle("solid", at(point.at), 3.0);
    labels_.keep_off(Box::around(at(point.at), 7.0, 7.0));
  }
}

/// Where the arc of a couple leaves room: at the support of its joint.
Point SchemePicture::couple_opening(Point p) const {
  for (const auto& joint : scheme_.joints) {
    const bool supported = joint.fixed && joint.pin == Scheme::Pin::revolute;
    if (supported && length(at(joint.at) - at(p)) < 1.0) return support_direction(joint);
  }
  return {0.0, 1.0};
}

void SchemePicture::draw_forces() {
  for (const auto& a : scheme_.arrows) {
    arrow(svg_, a.load ? 1 : 0, at(a.at), fit_.tip(a));
    labels_.keep_off({at(a.at), fit_.tip(a)}, 3.0);
  }
  for (const auto& moment : scheme_.moments) {
    couple(svg_, at(moment.at), couple_opening(moment.at), moment.value > 0.0);
    labels_.keep_off(ring(at(moment.at), couple_radius), 2.0);
  }
}

void SchemePicture::label_points() {
  std::set<std::string> done;
  const auto name = [&](const std::string& text, Point p, double gap) {
    if (!done.insert(text).second) return;
    label("halo", around(at(p), gap, width(typeset(text), 1.1 * text_size)), typeset(text));
  };
  for (const auto& joint : scheme_.joints) name(joint.name, joint.at, pin_radius + 2.5);
  for (const auto& point : scheme_.points) name(point.name, point.at, 5.0);
}

void SchemePicture::label_forces() {
  for (const auto& a : scheme_.arrows) {
    const Text text = typeset(a.label);
    const double wide = width(text, 1.1 * text_size);
    std::vector<Candidate> places = around(fit_.tip(a), 3.0, wide);
    for (Candidate& c : beside(at(a.at), fit_.tip(a), 4.0, wide)) places.push_back({c.box, 1.0 + c.cost});
    label(a.load ? "halo f1" : "halo f0", places, text);
  }
}

void SchemePicture::label_moments() {
  for (const auto& moment : scheme_.moments) {
    const std::string value = format_quantity(moment.value, "N*m", 4);
    const Text text = typeset(say("{1} = {2}", symbol(moment.label), value).text());
    label("halo f1", around(at(moment.at), couple_radius + 3.0, width(text, text_size)), text);
  }
}

void SchemePicture::label_bodies() {
  for (const auto& body : scheme_.bodies) {
    const std::vector<Point> points = outline(body);
    if (points.empty() || body.name.empty()) continue;
    const Text text = typeset(body.name);
    const double wide = width(text, text_size);
    std::vector<Candidate> places;
    if (points.size() > 2) {
      Point sum;
      for (const Point p : points) sum = sum + p;
      places = {{Box::around(1.0 / static_cast<double>(points.size()) * sum, wide, line_height), -5.0}};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto sides = beside(points[i], points[(i + 1) % points.size()], 5.0, wide);
      places.insert(places.end(), sides.begin(), sides.end());
    }
    label("quiet", places, text);
  }
}

/// A bar of a round length with what it stands for; returns where the next one may begin.
double SchemePicture::draw_scale(double x, double view_per_si, std::string (*written)(double)) {
  constexpr double longest = 80.0;
  const double value = round_below(longest / view_per_si), y = fit_.height - 13.0;
  const Point from{x, y}, to{x + value * view_per_si, y}, tick{0.0, 3.5};
  svg_.strokes("thin", {{from, to}, {from - tick, from + tick}, {to - tick, to + tick}});
  const Text text = typeset(written(value));
  svg_.text("quiet", to + Point{7.0, 4.0}, text);
  return to.x + 7.0 + width(text, text_size) + 26.0;
}

void SchemePicture::draw_scales() {
  double x = 10.0;
  if (!scheme_.bodies.empty() || !scheme_.joints.empty()) x = draw_scale(x, fit_.scale, length_text);
  if (!scheme_.arrows.empty()) draw_scale(x, fit_.newton, force_text);
}

std::string SchemePicture::description() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const auto& body : scheme_.bodies) add(say("link {1}", plain(body.name)).text());
  for (const auto& joint : scheme_.joints) {
    const bool slider = joint.pin == Scheme::Pin::slider;
    add(say(slider ? "slider {1}" : joint.fixed ? "fixed pin {1}" : "pin {1}", plain(joint.name)).text());
  }
  for (const auto& a : scheme_.arrows) {
    add(say("force {1} = {2}", plain(a.label), force_text(length(a.force))).text());
  }
  for (const auto& m : scheme_.moments) {
    add(say("moment {1} = {2}", plain(m.label), format_quantity(m.value, "N*m", 4)).text());
  }
  return text;
}

Picture SchemePicture::drawn() {
  draw_guides();
  draw_paths();
  draw_bodies();
  draw_supports();
  draw_forces();
  draw_pins();
  label_moments();
  label_points();
  label_forces();
  label_bodies();
  draw_scales();
  return {svg_, fit_.height, description()};
}

}  // namespace

Picture picture(const Scheme& scheme) { return SchemePicture(scheme).drawn(); }

}  // namespace loadpath::draw
