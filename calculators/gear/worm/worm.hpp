// Cylindrical worm gears with shafts at right angles: geometry, forces, efficiency, pitting and wear, bending, heat.
//
// Decides the diameters, the efficiency in both directions, the forces on both shafts where the worm drives, the rated
// force of a bronze wheel on a steel worm by ANSI/AGMA 6034, the bending stress by Buckingham, and the balance of heat
// of the case. Friction by the sliding velocity, as AGMA has it for lubricated hardened worms, or as given. Frame of
// the worm: x from its axis to the wheel, z along it; of the wheel: x to the worm, z along y of the worm. Nominal
// loads; the records worm and wheel have K_A. Heat is that of the nominal power. C_s below a centre distance of 3 in:
// 720 + 10.37 C^3, as in [EngineersEdge-worm] and [Shigley-15-32], continuous at 3 in, where C_s is 1000; a reprint
// with 270 jumps there and is a misprint of 720. Recalled: the heat transfer of the case, 0.67 d_1 (the sheet of
// [AGMA6034] has d_1/3), 3600 rpm, 100 MPa of torsion, widths from 3 m_x. Not covered: driving wheels, except for their
// efficiency, globoid worms, other materials than bronze on steel, losses of bearings, seals and churning.
#pragma once

#include "calculators/gear/worm/bounds.hpp"
#include "calculators/gear/worm/results.hpp"
#include "calculators/gear/worm/types.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <vector>

namespace loadpath::gear {

inline constexpr Unit<Area> square_metre{"m^2", from_si<Area>(1.0)};

struct Worm : WormTypes {
  static constexpr auto id = "gear.worm";
  static constexpr auto title = "Cylindrical worm gears (ANSI/AGMA 6034)";
  static constexpr auto scope =
      "Geometry, sliding, efficiency in both directions, self-locking and forces of cylindrical worm gears; pitting "
      "and wear of a bronze wheel by ANSI/AGMA 6034, tooth bending by Buckingham, and the heat of the case; deflection "
      "of the worm is not covered.";
  static constexpr auto source = "[AGMA6034], [EngineersEdge-worm], [Shigley-15-32], [KHK-worm], [Inventor]";
  static constexpr auto headline = "z {z_1}/{z_2}, m {m_x}";
  static constexpr auto details = "d_1 = {d_1}, b_2 = {b_2}, efficiency {eta}, centre distance {a}";
  static constexpr auto synonyms =
      "worm gear, worm, worm wheel, worm drive, lead angle, self-locking, sliding velocity, AGMA 6034, Buckingham, "
      "right-angle gear, worm reducer, heat dissipation, cooling, oil temperature, "
      "Schnecke, Schneckengetriebe, Schneckenrad, Steigungswinkel, Selbsthemmung, червяк, червячная передача, "
      "червячное колесо, самоторможение";
  static constexpr auto example = R"([project]
title = "Worm gear of a conveyor"

[worm]
calculator = "gear.worm"
z_1 = 2
z_2 = 40
m_x = "4 mm"
d_1 = "40 mm"
b_2 = "30 mm"
P = "0.6 kW"
n_1 = "1400 rpm"
K_A = 1.25
casting = "chill"
S_Wmin = 1
sigma_adm = "60 MPa"
A_h = "0.25 m^2"
dT_adm = "60 K"
)";

  static bool carries(const Input& in) { return is_set(in.T_1) || is_set(in.P) || is_set(in.T_2); }
  static bool rates(const Input& in) { return in.casting != Casting::unsaid; }
  static bool cools(const Input& in) { return is_set(in.A_h) || is_set(in.dT_adm) || is_set(in.P_cool); }
  static constexpr Fields inputs{
      Count{&Input::z_1, "z_1", 1, 12, "number of threads of the worm"}.same_as_that_of_source("stages[#].z_1"),
      Count{&Input::z_2, "z_2", 10, 500, "number of teeth of the wheel"}.same_as_that_of_source("stages[#].z_2"),
      Field{&Input::m_x, "m_x", mm, "axial module of the worm, transverse module of the wheel"}
          .positive()
          .usually(0.3, 32)
          .same_as_that_of_source("stages[#].m_n"),
      Field{&Input::d_1, "d_1", mm, "reference diameter of the worm"}.positive().usually(5, 500),
      Field{&Input::b_2, "b_2", mm, "face width of the wheel"}.positive().usually(3, 400),
      Field{&Input::alpha_n, "alpha_n", deg, "normal pressure angle"}.within(14.5, 30),
      Field{&Input::h_aP, "h_aP", ratio, "addendum in axial modules"}.within(0.7, 1.2),
      Field{&Input::h_fP, "h_fP", ratio, "dedendum in axial modules (AGMA 1.157)"}.within(0.8, 1.5).usually(1.1, 1.3),
      Choice{&Input::hand, "hand", "hand of the worm"}.may_be_missing(),
      Field{&Input::T_1, "T_1", N_m, "torque of the worm, which drives, nominal"}
          .load()
          .positive()
          .at_least_that_of_source("shafts[#].T")
          .with("F_t1, F_t2, F_r")
          .may_be_missing(),
      Field{&Input::T_2, "T_2", N_m, "torque of the wheel, nominal, replaces T_1"}
          .load()
          .positive()
          .with("F_t1, F_t2, F_r")
          .may_be_missing(),
      Field{&Input::P, "P", kW, "nominal power of the worm, with n_1, replaces T_1"}
          .load()
          .positive()
          .at_least_that_of_source("shafts[#].P")
          .may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the worm"}
          .positive()
          .usually(1, 1e4)
          .near_that_of_source("shafts[#].n")
          .may_be_missing(),
      Choice{&Input::turns, "turns", "direction of rotation of the worm, viewed from +z"}.may_be_missing(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the load includes it)"}
          .at_least(1)
          .usually(1, 2.5)
          .factor(),
      Field{&Input::mu, "mu", ratio, "coefficient of friction; omitted: by the sliding velocity"}
          .within(0.005, 0.3)
          .usually(0.01, 0.15)
          .may_be_missing(),
      Choice{&Input::locking, "locking", "self-locking, by mu or the friction at n_1 (without vibration)"}
          .may_be_missing(),
      Field{&Input::bore_2, "bore_2", mm, "bore diameter of the wheel"}.positive().may_be_missing(),
      Choice{&Input::casting, "casting", "bronze of the wheel, on a steel worm of 58 HRC or more"}.may_be_missing(),
      Field{&Input::S_Wmin, "S_Wmin", ratio, "required safety factor against pitting and wear"}
          .at_least(1)
          .usually(1, 2)
          .may_be_missing()
          .factor(),
      Field{&Input::y, "y", ratio, "form factor of the wheel teeth; omitted: by the pressure angle"}
          .within(0.03, 0.25)
          .usually(0.08, 0.18)
          .may_be_missing(),
      Field{&Input::sigma_adm, "sigma_adm", MPa, "allowable bending stress of the wheel (safety factor included)"}
          .positive()
          .usually(10, 250)
          .customarily_at_most(200)
          .may_be_missing(),
      Choice{&Input::cooling, "cooling", "cooling of the case, with A_h"}.may_be_missing(),
      Field{&Input::A_h, "A_h", square_metre, "surface of the case, with dT_adm"}
          .positive()
          .usually(0.005, 10)
          .may_be_missing(),
      Field{&Input::dT_adm, "dT_adm", kelvin, "allowable temperature rise of the oil above the surroundings"}
          .positive()
          .usually(10, 80)
          .customarily_at_most(80)
          .may_be_missing(),
      Field{&Input::P_cool, "P_cool", kW, "heat that the case or its cooler dissipates, replaces A_h and dT_adm"}
          .positive()
          .may_be_missing()};
  static constexpr auto results = worm_results;

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !is_set(in.d_1) || !is_set(in.m_x) || in.d_1 > 2.0 * in.h_fP * in.m_x; },
                  "d_1, m_x, h_fP", "the worm has no core: d_1 must exceed twice the dedendum h_fP m_x"},
      Rule<Input>{[](const Input& in) { return !is_set(in.d_1) || !is_set(in.m_x) || in.m_x * in.z_1 <= in.d_1; },
                  "z_1, m_x, d_1", "the lead angle must not exceed 45°: increase d_1, or reduce z_1"},
      Rule<Input>{[](const Input& in) { return in.h_fP - in.h_aP >= 0.1 - 1e-9; }, "h_fP, h_aP",
                  "the dedendum must exceed the addendum by at least 0.1, the tip clearance in modules"},
      Rule<Input>{[](const Input& in) {
                    return !is_set(in.b_2) || !is_set(in.d_1) || !is_set(in.m_x) ||
                           in.b_2 <= in.d_1 + 2.0 * in.h_aP * in.m_x;
                  },
                  "b_2, d_1, m_x, h_aP", "the wheel must not be wider than the tip diameter of the worm: reduce b_2"},
      Rule<Input>{[](const Input& in) {
                    return static_cast<int>(is_set(in.T_1)) + static_cast<int>(is_set(in.T_2)) +
                               static_cast<int>(is_set(in.P)) <=
                           1;
                  },
                  "T_1, T_2, P", "give the load once: as T_1, T_2 or P"},
      Rule<Input>{[](const Input& in) { return is_set(in.n_1) || is_set(in.mu); }, "n_1, mu",
                  "friction depends on the sliding velocity: give n_1, or mu"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P) || is_set(in.n_1); }, "P, n_1",
                  "a power needs the speed n_1"},
      Rule<Input>{[](const Input& in) { return !is_set(in.S_Wmin) || (rates(in) && carries(in) && is_set(in.n_1)); },
                  "S_Wmin, casting, n_1, T_1, T_2, P",
                  "the safety factor S_Wmin needs casting, the speed n_1, and a load (T_1, T_2 or P)"},
      Rule<Input>{[](const Input& in) { return !is_set(in.sigma_adm) || (carries(in) && is_set(in.n_1)); },
                  "sigma_adm, n_1, T_1, T_2, P", "an allowable stress needs a load (T_1, T_2 or P) and the speed n_1"},
      Rule<Input>{[](const Input& in) { return is_set(in.A_h) == is_set(in.dT_adm); }, "A_h, dT_adm",
                  "the heat of the case needs both its surface A_h and the allowable rise dT_adm"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P_cool) || !is_set(in.A_h); }, "P_cool, A_h",
                  "give the cooling as P_cool, or as A_h with dT_adm, not both"},
      Rule<Input>{[](const Input& in) { return !cools(in) || (carries(in) && is_set(in.n_1)); },
                  "A_h, P_cool, n_1, T_1, T_2, P", "the power loss needs a load (T_1, T_2 or P) and the speed n_1"}};

  static constexpr std::array bounds{
      Bound<Input>{"mu", "the sliding velocity, less 20 %", &worm_gear::least_friction}.least(),
      Bound<Input>{"mu", "the sliding velocity, plus 25 %", &worm_gear::most_friction},
      Bound<Input>{"y", "the pressure angle", &worm_gear::most_form_factor},
      Bound<Input>{"d_1", "the thinnest usual worm, 6 m_x", &worm_gear::least_diameter}.least(),
      Bound<Input>{"A_h", "a ribbed case of this centre distance", &worm_gear::most_surface}};

  static constexpr bool turns = true;
  static Applies loaded(const Input& in) { return where(carries(in)); }
  static Applies locks(const Input& in) { return shown_by(in.locking == Locking::required); }
  static Applies heats(const Input& in) { return carries(in) ? shown_by(is_set(in.n_1)) : Applies::no; }
  static constexpr std::array modes{
      Mode<Input>{"wear", "pitting and wear of the wheel", &loaded}
          .judged_by("u_W, C_s, x_i, x_s, x_n")
          .asking("give S_Wmin and casting, with n_1"),
      Mode<Input>{"root_2", "tooth bending of the wheel", &loaded}.judged_by("u_F").asking("give sigma_adm, with n_1"),
      Mode<Input>{"heat", "thermal capacity", &heats}.judged_by("u_T").asking("give A_h with dT_adm, or P_cool"),
      Mode<Input>{"locking", "self-locking of the driven worm", &locks}.judged_by("x_L").special(),
      Mode<Input>{"undercut", "undercut of the wheel", &always<Input>}.judged_by("x_z").of_shape(),
      Mode<Input>{"width", "face width of the wheel", &always<Input>}.judged_by("x_b").of_shape(),
      Mode<Input>{"core", "torsion of the worm", &loaded}.judged_by("tau_f1"),
      Mode<Input>{"rim_2", "rim thickness of the wheel", &unseen<Input>}.judged_by("m_R2").wanting("bore_2").special(),
      Mode<Input>{"deflection", "deflection of the worm shaft", &unseen<Input>}.special().advising(
          "give v_adm in the step of shaft.design that takes this worm"),
      Mode<Input>{"threads", "breakage of the worm threads", &unseen<Input>}.special(),
      Mode<Input>{"overload", "tooth overload at peak torque", &unseen<Input>}.special(),
      Mode<Input>{"scuffing", "scuffing", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::gear
