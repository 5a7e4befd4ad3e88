// The boundary dimensions of a rolling bearing, and the seat of the shaft that they must fit: bore, width, fillet,
// shoulder.
#pragma once

#include "calculators/bearing/rolling_kind.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::bearing {

/// Inputs of the bearing itself; those of a row of the table come from there.
template <class Input>
constexpr auto dimension_inputs() {
  return Fields{Field{&Input::d, "d", mm, "bore of the bearing"}.positive().from("bearing", "d").where_it_has(),
                Field{&Input::D, "D", mm, "outer diameter"}.positive().from("bearing", "D").where_it_has(),
                Field{&Input::B, "B", mm, "width; T of tapered roller bearings, H of thrust bearings"}
                    .positive()
                    .from("bearing", "B")
                    .where_it_has(),
                Field{&Input::r_s, "r_s", mm, "minimum chamfer dimension of the inner ring"}
                    .positive()
                    .from("bearing", "r_s")
                    .where_it_has(),
                Field{&Input::d_a, "d_a", mm, "minimum abutment diameter for the inner ring"}
                    .positive()
                    .from("bearing", "d_a")
                    .where_it_has()};
}

/// Inputs of the seat; `shaft.design` hands them over with the load.
template <class Input>
constexpr auto seat_inputs() {
  return Fields{Field{&Input::d_s, "d_s", mm, "shaft diameter at the bearing"}.positive().may_be_missing(),
                Field{&Input::l_s, "l_s", mm, "maximum ring width that fits the shaft segment, centred at the bearing"}
                    .at_least(0)
                    .may_be_missing(),
                Field{&Input::r_f, "r_f", mm, "fillet radius of the shoulder on which the inner ring abuts"}
                    .at_least(0)
                    .may_be_missing(),
                Field{&Input::d_f, "d_f", mm, "diameter of this shoulder"}.positive().may_be_missing()};
}

template <class Result>
constexpr auto seat_results() {
  return Fields{Field{&Result::x_d, "x_d", ratio, "bore / shaft diameter"}
                    .limit(1.0 - 1e-6, 1.0 + 1e-6, "d, d_s")
                    .criterion()
                    .where_it_applies(),
                Field{&Result::x_B, "x_B", ratio, "width / room on the shaft segment"}
                    .limit(0, 1.0 + 1e-9, "B, l_s")
                    .criterion()
                    .where_it_applies(),
                Field{&Result::x_r, "x_r", ratio, "fillet of the shaft / chamfer of the inner ring"}
                    .limit(0, 1.0 + 1e-9, "r_s, r_f")
                    .criterion()
                    .where_it_applies(),
                Field{&Result::x_a, "x_a", ratio, "least diameter / diameter of the shoulder"}
                    .limit(0, 1.0 + 1e-9, "d_a, d_f")
                    .criterion()
                    .where_it_applies()};
}

/// Rings of tapered roller and thrust bearings are narrower than T and H.
constexpr bool has_rings_of_its_width(Kind kind) {
  return kind != Kind::tapered_roller && kind != Kind::tapered_pair && !takes_axial_alone(kind);
}

template <class Input>
constexpr Applies sits_on_a_shaft(const Input& in) {
  if (!is_set(in.d_s)) return Applies::no;
  return is_set(in.d) ? Applies::yes : Applies::unseen;
}

/// Whether the ring meets the nearer end of its segment: a shoulder much further away carries a sleeve in between.
template <class Input>
bool abuts(const Input& in) {
  constexpr double least = 0.4;  // of the room; positions of bearings are often rounded
  const bool is_known = is_set(in.B) && is_set(in.l_s) && in.l_s > 0.0 * mm && has_rings_of_its_width(in.kind);
  return !is_known || in.B > least * in.l_s;
}

template <class Input, class Result, class Tracer>
void seat(const Input& in, Result& r, Tracer& trace) {
  if (sits_on_a_shaft(in) != Applies::yes) return;
  STEP_TO(r, x_d, in.d / in.d_s, "the ring sits on a shaft of its bore");
  if (is_set(in.B) && is_set(in.l_s) && in.l_s > 0.0 * mm && has_rings_of_its_width(in.kind)) {
    STEP_TO(r, x_B, in.B / in.l_s, "the ring sits on one segment over its full width");
  }
  if (!abuts(in)) return;
  if (is_set(in.r_s) && is_set(in.r_f)) {
    STEP_TO(r, x_r, in.r_f / in.r_s, "the ring abuts on the shoulder, not on the fillet");
  }
  if (is_set(in.d_a) && is_set(in.d_f)) {
    STEP_TO(r, x_a, in.d_a / in.d_f, "the shoulder reaches beyond the chamfer of the ring");
  }
}

}  // namespace loadpath::bearing
