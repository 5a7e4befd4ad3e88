// The failure modes of a bar under a normal force, common to column.buckling and column.lightest; each states its own
// sections.
#pragma once

#include "calculators/column/member/member.hpp"
#include "lib/calculator/mode.hpp"

#include <algorithm>

namespace loadpath::column {

/// The outline of a section, if the input gives it. For several sections the last of these present in one.
enum class Outline { solid, closed, unknown, two_flanges, one_symmetry, open };

template <class Input>
Applies compressed(const Input& in) {
  if (is_set(in.P)) return where(in.P > 0.0 * kN.one);
  return is_set(in.N) ? where(in.N < 0.0 * kN.one) : Applies::unseen;
}

template <class Input>
Applies pulled(const Input& in) {
  return where(in.N > 0.0 * kN.one);
}

template <class Input>
bool is_eccentric(const Input& in) {
  return is_offset_about_y(in) || is_offset_about_z(in);
}

template <class Input>
Applies bent(const Input& in) {
  return std::min(where(is_eccentric(in)), compressed(in));
}

template <class Input>
Applies pulled_and_bent(const Input& in) {
  return std::min(where(is_eccentric(in)), pulled(in));
}

template <class Input>
Applies pulled_at_holes(const Input& in) {
  return std::min(Applies::unseen, pulled(in));
}

/// Walls that can buckle: all but those of solid sections. Those of which nothing is known may be of any thickness.
template <class Input, auto outline_of>
Applies thin_walled(const Input& in) {
  const Outline outline = outline_of(in);
  if (outline == Outline::solid) return Applies::no;
  return compressed(in);
}

/// Open sections without symmetry twist when they buckle, and unknown sections may be such; sections of two flanges do
/// so where the ends or the supports about the weak axis restrain them, which no input gives.
template <class Input, auto outline_of, bool of_one_symmetry = false>
Applies twisting(const Input& in) {
  const Outline outline = outline_of(in);
  if (outline <= Outline::closed || (outline == Outline::one_symmetry && !of_one_symmetry)) return Applies::no;
  return std::min(outline == Outline::two_flanges ? Applies::unseen : Applies::yes, compressed(in));
}

/// Open sections of one symmetry whose twisting is known.
template <class Input, auto outline_of>
Applies twisting_and_bending(const Input& in) {
  return outline_of(in) == Outline::one_symmetry ? compressed(in) : Applies::no;
}

template <class Input, auto outline_of>
Applies twisting_when_bent(const Input& in) {
  const Outline outline = outline_of(in);
  return outline <= Outline::closed ? Applies::no : bent(in);
}

/// Calculators that assess buckling, and data that the walls need: known for a section of the tables.
template <class Input, auto outline_of>
constexpr auto member_modes(const char* of_buckling, const char* of_walls) {
  return std::array{
      Mode<Input>{"buckling", "flexural buckling about y and z", &compressed<Input>}.judged_by(of_buckling),
      Mode<Input>{"slenderness", "slenderness limit", &compressed<Input>}.judged_by("r_lambda").at_any_load(),
      Mode<Input>{"local", "local buckling (class 3 limit)", &thin_walled<Input, outline_of>}
          .judged_by("r_class, x_E")
          .wanting(of_walls),
      Mode<Input>{"torsional", "torsional and torsional-flexural buckling", &twisting<Input, outline_of>},
      Mode<Input>{"torsional_flexural", "torsional-flexural buckling", &twisting_and_bending<Input, outline_of>}
          .judged_by("u_TF")
          .wanting("method"),
      Mode<Input>{"eccentric", "eccentric compression (secant formula)", &bent<Input>}.judged_by("u_e").wanting(
          "method = secant"),
      Mode<Input>{"lateral_torsional", "lateral-torsional buckling", &twisting_when_bent<Input, outline_of>}
          .assessed_in("column.beam_column"),
      Mode<Input>{"lateral", "bending due to transverse and inertia loads", &unseen<Input>}
          .in_service()
          .by_companions()
          .assessed_in("link.member"),
      Mode<Input>{"tension", "yielding in tension", &pulled<Input>}.judged_by("x_t, u_t"),
      Mode<Input>{"tension_bent", "yielding in tension and bending", &pulled_and_bent<Input>}.assessed_in(
          "column.beam_column"),
      Mode<Input>{"net_section", "net section rupture (holes, pins)", &pulled_at_holes<Input>}.assessed_additionally_in(
          "pin.lug"),
      Mode<Input>{"fatigue", "fatigue", &unseen<Input>}.in_service().assessed_additionally_in(
          "fatigue.life, fatigue.history"),
      Mode<Input>{"weight", "bending due to self-weight", &unseen<Input>}.special()};
}

}  // namespace loadpath::column
