// Common to shaft-hub connections: the equivalent torque, its sense, what the sides allow, the shaft in torsion.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::shaft {

/// Whether a torque changes its sense.
enum class Sense { unknown, one_way, reversing };

constexpr auto choices_of(Sense) {
  return std::array{
      ChoiceName<Sense>{Sense::unknown, "unknown", "unknown"}, ChoiceName<Sense>{Sense::one_way, "one_way", "one-way"},
      ChoiceName<Sense>{Sense::reversing, "reversing", "reversing: starts in both directions, or torsional vibration"}};
}

/// The least torque over the largest that this allows; unset where nothing is known.
inline double least_ratio(Sense sense) {
  return sense == Sense::one_way ? 0.0 : sense == Sense::reversing ? -1.0 : unset<double>;
}

/// What is carried; of what has T, T_max, torque and K_A.
template <class Input>
constexpr auto torque_inputs() {
  return Fields{
      RecordField<Input>{"load", "shaft load of the mounted gear, belt, chain or drive: load = \"=gears.gear_2\""},
      Field<Input, Moment>{&Input::T, "T", N_m, "torque"}.load().one_of_body("torque"),
      Field<Input, Moment>{&Input::T_max, "T_max", N_m, "peak torque (start, shock), if larger than K_A T"}
          .load()
          .may_be_missing(),
      Choice{&Input::torque, "torque", "torque direction: one-way or reversing"}.may_be_missing(),
      Field<Input, double>{&Input::K_A, "K_A", ratio, "application factor K_A on T (1 if T includes it)"}
          .at_least(1)
          .usually(1, 4)
          .factor()};
}

/// The safety factor of the shaft itself.
template <class Input>
constexpr auto shaft_safety() {
  return Field<Input, double>{&Input::S_F, "S_F", ratio, "required safety factor of the shaft against yielding"}
      .at_least(1)
      .usually(1.1, 6)
      .customarily_at_least(1.1)
      .may_be_missing()
      .factor();
}

template <class Input>
constexpr Rule<Input> safety_has_strength() {
  return {[](const Input& in) { return !is_set(in.S_F) || is_set(in.R_e_1); }, "S_F, R_e_1",
          "the safety factor S_F of the shaft needs its yield strength R_e_1"};
}

/// Each side has one strength, and a factor of the reversal needs one.
template <class Input>
constexpr auto rules_of_sides() {
  return std::array{Rule<Input>{[](const Input& in) { return !(is_set(in.p_adm_1) && is_set(in.R_e_1)); },
                                "p_adm_1, R_e_1", "give p_adm_1 or R_e_1, not both"},
                    Rule<Input>{[](const Input& in) { return !(is_set(in.p_adm_2) && is_set(in.R_e_2)); },
                                "p_adm_2, R_e_2", "give p_adm_2 or R_e_2, not both"},
                    safety_has_strength<Input>(),
                    Rule<Input>{[](const Input& in) { return !(abs(in.T_max) < abs(in.T)); }, "T_max, T",
                                "the peak torque T_max must not be below T"},
                    Rule<Input>{[](const Input& in) { return !is_set(in.f_W) || in.torque == Sense::reversing; },
                                "f_W, torque", "f_W requires a reversing torque: torque = \"reversing\""}};
}

/// Something to carry: T, or T_max where it is given.
template <class Input>
Applies torque_loads(const Input& in) {
  return where(abs(in.T) > 0.0 * N_m.one || (is_set(in.T_max) && abs(in.T_max) > 0.0 * N_m.one));
}

template <class Input>
Applies torque_reverses(const Input& in) {
  if (in.torque == Sense::unknown) return Applies::unseen;
  return where(in.torque == Sense::reversing);
}

template <class Input>
Applies torque_varies(const Input& in) {
  return shown_by(in.K_A > 1.0 || in.torque == Sense::reversing);
}

/// A shear stress that any steel shaft carries, pulsating, with a keyway too: the old code for transmission
/// shafts allows 41 MPa (ASME B17c; recalled).
inline constexpr double light_torsion = 40.0;

/// Whether the shaft itself can be twisted off: open below that, for any shaft carries it.
inline Applies torsion_of(Stress tau_t) {
  if (!(tau_t > 0.0 * MPa)) return Applies::no;
  return shown_by(tau_t > light_torsion * MPa);
}

/// K_A acts once, on T and not on T_max, which is the largest shock in full.
template <class Input, class Result, class Tracer>
void torque_that_counts(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, T_eq, is_set(in.T_max) ? max(in.K_A * abs(in.T), abs(in.T_max)) : in.K_A * abs(in.T), "equivalent torque");
}

/// The shaft itself in torsion; not without a safety factor, for a stress up to the yield strength is not a design.
template <class Input, class Result, class Tracer>
void yielding_of_shaft(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.R_e_1) || !is_set(in.S_F)) return;
  STEP_TO(r, u_t, sqrt(3.0) * in.S_F * r.tau_t / in.R_e_1, "equivalent stress of pure shear, [Mises]");
}

/// What a side allows: typed, or 0.9 of its yield strength; none where neither is given.
template <class Tracer>
Stress allowed_pressure(const char* symbol, Stress typed, Stress R_e, Tracer& trace) {
  if (is_set(typed)) return trace.value(symbol, typed, "given");
  if (!is_set(R_e)) return typed;
  return trace.value(symbol, 0.9 * R_e, "0.9 R_e, method C of [DIN6892]");
}

}  // namespace loadpath::shaft
