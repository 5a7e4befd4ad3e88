// A retaining ring in the groove of a shaft (DIN 471): groove and shoulder, the ring, the speed at which it opens.
//
// Decides as the standard's load columns do: the groove yields at F_N = R_e A/q, where A is the ring of the groove's
// side and q = 1.2 for a shoulder of three depths or more, which its printed F_N at 200 MPa follow, [DIN471];
// shorter shoulders need a q that is typed. The ring carries F_R against a sharp edge and F_Rg g/c against a chamfer c,
// never more than F_R, and opens at n_abl: a manufacturer's values, or those of `circlip = "18x1.2"`. Neither holds a
// safety: S does. K_A acts once. Not covered: impact, the ring in assembly, rings in bores.
#pragma once

#include "calculators/shaft/parts/pieces.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::shaft {

struct Circlip {
  static constexpr auto id = "shaft.circlip";
  static constexpr auto title = "Retaining ring (circlip) and groove";
  static constexpr auto scope =
      "Axial load capacity of groove, shoulder and ring of a retaining ring on a shaft, and the detaching "
      "speed of the ring; impact and assembly are not covered; shaft fatigue at the groove is assessed by "
      "shaft.design.";
  static constexpr auto source = "[DIN471]";
  static constexpr auto headline = "d = {d_1}";
  static constexpr auto subject = "ring and groove";
  static constexpr auto synonyms =
      "circlip, retaining ring, snap ring, groove, axial retention, detaching speed, DIN 471, Sicherungsring, "
      "Seegerring, Ringnut, Ablösedrehzahl, стопорное кольцо, пружинное кольцо, канавка";
  static constexpr auto example = R"([project]
title = "Ring next to a bearing on a shaft of 18 mm"

[ring]
calculator = "shaft.circlip"
F_a = "2.2 kN"
K_A = 1.25
circlip = "18x1.2"
w = "2 mm"
c = "1 mm"
R_e = "340 MPa"
n = "1500 rpm"
)";

  struct Input {
    Force F_a = unset<Force>;
    double K_A = 1.0, S = 1.5;
    Length d_1 = unset<Length>, d_bore = 0.0 * mm, d_2 = unset<Length>, m = unset<Length>, r = unset<Length>,
           w = unset<Length>;
    double q = unset<double>;
    Stress R_e = unset<Stress>;
    Length c = unset<Length>, g = unset<Length>;
    Force F_R = unset<Force>, F_Rg = unset<Force>;
    AngularSpeed n = unset<AngularSpeed>, n_abl = unset<AngularSpeed>;
  };
  static Applies loaded(const Input& in);
  static Applies turns_round(const Input& in);
  static Applies varies(const Input& in);
  static constexpr Fields inputs{
      Field{&Input::F_a, "F_a", N, "axial force on the ring, magnitude"}.load(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A on F_a (1 if F_a includes it)"}
          .at_least(1)
          .usually(1, 4)
          .factor(),
      Field{&Input::S, "S", ratio, "required safety factor (F_N and F_R include none)"}
          .at_least(1)
          .usually(1, 5)
          .customarily_at_least(1.2)
          .factor(),
      Field{&Input::d_1, "d_1", mm, "shaft diameter"}
          .at_most_that_of_source("d, d_max")
          .positive()
          .usually(3, 300)
          .from("circlip", "d_1"),
      Field{&Input::d_bore, "d_bore", mm, "bore diameter of the shaft"}.at_least(0).one_of_body("bore"),
      Field{&Input::d_2, "d_2", mm, "groove diameter"}.positive().from("circlip", "d_2"),
      Field{&Input::m, "m", mm, "groove width"}.positive().from("circlip", "m").where_it_has(),
      Field{&Input::r, "r", mm, "fillet radius at the groove bottom, for the notch of the shaft"}
          .positive()
          .may_be_missing(),
      Field{&Input::w, "w", mm, "shoulder width from the groove to the shaft end"}.positive(),
      Field{&Input::q, "q", ratio, "load factor of a shoulder shorter than 3 groove depths, replaces 1.2"}
          .within(1.2, 20)
          .may_be_missing()
          .factor(),
      Field{&Input::R_e, "R_e", MPa, "yield strength of the shaft"}
          .positive()
          .usually(150, 2000)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "d_1"),
      Field{&Input::c, "c", mm, "chamfer, radius or clearance of the retained part; 0: sharp edge"}
          .at_least(0)
          .may_be_missing(),
      Field{&Input::g, "g", mm, "chamfer for which F_Rg is rated"}.positive().from("circlip", "g").where_it_has(),
      Field{&Input::F_R, "F_R", N, "load capacity of the ring against a sharp edge"}
          .positive()
          .from("circlip", "F_R")
          .where_it_has(),
      Field{&Input::F_Rg, "F_Rg", N, "load capacity of the ring against a part with chamfer g"}
          .positive()
          .from("circlip", "F_Rg")
          .where_it_has(),
      Field{&Input::n, "n", rpm, "speed of the shaft"}.at_least(0).may_be_missing(),
      Field{&Input::n_abl, "n_abl", rpm, "detaching speed of the ring"}
          .positive()
          .from("circlip", "n_abl")
          .where_it_has()};

  struct Result {
    Force F_d = unset<Force>, F_N = unset<Force>, F_ring = unset<Force>;
    Length t = unset<Length>;
    double u_N = unset<double>, u_R = unset<double>, u_n = unset<double>, x_w = unset<double>, x_t = unset<double>,
           x_b = unset<double>;
    RingNotch notch;
  };
  static constexpr Fields results{
      Field{&Result::F_d, "F_d", N, "design force: with the application factor"}.holding("K_A"),
      Field{&Result::t, "t", mm, "groove depth"},
      Field{&Result::F_N, "F_N", N, "load capacity of the groove at yielding"},
      Field{&Result::F_ring, "F_ring", N, "load capacity of the ring against the edge of the retained part"},
      Field{&Result::u_N, "u_N", ratio, "groove: S x axial force / load capacity F_N"}.check(),
      Field{&Result::u_R, "u_R", ratio, "ring: S x axial force / load capacity F_ring"}.check("c").where_it_applies(),
      Field{&Result::u_n, "u_n", ratio, "speed / detaching speed of the ring"}.check("n").where_it_applies(),
      Field{&Result::x_w, "x_w", ratio, "shoulder width / groove depth (below 3: give q)"}
          .limit(3 - 1e-9, 1e6)
          .where_it_applies(),
      Field{&Result::x_t, "x_t", ratio, "groove depth / shaft diameter (DIN 471: up to 0.034; limit set by loadpath)"}
          .limit(0, 0.04),
      Field{&Result::x_b, "x_b", ratio, "groove depth / remaining wall of a hollow shaft (limit set by loadpath)"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Group{&Result::notch, "notch", "the groove, for a notch of shaft.design: part"}.handed_over()};

  static constexpr std::array rules{Rule<Input>{[](const Input& in) { return !(in.d_bore >= in.d_2); }, "d_bore, d_2",
                                                "the groove must be shallower than the wall of the shaft"},
                                    Rule<Input>{[](const Input& in) { return !(in.d_1 <= in.d_2); }, "d_1, d_2",
                                                "the groove must be thinner than the shaft"},
                                    Rule<Input>{[](const Input& in) { return !is_set(in.F_Rg) || is_set(in.g); },
                                                "F_Rg, g", "F_Rg and the chamfer g must be given together"}};

  static constexpr std::array modes{
      Mode<Input>{"groove", "groove yielding and shoulder shear", &loaded}.judged_by("u_N, x_w, x_t"),
      Mode<Input>{"bore", "shaft wall under the groove", [](const Input& in) { return where(in.d_bore > 0.0 * mm); }}
          .judged_by("x_b")
          .of_shape(),
      Mode<Input>{"ring", "ring dishing and push-out", &loaded}.judged_by("u_R").wanting("c, F_R"),
      Mode<Input>{"opening", "detaching speed of the ring", &turns_round}
          .judged_by("u_n")
          .wanting("n, n_abl")
          .in_service(),
      Mode<Input>{"fatigue", "shaft fatigue at the groove", &varies}
          .left_to("shaft.design", "notch.fatigue")
          .in_service(),
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"impact", "impact on the ring", &unseen<Input>}.special(),
      Mode<Input>{"assembly", "ring stress at assembly", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::shaft
