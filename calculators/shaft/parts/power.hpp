// The torque of a shaft: as given, or of the power that it transmits at its speed.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::shaft {

/// Fields of an input that has T, P and n. No record fills them: it brings its own torque.
template <class Input>
constexpr auto power_inputs() {
  return Fields{Field<Input, Power>{&Input::P, "P", kW, "power transmitted, with n in place of T"}
                    .positive()
                    .load()
                    .one_of_body("torque")
                    .own()
                    .may_be_missing(),
                Field<Input, AngularSpeed>{&Input::n, "n", rpm, "speed, with P"}
                    .positive()
                    .usually(0.1, 1e5)
                    .own()
                    .may_be_missing()};
}

template <class Input>
constexpr auto power_rules() {
  return std::array{Rule<Input>{[](const Input& in) { return !(is_set(in.T) && is_set(in.P)); }, "T, P",
                                "T and P both give the torque: give T, or P with n"},
                    Rule<Input>{[](const Input& in) { return is_set(in.P) == is_set(in.n); }, "P, n",
                                "the power P requires the speed n, and vice versa: T = P/(2 pi n)"}};
}

template <class Input, class Tracer>
Moment torque_of(const Input& in, Tracer& trace) {
  if (is_set(in.T)) return in.T;
  return NAMED_STEP("T", in.P / in.n, "torque of the power at this speed, P/(2 pi n)");
}

}  // namespace loadpath::shaft
