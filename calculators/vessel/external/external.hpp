// A thin cylinder or sphere under external pressure: elastic and inelastic buckling.
//
// Decides the allowable external pressure by [VIII-2-4.4], 4.4.5 and 4.4.7: elastic buckling stress of a shell within
// the tolerances of roundness of that code, inelastic buckling, design factor from 2 down to 1.667. For comparison the
// elastic critical pressure of the perfect shell: of a cylinder by von Mises, with the number of its lobes, and by
// Windenburg and Trilling, both with ends that are held round, of a sphere by Zoelly. Sizes are those of the corroded
// wall. Not covered: rings themselves, heads, cones, axial force and bending, openings, internal pressure, creep.
#pragma once

#include "calculators/vessel/modes.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::vessel {

struct External {
  static constexpr auto id = "vessel.external";
  static constexpr auto title = "Cylinder or sphere under external pressure";
  static constexpr auto scope =
      "Buckling and yielding of a thin cylinder between lines of support, or of a sphere, under external pressure by "
      "ASME "
      "VIII-2, 4.4, and elastic critical pressures; rings, heads, axial forces, openings and creep are not covered.";
  static constexpr auto source = "[VIII-2-4.4], [Mises-tube], [Windenburg], [Zoelly]";
  static constexpr auto headline = "wall {delta}";
  static constexpr auto subject = "external pressure";
  static constexpr auto synonyms =
      "external pressure, vacuum vessel, vacuum, collapse, shell buckling, critical pressure, Windenburg and Trilling, "
      "submarine hull, pressure hull, tube under external pressure, lobes, Außendruck, Vakuumbehälter, Schalenbeulen, "
      "Beuldruck, Einbeulen, наружное давление, вакуумный сосуд, устойчивость оболочки";
  static constexpr auto example = R"([project]
title = "Vacuum vessel"

[shell]
calculator = "vessel.external"
p_e = "0.1 MPa"
D_a = "1200 mm"
L = "2400 mm"
c = "1 mm"
material = "P265GH"
)";

  enum class Shape { cylinder, sphere };

  struct Input {
    Stress p_e = unset<Stress>;
    Shape shape = Shape::cylinder;
    Length D_a = unset<Length>, L = unset<Length>, delta = unset<Length>;
    Length c = from_si<Length>(0.0), c_t = from_si<Length>(0.0);
    double f_t = 0.0;
    Stress E = unset<Stress>, R_e = unset<Stress>;
    double nu = 0.3;
  };
  static constexpr Fields inputs{
      RecordField<Input>{"wall", "wall of a cylindrical vessel: wall = \"=tank.wall\""},
      Field{&Input::p_e, "p_e", MPa, "external minus internal pressure; full vacuum: 0.1 MPa"}
          .load()
          .positive()
          .usually(0.001, 100),
      Choice{&Input::shape, "shape", "shape of the shell: cylinder or sphere"}.may_be_missing(),
      Field{&Input::D_a, "D_a", mm, "outside diameter"}.positive().usually(10, 20000),
      Field{&Input::L, "L", mm, "length between lines of support: rings, or heads with a third of their depths"}
          .positive()
          .usually(10, 100000)
          .may_be_missing(),
      Field{&Input::delta, "delta", mm, "nominal wall thickness"}
          .positive()
          .usually(0.5, 400)
          .searched("plate")
          .may_be_missing(),
      Field{&Input::c, "c", mm, "corrosion allowance"}.at_least(0).usually(0, 10),
      Field{&Input::c_t, "c_t", mm, "mill under-tolerance of the plate"}.at_least(0).usually(0, 3),
      Field{&Input::f_t, "f_t", ratio, "mill under-tolerance as a share of delta; 0.125 for pipes"}.at_least(0).below(
          0.5),
      Field{&Input::E, "E", GPa, "modulus of elasticity at the temperature in service"}
          .positive()
          .usually(least_E, most_E)
          .from("material", "E"),
      Field{&Input::R_e, "R_e", MPa, "yield strength at the temperature in service"}
          .positive()
          .usually(50, 1100)
          .customarily_at_most(960)
          .from("material", "R_e", "delta"),
      Field{&Input::nu, "nu", ratio, "Poisson's ratio"}.at_least(0).below(0.5).usually(0.2, 0.4)};

  struct Result {
    Length e = unset<Length>;
    double M_x = unset<double>, C_h = unset<double>;
    Stress F_he = unset<Stress>, F_ic = unset<Stress>;
    double FS = unset<double>;
    Stress p_a = unset<Stress>, p_k = unset<Stress>, p_cr = unset<Stress>, p_WT = unset<Stress>;
    double n = unset<double>, u_e = unset<double>, x_D = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::e, "e", mm, "analysis thickness: corroded, under-tolerance deducted"},
      Field{&Result::M_x, "M_x", ratio, "length over the root of outside radius and thickness"},
      Field{&Result::C_h, "C_h", ratio, "buckling coefficient of a cylinder"},
      Field{&Result::F_he, "F_he", MPa, "elastic buckling limit of the hoop stress, imperfections included"},
      Field{&Result::F_ic, "F_ic", MPa, "buckling limit of the hoop stress, elastic or inelastic"},
      Field{&Result::FS, "FS", ratio, "design factor of the code"},
      Field{&Result::p_a, "p_a", MPa, "allowable external pressure"},
      Field{&Result::p_k, "p_k", MPa, "external pressure at the buckling limit, without design factor"},
      Field{&Result::p_cr, "p_cr", MPa, "elastic critical pressure of the perfect shell"},
      Field{&Result::n, "n", ratio, "lobes around the circumference at the buckling pressure"},
      Field{&Result::p_WT, "p_WT", MPa, "elastic critical pressure by Windenburg and Trilling"},
      Field{&Result::u_e, "u_e", ratio, "buckling: external pressure / allowable external pressure"}.check(),
      Field{&Result::x_D, "x_D", ratio, "outside diameter / analysis thickness"}.limit(20, 2000)};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return (in.shape == Shape::cylinder) == is_set(in.L); }, "shape, L",
                  "a cylinder needs its length L between lines of support; a sphere has none"},
      Rule<Input>{[](const Input& in) { return is_set(in.E) && is_set(in.R_e); }, "E, R_e",
                  "give E and R_e, or a material"},
      Rule<Input>{[](const Input& in) { return in.c_t == 0.0 * mm || in.f_t == 0.0; }, "c_t, f_t",
                  "give the under-tolerance as c_t or as f_t, not both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.delta) || in.delta * (1.0 - in.f_t) > in.c + in.c_t; },
                  "delta, c, c_t, f_t", "the wall must be thicker than its allowances"},
      Rule<Input>{[](const Input& in) { return !is_set(in.delta) || 2.0 * in.delta < in.D_a; }, "delta, D_a",
                  "the wall must be thinner than the outside radius"}};

  static constexpr Applies has_ends(const Input& in) {
    return in.shape == Shape::cylinder ? Applies::unseen : Applies::no;
  }
  static constexpr std::array meanings{Meaning{"R_e", yield_strength}};
  static constexpr std::array modes{
      Mode<Input>{"buckling", "buckling under external pressure", &always<Input>}.judged_by("u_e, x_D"),
      Mode<Input>{"ends", "buckling of the ends", &has_ends}.of_service(),
      Mode<Input>{"rings", "strength and stiffness of reinforcing rings", &has_ends}.special(),
      Mode<Input>{"roundness", "out-of-roundness beyond the tolerance of the code", &unseen<Input>}.special(),
      Mode<Input>{"axial", "axial compression and bending of the shell", &unseen<Input>}.special(),
      Mode<Input>{"nozzles", "reinforcement of openings and nozzles", &unseen<Input>}.special(),
      Mode<Input>{"inside", "yielding under internal pressure", &unseen<Input>}.special(),
      Mode<Input>{"creep", "creep at elevated temperature", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(External::Shape) {
  using Shape = External::Shape;
  return std::array{ChoiceName<Shape>{Shape::cylinder, "cylinder", "cylinder between lines of support"},
                    ChoiceName<Shape>{Shape::sphere, "sphere", "sphere"}};
}

}  // namespace loadpath::vessel
