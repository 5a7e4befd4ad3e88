#include "lib/draw/dxf.hpp"

#include "lib/draw/dxf_writer.hpp"
#include "lib/draw/scheme/fit.hpp"
#include "lib/draw/scheme/parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::draw {

namespace {

Point in_mm(Point p) { return {1e3 * p.x, 1e3 * p.y}; }

figure::Scheme in_mm(figure::Scheme scheme) {
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

class SchemeDrawing {
 public:
  explicit SchemeDrawing(const figure::Scheme& scheme);
  std::string text();

 private:
  [[nodiscard]] std::vector<std::string> layers() const;
  void body(const figure::Scheme::Body& body);
  [[nodiscard]] std::vector<Point> block_at(Point centre) const;

  figure::Scheme scheme_;  // in mm
  double radius_ = 0.0;    // radius of a pin
  DxfWriter dxf_;
};

/// Pins are a fiftieth of the drawing's size.
double pin_radius(const figure::Scheme& scheme) {
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

SchemeDrawing::SchemeDrawing(const figure::Scheme& scheme)
    : scheme_(in_mm(draw::without_gaps(scheme))), radius_(pin_radius(scheme_)) {}

std::vector<std::string> SchemeDrawing::layers() const {
  std::vector<std::string> names{"pins", "guides"};
  if (!scheme_.outlines.empty()) names.emplace_back("cams");
  for (const auto& body : scheme_.bodies) names.push_back(body.name);
  return names;
}

/// A slider's block: a rectangle along the guide that it runs on.
std::vector<Point> SchemeDrawing::block_at(Point centre) const {
  const auto slides = [&](const figure::Scheme::Joint& j) {
    return j.pin == figure::Scheme::Pin::slider && std::hypot(j.at.x - centre.x, j.at.y - centre.y) < 1e-3 * radius_;
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

void SchemeDrawing::body(const figure::Scheme::Body& body) {
  const std::vector<Point> outline = draw::convex_hull(body.points);
  if (outline.size() == 1) return dxf_.polygon(body.name, block_at(outline[0]));
  if (outline.size() == 2) return dxf_.line(body.name, outline[0], outline[1]);
  dxf_.polygon(body.name, outline);
}

std::string SchemeDrawing::text() {
  dxf_.begin(layers());
  for (const auto& b : scheme_.bodies) body(b);
  for (const auto& joint : scheme_.joints) {
    if (joint.pin == figure::Scheme::Pin::revolute) dxf_.circle("pins", joint.at, radius_);
  }
  for (const auto& guide : scheme_.guides) dxf_.line("guides", guide.from, guide.to);
  for (const auto& outline : scheme_.outlines) dxf_.polygon("cams", outline.points);
  return dxf_.end();
}

}  // namespace

std::string dxf_of(const figure::Scheme& scheme) { return SchemeDrawing(scheme).text(); }

}  // namespace loadpath::draw
