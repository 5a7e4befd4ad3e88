// The driven pulley of a belt drive from the speed or the ratio that is wanted: the standard pulley that comes nearest.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <cmath>
#include <span>

namespace loadpath::belt {

/// Fields of an input that has n_2_set and i_set. Results are called n_2 and i, so a project may call these so, too.
template <class Input>
constexpr auto driven_inputs() {
  return Fields{Field<Input, AngularSpeed>{&Input::n_2_set, "n_2_set", rpm, "target speed of the driven pulley"}
                    .also("n_2")
                    .positive()
                    .usually(20, 9000)
                    .may_be_missing(),
                Field<Input, double>{&Input::i_set, "i_set", ratio, "required speed ratio n_1/n_2"}
                    .also("i")
                    .positive()
                    .usually(0.1, 12)
                    .may_be_missing()};
}

/// Derived quantities.
template <class Result>
constexpr auto driven_results(const char* of_pulley) {
  return Fields{Field<Result, Length>{&Result::d_2, "d_2", mm, of_pulley},
                Field<Result, double>{&Result::i_w, "i_w", ratio, "required speed ratio"},
                Field<Result, double>{&Result::dev_i, "dev_i", ratio, "relative deviation of the ratio"}};
}

/// One of d_2, n_2_set and i_set.
template <class Input>
constexpr auto driven_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) {
                    return (is_set(in.d_2) ? 1 : 0) + (is_set(in.n_2_set) ? 1 : 0) + (is_set(in.i_set) ? 1 : 0) == 1;
                  },
                  "d_2, n_2_set, i_set", "give one of these: the driven pulley d_2, its speed n_2, the ratio i"}};
}

template <class Input, class Tracer>
double wanted_ratio(const Input& in, Tracer& trace) {
  if (is_set(in.i_set)) return NAMED_STEP("i_w", in.i_set, "required ratio, as given");
  return NAMED_STEP("i_w", in.n_1 / in.n_2_set, "required ratio of the speeds");
}

/// The member nearest to a diameter by ratio; unset of an empty list.
inline Length nearest_pulley(std::span<const Length> pulleys, Length wanted) {
  Length best = unset<Length>;
  double least = std::numeric_limits<double>::infinity();
  for (const Length& d : pulleys) {
    const double off = std::abs(std::log(in_si(d) / in_si(wanted)));
    if (off < least) best = d, least = off;
  }
  return best;
}

/// The input with the driven pulley.
template <class Input, class Tracer>
Input with_driven_pulley(const Input& in, std::span<const Length> pulleys, Tracer& trace) {
  Input whole = in;
  const double i_w = wanted_ratio(in, trace);
  STEP(d_2w, i_w * (1.0 - in.epsilon) * in.d_1, "driven pulley that gives this ratio, with slip");
  whole.d_2 = trace.value("d_2", nearest_pulley(pulleys, d_2w), "the standard pulley that comes nearest");
  return whole;
}
template <class Input>
Input with_driven_pulley(const Input& in, std::span<const Length> pulleys) {
  NoTrace quiet;
  return is_set(in.d_2) || !(is_set(in.n_2_set) || is_set(in.i_set)) ? in : with_driven_pulley(in, pulleys, quiet);
}

/// The actual ratio against the wanted one.
template <class Input, class Result, class Tracer>
void compare_ratio(const Input& in, Result& r, Tracer& trace) {
  NoTrace quiet;
  const double i_w = r.i_w = wanted_ratio(in, quiet);
  STEP_TO(r, dev_i, r.i / i_w - 1.0, "actual ratio against the wanted one");
}

}  // namespace loadpath::belt
