// The pressure centre of a bearing at an angle, where its radial load acts, against the place at which the shaft was
// supported.
#pragma once

#include "calculators/bearing/rolling_mate.hpp"
#include "lib/calculator/mode.hpp"

namespace loadpath::bearing {

/// The distance of the bearing itself; the offset comes with the load from `shaft.design`.
template <class Input>
constexpr auto centre_inputs() {
  return Fields{Field{&Input::a, "a", mm,
                      "distance of the pressure centre from the back face of the outer ring, manufacturer's value"}
                    .positive()
                    .from("bearing", "a")
                    .where_it_has(),
                Field{&Input::s_p, "s_p", mm,
                      "offset of the point where the shaft is supported from the centre of the bearing, positive to "
                      "the right"}
                    .may_be_missing()};
}

template <class Result>
constexpr auto centre_results() {
  return Fields{Field{&Result::s_c, "s_c", mm,
                      "offset of the pressure centre from the centre of the bearing, positive to the right: s_p of the "
                      "support"},
                Field{&Result::x_c, "x_c", ratio,
                      "distance of the pressure centre from the supported point / a: give s_c as s_p of the support "
                      "(limit set by loadpath)"}
                    .limit(0, 0.1, "a, s_p")
                    .where_it_applies()};
}

/// A bearing at an angle, on a shaft that was supported at a known point.
template <class Input>
constexpr Applies supports_at_an_angle(const Input& in) {
  return is_set(in.s_p) && at_an_angle(in.kind) && in.F_r > 0.0 * N.one ? Applies::yes : Applies::no;
}

template <class Input, class Result, class Tracer>
void pressure_centre(const Input& in, Result& r, Tracer& trace) {
  if (!at_an_angle(in.kind) || !is_set(in.a) || !is_set(in.B)) return;
  STEP(s_a, in.a - in.B / 2.0, "from the centre of the bearing to its pressure centre, [SKF-pairs]");
  const Carries way = carried(in);
  if (way == Carries::unsaid && !is_set(in.s_p)) return;
  const bool to_the_left = way == Carries::unsaid ? in.s_p < 0.0 * mm.one : way == Carries::right;
  r.s_c = trace.value("s_c", to_the_left ? -s_a : s_a,
                      way == Carries::unsaid ? "on the side of s_p, as the direction of the bearing is not stated"
                                             : "against the axial force that it carries: outside back to back, "
                                               "inside face to face");
  if (!is_set(in.s_p)) return;
  STEP_TO(r, x_c, abs(in.s_p - r.s_c) / in.a, "the radial load acts at the pressure centre, [SKF-pairs]");
}

}  // namespace loadpath::bearing
