// Rules of shaft.torsion beyond the bounds of its fields.
#include "calculators/shaft/section.hpp"
#include "calculators/shaft/torsion/parts.hpp"
#include "calculators/shaft/torsion/torsion.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::shaft {

bool Torsion::torques_close(const Input& in) {
  if (in.fixed != Fixed::none || in.torques.empty()) return true;
  double largest = 0.0;
  for (const auto& t : in.torques) largest = std::max(largest, std::abs(in_si(t.T)));
  return std::abs(in_si(given_sum(in))) <= 1e-6 * largest;
}

FieldFault Torsion::open_sum(const Input& in) {
  const double sum = in_si(given_sum(in));
  return {"torques", say("the torques sum to {1}, not to zero", format_quantity(sum, N_m.symbol)),
          say("add the torque of {1} that is missing, or hold an end: fixed = \"left\" or fixed = \"right\"",
              format_quantity(-sum, N_m.symbol))};
}

bool Torsion::torques_on_shaft(const Input& in) {
  return std::none_of(in.torques.begin(), in.torques.end(), [&](const Torque& t) { return is_beyond(in, t); }) &&
         (in.torques.empty() || total_length(in) > 0.0 * m.one);
}

FieldFault Torsion::torque_off_shaft(const Input& in) {
  const auto off =
      std::find_if(in.torques.begin(), in.torques.end(), [&](const Torque& t) { return is_beyond(in, t); });
  if (off == in.torques.end()) {
    return {"torques", say("all torques act at one position, and the shaft has no length"),
            say("give each torque its position x, from the left end")};
  }
  const std::string number = std::to_string(off - in.torques.begin() + 1);
  const std::string name = off->name.empty() ? number : "'" + std::string(off->name.view()) + "'";
  return {off->name.empty() ? "torques[" + number + "].x" : "torques." + std::string(off->name.view()) + ".x",
          say("torque {1} is at {2}, {3} beyond the end of the shaft at {4}", name,
              format_quantity(in_si(off->x), mm.symbol), format_quantity(in_si(off->x - total_length(in)), mm.symbol),
              format_quantity(in_si(total_length(in)), mm.symbol)),
          in.segments.empty() ? say("x counts from the left end: correct it, or the length l")
                              : say("x counts from the left end: correct it, or the lengths of the segments")};
}

/// With tau_adm given no material fills R_e: it was typed, or S is given without it.
FieldFault Torsion::two_safeties(const Input& in) {
  if (is_set(in.R_e)) return {};
  return {"S", say("tau_adm includes the safety factor; S would be a second one"),
          say("omit S; or omit tau_adm, and S applies to the yield strength R_e, given or of a material")};
}

FieldFault Torsion::no_strength(const Input& in) {
  const bool yields = is_set(in.R_e);
  return {yields ? "S" : "",
          yields ? say("give the required safety factor S on the yield strength, or tau_adm")
                 : say("give tau_adm, or S with the yield strength R_e (or a material), or sigma_adm with behaviour"),
          say("for the twist only, without the strength: theta_adm, or the diameter and G")};
}

/// Whether a torque runs through it at all.
Applies Torsion::loaded(const Input& in) {
  const auto turns = [](Moment T) { return abs(T) > 0.0 * N_m.one; };
  return where(turns(in.T) || in.P > 0.0 * kW.one ||
               std::any_of(in.torques.begin(), in.torques.end(), [&](const Torque& t) { return turns(t.T); }));
}

/// The least diameter, where a component may sit; unknown if a segment has none yet.
Length Torsion::thinnest(const Input& in) {
  Length least = in.segments.empty() ? in.d : unset<Length>;
  for (const Segment& s : in.segments) {
    const Length d = is_set(s.d) ? s.d : in.d;
    if (!is_set(d)) return d;
    if (!(d >= least)) least = d;
  }
  return least;
}

/// The twist of a shaft whose diameters are all known.
bool Torsion::asks_twist(const Input& in) {
  const bool all_known = !in.segments.empty() && std::all_of(in.segments.begin(), in.segments.end(),
                                                             [](const Segment& s) { return is_set(s.d); });
  return is_set(in.G) && (is_set(in.d) || all_known);
}

namespace {

/// The inner and the outer radius of a segment; the outer one unset where the diameter is left to the calculator.
struct Wall {
  Length inner, outer;
};
Wall wall_of(const Torsion::Input& in, const Torsion::Segment& s) {
  const Cylinder c = cylinder_of(in, s);
  const Length bore = bore_of(c.d_bore, c.chi, c.d);
  return {bore / 2.0, c.d / 2.0};
}

bool is_outside(const Torsion::Input& in, const Torsion::Segment& s) {
  const Wall wall = wall_of(in, s);
  constexpr double rounding = 1e-9;
  return s.rho < wall.inner * (1.0 - rounding) || s.rho > wall.outer * (1.0 + rounding);
}

}  // namespace

bool Torsion::radii_in_wall(const Input& in) {
  return std::none_of(in.segments.begin(), in.segments.end(), [&](const Segment& s) { return is_outside(in, s); });
}

FieldFault Torsion::radius_outside(const Input& in) {
  const auto off =
      std::find_if(in.segments.begin(), in.segments.end(), [&](const Segment& s) { return is_outside(in, s); });
  if (off == in.segments.end()) return {};
  const Wall wall = wall_of(in, *off);
  const std::string place = "segments[" + std::to_string(off - in.segments.begin() + 1) + "].rho";
  return {off->name.empty() ? place : "segments." + std::string(off->name.view()) + ".rho",
          off->rho < wall.inner
              ? say("rho = {1} lies in the bore, which carries no stress", format_quantity(in_si(off->rho), mm.symbol))
              : say("rho = {1} lies outside the shaft", format_quantity(in_si(off->rho), mm.symbol)),
          say("give a radius from {1} to {2}", format_quantity(in_si(wall.inner), mm.symbol),
              format_quantity(in_si(wall.outer), mm.symbol))};
}

bool Torsion::bores_fit(const Input& in) {
  return std::all_of(in.segments.begin(), in.segments.end(), [&](const Segment& s) {
    const Length d = is_set(s.d) ? s.d : in.d;
    const Length d_bore = is_set(s.d_bore) || is_set(s.chi) ? s.d_bore : in.d_bore;
    return !(is_set(s.chi) && is_set(s.d_bore)) && !(is_set(d) && is_set(d_bore) && d_bore >= d);
  });
}

}  // namespace loadpath::shaft
