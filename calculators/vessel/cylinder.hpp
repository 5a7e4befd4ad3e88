// A thin-walled cylinder under internal pressure of gas and liquid, without ends, with ends, or strengthened by rings.
//
// Decides the least thickness, the equivalent stress at the lowest place and the allowable gas pressure, Lamé's
// thick-walled result, and the new wall at its test pressure. Membrane stresses of [B24]; the axis is vertical with a
// liquid. Tension is positive. Not covered: weight of the wall, nozzles, junctions with the ends, external pressure,
// temperature, fatigue.
#pragma once

#include "calculators/vessel/growth.hpp"
#include "calculators/vessel/lame.hpp"
#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/form.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct Cylinder {
  static constexpr auto id = "vessel.cylinder";
  static constexpr auto title = "Thin-walled cylindrical vessel";
  static constexpr auto scope =
      "Static membrane stresses and wall thickness of a cylinder under internal gas and liquid pressure, as "
      "open pipe, closed vessel or ring-reinforced vessel; nozzles, end junctions, self-weight, external "
      "pressure and fatigue are not covered.";
  static constexpr auto source = "[B24], [Lame], [Mises]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "membrane stresses";
  static constexpr auto synonyms =
      "pressure vessel, cylinder, pipe, hoop stress, boiler formula, membrane stress, wall thickness, "
      "weld efficiency, corrosion allowance, Druckbehälter, Kesselformel, Umfangsspannung, Wanddicke, "
      "сосуд давления, цилиндрическая оболочка, котельная формула, толщина стенки";
  static constexpr auto example = R"([project]
title = "Air receiver"

[receiver]
calculator = "vessel.cylinder"
p = "1.6 MPa"
R = "600 mm"
measured = "inner"
c = "1 mm"
z_l = 0.85
sigma_adm = "140 MPa"
)";

  enum class Ends { closed, open, ringed };
  enum class Support { bottom, top };

  struct Input : WallInput, Liquid, TestInput, ElasticInput {
    Length R = unset<Length>;
    Ends ends = Ends::closed;
    Support support = Support::bottom;
    Area A_r = unset<Area>;
    Length l_r = unset<Length>;
    Length delta_e = unset<Length>;
  };
  static constexpr Fields inputs = join(
      Fields{Field<Input, Length>{&Input::R, "R", mm, "radius of the cylinder, to the surface given by measured"}
                 .one_of_body("radius")
                 .positive()
                 .usually(5, 50000),
             Choice<Input, Ends>{&Input::ends, "ends", "end condition: closed ends, open pipe or ring-reinforced"}
                 .may_be_missing()},
      wall_inputs<Input>(), liquid_inputs<Input>("height of the liquid surface above the lowest point of the wall"),
      Fields{
          Choice<Input, Support>{&Input::support, "support", "support of a liquid-filled cylinder"}.may_be_missing(),
          Field<Input, Area>{&Input::A_r, "A_r", mm2, "cross-sectional area of one ring"}.positive().may_be_missing(),
          Field<Input, Length>{&Input::l_r, "l_r", mm, "ring spacing"}.positive().may_be_missing(),
          Field<Input, Length>{&Input::delta_e, "delta_e", mm, "nominal thickness of flat ends"}
              .positive()
              .usually(0.5, 400)
              .may_be_missing()},
      test_inputs<Input>(), elastic_inputs<Input>("modulus of elasticity, for the growth under pressure"));

  struct Result : WallResult, LameResult, TestResult, GrowthResult {
    Length R_m = unset<Length>, delta_o = unset<Length>, delta_M = unset<Length>, a_r = unset<Length>;
    double w_r = unset<double>;
    Stress sigma_e = unset<Stress>;
    double u_e = unset<double>, t_M = unset<double>;
    ShellOfEnds shell;
    WallOutside wall;
  };
  static Applies has_ends(const Input& in) { return in.ends == Ends::open ? Applies::no : Applies::unseen; }
  static constexpr Fields results = join(
      wall_results<Result>(round_and_thin),
      Fields{Field{&Result::R_m, "R_m", mm, "mean radius at the analysis thickness"},
             Field{&Result::delta_o, "delta_o", mm, "analysis thickness from the hoop stress only, pR/sigma"},
             Field{&Result::delta_M, "delta_M", mm, "analysis thickness from the meridional stress only, pR/2sigma"},
             Field{&Result::a_r, "a_r", mm, "ring area per length of the vessel"}, thin_by_membrane<Result>()},
      lame_results<Result>(), growth_of_cylinder<Result>(), test_results<Result>(),
      Fields{Field{&Result::sigma_e, "sigma_e", MPa, "bending stress of flat ends, at the centre"},
             Field{&Result::u_e, "u_e", ratio, "flat ends: bending stress / allowable stress"}
                 .check("delta_e")
                 .where_it_applies(),
             Field{&Result::w_r, "w_r", ratio, "rings: spacing / effective wall length"}.limit(0, 1, "l_r"),
             Group{&Result::shell, "shell", "the cylinder at its ends, for vessel.end: shell"}.handed_over(),
             Group{&Result::wall, "wall", "the wall from outside, for vessel.external: wall"}.handed_over()});

  static constexpr std::array rules = join(
      wall_rules<Input>(), liquid_rules<Input>(), test_rules<Input>(),
      std::array{Rule<Input>{[](const Input& in) { return in.ends != Ends::ringed || !is_set(in.p_t); }, "p_t, ends",
                             "the test of a wall between rings is not covered: leave p_t out"},
                 Rule<Input>{[](const Input& in) { return is_set(in.A_r) == is_set(in.l_r); }, "A_r, l_r",
                             "rings need both the area A_r of their section and their distance l_r"},
                 Rule<Input>{[](const Input& in) { return in.ends == Ends::ringed || !is_set(in.A_r); },
                             "A_r, l_r, ends", "rings require ends = \"ringed\""},
                 Rule<Input>{[](const Input& in) { return in.ends != Ends::open || !is_set(in.delta_e); },
                             "delta_e, ends", "a pipe with ends = \"open\" has no end plates"},
                 Rule<Input>{
                     [](const Input& in) { return !is_set(in.delta_e) || in.delta_e * (1.0 - in.f_t) > in.c + in.c_t; },
                     "delta_e, c, c_t, f_t", "the ends must be thicker than their allowances"},
                 Rule<Input>{[](const Input& in) { return leaves_room(in, in.R); }, "R, delta",
                             "the wall must be thinner than the radius"}});

  static constexpr Applies ringed(const Input& in) { return where(in.ends == Ends::ringed); }
  static constexpr std::array meanings =
      join(wall_meanings, std::array{Meaning{"R", radius_when_open, "ends", "open"}});
  static constexpr std::array modes = with_vacuum_assessed(modes_of_tested_wall<Input>(
      membrane_strength<Input>("u_v, t_R, t_M, w_r").assessed_in("vessel.thick"), test_mode<Input>(),
      test_level_mode<Input>(),
      Mode<Input>{"ends", "strength of the ends", &has_ends}
          .judged_by("u_e")
          .left_to("vessel.end", "shell.strength, shell.knuckle")
          .of_service(),
      Mode<Input>{"rings", "spacing of reinforcing rings", &ringed}.judged_by("w_r").wanting("A_r, l_r")));

  static constexpr std::array forms{
      Form{"p, R, delta, sigma_adm", "sigma_o, sigma_M, sigma_v, t_R, delta_min, p_max, u_v, sigma_L, delta_L"}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Cylinder::Ends) {
  using Ends = Cylinder::Ends;
  return std::array{
      ChoiceName<Ends>{Ends::closed, "closed", "closed ends"},
      ChoiceName<Ends>{Ends::open, "open", "open pipe: no axial force"},
      ChoiceName<Ends>{Ends::ringed, "ringed", "ring-reinforced: closed, with rings that take part of the hoop force"}};
}

constexpr auto choices_of(Cylinder::Support) {
  using Support = Cylinder::Support;
  return std::array{ChoiceName<Support>{Support::bottom, "bottom", "standing: the ground carries the liquid"},
                    ChoiceName<Support>{Support::top, "top", "suspended: the wall carries the liquid"}};
}

}  // namespace loadpath::vessel
