#include "calculators/vessel/meridian.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::vessel {

namespace {

struct Pair {
  double r, z;
};

Pair minus(const MeridianPoint& a, const MeridianPoint& b) { return {a.r - b.r, a.z - b.z}; }
double cross(Pair a, Pair b) { return a.r * b.z - a.z * b.r; }
double dot(Pair a, Pair b) { return a.r * b.r + a.z * b.z; }
double length(Pair a) { return std::hypot(a.r, a.z); }

/// The circle through three points in order, at one of them: its direction and curvature, positive to the left.
struct Bend {
  Pair tangent;
  double kappa;
  double turn;
};

Bend bend(const MeridianPoint& a, const MeridianPoint& b, const MeridianPoint& c, int at) {
  const Pair ab = minus(b, a), bc = minus(c, b), ac = minus(c, a);
  const double turn = std::atan2(cross(ab, bc), dot(ab, bc));
  const double kappa = 2.0 * cross(ab, bc) / (length(ab) * length(bc) * length(ac));
  // A chord lies half its arc off the tangents at its two ends.
  const Pair chord = at == 0 ? ab : bc;
  const double half = std::asin(std::clamp(0.5 * kappa * length(chord), -1.0, 1.0));
  const double angle = std::atan2(chord.z, chord.r) + (at == 2 ? half : -half);
  return {{std::cos(angle), std::sin(angle)}, kappa, at == 1 ? turn : 0.0};
}

Bend bend_at(const Meridian& p, std::size_t i) {
  const std::size_t last = p.size() - 1;
  if (i == 0 && p[0].r == 0.0) {  // a pole: the other half of the shell is its mirror image
    MeridianPoint mirrored = p[1];
    mirrored.r = -mirrored.r;
    return bend(mirrored, p[0], p[1], 1);
  }
  if (i == 0) return bend(p[0], p[1], p[2], 0);
  if (i == last) return bend(p[last - 2], p[last - 1], p[last], 2);
  return bend(p[i - 1], p[i], p[i + 1], 1);
}

/// Upward meridians have the outside on their right.
double sense(const Meridian& p) { return p.back().z > p.front().z ? 1.0 : -1.0; }

Meridian moved(const Meridian& points, double e) {
  Meridian out = points;
  const double side = sense(points);
  for (std::size_t i = 0; i < points.size() && e != 0.0; ++i) {
    const Pair t = bend_at(points, i).tangent;
    if (points[i].r > 0.0) out[i].r += side * e * t.z;
    out[i].z -= side * e * t.r;
  }
  return out;
}

/// Force of the liquid's pressure on the band between two points along the axis, over 2 pi: pressure and radius run
/// straight between them.
double band(const MeridianPoint& a, const MeridianPoint& b, double rho_g, double surface) {
  const double p_a = rho_g * std::max(surface - a.z, 0.0), p_b = rho_g * std::max(surface - b.z, 0.0);
  const double dr = b.r - a.r, dp = p_b - p_a;
  return dr * (p_a * a.r + (p_a * dr + dp * a.r) / 2.0 + dp * dr / 3.0);
}

}  // namespace

Meridian meridian(Meridian points, double e, Free start, double rho_g, double surface) {
  Meridian p = moved(points, e);
  const double side = sense(p);
  const double lid = start.closed ? p[0].r * p[0].r / 2.0 : 0.0;
  double liquid = lid * rho_g * std::max(surface - p[0].z, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Bend b = bend_at(p, i);
    p[i].sine = side * b.tangent.z;
    p[i].kappa = side * b.kappa;
    p[i].turn = std::abs(b.turn);
    if (i > 0) liquid += band(p[i - 1], p[i], rho_g, surface);
    p[i].gas = (p[i].r * p[i].r - p[0].r * p[0].r) / 2.0 + lid;
    p[i].liquid = liquid;
  }
  return p;
}

}  // namespace loadpath::vessel
