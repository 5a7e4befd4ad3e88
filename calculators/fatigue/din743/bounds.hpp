// Bounds on typed notch factors: those of the shoulder with the given D, d and r.
#pragma once

#include "calculators/fatigue/din743/notch.hpp"
#include "lib/calculator/bound.hpp"

#include <array>

namespace loadpath::fatigue {

/// The section as a shoulder, where D, d and r are given; a groove of these sizes has a higher stress concentration.
template <class Input>
Din743Section as_shoulder(const Input& in) {
  Din743Section shoulder = in;
  shoulder.notch = in.D > in.d && is_set(in.r) ? Notch::shoulder : Notch::untold;
  return shoulder;
}

template <class Input, Stressing kind>
double shape_of_shoulder(const Input& in) {
  const Din743Section shoulder = as_shoulder(in);
  NoTrace quiet;
  const bool is_held = in.notch == Notch::alpha && shoulder.notch == Notch::shoulder;
  return is_held ? shape_factor(shoulder, kind, (in.D - in.d) / 2.0, quiet) : unset<double>;
}

/// The yield strength, in this size or at the reference diameter.
template <class Input>
Stress yield_strength_of(const Input& in) {
  if (is_set(in.R_e)) return in.R_e;
  if constexpr (requires { in.sigma_S; })
    return in.sigma_S;
  else
    return in.R_eN;
}

/// With the largest support factor at this yield strength.
template <class Input, Stressing kind>
double notch_of_shoulder(const Input& in) {
  const Din743Section shoulder = as_shoulder(in);
  Din743Root root;
  root.t = (in.D - in.d) / 2.0, root.phi = 0.5;  // 1/(4 sqrt(t/r) + 2) is no more
  root.sigma_Sd = yield_strength_of(in);
  if (in.notch != Notch::beta || shoulder.notch != Notch::shoulder || !is_set(root.sigma_Sd)) return unset<double>;
  Din743Stress stress;
  NoTrace quiet;
  by_shape(shoulder, root, kind, stress, quiet);
  return stress.beta;
}

template <class Input>
constexpr auto notch_bounds() {
  constexpr auto of = "the shoulder of D, d and r";
  using S = Stressing;
  return std::array{Bound<Input>{"alpha_zd", of, &shape_of_shoulder<Input, S::tension>}.least(),
                    Bound<Input>{"alpha_b", of, &shape_of_shoulder<Input, S::bending>}.least(),
                    Bound<Input>{"alpha_t", of, &shape_of_shoulder<Input, S::torsion>}.least(),
                    Bound<Input>{"beta_zd", of, &notch_of_shoulder<Input, S::tension>}.least(),
                    Bound<Input>{"beta_b", of, &notch_of_shoulder<Input, S::bending>}.least(),
                    Bound<Input>{"beta_t", of, &notch_of_shoulder<Input, S::torsion>}.least()};
}

}  // namespace loadpath::fatigue
