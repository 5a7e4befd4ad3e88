// The second bearing of a pair of single-row tapered roller or angular contact ball bearings: both induce axial
// forces, and share the external one.
#pragma once

#include "calculators/bearing/rolling_block.hpp"
#include "calculators/bearing/rolling_kind.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::bearing {

/// The direction of the axial forces on the shaft that a bearing carries.
enum class Carries { unsaid, left, right };

constexpr auto choices_of(Carries) {
  return std::array{
      ChoiceName<Carries>{Carries::unsaid, "", "not given"},
      ChoiceName<Carries>{Carries::left, "left", "axial forces to the left: negative F_a of the shaft"},
      ChoiceName<Carries>{Carries::right, "right", "axial forces to the right: positive F_a of the shaft"}};
}

enum class Arrangement { unsaid, back_to_back, face_to_face };

constexpr auto choices_of(Arrangement) {
  return std::array{ChoiceName<Arrangement>{Arrangement::unsaid, "", "not given"},
                    ChoiceName<Arrangement>{Arrangement::back_to_back, "back_to_back",
                                            "O arrangement: the left bearing carries axial forces to the right, "
                                            "pressure centres outside"},
                    ChoiceName<Arrangement>{Arrangement::face_to_face, "face_to_face",
                                            "X arrangement: the left bearing carries axial forces to the left, "
                                            "pressure centres inside"}};
}

struct Mate {
  Force F_r = unset<Force>, F_a = unset<Force>;
  Force F_r0 = unset<Force>, F_a0 = unset<Force>;
  double Y = unset<double>;
  Length x = unset<Length>;
  AngularSpeed n = unset<AngularSpeed>;
  static constexpr Fields fields{
      RecordField<Mate>{"load", "loads of the mating bearing: load = \"=shaft.bearings.right\""},
      Field{&Mate::F_r, "F_r", kN, "its radial load"}.load().at_least(0),
      Field{&Mate::F_a, "F_a", kN, "external axial force on the mating bearing, positive to the right"}
          .load()
          .may_be_missing(),
      Field{&Mate::Y, "Y", ratio, "its axial load factor above e: Y = \"=right_bearing.Y\""}.positive().usually(0.2, 7),
      Field{&Mate::F_r0, "F_r0", kN, "its peak radial load"}.load().at_least(0).may_be_missing(),
      Field{&Mate::F_a0, "F_a0", kN, "simultaneous axial force"}.load().may_be_missing(),
      Field{&Mate::x, "x", mm, "its position on the shaft"}.may_be_missing(),
      Field{&Mate::n, "n", rpm, "speed of the mating bearing, that of the common shaft"}.may_be_missing()};
};

/// Inputs of a bearing that is one of a pair.
template <class Input>
constexpr auto pair_inputs() {
  return Fields{
      Group{&Input::mate, "mate",
            "the other bearing of a pair: F_a is then the external axial force, positive to the right"}
          .may_be_missing(),
      Choice{&Input::arrangement, "arrangement",
             "arrangement of the pair, with mate; the positions x show which bearing is the left one"}
          .may_be_missing(),
      Choice{&Input::carries, "carries", "direction of the axial force that this bearing carries, with mate"}
          .may_be_missing(),
      Field{&Input::x, "x", mm, "position of the bearing on the shaft, from its left end"}.may_be_missing(),
      Field{&Input::c_i, "c_i", ratio, "induced axial force x Y / F_r: 0.5; in catalogues also 0.6, or 0.47 with K"}
          .within(0.47, 0.6)};
}

template <class Input>
constexpr bool has_mate(const Input& in) {
  return is_set(in.mate.F_r) || is_set(in.mate.Y);
}

/// The direction by the arrangement, where it is known which bearing is the left one.
template <class Input>
constexpr Carries carried_by_arrangement(const Input& in) {
  if (in.arrangement == Arrangement::unsaid || !is_set(in.x) || !is_set(in.mate.x) || in.x == in.mate.x)
    return Carries::unsaid;
  const bool is_left = in.x < in.mate.x;
  return is_left == (in.arrangement == Arrangement::back_to_back) ? Carries::right : Carries::left;
}

template <class Input>
constexpr Carries carried(const Input& in) {
  return in.carries != Carries::unsaid ? in.carries : carried_by_arrangement(in);
}

template <class Input>
constexpr bool mate_is_complete(const Input& in) {
  if (!has_mate(in)) return in.carries == Carries::unsaid && in.arrangement == Arrangement::unsaid;
  return at_an_angle(in.kind) && is_set(in.Y) && is_set(in.mate.Y);
}

template <class Input>
constexpr bool direction_is_known(const Input& in) {
  return !has_mate(in) || carried(in) != Carries::unsaid;
}

template <class Input>
FieldFault unknown_direction(const Input& in) {
  if (in.arrangement == Arrangement::unsaid)
    return {"mate", say("the directions in which the bearings of the pair carry axial forces are not known"),
            say("give arrangement = \"back_to_back\" or \"face_to_face\", or carries = \"left\" or \"right\"")};
  if (in.x == in.mate.x)
    return {"x", say("both bearings of the pair are at the same position"), say("correct x, or mate.x")};
  return {"arrangement", say("the arrangement does not show which bearing is the left one"),
          say("give x and mate.x, as the loads of shaft.design do, or carries in place of arrangement")};
}

template <class Input>
constexpr bool direction_agrees(const Input& in) {
  const Carries found = carried_by_arrangement(in);
  return in.carries == Carries::unsaid || found == Carries::unsaid || found == in.carries;
}

/// Bearings of one pair sit on one shaft; those of different speeds do not.
template <class Input>
bool is_on_one_shaft(const Input& in) {
  if (!is_set(in.mate.n) || !is_set(in.n)) return true;
  return abs(abs(in.mate.n) - abs(in.n)) <= 1e-6 * abs(in.n);
}

template <class Input>
constexpr auto pair_rules() {
  return std::array{
      Rule<Input>{&mate_is_complete<Input>, "mate, carries, arrangement, kind, Y",
                  "a pair is of two single-row bearings at an angle: give Y, and F_r and Y of the mate"},
      Rule<Input>{&direction_is_known<Input>, "mate, arrangement, carries, x", "the pair needs its arrangement",
                  &unknown_direction<Input>},
      Rule<Input>{
          &direction_agrees<Input>, "carries, arrangement, x",
          "the left bearing carries axial forces to the right back to back, to the left face to face: omit carries, "
          "or correct arrangement"},
      Rule<Input>{
          &is_on_one_shaft<Input>, "mate, n",
          "both bearings of a pair must run at the speed of their shaft: take mate.load from the shaft of load"}};
}

/// Axial loads of the bearing in its direction, in service and at the peak.
struct Thrust {
  Force F_a, F_a0;
};

/// The external force presses one bearing; the other has its own induced force, with which the sum is in balance.
template <class Input>
Force shared(const Input& in, Force F_r, Force mate_F_r, Force external) {
  const double direction = carried(in) == Carries::left ? -1.0 : 1.0;
  return max(in.c_i * F_r / in.Y, in.c_i * mate_F_r / in.mate.Y + direction * external);
}

/// The axial load on the bearing in a block with an axial force of its own.
template <class Input>
Force thrust_of_block(const Input& in, const Block& b) {
  if (!has_mate(in)) return b.F_a;
  const Force mate_F_a = is_set(in.mate.F_a) ? b.k * in.mate.F_a : 0.0 * N.one;
  return shared(in, b.k * in.F_r, b.k * in.mate.F_r, b.F_a + mate_F_a);
}

template <class Input, class Tracer>
Thrust thrust(const Input& in, Tracer& trace) {
  const Force none = 0.0 * N.one;
  if (!has_mate(in)) {
    return {trace.value("F_ax", in.F_a, "axial load as given"),
            trace.value("F_ax0", is_set(in.F_a0) ? in.F_a0 : none, "at rest or in a shock, as given")};
  }
  const Force mate_F_a = is_set(in.mate.F_a) ? in.mate.F_a : none;
  const double direction = carried(in) == Carries::left ? -1.0 : 1.0;
  const Force K_a = trace.value("K_a", direction * (in.F_a + mate_F_a),
                                "external axial force, positive in the direction that this bearing carries");
  const Force F_i2 = trace.value("F_i2", in.c_i * in.mate.F_r / in.mate.Y,
                                 "induced by the mating bearing, c_i F_r/Y with its F_r and Y, [SKF-pairs]");
  STEP(F_i1, in.c_i * in.F_r / in.Y,
       in.c_i < 0.5 ? "induced by this bearing, Y is K, [Shigley-11-18]" : "induced by this bearing, [SKF-pairs]");
  STEP(F_ax, max(F_i1, F_i2 + K_a),
       F_i2 + K_a > F_i1 ? "the mating bearing and the external force press it, load cases of [SKF-pairs]"
                         : "its own induced force, which holds the balance, load cases of [SKF-pairs]");
  Force F_ax0 = none;
  if (is_set(in.F_r0)) {
    const Force mate_F_r0 = is_set(in.mate.F_r0) ? in.mate.F_r0 : in.mate.F_r;
    const Force F_a0 = is_set(in.F_a0) ? in.F_a0 : in.F_a, mate_F_a0 = is_set(in.mate.F_a0) ? in.mate.F_a0 : mate_F_a;
    F_ax0 = shared(in, in.F_r0, mate_F_r0, F_a0 + mate_F_a0);
  }
  return {F_ax, trace.value("F_ax0", F_ax0, "the same at rest or in a shock")};
}

}  // namespace loadpath::bearing
