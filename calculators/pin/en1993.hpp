// A solid pin between plates, by EN 1993-1-8, 3.13: resistance of the pin, of the plates in bearing, their shape.
//
// Decides shear, bending and both together of the pin, bearing of the middle plate and of the two outer ones, and the
// least distances from bore to edge of plates of a given thickness, table 3.9 type A; of a pin that can be replaced
// also bending, bearing and the contact stress (3.14) under the force without its partial factor. F is characteristic,
// gamma_F makes it the design force. The extract of the standard that was seen holds (3.14) to (3.16) and table 3.10;
// table 3.9 was seen as restated, the moment of figure 3.11 as in published sheets. Symbols of the plates: 1 the middle
// one, 2 each of the outer ones; c the gap between them, e_a along the force from bore to edge and e_c across it, a and
// c of the standard. Not covered: bored pins, table 3.9 type B, plates under a force other than tension, fatigue.
#pragma once

#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::pin {

struct En1993 {
  static constexpr auto id = "pin.en1993";
  static constexpr auto title = "Pin connection to EN 1993-1-8";
  static constexpr auto scope =
      "Shear, bending and bearing resistance of a solid pin and its plates, minimum end and edge distances, "
      "and the additional requirements for replaceable pins, to EN 1993-1-8:2005, 3.13, with partial factors; "
      "fatigue and hollow pins are not covered.";
  static constexpr auto source = "[EN1993-1-8]";
  static constexpr auto headline = "d = {d}";
  static constexpr auto subject = "pin connection";
  static constexpr auto synonyms =
      "EN 1993-1-8, Eurocode 3, pinned connection, pin plate, bearing resistance, replaceable pin, "
      "Bolzenverbindung, Augenblech, шарнирное соединение, еврокод 3";
  static constexpr auto example = R"([project]
title = "Pin of a tie"

[tie]
calculator = "pin.en1993"
F = "150 kN"
gamma_F = 1.4
gamma_M0 = 1
gamma_M2 = 1.25
d = "50 mm"
d_0 = "51 mm"
t_1 = "30 mm"
t_2 = "18 mm"
c = "2 mm"
f_yp = "355 MPa"
f_up = "490 MPa"
f_y_1 = "235 MPa"
f_y_2 = "235 MPa"
e_a1 = "55 mm"
e_c1 = "35 mm"
e_a2 = "55 mm"
e_c2 = "35 mm"
)";

  enum class Replaceable { no, yes };

  struct Input {
    Force F = unset<Force>;
    double gamma_F = unset<double>, gamma_M0 = unset<double>, gamma_M2 = unset<double>, gamma_M6 = unset<double>;
    Replaceable replaceable = Replaceable::no;
    Length d = unset<Length>, d_0 = unset<Length>, t_1 = unset<Length>, t_2 = unset<Length>;
    Length c = from_si<Length>(0.0);
    Stress f_yp = unset<Stress>, f_up = unset<Stress>, f_y_1 = unset<Stress>, f_y_2 = unset<Stress>;
    Stress E = from_si<Stress>(210e9);
    Length e_a1 = unset<Length>, e_c1 = unset<Length>, e_a2 = unset<Length>, e_c2 = unset<Length>;
  };
  static Applies loaded(const Input& in);
  static Applies replaced(const Input& in);
  static constexpr Fields inputs{
      RecordField<Input>{"load", "loads of a mechanism joint: load = \"=press.joints.B\""},
      Field{&Input::F, "F", kN, "characteristic force of the middle plate on the pin, magnitude"}.load(),
      Field{&Input::gamma_F, "gamma_F", ratio, "partial factor of actions; 1 if F is a design force"}
          .at_least(1)
          .usually(1, 1.6)
          .factor(),
      Field{&Input::gamma_M0, "gamma_M0", ratio, "partial factor of yielding (national annex)"}
          .at_least(1)
          .usually(1, 1.25)
          .factor(),
      Field{&Input::gamma_M2, "gamma_M2", ratio, "partial factor of the pin in shear (national annex)"}
          .at_least(1)
          .usually(1.1, 1.5)
          .customarily_at_least(1.1)
          .factor(),
      Field{&Input::gamma_M6, "gamma_M6", ratio, "partial factor of a replaceable pin, serviceability"}
          .at_least(1)
          .usually(1, 1.25)
          .may_be_missing()
          .factor(),
      Choice{&Input::replaceable, "replaceable", "replaceable pin (additional serviceability checks)"}.may_be_missing(),
      Field{&Input::d, "d", mm, "diameter of the pin"}.positive().usually(5, 500).findable("R40"),
      Field{&Input::d_0, "d_0", mm, "hole diameter"}.positive().usually(5, 500),
      Field{&Input::t_1, "t_1", mm, "thickness of the middle plate"}.positive().usually(2, 500),
      Field{&Input::t_2, "t_2", mm, "thickness of each outer plate"}.positive().usually(2, 500),
      Field{&Input::c, "c", mm, "gap between the middle plate and an outer one"}.at_least(0).usually(0, 50),
      Field{&Input::f_yp, "f_yp", MPa, "yield strength of the pin"}.positive().usually(200, 1100).customarily_at_most(
          1100),
      Field{&Input::f_up, "f_up", MPa, "tensile strength of the pin"}.positive().usually(300, 1200).customarily_at_most(
          1200),
      Field{&Input::f_y_1, "f_y_1", MPa, "yield strength of the middle plate"}
          .positive()
          .usually(200, 960)
          .customarily_at_most(960),
      Field{&Input::f_y_2, "f_y_2", MPa, "yield strength of the outer plates"}
          .positive()
          .usually(200, 960)
          .customarily_at_most(960),
      Field{&Input::E, "E", GPa, "modulus of elasticity of pin and plates, for the contact stress"}.positive().usually(
          180, 220),
      Field{&Input::e_a1, "e_a1", mm, "end distance of the middle plate from the hole edge, along the force"}
          .positive()
          .may_be_missing(),
      Field{&Input::e_c1, "e_c1", mm, "edge distance of the middle plate from the hole edge, transverse to the force"}
          .positive()
          .may_be_missing(),
      Field{&Input::e_a2, "e_a2", mm, "end distance of the outer plates from the hole edge, along the force"}
          .positive()
          .may_be_missing(),
      Field{&Input::e_c2, "e_c2", mm, "edge distance of the outer plates from the hole edge, transverse to the force"}
          .positive()
          .may_be_missing()};

  struct Result {
    Force F_Ed = unset<Force>, F_vRd = unset<Force>, F_bRd1 = unset<Force>, F_bRd2 = unset<Force>;
    Moment M_Ed = unset<Moment>, M_Rd = unset<Moment>, M_Rdser = unset<Moment>;
    Length a_1 = unset<Length>, c_1 = unset<Length>, a_2 = unset<Length>, c_2 = unset<Length>;
    Stress sigma_h1 = unset<Stress>, sigma_h2 = unset<Stress>;
    double u_v = unset<double>, u_m = unset<double>, u_vm = unset<double>, u_b1 = unset<double>, u_b2 = unset<double>;
    double u_a1 = unset<double>, u_c1 = unset<double>, u_a2 = unset<double>, u_c2 = unset<double>;
    double u_ms = unset<double>, u_s1 = unset<double>, u_s2 = unset<double>, u_h1 = unset<double>, u_h2 = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::F_Ed, "F_Ed", kN, "design force"}.holding("gamma_F"),
      Field{&Result::M_Ed, "M_Ed", N_m, "design moment of the pin"}.holding("gamma_F"),
      Field{&Result::F_vRd, "F_vRd", kN, "shear resistance of the pin, per shear plane"},
      Field{&Result::M_Rd, "M_Rd", N_m, "bending resistance of the pin"},
      Field{&Result::M_Rdser, "M_Rdser", N_m, "serviceability bending resistance of a replaceable pin"},
      Field{&Result::F_bRd1, "F_bRd1", kN, "bearing resistance of the middle plate and the pin"},
      Field{&Result::F_bRd2, "F_bRd2", kN, "bearing resistance of an outer plate and the pin"},
      Field{&Result::a_1, "a_1", mm, "middle plate: minimum end distance"},
      Field{&Result::c_1, "c_1", mm, "middle plate: minimum edge distance"},
      Field{&Result::a_2, "a_2", mm, "outer plates: minimum end distance"},
      Field{&Result::c_2, "c_2", mm, "outer plates: minimum edge distance"},
      Field{&Result::sigma_h1, "sigma_h1", MPa, "contact stress in the middle plate, in service"},
      Field{&Result::sigma_h2, "sigma_h2", MPa, "contact stress in an outer plate, in service"},
      Field{&Result::u_v, "u_v", ratio, "shear of the pin: design force / resistance"}.check(),
      Field{&Result::u_m, "u_m", ratio, "bending of the pin: design moment / resistance"}.check(),
      Field{&Result::u_vm, "u_vm", ratio, "combined shear and bending of the pin: force / allowable force"}.check(),
      Field{&Result::u_b1, "u_b1", ratio, "bearing of the middle plate: design force / resistance"}.check(),
      Field{&Result::u_b2, "u_b2", ratio, "bearing of the outer plates: design force / resistance"}.check(),
      Field{&Result::u_a1, "u_a1", ratio, "middle plate: required / actual end distance"}.check("e_a1"),
      Field{&Result::u_c1, "u_c1", ratio, "middle plate: required / actual edge distance"}.check("e_c1"),
      Field{&Result::u_a2, "u_a2", ratio, "outer plates: required / actual end distance"}.check("e_a2"),
      Field{&Result::u_c2, "u_c2", ratio, "outer plates: required / actual edge distance"}.check("e_c2"),
      Field{&Result::u_ms, "u_ms", ratio, "in service: bending of the pin"}.check("gamma_M6").where_it_applies(),
      Field{&Result::u_s1, "u_s1", ratio, "in service: bearing of the middle plate"}
          .check("gamma_M6")
          .where_it_applies(),
      Field{&Result::u_s2, "u_s2", ratio, "in service: bearing of the outer plates"}
          .check("gamma_M6")
          .where_it_applies(),
      Field{&Result::u_h1, "u_h1", ratio, "in service: contact stress in the middle plate"}
          .check("gamma_M6")
          .where_it_applies(),
      Field{&Result::u_h2, "u_h2", ratio, "in service: contact stress in the outer plates"}
          .check("gamma_M6")
          .where_it_applies()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !(in.d_0 < in.d); }, "d_0, d", "the pin must fit into its bores"},
      Rule<Input>{[](const Input& in) { return !(in.d_0 > 1.1 * in.d); }, "d_0, d",
                  "the bore is more than 10 % wider than the pin", nullptr, true},
      Rule<Input>{[](const Input& in) { return !(in.d_0 > 1.5 * in.d); }, "d_0, d",
                  "the bore must not be wider than 1.5 pin diameters: the pin would bear on a line"},
      Rule<Input>{[](const Input& in) { return in.f_yp <= in.f_up; }, "f_yp, f_up",
                  "the yield strength R_e must not exceed the tensile strength R_m"},
      Rule<Input>{[](const Input& in) { return is_set(in.gamma_M6) <= (in.replaceable == Replaceable::yes); },
                  "gamma_M6, replaceable", "gamma_M6 requires a replaceable pin: replaceable = \"yes\""}};

  /// Own bound: the formulas are those of a pin that fits its holes.
  static double widest_hole(const Input& in) { return 1.1 * in.d.value(); }
  static constexpr std::array bounds{Bound<Input>{"d_0", "a pin that fits its hole", &widest_hole}};
  static constexpr std::array modes{
      Mode<Input>{"shear", "shear resistance of the pin", &loaded}.judged_by("u_v"),
      Mode<Input>{"bending", "bending resistance of the pin, with shear", &loaded}.judged_by("u_m, u_vm"),
      Mode<Input>{"bearing_1", "bearing resistance, middle plate", &loaded}.judged_by("u_b1"),
      Mode<Input>{"bearing_2", "bearing resistance, outer plates", &loaded}.judged_by("u_b2"),
      Mode<Input>{"plate_1", "end and edge distance, middle plate", &loaded}.judged_by("u_a1, u_c1"),
      Mode<Input>{"plate_2", "end and edge distance, outer plates", &loaded}.judged_by("u_a2, u_c2"),
      Mode<Input>{"replacing", "serviceability of a replaceable pin", &replaced}.judged_by(
          "u_ms, u_s1, u_s2, u_h1, u_h2"),
      Mode<Input>{"fatigue", "fatigue of pin and plates", &unseen<Input>}.in_service().assessed_additionally_in(
          "fatigue.life"),
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"wear", "wear of pin and bores", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(En1993::Replaceable) {
  using Replaceable = En1993::Replaceable;
  return std::array{ChoiceName<Replaceable>{Replaceable::no, "no", "permanently installed"},
                    ChoiceName<Replaceable>{Replaceable::yes, "yes", "replaceable"}};
}

}  // namespace loadpath::pin
