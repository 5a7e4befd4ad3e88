// What a hub carries, and has to fit under: the root circle, the rim and the bore of a gear, a sprocket, a pulley. They
// come with the load.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath {

/// What sits on a shaft, as far as its record says.
enum class Mounted { unsaid, gear, pulley, sprocket };

constexpr auto choices_of(Mounted) {
  return std::array{ChoiceName<Mounted>{Mounted::unsaid, "unsaid", "not said"},
                    ChoiceName<Mounted>{Mounted::gear, "gear", "a gear"},
                    ChoiceName<Mounted>{Mounted::pulley, "pulley", "the pulley of a belt"},
                    ChoiceName<Mounted>{Mounted::sprocket, "sprocket", "the sprocket of a chain"}};
}

/// Of what has d_f, h_t, b_r and bore. All of them come with a torque that is taken singly, too.
template <class Input>
constexpr auto hub_inputs() {
  using Size = Field<Input, Length>;
  return Fields{
      Size{&Input::d_f, "d_f", mm, "root circle of the gear, groove bottom of the pulley that is fastened"}
          .positive()
          .of_body()
          .may_be_missing(),
      Size{&Input::h_t, "h_t", mm, "tooth height of the gear that is fastened"}.positive().of_body().may_be_missing(),
      Size{&Input::b_r, "b_r", mm, "rim width of the gear or pulley that is fastened"}
          .positive()
          .of_body()
          .may_be_missing(),
      Size{&Input::bore, "bore", mm, "bore of the gear that is fastened"}.positive().of_body().may_be_missing()};
}

/// Whether a bore, where one is told, is that of the shaft.
inline bool bore_fits(Length bore, Length d) { return !is_set(bore) || abs(bore - d) <= 1e-3 * d; }

/// A connection that is longer than the rim: whether the hub is, only who designs it knows.
template <class Input>
Applies beyond_rim(const Input& in) {
  return where(is_set(in.b_r) && in.l > 1.000001 * in.b_r);
}
template <class Input>
constexpr auto overhang() {
  return Mode<Input>{"overhang", "length of the connection beyond the rim", &beyond_rim<Input>}.advising(
      "give an l up to b_r, or confirm a hub that is longer than the rim: accept.overhang = \"...\"");
}

template <class Input>
Applies has_root(const Input& in) {
  return is_set(in.d_f) ? Applies::yes : Applies::unseen;
}

/// The rim that the formulas of tooth roots ask for, as of gear.pair.
template <class Result>
constexpr auto rim_of_gear() {
  return Field<Result, double>{&Result::m_R, "m_R", ratio,
                               "rim of the gear between root circle and shaft or keyway / tooth height: roots from 1.2"}
      .limit(1.2 * (1 - 1e-9), 1e6)
      .where_it_applies();
}
/// `doc`: what the wall must be as thick as.
template <class Result>
constexpr auto wall_of_hub(const char* doc) {
  return Field<Result, double>{&Result::x_R, "x_R", ratio, doc}.limit(0, 1 + 1e-9).where_it_applies();
}

/// The wall of a hub on a shaft of `d` under the root circle, above a cut of this depth.
template <class Input, class Result, class Tracer>
Length wall_under_root(const Input& in, Length d, Length cut, Result& r, Tracer& trace) {
  const Length d_N = trace.value("d_N", d, "of the shaft in its hub");
  const Length t_N = trace.value("t_N", cut, "cut into the hub");
  STEP(s_N, (in.d_f - d_N) / 2.0 - t_N, "wall of the hub under the root circle");
  if (is_set(in.h_t)) {
    STEP_TO(r, m_R, s_N / in.h_t, "rim over the height of a tooth, as of gear.pair");
  }
  return s_N;
}

}  // namespace loadpath
