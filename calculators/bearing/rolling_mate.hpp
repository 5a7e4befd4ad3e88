// The second bearing of a pair of single-row tapered roller or angular contact ball bearings: both induce axial
// forces, and share the external one.
#pragma once

#include "calculators/bearing/rolling_kind.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::bearing {

/// The direction of the axial forces on the shaft that a bearing carries.
enum class Carries { unsaid, left, right };

constexpr auto choices_of(Carries) {
  return std::array{
      ChoiceName<Carries>{Carries::unsaid, "", "not stated"},
      ChoiceName<Carries>{Carries::left, "left", "axial forces to the left: negative F_a of the shaft"},
      ChoiceName<Carries>{Carries::right, "right", "axial forces to the right: positive F_a of the shaft"}};
}

struct Mate {
  Force F_r = unset<Force>, F_a = unset<Force>;
  Force F_r0 = unset<Force>, F_a0 = unset<Force>;
  double Y = unset<double>;
  static constexpr Fields fields{
      RecordField<Mate>{"load", "loads of the mating bearing: load = \"=shaft.bearings.right\""},
      Field{&Mate::F_r, "F_r", kN, "its radial load"}.load().at_least(0),
      Field{&Mate::F_a, "F_a", kN, "external axial force on it, positive to the right"}.load().may_be_missing(),
      Field{&Mate::Y, "Y", ratio, "its axial load factor above e"}.positive().usually(0.2, 7),
      Field{&Mate::F_r0, "F_r0", kN, "its peak radial load"}.load().at_least(0).may_be_missing(),
      Field{&Mate::F_a0, "F_a0", kN, "simultaneous axial force"}.load().may_be_missing()};
};

template <class Input>
constexpr bool has_mate(const Input& in) {
  return is_set(in.mate.F_r) || is_set(in.mate.Y);
}
template <class Input>
constexpr bool mate_is_complete(const Input& in) {
  if (!has_mate(in)) return in.carries == Carries::unsaid;
  return at_an_angle(in.kind) && is_set(in.Y) && is_set(in.mate.Y) && in.carries != Carries::unsaid;
}

/// Axial loads of the bearing in its direction, in service and at the peak.
struct Thrust {
  Force F_a, F_a0;
};

/// The external force presses one bearing; the other has its own induced force, with which the sum is in balance.
template <class Input>
Force shared(const Input& in, Force F_r, Force mate_F_r, Force external) {
  const double direction = in.carries == Carries::left ? -1.0 : 1.0;
  return max(in.c_i * F_r / in.Y, in.c_i * mate_F_r / in.mate.Y + direction * external);
}

template <class Input, class Tracer>
Thrust thrust(const Input& in, Tracer& trace) {
  const Force none = 0.0 * N.one;
  if (!has_mate(in)) {
    return {trace.value("F_ax", in.F_a, "axial load as given"),
            trace.value("F_ax0", is_set(in.F_a0) ? in.F_a0 : none, "at rest or in a shock, as given")};
  }
  const Force mate_F_a = is_set(in.mate.F_a) ? in.mate.F_a : none;
  const Force F_ax = shared(in, in.F_r, in.mate.F_r, in.F_a + mate_F_a);
  Force F_ax0 = none;
  if (is_set(in.F_r0)) {
    const Force mate_F_r0 = is_set(in.mate.F_r0) ? in.mate.F_r0 : in.mate.F_r;
    const Force F_a0 = is_set(in.F_a0) ? in.F_a0 : in.F_a, mate_F_a0 = is_set(in.mate.F_a0) ? in.mate.F_a0 : mate_F_a;
    F_ax0 = shared(in, in.F_r0, mate_F_r0, F_a0 + mate_F_a0);
  }
  return {trace.value("F_ax", F_ax,
                      "own induced force, or that of the mating bearing with the external force: the larger, "
                      "[LYC-bearings]"),
          trace.value("F_ax0", F_ax0, "the same at rest or in a shock")};
}

}  // namespace loadpath::bearing
