// A link of a mechanism under normal force, shear force and bending moment: yield, buckling with bending.
//
// Decides the extreme fibre under N and M_b, the neutral axis under N and V, buckling about both axes as
// column.buckling does, and buckling with bending: in the plane of motion by the secant formula, whose eccentricity
// is M_b/|N|, and by the sum of buckling about the weaker axis and of the bending stress that the compression raises.
// M_b bends the link about y, in the plane of its height h. It counts as constant along the link, which bounds every
// other moment of hinged ends and of a link built in at one end; N, V and M_b each with the largest size along the
// link, as mechanisms give them, and as if at one place. The moment has the safety of yield, the compression that of
// buckling. A rectangle on edge is judged against tilting sideways too. N is positive in tension. Not covered:
// bending out of the plane, sections of class 4, open sections that twist, curved links, what holes take away.
#pragma once

#include "calculators/column/buckling.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/quantity/drive_units.hpp"

namespace loadpath::link {

/// Its largest stress, an input record of fatigue.cycle: cycle = "=rod.cycle". The cycle type is given there.
struct LinkCycle {
  Stresses stress = Stresses::normal;
  Stress sigma_max = unset<Stress>, E = unset<Stress>;

  static constexpr Fields fields{
      Choice{&LinkCycle::stress, "stress", "stress component: normal or shear"},
      Field{&LinkCycle::sigma_max, "sigma_max", MPa, "maximum nominal stress, magnitude"}.load(),
      Field{&LinkCycle::E, "E", GPa, "modulus of elasticity, identifies the metal"}};
};

struct Member {
  static constexpr auto id = "link.member";
  static constexpr auto title = "Link under axial force, shear and bending";
  static constexpr auto scope =
      "Yielding of a uniform link under N, V and M_b from a mechanism, flexural buckling about both axes by "
      "the chosen method, and buckling with bending by the secant formula in the plane of motion and by "
      "summation out of it; holes, curved links and out-of-plane bending are not covered.";
  static constexpr auto source = "[Gere], [Mises], [B25], [EN1993-1-1-LTB], [Narrow-beam]";
  static constexpr auto headline = "{section}|d = {d}|A = {A}";
  static constexpr auto subject = "strength and buckling";
  static constexpr auto synonyms =
      "link, connecting rod, rod, rocker, beam-column, combined bending and compression, buckling, internal forces, "
      "two-force member, Pleuel, Koppel, Stab, Biegung mit Druck, Knicken, звено, шатун, коромысло, "
      "сжато-изогнутый стержень";
  static constexpr auto example = R"([project]
title = "Connecting rod"

[rod]
calculator = "link.member"
N = "-18 kN"
V = "0.4 kN"
M_b = "60 N*m"
l = "400 mm"
h = "40 mm"
b = "20 mm"
ends_y = "pinned_pinned"
ends_z = "fixed_fixed"
beta_basis = "recommended"
E = "210 GPa"
R_e = "355 MPa"
method = "johnson"
n_st = 3
S = 1.5
)";

  struct Input : column::Buckling::Input {
    Force V = unset<Force>;
    Moment M_b = unset<Moment>;
    Area A_v = unset<Area>;
    double S = unset<double>;
    Acceleration a_m = unset<Acceleration>;
    Density rho = unset<Density>;
  };
  static constexpr auto inputs = join(
      column::held_inputs<Input>(),
      Fields{Field<Input, Force>{&Input::V, "V", kN, "shear force in the plane of motion, magnitude"}.load(),
             Field<Input, Moment>{&Input::M_b, "M_b", N_m, "bending moment about y, in the plane of motion, magnitude"}
                 .load()},
      column::section_inputs<Input>(),
      Fields{
          Field<Input, Area>{&Input::A_v, "A_v", mm2, "effective shear area; known for a round bar, tube or rectangle"}
              .positive()
              .may_be_missing()},
      column::strength_inputs<Input>(), column::tetmajer_inputs<Input>(), column::derived_section_inputs<Input>(),
      column::method_choice<Input>(), column::code_inputs<Input>(),
      Fields{
          Field<Input, double>{&Input::S, "S", ratio, "required safety factor against yielding, under N, V and M_b"}
              .at_least(1)
              .usually(1.1, 6)
              .customarily_at_least(1.1)
              .may_be_missing()
              .factor(),
          Field<Input, Acceleration>{&Input::a_m, "a_m", m_per_s2,
                                     "acceleration of the axis, if N, V and M_b do not include its inertia forces"}
              .at_least(0)
              .may_be_missing(),
          Field<Input, Density>{&Input::rho, "rho", kg_per_m3, "density, for these inertia forces; omitted: of steel"}
              .positive()
              .usually(500, 2e4)
              .from("material", "rho")
              .where_it_has()});

  struct Result : column::MemberResult {
    Stress sigma_N = unset<Stress>, sigma_M = unset<Stress>, sigma_o = unset<Stress>, sigma_u = unset<Stress>,
           tau = unset<Stress>;
    double k = unset<double>, u_y = unset<double>, u_Q = unset<double>, u_p = unset<double>, u_i = unset<double>;
    double chi_t = unset<double>, u_t = unset<double>;
    LinkCycle cycle;
    double x_m = unset<double>;
  };
  static constexpr auto results = join(
      Fields{Field<Result, Stress>{&Result::sigma_N, "sigma_N", MPa, "axial stress, tension positive"}.with("sigma_M"),
             Field<Result, Stress>{&Result::sigma_M, "sigma_M", MPa, "bending stress at the extreme fibre"}.with(
                 "sigma_N"),
             Field<Result, Stress>{&Result::sigma_o, "sigma_o", MPa,
                                   "stress at the fibre in tension under a positive moment"},
             Field<Result, Stress>{&Result::sigma_u, "sigma_u", MPa,
                                   "stress at the fibre in compression under a positive moment"},
             Field<Result, Stress>{&Result::tau, "tau", MPa, "maximum shear stress"},
             Field<Result, double>{&Result::k, "k", ratio,
                                   "amplification factor of the moment by the compression at its safety factor"}},
      column::slenderness_results<Result>(), column::stress_results<Result>(),
      Fields{Field<Result, double>{&Result::u_y, "u_y", ratio,
                                   "yielding of the extreme fibre: S x stress / yield strength"}
                 .check("S"),
             Field<Result, double>{&Result::u_Q, "u_Q", ratio,
                                   "yielding at the neutral axis: S x equivalent stress / yield strength"}
                 .check("S")
                 .where_it_applies()},
      column::buckling_check<Result>(),
      Fields{Field<Result, double>{
                 &Result::u_p, "u_p", ratio,
                 "buckling with bending in plane: force / allowable force of the secant formula; 0 in tension"}
                 .check("n_st, gamma_M1, Omega_c"),
             Field<Result, double>{&Result::u_i, "u_i", ratio,
                                   "sum of weak-axis buckling and bending utilisations; 0 in tension"}
                 .check("n_st, gamma_M1, Omega_c"),
             Field<Result, double>{&Result::chi_t, "chi_t", ratio,
                                   "lateral-torsional buckling reduction factor of the moment, rectangle on edge"},
             Field<Result, double>{&Result::u_t, "u_t", ratio,
                                   "lateral-torsional buckling of a rectangle on edge, combined with flexural buckling"}
                 .check("S, n_st, gamma_M1, Omega_c")
                 .where_it_applies()},
      column::slenderness_limits<Result>(), column::wall_limits<Result>(),
      Fields{Group<Result, LinkCycle>{&Result::cycle, "cycle",
                                      "maximum nominal stress of the link, for fatigue.cycle: cycle"}
                 .handed_over()},
      Fields{Field<Result, double>{&Result::x_m, "x_m", ratio,
                                   "own inertia: S x stress / yield strength (beyond 0.1 give the link its mass)"}
                 .limit(0, 0.1)
                 .where_it_applies()},
      column::side_by_side<Result>());

  static bool force_given(const Input& in);
  static bool fibre_known(const Input& in);
  static bool shear_inside(const Input& in);
  static double most_shear_area(const Input& in);
  static double least_moment(const Input& in);
  static Applies without_mass(const Input& in);
  static double amount(const Input& in) { return in_si(column::area_of(in)); }
  static bool ends_in_plane(const Input& in);
  static bool is_lean(const Input& in);
  static Applies loaded(const Input& in);
  static Applies sheared(const Input& in);
  static Applies compressed_and_bent(const Input& in);
  static Applies walls_pressed(const Input& in);
  static bool is_on_edge(const Input& in);
  static Applies twisting_when_bent(const Input& in);

  static constexpr auto rules = join(
      column::held_rules<Input>(),
      column::section_rules<Input, &column::Buckling::section_given, &column::Buckling::section_missing,
                            &column::Buckling::radii_fit>(),
      std::array{
          Rule<Input>{&force_given, "N, P", "give the normal force N, positive in tension, or P in compression"},
          Rule<Input>{[](const Input& in) { return is_set(in.R_e); }, "R_e",
                      "a link with bending is assessed by its yield strength: give R_e, or a material"},
          Rule<Input>{[](const Input& in) { return in.method != column::Method::secant; }, "method",
                      "the secant formula is used for the moment in any case: choose another buckling method"},
          Rule<Input>{&ends_in_plane, "ends_y, ends, beta_y, supports_y",
                      "in the plane of motion a link is pinned at both ends, or fixed at one: ends_y = "
                      "\"pinned_pinned\" or \"fixed_free\"; out of plane ends_z"},
          Rule<Input>{&fibre_known, "c_y, h, d, kind",
                      "bending needs the distance of the extreme fibre c_y, or h (for a tee or an angle c_y)"},
          Rule<Input>{&column::of<Input, &column::Buckling::needs_of_method>,
                      "method, R_e, sigma_P, a_T, n_st, gamma_M1, gamma_F, kind, curve_y, curve_z, A, h, b, t_f",
                      "an input of the method is missing", &column::of<Input, &column::Buckling::missing_for_method>}},
      std::array{Rule<Input>{&shear_inside, "A_v, A, d, d_bore, h, b", "the shear area cannot exceed the area"}},
      column::method_rules<Input>(), column::assumption_rules<Input, &column::method_of>());
  static constexpr auto bounds =
      join(column::held_bounds<Input>(), column::curve_bounds<Input>(),
           std::array{Bound<Input>{"A_v", "the section, EN 1993-1-1 6.2.6", &most_shear_area},
                      Bound<Input>{"M_b", "V, evenly distributed over l", &least_moment}.least()});

  static constexpr std::array modes{
      Mode<Input>{"yield", "yielding under N and M_b", &loaded}.judged_by("u_y"),
      Mode<Input>{"shear", "shear yielding under N and V", &sheared}.judged_by("u_Q").wanting("S, A_v"),
      Mode<Input>{"buckling", "flexural buckling about y and z", &column::compressed<Input>}.judged_by("u, r_1"),
      Mode<Input>{"bent", "bending and axial compression", &compressed_and_bent}.judged_by("u_p, u_i"),
      Mode<Input>{"slenderness", "slenderness limit", &column::compressed<Input>}.judged_by("r_lambda").at_any_load(),
      Mode<Input>{"local", "local buckling (class 3 limit)", &walls_pressed}
          .judged_by("r_class, x_E")
          .wanting("kind, h, b, t_f, t_w"),
      Mode<Input>{"torsional", "torsional and torsional-flexural buckling",
                  &column::twisting<Input, &column::Buckling::outline_of, true>},
      Mode<Input>{"lateral_torsional", "lateral-torsional buckling", &twisting_when_bent}.judged_by("u_t").wanting("S"),
      Mode<Input>{"net_section", "net section rupture (holes, pins)", &unseen<Input>}.assessed_additionally_in(
          "pin.lug"),
      Mode<Input>{"fatigue", "fatigue (holes, section changes)", &unseen<Input>}
          .left_to("fatigue.cycle", "cycle.fatigue")
          .or_counted_by("fatigue.history", "sigma_o, sigma_u")
          .in_service(),
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"inertia", "inertia forces of a link without mass", &without_mass}.judged_by("x_m"),
      Mode<Input>{"weight", "bending due to self-weight", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::link
