// Dimensions of the gear, sprocket or pulley of a hub: root circle, rim and bore. They accompany its load.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath {

/// Type of the component mounted on a shaft.
enum class Mounted { unsaid, gear, pulley, sprocket };

constexpr auto choices_of(Mounted) {
  return std::array{ChoiceName<Mounted>{Mounted::unsaid, "not_given", "not given", "unstated"},
                    ChoiceName<Mounted>{Mounted::gear, "gear", "a gear"},
                    ChoiceName<Mounted>{Mounted::pulley, "pulley", "the pulley of a belt"},
                    ChoiceName<Mounted>{Mounted::sprocket, "sprocket", "the sprocket of a chain"}};
}

/// Sizes of a mounted component. They also accompany a torque given as a single value.
template <class Input>
constexpr auto root_size() {
  return Field<Input, Length>{
      &Input::d_f, "d_f", mm,
      "root diameter of the mounted gear or sprocket, groove bottom diameter of the mounted pulley"}
      .positive()
      .of_body()
      .may_be_missing();
}
template <class Input>
constexpr auto rim_size() {
  return Field<Input, Length>{&Input::b_r, "b_r", mm, "rim width of the mounted gear or pulley"}
      .positive()
      .of_body()
      .may_be_missing();
}
template <class Input>
constexpr auto bore_size() {
  return Field<Input, Length>{&Input::bore, "bore", mm, "bore of the mounted gear"}
      .positive()
      .of_body()
      .may_be_missing();
}

/// Inputs d_f, h_t, b_r and bore of a hub.
template <class Input>
constexpr auto hub_inputs() {
  return Fields{root_size<Input>(),
                Field<Input, Length>{&Input::h_t, "h_t", mm, "tooth depth of the mounted gear"}
                    .positive()
                    .of_body()
                    .may_be_missing(),
                rim_size<Input>(), bore_size<Input>()};
}

/// A shaft thicker than the root circle of the component whose load it takes, or than its bore.
template <class Input, Length (*thinnest)(const Input&)>
Applies beyond_root(const Input& in) {
  const Length d = thinnest(in);
  if constexpr (requires { in.bore; }) {
    if (d > 1.001 * in.bore) return Applies::yes;
  }
  return where(d >= in.d_f);
}
template <class Input, Length (*thinnest)(const Input&)>
constexpr auto within_root() {
  return Mode<Input>{"root", "shaft diameter within bore and root circle of the mounted part",
                     &beyond_root<Input, thinnest>}
      .independent_of_loads()
      .advising("reduce the diameter, or confirm a shaft that steps down to the component: accept.root = \"...\"");
}

/// Whether a given bore matches the shaft.
inline bool bore_fits(Length bore, Length d) { return !is_set(bore) || abs(bore - d) <= 1e-3 * d; }

/// Whether the length of the hub is given, of a pulley or sprocket: it is often longer than the rim. A gear, which
/// alone has a tooth depth, is usually as wide as its hub.
template <class Input>
bool has_long_hub(const Input& in) {
  if constexpr (requires { in.l_n; }) return !is_set(in.h_t) && is_set(in.l_n) && in.l <= 1.000001 * in.l_n;
  return false;
}

/// A connection longer than the rim, without the length of the hub.
template <class Input>
Applies beyond_rim(const Input& in) {
  if (has_long_hub(in)) return Applies::no;
  return where(is_set(in.b_r) && in.l > 1.000001 * in.b_r);
}
template <class Input>
constexpr auto overhang() {
  return Mode<Input>{"overhang", "connection length within the rim", &beyond_rim<Input>}.advising(
      "reduce l to b_r or less, or confirm a hub longer than the rim: accept.overhang = \"...\"");
}

template <class Input>
Applies has_root(const Input& in) {
  return is_set(in.d_f) ? Applies::yes : Applies::unseen;
}

/// Rim thickness required by the tooth root formulas, as in gear.pair.
template <class Result>
constexpr auto rim_of_gear() {
  return Field<Result, double>{&Result::m_R, "m_R", ratio,
                               "rim thickness of the gear between root circle and shaft or keyway / tooth depth; at "
                               "least 1.2 for the tooth root formulas"}
      .limit(1.2 * (1 - 1e-9), 1e6)
      .where_it_applies();
}
/// `doc`: the thickness that the wall must have.
template <class Result>
constexpr auto wall_of_hub(const char* doc) {
  return Field<Result, double>{&Result::x_R, "x_R", ratio, doc}.limit(0, 1 + 1e-9).where_it_applies();
}

/// Wall of the hub between the root circle and a keyway of depth `cut` on a shaft of `d`.
template <class Input, class Result, class Tracer>
Length wall_under_root(const Input& in, Length d, Length cut, Result& r, Tracer& trace) {
  const Length d_N = trace.value("d_N", d, "shaft diameter in the hub");
  const Length t_N = trace.value("t_N", cut, "cut into the hub");
  STEP(s_N, (in.d_f - d_N) / 2.0 - t_N, "hub wall under the root circle");
  if (is_set(in.h_t)) {
    STEP_TO(r, m_R, s_N / in.h_t, "rim thickness over tooth depth, as in gear.pair");
  }
  return s_N;
}

}  // namespace loadpath
