// A thin-walled section in torsion: one cell or several that share walls, open branches, or both.
//
// Decides the flow of shear of every cell by Bredt: all cells twist alike, n linear equations; to its torsion
// constant the walls add that of thin strips, l t^3/3, and the sum of only these is that of the section slit open.
// Stress of a wall: the flow over its thickness, which books give, and at its surface what it has of its own twist
// more. Each wall may have a shear modulus of its own. Saint-Venant: the section is free to warp and keeps its shape.
// Not covered: warping that is held, distortion, stress at inner corners and welds, buckling, fatigue, bending.
#pragma once

#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "calculators/section/torsion/thin_walled_types.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::section {

/// Thickness over 2 A/U of a cell: of a square tube a quarter of its middle line, where a finite-difference solution
/// has 6 % more I_t and 0.6 % more W_t; and over the length of a free wall, where the series of the rectangle has 6 %
/// less.
inline constexpr double thickest_of_cell = 0.5, thickest_free_wall = 0.1;

struct ThinWalled : ThinWalledTypes {
  static constexpr auto id = "section.thin_walled";
  static constexpr auto title = "Torsion of a thin-walled section";
  static constexpr auto scope =
      "Torsion constant, shear flow, wall stresses and twist of a thin-walled single- or multi-cell section "
      "with open branches, compared with the same section slit open; restrained warping, distortion, "
      "re-entrant corners, buckling and fatigue are not covered.";
  static constexpr auto source = "[Bredt], [Megson]";
  static constexpr auto headline = "I_t = {I_t}";
  static constexpr auto subject = "torsion";
  static constexpr auto synonyms =
      "thin-walled section, Bredt, shear flow, closed section, multi-cell, box girder torsion, open section, "
      "torsion constant, Bredtsche Formel, Schubfluss, dünnwandiger Querschnitt, geschlossenes Profil, "
      "тонкостенное сечение, формула Бредта, поток касательных напряжений";
  static constexpr auto example = R"([project]
title = "Box girder of two cells with a lip"

[girder]
calculator = "section.thin_walled"
T = "18 kN*m"
cells = [
  { name = "nose", points = [["0 mm", "0 mm"], ["150 mm", "0 mm"], ["150 mm", "200 mm"], ["0 mm", "200 mm"]] },
  { name = "box", A = "60000 mm^2" },
]
walls = [
  { name = "front", cell = "nose", points = [["150 mm", "200 mm"], ["0 mm", "200 mm"], ["0 mm", "0 mm"], ["150 mm", "0 mm"]], t = "4 mm" },
  { name = "web", cell = "nose", beside = "box", l = "200 mm", t = "6 mm" },
  { name = "top", cell = "box", l = "300 mm", t = "6 mm" },
  { name = "bottom", cell = "box", l = "300 mm", t = "6 mm" },
  { name = "rear", cell = "box", l = "200 mm", t = "5 mm" },
  { name = "lip", l = "60 mm", t = "5 mm" },
]
G = "80 GPa"
R_e = "235 MPa"
S = 2
theta_adm = "0.5 deg/m"
)";

  static constexpr auto inputs =
      join(Fields{Field{&Input::T, "T", N_m, "torque"}.load(),
                  Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the torque includes it)"}
                      .at_least(1)
                      .usually(1, 4)
                      .factor(),
                  ListField{&Input::cells, "cells", "closed cells"}.may_be_missing(),
                  ListField{&Input::walls, "walls", "outer walls, walls between cells and open branches"},
                  Field{&Input::G, "G", GPa, "shear modulus of walls without their own, for the twist"}
                      .positive()
                      .usually(least_G, most_G)
                      .from("material", "G")},
           shear_strength_inputs<Input>("t_max"),
           Fields{Field{&Input::theta_adm, "theta_adm", deg_per_m, "allowable angle of twist per unit length"}
                      .positive()
                      .usually(0.02, 10)
                      .may_be_missing()});

  static constexpr Fields results{
      Field{&Result::I_B, "I_B", mm4, "torsion constant of the cells, by Bredt"},
      Field{&Result::I_s, "I_s", mm4, "torsion constant of the walls as strips: of the section slit open"},
      Field{&Result::I_t, "I_t", mm4, "torsion constant of the section"},
      Field{&Result::W_t, "W_t", mm3, "torsional section modulus: torque / maximum shear stress"},
      Field{&Result::W_s, "W_s", mm3, "the same of the section slit open"},
      Field{&Result::r_I, "r_I", ratio, "stiffness ratio to the open (slit) section"},
      Field{&Result::t_max, "t_max", mm, "thickest wall, which the strength of the material belongs to"},
      Field{&Result::tau_max, "tau_max", MPa, "maximum shear stress"},
      Field{&Result::tau_s, "tau_s", MPa, "maximum shear stress of the section slit open"},
      Field{&Result::theta, "theta", deg_per_m, "angle of twist per unit length, positive like T"},
      Field{&Result::w, "w", ratio, "walls of cells: thickness over 2 A/U of the cell, maximum"}
          .limit(0, thickest_of_cell)
          .where_it_applies(),
      Field{&Result::w_s, "w_s", ratio, "free walls: thickness over length, maximum"}
          .limit(0, thickest_free_wall)
          .where_it_applies(),
      Field{&Result::u_tau, "u_tau", ratio, "strength: shear stress / allowable shear stress, maximum of the walls"}
          .check(),
      Field{&Result::u_theta, "u_theta", ratio, "stiffness: angle of twist per unit length / allowable angle"}.check(
          "theta_adm"),
      Group{&Result::cycle, "cycle", "maximum stress of the section, for fatigue.cycle: cycle"}.handed_over(),
      ListField{&Result::cells, "cells", "cells"},
      ListField{&Result::walls, "walls", "walls"}};

  static bool sizes_given(const Input& in);
  static bool cells_known(const Input& in);
  static FieldFault unknown_cell(const Input& in);
  static bool cells_once(const Input& in);
  static bool cells_close(const Input& in);
  static FieldFault open_cell(const Input& in);
  static bool no_islands(const Input& in);
  static FieldFault island(const Input& in);
  static bool outlines_apart(const Input& in);
  static FieldFault covered_twice(const Input& in);
  static bool areas_fit(const Input& in);
  static FieldFault too_much_area(const Input& in);
  static bool outlines_fit(const Input& in);
  static bool one_strength(const Input& in);
  static bool moduli_fit(const Input& in);
  static Applies brittle(const Input& in);
  static Applies tough(const Input& in);
  static Applies loaded(const Input& in);
  static Applies slender(const Input& in);

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.walls.empty(); }, "walls", "a section needs at least one wall"},
      Rule<Input>{
          &sizes_given, "cells, walls",
          "give the area of a cell as A or by three points or more, the length of a wall as l or by two or more"},
      Rule<Input>{&cells_once, "cells", "each cell needs a different name"},
      Rule<Input>{&cells_known, "walls, cells", "a wall must name its cell, and the adjacent cell if there is one",
                  &unknown_cell},
      Rule<Input>{&cells_close, "cells, walls",
                  "a cell needs walls, and at least one of its walls or of adjacent cells borders on the outside",
                  &open_cell},
      Rule<Input>{&no_islands, "cells, walls", "cells must lie side by side", &island},
      Rule<Input>{&outlines_apart, "cells", "the outlines of cells must not cross or overlap", &covered_twice},
      Rule<Input>{&areas_fit, "cells, walls", "a cell must not be larger than a circle of the same perimeter",
                  &too_much_area},
      Rule<Input>{&outlines_fit, "cells, walls", "the walls of a cell must be as long as its outline by points",
                  nullptr, true},
      Rule<Input>{&one_strength, "tau_adm, sigma_adm, behaviour, S, R_e",
                  "give one of them: tau_adm; sigma_adm with behaviour; S with the yield strength R_e (or a material)"},
      Rule<Input>{&moduli_fit, "walls, G",
                  "a wall with its own G is of another material: give its tau_adm, and the G of the others"},
      Rule<Input>{[](const Input& in) { return !is_set(in.theta_adm) || is_set(in.G); }, "theta_adm, G",
                  "theta_adm needs the shear modulus G (or a material)"}};

  static constexpr std::array meanings{all_in_shear, all_in_normal, Meaning{"walls.tau_adm", allowable_in_shear}};
  static constexpr std::array modes{
      Mode<Input>{"yield", "yielding in torsion", &tough}.judged_by("u_tau, w, w_s"),
      Mode<Input>{"fracture", "brittle fracture in torsion", &brittle}.judged_by("u_tau, w, w_s"),
      Mode<Input>{"twist", "angle of twist per unit length", &loaded}.judged_by("u_theta, w, w_s").of_service(),
      Mode<Input>{"buckling", "shear buckling of walls", &slender},
      Mode<Input>{"corners", "stress concentration at corners, welds, holes", &unseen<Input>},
      Mode<Input>{"warping", "restrained warping stress", &unseen<Input>},
      Mode<Input>{"distortion", "cross-section distortion", &unseen<Input>},
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"fatigue", "fatigue (welds, corners)", [](const Input& in) { return shown_by(in.K_A > 1.0); }}
          .in_service()
          .left_to("fatigue.cycle", "cycle.fatigue")};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::section
