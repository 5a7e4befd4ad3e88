#include "calculators/motion/spherical/loop.hpp"

#include "lib/numerics/peak.hpp"
#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::motion {

namespace {

constexpr double rounding = 1e-12;

/// The angle at the joint of the arcs p and q: its diagonal lies between the difference and the sum of the arcs r and s
/// on the other side.
JointRange joint_range(double p, double q, double r, double s) {
  const double scale = std::sin(p) * std::sin(q), middle = std::cos(p) * std::cos(q);
  const double least = (std::cos(r + s) - middle) / scale, most = (std::cos(r - s) - middle) / scale;
  if (most < -1.0 - rounding || least > 1.0 + rounding) return {pi, 0.0};
  return {most >= 1.0 - rounding ? 0.0 : std::acos(std::max(most, -1.0)),
          least <= -1.0 + rounding ? pi : std::acos(std::min(least, 1.0))};
}

/// Input and coupler on one great circle, their ends at the signed arc d from the input axis. The law of cosines of the
/// triangle with output and ground holds for a negative d as well.
DeadCentre on_one_circle(const SphericalLoop& loop, double d, double sign) {
  const double cosine = (std::cos(loop.alpha_3) - std::cos(loop.alpha_4) * std::cos(d)) / std::sin(loop.alpha_4);
  const double radius = std::sin(d);
  if (!(std::abs(cosine) <= std::abs(radius)) || radius == 0.0) return {unset<double>, unset<double>};
  const double phi = sign * std::acos(cosine / radius);
  return {phi, std::atan2(radius * std::sin(phi),
                          radius * std::cos(phi) * std::cos(loop.alpha_4) - std::cos(d) * std::sin(loop.alpha_4))};
}

}  // namespace

bool JointRange::revolves() const { return low == 0.0 && high == pi; }

bool SphericalLoop::closes() const {
  const JointRange range = input();
  return range.low <= range.high;
}

JointRange SphericalLoop::input() const { return joint_range(alpha_1, alpha_4, alpha_2, alpha_3); }

JointRange SphericalLoop::output() const { return joint_range(alpha_3, alpha_4, alpha_1, alpha_2); }

bool SphericalLoop::coupler_revolves() const {
  return joint_range(alpha_1, alpha_2, alpha_3, alpha_4).revolves() ||
         joint_range(alpha_2, alpha_3, alpha_4, alpha_1).revolves();
}

double SphericalLoop::cos_transmission(double phi_1) const {
  const double diagonal =
      std::cos(alpha_1) * std::cos(alpha_4) + std::sin(alpha_1) * std::sin(alpha_4) * std::cos(phi_1);
  return (diagonal - std::cos(alpha_2) * std::cos(alpha_3)) / (std::sin(alpha_2) * std::sin(alpha_3));
}

double SphericalLoop::output_angle(double phi_1, double side) const {
  const double c_mu = cos_transmission(phi_1), s_2 = std::sin(alpha_2), s_3 = std::sin(alpha_3);
  const double A =
      s_3 * (std::sin(alpha_1) * std::cos(phi_1) * std::cos(alpha_4) - std::cos(alpha_1) * std::sin(alpha_4));
  const double B = s_3 * std::sin(alpha_1) * std::sin(phi_1);
  const double diagonal = std::cos(alpha_2) * std::cos(alpha_3) + s_2 * s_3 * c_mu;
  const double C = std::cos(alpha_2) - std::cos(alpha_3) * diagonal;
  const double D = s_2 * s_3 * std::sqrt(std::max(0.0, 1.0 - c_mu * c_mu));
  return std::remainder(std::atan2(B, A) + side * std::atan2(D, C), 2.0 * pi);
}

double SphericalLoop::ratio(double phi_1, double side) const {
  const double phi_4 = output_angle(phi_1, side), s_3 = std::sin(alpha_3), c_mu = cos_transmission(phi_1);
  const double G = std::sin(alpha_1) *
                   (s_3 * (std::cos(phi_1) * std::sin(phi_4) - std::cos(alpha_4) * std::sin(phi_1) * std::cos(phi_4)) -
                    std::cos(alpha_3) * std::sin(alpha_4) * std::sin(phi_1));
  return side * G / (std::sin(alpha_2) * s_3 * std::sqrt(std::max(0.0, 1.0 - c_mu * c_mu)));
}

DeadCentre stretched(const SphericalLoop& loop, double side) {
  return on_one_circle(loop, loop.alpha_1 + loop.alpha_2, -side);
}

DeadCentre folded(const SphericalLoop& loop, double side) {
  return on_one_circle(loop, loop.alpha_1 - loop.alpha_2, side);
}

WorstTransmission worst_transmission(const SphericalLoop& loop, double phi_a, double phi_b) {
  // the cosine is linear in cos(phi_1): extremes at the ends, and at multiples of a half turn
  WorstTransmission worst{phi_a, std::abs(loop.cos_transmission(phi_a))};
  const auto try_at = [&](double phi) {
    const double cosine = std::abs(loop.cos_transmission(phi));
    if (cosine > worst.cosine + rounding) worst = {phi, cosine};
  };
  try_at(phi_b);
  const double first = std::ceil(phi_a / pi);
  for (int k = 0; k < 3 && (first + k) * pi < phi_b; ++k) try_at((first + k) * pi);
  return worst;
}

Ratios extreme_ratios(const SphericalLoop& loop, double side, double phi_a, double phi_b) {
  constexpr int parts = 180;
  const auto place = [&](int k) { return phi_a + (phi_b - phi_a) * std::clamp(k, 0, parts) / parts; };
  int lowest = 0, highest = 0;
  Ratios found{loop.ratio(phi_a, side), loop.ratio(phi_a, side)};
  for (int k = 1; k <= parts; ++k) {
    const double ratio = loop.ratio(place(k), side);
    if (ratio < found.low) found.low = ratio, lowest = k;
    if (ratio > found.high) found.high = ratio, highest = k;
  }
  const auto up = [&](double phi) { return loop.ratio(phi, side); };
  const auto down = [&](double phi) { return -loop.ratio(phi, side); };
  found.high = std::max(found.high, numerics::peak_between(up, place(highest - 1), place(highest + 1)).f);
  found.low = std::min(found.low, -numerics::peak_between(down, place(lowest - 1), place(lowest + 1)).f);
  return found;
}

}  // namespace loadpath::motion
