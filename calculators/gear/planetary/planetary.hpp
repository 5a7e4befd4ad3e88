// A simple planetary gear set: sun, planets on a carrier, ring.
//
// Decides the speeds of all members by Willis, their torques with losses by the direction of the rolling power, the
// powers and the efficiency; whether the planets can be put in evenly, have clearance to each other, and lie on one
// circle. Signs: speeds and torques are positive in one direction of rotation; a torque is what acts on the member
// from outside, so power enters where T n > 0. Losses: eta_0 of the set with the carrier at rest, from sun to ring or
// back alike; bearings, seals and churning are not covered. Sun and planet, planet and ring mesh as gear.pair has it:
// the sun with its planet without backlash, the ring with the shift for the same centre distance. Planets are spaced
// as evenly as integer assembly steps allow; those that touch each other, or that the ring interferes with, fail.
#pragma once

#include "calculators/gear/planetary/mesh_of_set.hpp"
#include "calculators/gear/planetary/types.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <cstdlib>
#include <vector>

namespace loadpath::gear {

struct Planetary : PlanetaryTypes {
  static constexpr auto id = "gear.planetary";
  static constexpr auto title = "Planetary gear set";
  static constexpr auto scope =
      "Speeds, torques, powers and efficiency of sun, carrier and ring by Willis with any member fixed or "
      "none, assembly conditions and mesh geometry of sun, planets and ring; losses are tooth losses only; "
      "tooth strength is not covered.";
  static constexpr auto source = "[Willis], [Mueller]";
  static constexpr auto headline = "z {z_s}/{z_p}/{z_r}";
  static constexpr auto synonyms =
      "planetary gear, epicyclic gear, sun gear, ring gear, carrier, planet, Willis equation, assembly condition, "
      "efficiency, Planetengetriebe, Umlaufgetriebe, Sonnenrad, Hohlrad, Planetenträger, gear, "
      "планетарная передача, планетарный механизм, сателлит, водило";
  static constexpr auto example = R"([project]
title = "Planetary stage of a winch"

[winch]
calculator = "gear.planetary"
z_s = 24
z_p = 30
z_r = 84
N_p = 3
fixed = "ring"
n_s = "1450 rpm"
T_s = "50 N*m"
eta_0 = 0.97
h_ar = 0.9
)";

  static constexpr double most_shifted = 4.0;  // teeth that profile shift can still correct

  static bool speeds_determined(const Input& in);
  static FieldFault wrong_speeds(const Input& in);
  static constexpr Fields inputs{
      Count{&Input::z_s, "z_s", 5, 1000, "number of teeth of the sun"},
      Count{&Input::z_p, "z_p", 5, 1000, "number of teeth of a planet"},
      Count{&Input::z_r, "z_r", 10, 3000, "number of teeth of the ring gear; omitted: z_s + 2 z_p"}.may_be_missing(),
      Count{&Input::N_p, "N_p", 1, 20, "number of planets"}.may_be_missing(),
      Choice{&Input::fixed, "fixed", "fixed member"}.may_be_missing(),
      Field{&Input::n_s, "n_s", rpm, "speed of the sun, signed"}.may_be_missing(),
      Field{&Input::n_c, "n_c", rpm, "speed of the carrier, signed"}.may_be_missing(),
      Field{&Input::n_r, "n_r", rpm, "speed of the ring, signed"}.may_be_missing(),
      Field{&Input::T_s, "T_s", N_m, "external torque on the sun, signed"}.load().may_be_missing(),
      Field{&Input::T_c, "T_c", N_m, "external torque on the carrier, signed"}.load().may_be_missing(),
      Field{&Input::T_r, "T_r", N_m, "external torque on the ring gear, signed"}.load().may_be_missing(),
      Field{&Input::eta_0, "eta_0", ratio, "basic efficiency, carrier at rest; omitted: no losses"}
          .within(0.5, 1)
          .usually(0.94, 0.99)
          .customarily_at_least(0.88)
          .may_be_missing(),
      Field{&Input::h_aP, "h_aP", ratio, "tooth addendum, in modules"}.within(0.3, 2),
      Field{&Input::x_s, "x_s", ratio, "profile shift coefficient of the sun"}.within(-3, 3),
      Field{&Input::x_p, "x_p", ratio, "profile shift coefficient of the planets; that of the ring gear follows"}
          .within(-3, 3),
      Field{&Input::h_ar, "h_ar", ratio, "addendum of the ring gear, in modules; omitted: as the other gears"}
          .within(0, 2)
          .may_be_missing(),
      Field{&Input::m_n, "m_n", mm, "normal module, for the tooth force"}.positive().usually(0.2, 50).may_be_missing(),
      Field{&Input::beta, "beta", deg, "helix angle"}.within(0, 45),
      Field{&Input::K_gamma, "K_gamma", ratio, "mesh load factor: load of the most loaded planet / mean load"}
          .at_least(1)
          .usually(1, 1.6)
          .factor()};

  static constexpr Fields results{
      Field{&Result::z_r, "z_r", ratio, "number of teeth of the ring gear"},
      Field{&Result::i_0, "i_0", ratio, "basic ratio: sun / ring gear, carrier at rest"},
      Field{&Result::n_s, "n_s", rpm, "speed of the sun"},
      Field{&Result::n_c, "n_c", rpm, "speed of the carrier"},
      Field{&Result::n_r, "n_r", rpm, "speed of the ring"},
      Field{&Result::n_p, "n_p", rpm, "speed of a planet"},
      Field{&Result::n_pc, "n_pc", rpm, "speed of a planet relative to the carrier"},
      Field{&Result::i, "i", ratio,
            "ratio with one member fixed: sun/carrier, sun/ring gear, or ring gear/carrier (sun fixed)"},
      Field{&Result::T_s, "T_s", N_m, "external torque on the sun"}.load(),
      Field{&Result::T_c, "T_c", N_m, "external torque on the carrier"}.load(),
      Field{&Result::T_r, "T_r", N_m, "external torque on the ring gear"}.load(),
      Field{&Result::P_s, "P_s", kW, "power into the sun, negative out of it"},
      Field{&Result::P_c, "P_c", kW, "power into the carrier, negative out of it"},
      Field{&Result::P_r, "P_r", kW, "power into the ring, negative out of it"},
      Field{&Result::P_w, "P_w", kW, "rolling power, positive from sun to ring; it causes the losses"},
      Field{&Result::P_in, "P_in", kW, "input power"},
      Field{&Result::P_loss, "P_loss", kW, "power loss"},
      Field{&Result::eta, "eta", ratio, "efficiency"},
      Field{&Result::F_t, "F_t", N, "tangential force at the sun, most loaded planet"}.load(),
      Field{&Result::q, "q", ratio, "(z_s + z_r)/N_p; an integer for even spacing"},
      Choice{&Result::spacing, "spacing", "assembly condition of the planets"},
      Field{&Result::phi_2, "phi_2", deg, "position of the second planet nearest to even spacing"},
      Field{&Result::h_clear, "h_clear", ratio,
            "maximum addendum of the ring gear without interference with the planet fillets"},
      Choice{&Result::coaxial, "coaxial", "coaxiality of sun, planet and ring gear"},
      Field{&Result::z_gap, "z_gap", ratio, "coaxiality: z_r - z_s - 2 z_p, which profile shift can correct"}.limit(
          -most_shifted, most_shifted),
      Field{&Result::u_N, "u_N", ratio, "planet clearance: tip diameter / distance of adjacent planet axes"}.check(),
      Field{&Result::f_sp, "f_sp", ratio, "interference of sun and planet: minimum clearance, in modules"}
          .limit(-0.01, 1e4)
          .criterion()
          .where_it_applies(),
      Field{&Result::f_pr, "f_pr", ratio,
            "interference of planet and ring gear: minimum clearance, in modules (clear up to h_ar = h_clear)"}
          .limit(-0.01, 1e4)
          .criterion()
          .where_it_applies(),
      Field{&Result::eps_sp, "eps_sp", ratio, "transverse contact ratio of sun and planet"}
          .limit(1, 100)
          .criterion()
          .where_it_applies(),
      Field{&Result::eps_pr, "eps_pr", ratio, "transverse contact ratio of planet and ring gear"}
          .limit(1, 100)
          .criterion()
          .where_it_applies(),
      Field{&Result::x_free, "x_free", ratio,
            "undercut: minimum margin of profile shift of sun and planet to the undercut limit (-0.02 "
            "is harmless)"}
          .limit(-0.02, 100)
          .criterion(),
      Field{&Result::c_a, "c_a", ratio, "tip clearance: minimum of both meshes, in modules"}
          .limit(-1e-6, 100)
          .criterion()
          .where_it_applies(),
      Field{&Result::s_a, "s_a", ratio, "tip thickness: minimum in modules (0.2; case-hardened 0.4)"}
          .limit(0.2, 100)
          .criterion()
          .where_it_applies(),
      Group{&Result::sun_mesh, "sun_mesh", "mesh of the sun with the most loaded planet, for gear.pair: pair"}
          .handed_over(),
      Group{&Result::ring_mesh, "ring_mesh", "mesh of the most loaded planet with the ring gear, for gear.pair: pair"}
          .handed_over(),
      Group{&Result::gear_s, "gear_s", "sun with its torque and root circle, for the connection to its shaft: load"}
          .handed_over()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return ring_teeth(in) > in.z_p && ring_teeth(in) > in.z_s; }, "z_r, z_s, z_p",
                  "the ring gear must have more teeth than sun and planet"},
      Rule<Input>{&speeds_determined, "fixed, n_s, n_c, n_r", "give one speed if a member is fixed, otherwise two",
                  &wrong_speeds},
      Rule<Input>{[](const Input& in) { return in.N_p <= in.z_s + ring_teeth(in); }, "N_p, z_s, z_r",
                  "N_p must not exceed z_s + z_r"},
      Rule<Input>{[](const Input& in) { return is_set(in.T_s) + is_set(in.T_c) + is_set(in.T_r) <= 1; },
                  "T_s, T_c, T_r", "give one of T_s, T_c, T_r; the others follow"},
      Rule<Input>{&evenly_spaced, "z_s, z_r, N_p",
                  "(z_s + z_r)/N_p is not an integer: the planets can be assembled, but not evenly spaced", nullptr,
                  true},
      Rule<Input>{[](const Input& in) {
                    const double gap = ring_teeth(in) - in.z_s - 2 * in.z_p;
                    return gap == 0 || std::abs(gap) > most_shifted;  // a limit reports larger gaps
                  },
                  "z_r, z_s, z_p",
                  "z_r is not z_s + 2 z_p: only profile shift brings sun, planets and ring to one axis", nullptr,
                  true}};

  static constexpr bool turns = true;
  static Applies loaded(const Input& in) { return where(is_set(in.T_s) || is_set(in.T_c) || is_set(in.T_r)); }
  static constexpr std::array modes{
      Mode<Input>{"room", "clearance between adjacent planets", &always<Input>}.judged_by("u_N").of_shape(),
      Mode<Input>{"coaxial", "coaxiality condition", &always<Input>}.judged_by("z_gap").of_shape(),
      Mode<Input>{"mesh_sun", "interference and contact ratio, sun-planet", &always<Input>}
          .judged_by("f_sp, eps_sp")
          .of_shape(),
      Mode<Input>{"mesh_ring", "interference and contact ratio, planet-ring", &always<Input>}
          .judged_by("f_pr, eps_pr")
          .of_shape(),
      Mode<Input>{"undercut", "undercut of sun and planets", &always<Input>}.judged_by("x_free").of_shape(),
      Mode<Input>{"clearance", "tip clearance", &always<Input>}.judged_by("c_a").of_shape(),
      Mode<Input>{"pointed", "tip thickness", &always<Input>}.judged_by("s_a").of_shape(),
      Mode<Input>{"teeth_sun", "tooth strength, sun", &loaded}.left_to("gear.pair",
                                                                       "sun_mesh.root_1, sun_mesh.pitting_1"),
      Mode<Input>{"teeth_planet", "tooth strength, planets", &loaded}.left_to(
          "gear.pair", "sun_mesh.root_2, sun_mesh.pitting_2, ring_mesh.root_1, ring_mesh.pitting_1"),
      Mode<Input>{"teeth_ring", "tooth strength, ring", &loaded}.left_to("gear.pair",
                                                                         "ring_mesh.root_mate, ring_mesh.pitting_2"),
      Mode<Input>{"trimming", "trimming interference at radial assembly", &unseen<Input>}.special(),
      Mode<Input>{"sharing", "load sharing between planets",
                  [](const Input& in) { return in.N_p > 1 && in.K_gamma == 1.0 ? Applies::unseen : Applies::no; }}
          .special(),
      Mode<Input>{"pins", "planet pins and bearings", &unseen<Input>}.special(),
      Mode<Input>{"wear", "scuffing, micropitting and wear", &unseen<Input>}.special(),
      Mode<Input>{"heat", "thermal capacity", &unseen<Input>}.special(),
      Mode<Input>{"rim", "rim thickness, planets and ring", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::gear
