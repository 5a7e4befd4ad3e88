#include "lib/draw/dxf.hpp"

#include "lib/draw/scheme/fit.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::draw {

namespace {

using draw::Point;
using draw::Scheme;

constexpr int colours = 7;  // of the palette's first seven, which differ on dark and light

/// What rounding leaves of a zero is one.
std::string number(double mm) { return std::abs(mm) < 1e-9 ? "0" : format_number(mm, 10); }

Point in_mm(Point p) { return {1e3 * p.x, 1e3 * p.y}; }

Scheme in_mm(Scheme scheme) {
  for (auto& body : scheme.bodies)
    std::transform(body.points.begin(), body.points.end(), body.points.begin(), [](Point p) { return in_mm(p); });
  for (auto& joint : scheme.joints) joint.at = in_mm(joint.at);
  for (auto& outline : scheme.outlines) {
    std::transform(outline.points.begin(), outline.points.end(), outline.points.begin(),
                   [](Point p) { return in_mm(p); });
  }
  for (auto& guide : scheme.guides) guide.from = in_mm(guide.from), guide.to = in_mm(guide.to);
  return scheme;
}

class Drawing {
 public:
  explicit Drawing(const Scheme& scheme);
  std::string text();

 private:
  void pair(int code, const std::string& value) { text_ += std::to_string(code) + "\n" + value + "\n"; }
  void section(const char* name) { pair(0, "SECTION"), pair(2, name); }
  void header();
  void layers();
  void body(const Scheme::Body& body);
  void line(const std::string& layer, Point from, Point to);
  void polygon(const std::string& layer, const std::vector<Point>& corners);
  void circle(const std::string& layer, Point centre);
  [[nodiscard]] std::vector<Point> block_at(Point centre) const;

  Scheme scheme_;        // in mm
  double radius_ = 0.0;  // of a pin
  std::string text_;
};

/// Pins are a fiftieth of the drawing's size.
double pin_radius(const Scheme& scheme) {
  double left = HUGE_VAL, right = -HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& body : scheme.bodies) {
    for (const Point p : body.points) {
      left = std::min(left, p.x), right = std::max(right, p.x);
      low = std::min(low, p.y), high = std::max(high, p.y);
    }
  }
  const double size = std::max(right - left, high - low);
  return size > 0.0 ? 0.02 * size : 10.0;
}

Drawing::Drawing(const Scheme& scheme) : scheme_(in_mm(draw::without_gaps(scheme))), radius_(pin_radius(scheme_)) {}

void Drawing::header() {
  pair(999, "lengths in mm");
  section("HEADER");
  pair(9, "$ACADVER"), pair(1, "AC1009");
  pair(0, "ENDSEC");
}

void Drawing::layers() {
  std::vector<std::string> names{"pins", "guides"};
  if (!scheme_.outlines.empty()) names.emplace_back("cams");
  for (const auto& body : scheme_.bodies) names.push_back(body.name);
  section("TABLES");
  pair(0, "TABLE"), pair(2, "LAYER"), pair(70, std::to_string(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    pair(0, "LAYER"), pair(2, names[i]), pair(70, "0");
    pair(62, std::to_string(colours - static_cast<int>(i) % colours)), pair(6, "CONTINUOUS");
  }
  pair(0, "ENDTAB"), pair(0, "ENDSEC");
}

void Drawing::line(const std::string& layer, Point from, Point to) {
  pair(0, "LINE"), pair(8, layer);
  pair(10, number(from.x)), pair(20, number(from.y)), pair(30, "0");
  pair(11, number(to.x)), pair(21, number(to.y)), pair(31, "0");
}

void Drawing::polygon(const std::string& layer, const std::vector<Point>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) line(layer, corners[i], corners[(i + 1) % corners.size()]);
}

void Drawing::circle(const std::string& layer, Point centre) {
  pair(0, "CIRCLE"), pair(8, layer);
  pair(10, number(centre.x)), pair(20, number(centre.y)), pair(30, "0"), pair(40, number(radius_));
}

/// A slider's block: a rectangle along the guide that it runs on.
std::vector<Point> Drawing::block_at(Point centre) const {
  const auto slides = [&](const Scheme::Joint& j) {
    return j.pin == Scheme::Pin::slider && std::hypot(j.at.x - centre.x, j.at.y - centre.y) < 1e-3 * radius_;
  };
  const auto joint = std::find_if(scheme_.joints.begin(), scheme_.joints.end(), slides);
  const double angle = joint == scheme_.joints.end() ? 0.0 : joint->angle;
  const Point along{2.0 * radius_ * std::cos(angle), 2.0 * radius_ * std::sin(angle)},
      across{-0.6 * along.y, 0.6 * along.x};
  const auto corner = [&](double u, double v) {
    return Point{centre.x + u * along.x + v * across.x, centre.y + u * along.y + v * across.y};
  };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

void Drawing::body(const Scheme::Body& body) {
  const std::vector<Point> outline = draw::convex_hull(body.points);
  if (outline.size() == 1) return polygon(body.name, block_at(outline[0]));
  if (outline.size() == 2) return line(body.name, outline[0], outline[1]);
  polygon(body.name, outline);
}

std::string Drawing::text() {
  header();
  layers();
  section("ENTITIES");
  for (const auto& b : scheme_.bodies) body(b);
  for (const auto& joint : scheme_.joints) {
    if (joint.pin == Scheme::Pin::revolute) circle("pins", joint.at);
  }
  for (const auto& guide : scheme_.guides) line("guides", guide.from, guide.to);
  for (const auto& outline : scheme_.outlines) polygon("cams", outline.points);
  pair(0, "ENDSEC"), pair(0, "EOF");
  return std::move(text_);
}

}  // namespace

std::string dxf_of(const Scheme& scheme) { return Drawing(scheme).text(); }

}  // namespace loadpath::draw
