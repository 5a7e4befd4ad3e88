#include "calculators/gear/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loadpath::gear {

namespace {

using figure::Point;
using std::numbers::pi;

constexpr int on_flank = 16, on_fillet = 6, on_arc = 3;

/// A place on half a tooth: its angle from the middle of the tooth, and its radius.
struct Polar {
  double angle = 0.0;
  double r = 0.0;
};

/// Half a tooth with outer teeth, from the middle of the space up to its tip; in modules.
std::vector<Polar> half_tooth(const Body& b) {
  std::vector<Polar> points{{pi / b.z, b.r_f / b.m_t}};
  for (int i = 0; i <= on_fillet; ++i) {
    const FormPoint p = fillet_point(b.rack, b.z, b.x, (0.5 * pi - b.rack.alpha) * i / on_fillet);
    points.push_back({std::min(std::atan2(p.x, p.y), pi / b.z), std::hypot(p.x, p.y)});
  }
  const double from = std::max(form_radius(b.rack, b.z, b.x), points.back().r), to = b.r_a / b.m_t;
  for (int i = 1; i <= on_flank; ++i) {
    const double r = from + (to - from) * i / on_flank;
    points.push_back({std::max(0.0, half_angle(b.rack.alpha, b.z, b.x, r)), r});
  }
  return points;
}

/// Half a space of a ring, from the middle of its tooth (the tip) out to its root; in modules. The space has the form
/// of a tooth of a wheel with the opposite shift.
std::vector<Polar> half_space(const Body& b) {
  std::vector<Polar> points{{pi / b.z, b.r_a / b.m_t}};
  const double from = b.r_a / b.m_t, to = b.r_f / b.m_t;
  for (int i = 0; i <= on_flank; ++i) {
    const double r = from + (to - from) * i / on_flank;
    points.push_back({std::max(0.0, half_angle(b.rack.alpha, b.z, -b.x, r)), r});
  }
  return points;
}

std::vector<Point> around(const Body& b, const std::vector<Polar>& half) {
  std::vector<Point> outline;
  const auto add = [&](double angle, double r) {
    outline.push_back({b.at.x + b.m_t * r * std::cos(angle), b.at.y + b.m_t * r * std::sin(angle)});
  };
  for (int tooth = 0; tooth < b.z; ++tooth) {
    const double middle = b.turn + 2.0 * pi * tooth / b.z;
    for (const Polar& p : half) add(middle - p.angle, p.r);
    for (int i = 1; i < on_arc; ++i) add(middle - half.back().angle * (1.0 - 2.0 * i / on_arc), half.back().r);
    for (auto p = half.rbegin(); p != half.rend(); ++p) add(middle + p->angle, p->r);
  }
  return outline;
}

}  // namespace

std::vector<Point> wheel_outline(const Body& body) { return around(body, half_tooth(body)); }

std::vector<Point> ring_outline(const Body& body) { return around(body, half_space(body)); }

std::vector<Point> rack_outline(const Rack& rack, double m_t, double h_a, int teeth, Point at) {
  std::vector<Point> outline;
  const double lean = std::tan(rack.alpha), pitch = pi * m_t, tip = h_a * m_t, root = rack.h_f * m_t;
  const double bottom = at.y - 0.5 * teeth * pitch;
  for (int i = 0; i < teeth; ++i) {
    const double middle = bottom + (i + 0.5) * pitch;
    for (const double side : {-1.0, 1.0}) {
      const Point at_root{at.x + root, middle + side * (0.25 * pitch + root * lean)};
      const Point at_tip{at.x - tip, middle + side * (0.25 * pitch - tip * lean)};
      outline.push_back(side < 0.0 ? at_root : at_tip);
      outline.push_back(side < 0.0 ? at_tip : at_root);
    }
  }
  outline.push_back({at.x + 2.0 * root, bottom + teeth * pitch});
  outline.push_back({at.x + 2.0 * root, bottom});
  return outline;
}

}  // namespace loadpath::gear
