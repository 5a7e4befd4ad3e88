// A rotating disc or ring of uniform thickness, or a long cylinder, solid or with a bore.
//
// Decides radial and hoop stress by rotation, the growth of bore and outside, the speeds of first yield and of full
// plasticity. Plane stress by [Timoshenko-II]; a long cylinder has free ends, its sections stay plane: nu/(1 - nu) in
// place of nu. Thicker discs have stresses between both. The largest stress is the hoop stress
// at the bore, or that of the axis; by Tresca it counts against the least one, taken as zero. Tension is positive. Not
// covered: forces at the rim, shrink fits (shaft.press_fit has a speed), holes, keyways, heat, vibration, fatigue.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/fit_units.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::machine {

struct Disc {
  static constexpr auto id = "machine.disc";
  static constexpr auto title = "Rotating disc, ring or cylinder of uniform thickness";
  static constexpr auto scope =
      "Radial and hoop stress due to rotation, growth, speeds of first yield and of full plasticity of a solid or "
      "hollow disc, ring or long cylinder; forces at the rim, shrink fits, holes, heat and vibration are not covered.";
  static constexpr auto source = "[Timoshenko-II], [Hearn-2]";
  static constexpr auto headline = "D = {D}, n = {n}";
  static constexpr auto subject = "stresses by rotation";
  static constexpr auto synonyms =
      "rotating disc, rotating disk, rotating ring, spinning disc, rotor, flywheel rim, flywheel disc, grinding wheel, "
      "impeller disc, turbine disc, centrifugal stress, burst speed, bursting speed, overspeed, hoop stress, "
      "rotierende "
      "Scheibe, Scheibe gleicher Dicke, Schwungscheibe, Schwungring, Fliehkraft, Berstdrehzahl, вращающийся диск, диск "
      "постоянной толщины, вращающееся кольцо, центробежные силы";
  static constexpr auto example = R"([project]
title = "Flywheel disc"

[disc]
calculator = "machine.disc"
n = "6000 rpm"
D = "500 mm"
d_i = "100 mm"
b = "40 mm"
rho = "7850 kg/m^3"
nu = 0.3
E = "210 GPa"
R_e = "450 MPa"
S = 2
)";

  enum class Form { disc, cylinder };

  struct Input {
    AngularSpeed n = unset<AngularSpeed>;
    Length D = unset<Length>, d_i = 0.0 * mm.one, b = unset<Length>;
    Form form = Form::disc;
    Density rho = unset<Density>;
    double nu = unset<double>;
    Stress E = unset<Stress>, R_e = unset<Stress>;
    double S = unset<double>;
    Length r = unset<Length>;
  };
  static constexpr Fields inputs{
      Field{&Input::n, "n", rpm, "maximum speed, overspeed included; the sign has no effect"},
      Field{&Input::D, "D", mm, "outer diameter"}.positive().usually(5, 20000),
      Field{&Input::d_i, "d_i", mm, "bore diameter; 0: solid"}.at_least(0),
      Field{&Input::b, "b", mm, "axial thickness"}.positive().usually(0.2, 20000),
      Choice{&Input::form, "form", "disc, or long cylinder (upper bound of thick discs)"}.may_be_missing(),
      Field{&Input::rho, "rho", kg_per_m3, "density"}.positive().usually(500, 20000).from("material", "rho"),
      Field{&Input::nu, "nu", ratio, "Poisson's ratio"}.at_least(0).below(0.5).usually(0.1, 0.45).from("material",
                                                                                                       "nu"),
      Field{&Input::E, "E", GPa, "modulus of elasticity, for the growth"}
          .positive()
          .usually(least_E, most_E)
          .from("material", "E")
          .where_it_has()
          .may_be_missing(),
      Field{&Input::R_e, "R_e", MPa, "yield strength; brittle bodies are not covered"}
          .positive()
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "b"),
      Field{&Input::S, "S", ratio, "required safety factor against yielding, of stresses"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.5)
          .may_be_missing()
          .factor(),
      Field{&Input::r, "r", mm, "radius at which the stresses are shown too"}.at_least(0).may_be_missing()};

  struct Result {
    Length R_a = unset<Length>, R_i = unset<Length>;
    Mass mass = unset<Mass>;
    MassMoment J_z = unset<MassMoment>;
    Moment W_k = unset<Moment>;
    Speed v_a = unset<Speed>;
    Stress sigma_ti = unset<Stress>, sigma_ta = unset<Stress>, sigma_rm = unset<Stress>, sigma_zm = unset<Stress>;
    Stress sigma_tr = unset<Stress>, sigma_rr = unset<Stress>;
    Length w_i = unset<Length>, w_a = unset<Length>;
    AngularSpeed n_F = unset<AngularSpeed>, n_pl = unset<AngularSpeed>;
    double S_F = unset<double>, u_v = unset<double>, x_b = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::R_a, "R_a", mm, "outside radius"},
      Field{&Result::R_i, "R_i", mm, "inside radius"},
      Field{&Result::mass, called("m"), kg, "mass"},
      Field{&Result::J_z, "J_z", kg_m2, "moment of inertia about the axis"},
      Field{&Result::W_k, "W_k", J, "kinetic energy"},
      Field{&Result::v_a, "v_a", m_per_s, "circumferential speed at the outside"},
      Field{&Result::sigma_ti, "sigma_ti", MPa, "hoop stress at the bore, or at the axis"},
      Field{&Result::sigma_ta, "sigma_ta", MPa, "hoop stress at the outside"},
      Field{&Result::sigma_rm, "sigma_rm", MPa, "maximum radial stress"},
      Field{&Result::sigma_zm, "sigma_zm", MPa, "axial stress of a long cylinder at the bore or the axis"},
      Field{&Result::sigma_tr, "sigma_tr", MPa, "hoop stress at the radius r"},
      Field{&Result::sigma_rr, "sigma_rr", MPa, "radial stress at the radius r"},
      Field{&Result::w_i, "w_i", um, "radial growth of the bore"},
      Field{&Result::w_a, "w_a", um, "radial growth of the outside"},
      Field{&Result::n_F, "n_F", rpm, "speed at first yield"},
      Field{&Result::n_pl, "n_pl", rpm, "speed at which the mean hoop stress reaches the yield strength"},
      Field{&Result::S_F, "S_F", ratio, "safety factor against first yield, of stresses"},
      Field{&Result::u_v, "u_v", ratio, "strength: S x maximum stress / yield strength"}.check("S"),
      Field{&Result::x_b, "x_b", ratio, "disc: thickness / outer diameter (plane stress)"}
          .limit(0, 0.25 * (1 + 1e-12))
          .where_it_applies()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.d_i < in.D; }, "d_i, D",
                  "the bore must be smaller than the outer diameter"},
      Rule<Input>{[](const Input& in) { return abs(in.n) > 0.0 * rpm; }, "n", "give a speed other than zero"},
      Rule<Input>{[](const Input& in) { return !is_set(in.S) || is_set(in.R_e); }, "S, R_e",
                  "the safety factor against yielding needs the yield strength R_e, or a material"}};

  static constexpr std::array meanings{Meaning{"R_e", yield_strength}};
  static constexpr std::array modes{
      Mode<Input>{"strength", "yielding due to rotation", &always<Input>}.judged_by("u_v, x_b").wanting("S, R_e"),
      Mode<Input>{"rim", "forces of blades or segments at the rim", &unseen<Input>}.special(),
      Mode<Input>{"fit", "stress due to a shrink fit at the bore", &unseen<Input>}.special(),
      Mode<Input>{"notches", "stress concentration at holes and keyways", &unseen<Input>}.special(),
      Mode<Input>{"fatigue", "fatigue due to starts and stops", &unseen<Input>}.special(),
      Mode<Input>{"vibration", "vibration of disc and blades", &unseen<Input>}.special(),
      Mode<Input>{"brittle", "brittle fracture", &unseen<Input>}.special(),
      Mode<Input>{"heat", "thermal stress and creep", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Disc::Form) {
  using Form = Disc::Form;
  return std::array{ChoiceName<Form>{Form::disc, "disc", "disc or ring, thin along the axis: plane stress"},
                    ChoiceName<Form>{Form::cylinder, "cylinder", "long cylinder with free ends"}};
}

}  // namespace loadpath::machine
