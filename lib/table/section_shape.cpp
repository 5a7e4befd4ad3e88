#include "lib/table/section_shape.hpp"

#include "lib/quantity/format.hpp"

#include <array>
#include <cmath>

namespace loadpath::table {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double rounding = 1.01;      // rounding of values from tables
constexpr double most_fillets = 1.25;  // area over that of the walls: fillets, tapers, rounded corners
constexpr double most_moment = 1.15;   // second moment over that of the walls: rolled sections have up to 1.061

/// A value and the most that it can be.
struct Most {
  const char* key;
  const char* unit;
  double value, most;
  const char* why;
};

/// The area of the walls by the middle lines or rectangles of a kind; NaN if they are not known.
double area_of_walls(const SectionShape& s) {
  const double web = std::isnan(s.t_w) ? s.t_f : s.t_w, flange = std::isnan(s.t_f) ? web : s.t_f;
  if (!std::isnan(s.d)) return s.kind == "solid" ? pi / 4.0 * s.d * s.d : pi * web * (s.d - web);
  if (s.kind == "rolled_I" || s.kind == "welded_I" || s.kind == "channel")
    return 2.0 * s.b * flange + (s.h - 2.0 * flange) * web;
  if (s.kind == "tee") return s.b * flange + (s.h - flange) * web;
  if (s.kind == "angle") return (s.h + s.b - web) * web;
  if (s.kind == "hot_hollow" || s.kind == "cold_hollow" || s.kind == "welded_box")
    return 2.0 * s.b * flange + 2.0 * (s.h - 2.0 * flange) * web;
  return SectionShape::unknown;
}

Inconsistency misfit(const Most& bound) {
  return {bound.key, say("{1} = {2} is more than {3}: {4}", bound.key, format_quantity(bound.value, bound.unit, 5),
                         format_quantity(bound.most, bound.unit, 5), bound.why)};
}

/// The second moments of a rectangle less a smaller one, or of two flanges and a web.
struct Moments {
  double y = SectionShape::unknown, z = SectionShape::unknown;
};

double cube(double x) { return x * x * x; }

/// Moments of the walls of a shape with two axes of symmetry; for a channel only about y.
Moments moments_of_walls(const SectionShape& s) {
  const double web = std::isnan(s.t_w) ? s.t_f : s.t_w, flange = std::isnan(s.t_f) ? web : s.t_f;
  const double clear = s.h - 2.0 * flange;
  const bool hollow = s.kind == "hot_hollow" || s.kind == "cold_hollow" || s.kind == "welded_box";
  if (!std::isnan(s.d)) {
    const double of_tube = pi / 64.0 * (std::pow(s.d, 4) - std::pow(s.d - 2.0 * web, 4));
    return hollow ? Moments{of_tube, of_tube} : Moments{};
  }
  const double one_web = (s.b * cube(s.h) - (s.b - web) * cube(clear)) / 12.0;
  if (s.kind == "channel") return {one_web, SectionShape::unknown};
  if (s.kind == "rolled_I" || s.kind == "welded_I")
    return {one_web, (2.0 * flange * cube(s.b) + clear * cube(web)) / 12.0};
  if (!hollow) return {};
  const double inside = s.b - 2.0 * web;
  return {(s.b * cube(s.h) - inside * cube(clear)) / 12.0, (s.h * cube(s.b) - clear * cube(inside)) / 12.0};
}

bool is_flanged(const SectionShape& s) { return s.kind == "rolled_I" || s.kind == "welded_I"; }

bool is_open(const SectionShape& s) {
  return is_flanged(s) || s.kind == "channel" || s.kind == "tee" || s.kind == "angle";
}

/// The minimum second moment of two rectangular legs.
double minimum_of_legs(const SectionShape& s) {
  const double t = std::isnan(s.t_w) ? s.t_f : s.t_w, foot = s.b - t;
  const double A = s.h * t + foot * t, z = (0.5 * s.h * s.h * t + 0.5 * t * foot * t) / A;
  const double y = (0.5 * t * s.h * t + (t + 0.5 * foot) * foot * t) / A;
  const double up = 0.5 * s.h - z, low = 0.5 * t - z, near = 0.5 * t - y, far = t + 0.5 * foot - y;
  const double I_y = t * cube(s.h) / 12.0 + s.h * t * up * up + foot * cube(t) / 12.0 + foot * t * low * low;
  const double I_z = s.h * cube(t) / 12.0 + s.h * t * near * near + t * cube(foot) / 12.0 + foot * t * far * far;
  const double I_yz = s.h * t * up * near + foot * t * low * far;
  return 0.5 * (I_y + I_z) - std::hypot(0.5 * (I_y - I_z), I_yz);
}

/// Upper bounds of torsion and warping constants, plastic moduli and the minimum moment. By Cauchy and Schwarz the
/// first moment of the area about an axis is at most the root of A I.
std::optional<Inconsistency> misfit_of_constants(const SectionShape& s) {
  constexpr double off_centre = 1.15;  // of the axis that halves the area; fillets
  constexpr double most_twist = 1.5;   // over the strips of an open section, all as thick as its thickest wall
  const double t = std::fmax(s.t_w, s.t_f), lever = s.h - (std::isnan(s.t_f) ? 0.0 : s.t_f);
  const double strips = is_open(s) ? most_twist * s.A * t * t / 3.0 : SectionShape::unknown;
  const double warped = is_flanged(s)         ? 0.25 * s.I_z * lever * lever
                        : s.kind == "channel" ? 0.25 * s.I_z * s.h * s.h
                                              : SectionShape::unknown;
  const double legs = s.kind == "angle" ? minimum_of_legs(s) : SectionShape::unknown;
  const std::array bounds{
      Most{"W_pl_y", "mm^3", s.W_pl_y, off_centre * std::sqrt(s.A * s.I_y), "1.15 times the root of A I_y"},
      Most{"W_pl_z", "mm^3", s.W_pl_z, off_centre * std::sqrt(s.A * s.I_z), "1.15 times the root of A I_z"},
      Most{"I_t", "mm^4", s.I_t, s.I_y + s.I_z, "the polar second moment I_y + I_z"},
      Most{"I_t", "mm^4", s.I_t, strips, "1.5 times that of its walls as strips"},
      Most{"I_w", "mm^6", s.I_w, off_centre * warped, "1.15 times that of its flanges bent sideways"},
      Most{"I_min", "mm^4", s.I_min, off_centre * legs, "1.15 times the minimum second moment of its legs"}};
  for (const Most& bound : bounds) {
    if (bound.value > rounding * bound.most) return misfit(bound);
  }
  return std::nullopt;
}

/// The first wall that is thicker than there is room for.
std::optional<Inconsistency> misfit_of_walls(const SectionShape& s) {
  const bool hollow = s.kind == "hot_hollow" || s.kind == "cold_hollow" || s.kind == "welded_box";
  const std::array bounds{Most{"t_f", "mm", s.t_f, 0.5 * s.h, "half the height"},
                          Most{"t_w", "mm", s.t_w, hollow ? 0.5 * s.b : s.b, hollow ? "half the width" : "the width"},
                          Most{"t_w", "mm", s.t_w, 0.5 * s.d, "half the diameter"}};
  for (const Most& bound : bounds) {
    if (bound.value > rounding * bound.most) return misfit(bound);
  }
  return std::nullopt;
}

}  // namespace

/// Among convex sections a triangle has the maximum I_1 I_2/A^4, 1/108; a circle has the minimum among all sections,
/// 1/158 (isotropic constants of plane bodies, recalled).
bool is_full(double A, double I_y, double I_z) { return I_y * I_z * 108.0 <= rounding * std::pow(A, 4); }

std::optional<Inconsistency> inconsistency_of(const SectionShape& s) {
  if (auto wall = misfit_of_walls(s)) return wall;
  const double round = 0.25 * pi * s.d * s.d;
  const std::array bounds{Most{"A", "mm^2", s.A, s.h * s.b, "the area of h times b"},
                          Most{"A", "mm^2", s.A, round, "the area of d"},
                          Most{"I_y", "mm^4", s.I_y, 0.25 * s.A * s.h * s.h, "A h^2/4, all of the area at its edges"},
                          Most{"I_z", "mm^4", s.I_z, 0.25 * s.A * s.b * s.b, "A b^2/4, all of the area at its edges"},
                          Most{"I_y", "mm^4", s.I_y, 0.25 * s.A * s.d * s.d, "A d^2/4, all of the area at its edges"},
                          Most{"I_z", "mm^4", s.I_z, 0.25 * s.A * s.d * s.d, "A d^2/4, all of the area at its edges"}};
  for (const Most& bound : bounds) {
    if (bound.value > rounding * bound.most) return misfit(bound);
  }
  if (s.kind == "solid" && s.I_y * s.I_z * 108.0 > rounding * std::pow(s.A, 4))
    return Inconsistency{"kind", say("a solid section of A = {1} has no such second moments: it is hollow, or open",
                                     format_quantity(s.A, "mm^2", 5))};
  const double walls = area_of_walls(s);
  if (s.A > most_fillets * walls || s.A * most_fillets < walls)
    return Inconsistency{"A", say("A = {1} does not match its walls, which give {2}", format_quantity(s.A, "mm^2", 5),
                                  format_quantity(walls, "mm^2", 5))};
  const Moments moments = moments_of_walls(s);
  for (const Most& bound : {Most{"I_y", "mm^4", s.I_y, most_moment * moments.y, "1.15 times that of its walls"},
                            Most{"I_z", "mm^4", s.I_z, most_moment * moments.z, "1.15 times that of its walls"}}) {
    if (bound.value > bound.most) return misfit(bound);
  }
  return misfit_of_constants(s);
}

}  // namespace loadpath::table
