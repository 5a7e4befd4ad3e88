#include "lib/mechanism/groups/loci.hpp"

namespace loadpath::mechanism {
namespace {

double side(double value) { return value < 0.0 ? -1.0 : 1.0; }

Meeting meet_circles(const Locus& a, const Locus& b, double branch) {
  const Vec across = b.at - a.at;
  const double inverse = 1.0 / dot(across, across);
  const double aa = a.radius * a.radius, bb = b.radius * b.radius;
  const double along = 0.5 * (1.0 + (aa - bb) * inverse);
  const double aside = std::sqrt(aa * inverse - along * along);
  return {a.at + along * across + branch * aside * normal(across), aside / (a.radius * b.radius * inverse)};
}

Meeting meet_line(const Locus& circle, const Locus& line, double branch) {
  const Vec from = circle.at - line.at;
  const double distance = cross(line.direction, from);
  const double half = std::sqrt(circle.radius * circle.radius - distance * distance);
  return {line.at + (dot(line.direction, from) + branch * half) * line.direction, half / circle.radius};
}

Meeting meet_lines(const Locus& a, const Locus& b) {
  const double sine = cross(a.direction, b.direction);
  return {a.at + cross(b.at - a.at, b.direction) / sine * a.direction, std::abs(sine)};
}

}  // namespace

Meeting meet(const Locus& a, const Locus& b, double branch) {
  if (a.straight) return b.straight ? meet_lines(a, b) : meet_line(b, a, branch);
  return b.straight ? meet_line(a, b, branch) : meet_circles(a, b, branch);
}

double branch_of(const Locus& a, const Locus& b, Vec meeting) {
  if (a.straight) return side(dot(a.direction, meeting - b.at));
  if (b.straight) return side(dot(b.direction, meeting - a.at));
  return side(cross(b.at - a.at, meeting - a.at));
}

Meeting unit_vector_with_projection(Vec d, double c, double branch) {
  const double dd = dot(d, d);
  const double aside = std::sqrt(dd - c * c);
  return {(1.0 / dd) * (c * d + branch * aside * normal(d)), aside / std::sqrt(dd)};
}

}  // namespace loadpath::mechanism
