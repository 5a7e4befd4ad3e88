#include "lib/table/section_shape.hpp"

#include "lib/quantity/format.hpp"

#include <array>
#include <cmath>

namespace loadpath::table {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double rounding = 1.01;      // of values from tables
constexpr double most_fillets = 1.25;  // area over that of the walls: fillets, tapers, rounded corners

/// A value and the most that it can be.
struct Most {
  const char* key;
  const char* unit;
  double value, most;
  const char* why;
};

/// The area of the walls by the middle lines or rectangles of a kind; NaN where they are not known.
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

Misfit misfit(const Most& bound) {
  return {bound.key, say("{1} = {2} is more than {3}: {4}", bound.key, format_quantity(bound.value, bound.unit, 5),
                         format_quantity(bound.most, bound.unit, 5), bound.why)};
}

}  // namespace

/// Of all convex sections a triangle has the largest I_1 I_2/A^4, 1/108; a circle the least of all sections, 1/158
/// (isotropic constants of plane bodies, recalled).
bool is_full(double A, double I_y, double I_z) { return I_y * I_z * 108.0 <= rounding * std::pow(A, 4); }

std::optional<Misfit> misfit_of(const SectionShape& s) {
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
    return Misfit{"kind", say("a solid section of A = {1} has no such second moments: it is hollow, or open",
                              format_quantity(s.A, "mm^2", 5))};
  const double walls = area_of_walls(s);
  if (s.A > most_fillets * walls || s.A * most_fillets < walls)
    return Misfit{"A", say("A = {1} does not match its walls, which give {2}", format_quantity(s.A, "mm^2", 5),
                           format_quantity(walls, "mm^2", 5))};
  return std::nullopt;
}

}  // namespace loadpath::table
