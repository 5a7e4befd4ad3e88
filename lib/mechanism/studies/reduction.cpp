#include "lib/mechanism/studies/reduction.hpp"

#include "lib/mechanism/model/point_motion.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

// Relative error of lengths and directions.
constexpr double rounding = 1e-9;

/// From the first to the second, when the mass centre lies on their line.
std::optional<Vec> line_through_centre(const Link& link, Vec a, Vec b) {
  const Vec line = b - a;
  const double size = length(line);
  const double reach = std::max({size, length(a - link.centre), length(b - link.centre)});
  if (!(size > rounding * reach)) return std::nullopt;
  if (!(std::abs(cross(line, link.centre - a)) <= rounding * size * reach)) return std::nullopt;
  return (1.0 / size) * line;
}

}  // namespace

Reduction::Reduction(const Model& model) : instant_(model), functions_(model), derivative_(blank_position(model)) {}

std::optional<Reduced> Reduction::find(const Position& at, std::size_t driver) {
  derivative_ = at;
  if (!functions_.derive(derivative_, driver)) return std::nullopt;
  return find(at, derivative_);
}

Reduced Reduction::find(const Position& at, const Position& derivative) {
  instant_.take_forces(at, true);
  Reduced reduced;
  for (std::size_t k = 0; k < at.pose.size(); ++k) {
    const Link& link = instant_.model().links[k];
    const Vec arm = turn(at.pose[k].phi)(link.centre);
    const Pose &v = derivative.velocity[k], &a = derivative.acceleration[k];
    const Vec speed = point_velocity(v, arm);
    reduced.inertia += link.mass * dot(speed, speed) + link.inertia * v.phi * v.phi;
    reduced.derivative +=
        2.0 * (link.mass * dot(speed, point_acceleration(a, v.phi, arm)) + link.inertia * v.phi * a.phi);
  }
  for (const ActiveForce& force : instant_.external()) reduced.moment += power(force, derivative.velocity[force.link]);
  for (const ActiveForce& force : instant_.induced()) reduced.induced += power(force, derivative.velocity[force.link]);
  return reduced;
}

std::optional<std::array<PointMass, 2>> statically_equivalent(const Link& link, Vec a, Vec b) {
  const std::optional<Vec> line = line_through_centre(link, a, b);
  if (!line) return std::nullopt;
  const double part = dot(link.centre - a, *line) / length(b - a);
  return std::array<PointMass, 2>{{{a, link.mass * (1.0 - part)}, {b, link.mass * part}}};
}

std::optional<std::array<PointMass, 3>> dynamically_equivalent(const Link& link, Vec a, Vec b) {
  const std::optional<Vec> line = line_through_centre(link, a, b);
  if (!line) return std::nullopt;
  const double from_a = dot(link.centre - a, *line), to_b = dot(b - link.centre, *line);
  if (!(from_a > 0.0) || !(to_b > 0.0)) return std::nullopt;
  const double at_a = link.inertia / (from_a * (from_a + to_b)), at_b = link.inertia / (to_b * (from_a + to_b));
  return std::array<PointMass, 3>{{{a, at_a}, {b, at_b}, {link.centre, link.mass - at_a - at_b}}};
}

double missing_inertia(const Link& link, std::span<const PointMass> masses) {
  double missing = link.inertia;
  for (const PointMass& mass : masses) missing -= mass.mass * dot(mass.at - link.centre, mass.at - link.centre);
  return missing;
}

}  // namespace loadpath::mechanism
