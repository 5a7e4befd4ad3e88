// A pin in a fork and an eye, or in one wall: bending, shear, pressure, and pressure times speed where it turns.
//
// Decides as [RM-9] does, by beams whose moment follows from how the pin is held: loose, fixed in the fork, fixed in
// the eye; with a gap c on either side of the eye. A pin held on one side is a cantilever that bears in its wall by
// force and moment. The load is even over eye and cheeks, or falls towards the outside of the cheeks, [Bhandari-4].
// Shear is that of the neutral axis, of a bore too. What is allowed is typed, or a share of R_m by how the force
// varies, [RM-9]. The equivalent stress is that of the extreme fibre in bending or of the neutral axis in shear: over a
// section it is lower between them. K_A acts once, on F. Not covered: a bored pin that turns oval, forces along it,
// heat, what keeps it in its place.
#pragma once

#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/steel.hpp"
#include "calculators/pin/loading.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::pin {

/// What an eye, or one cheek of a fork, has to carry: for pin.lug to take whole, load = "=pin.eye".
struct LugLoad {
  Force F = unset<Force>;
  Length d = unset<Length>, t = unset<Length>;

  static constexpr Fields fields{
      Field{&LugLoad::F, "F", N, "force of the pin on it, with the service factor"}.load().holding("K_A"),
      Field{&LugLoad::d, "d", mm, "diameter of the pin"}, Field{&LugLoad::t, "t", mm, "thickness"}};
};

struct Joint {
  static constexpr auto id = "pin.joint";
  static constexpr auto title = "Pin in a fork or a wall";
  static constexpr auto scope =
      "Bending and shear of a pin, solid or bored, in a fork and an eye or held on one side; pressure in eye and fork; "
      "pressure times speed where it turns. The walls of eye and fork are left to pin.lug; a bored pin that turns oval "
      "is not covered.";
  static constexpr auto source = "[RM-9], [Bhandari-4], [Mises]";
  static constexpr auto headline = "d = {d}";
  static constexpr auto subject = "pin and eyes";
  static constexpr auto example = R"([project]
title = "Pin of a fork"

[joint]
calculator = "pin.joint"
F = "14.5 kN"
K_A = 1.25
held = "loose"
loading = "pulsating"
d = "30 mm"
t_1 = "30 mm"
t_2 = "16 mm"
c = "0.5 mm"
R_m = "600 MPa"
p_adm_1 = "100 MPa"
p_adm_2 = "100 MPa"
)";

  enum class Held { unsaid, loose, in_fork, in_eye, one_side };
  enum class Spread { even, falling };

  struct Input {
    Force F = unset<Force>;
    double K_A = 1.0;
    Held held = Held::unsaid;
    Loading loading = Loading::unsaid;
    Spread spread = Spread::even;
    Length d = unset<Length>, d_i = unset<Length>;
    Length t_1 = unset<Length>, t_2 = unset<Length>, c = from_si<Length>(0.0);
    Length d_h = unset<Length>;
    Stress E = unset<Stress>, R_m = unset<Stress>, sigma_adm = unset<Stress>, tau_adm = unset<Stress>;
    Stress p_adm_1 = unset<Stress>, p_adm_2 = unset<Stress>;
    AngularSpeed n = unset<AngularSpeed>;
    PressureSpeed pv_adm = unset<PressureSpeed>;
  };
  static Applies loaded(const Input& in);
  static Applies varies(const Input& in);
  static Applies may_vary(const Input& in);
  static Applies turns_in_seat(const Input& in);
  static Applies bored(const Input& in);
  static Applies forked(const Input& in);
  static Applies in_wall(const Input& in);
  static constexpr Fields inputs{
      RecordField<Input>{"load", "the joint of a mechanism, whole: load = \"=press.joints.B\""},
      Field{&Input::F, "F", N, "force on the pin, across it; its size counts"}.load(),
      Field{&Input::K_A, "K_A", ratio, "service factor on F: what it does not contain, once"}
          .at_least(1)
          .usually(1, 4)
          .factor(),
      Choice{&Input::held, "held", "how the pin is held"}.may_be_missing(),
      Choice{&Input::loading, "loading", "how the force varies on a point of the pin"}.may_be_missing(),
      Choice{&Input::spread, "spread", "how the force spreads over the cheeks of a loose pin"}.may_be_missing(),
      Field{&Input::d, "d", mm, "diameter of the pin"}.positive().usually(2, 500).findable("R40"),
      Field{&Input::d_i, "d_i", mm, "bore of the pin; solid where missing"}.at_least(0).may_be_missing(),
      Field{&Input::t_1, "t_1", mm, "thickness of the eye"}.positive().usually(1, 1000),
      Field{&Input::t_2, "t_2", mm, "thickness of one cheek of the fork; of a pin held on one side that of its wall"}
          .positive()
          .usually(1, 1000),
      Field{&Input::c, "c", mm, "gap between the eye and a cheek, on either side"}.at_least(0).usually(0, 100),
      Field{&Input::R_m, "R_m", MPa, "tensile strength of the pin"}
          .positive()
          .usually(200, 2500)
          .from("material", "R_m", "d_h, d")
          .where_it_has(),
      modulus_of_material(&Input::E),
      diameter_at_heat_treatment(&Input::d_h),
      Field{&Input::sigma_adm, "sigma_adm", MPa, "allowable bending stress under this loading, in place of R_m"}
          .positive()
          .usually(10, 1500)
          .may_be_missing(),
      Field{&Input::tau_adm, "tau_adm", MPa, "allowable shear stress under this loading, in place of R_m"}
          .positive()
          .usually(5, 1000)
          .may_be_missing(),
      Field{&Input::p_adm_1, "p_adm_1", MPa, "allowable pressure in the eye; where it turns, that of sliding"}
          .positive()
          .usually(1, 1000)
          .may_be_missing(),
      Field{&Input::p_adm_2, "p_adm_2", MPa, "allowable pressure in fork or wall; where it turns, that of sliding"}
          .positive()
          .usually(1, 1000)
          .may_be_missing(),
      Field{&Input::n, "n", rpm, "speed of turning of the pin in its loose seat, either way"}
          .usually(-3000, 3000)
          .may_be_missing(),
      Field{&Input::pv_adm, "pv_adm", MPa_m_per_s, "allowable pressure times speed"}
          .positive()
          .usually(0.01, 20)
          .may_be_missing()};

  struct Result {
    Force F_d = unset<Force>;
    Moment M_b = unset<Moment>;
    Stress sigma_b = unset<Stress>, tau_m = unset<Stress>, tau = unset<Stress>, sigma_v = unset<Stress>;
    Stress p_1 = unset<Stress>, p_2 = unset<Stress>;
    Speed v = unset<Speed>;
    PressureSpeed pv = unset<PressureSpeed>;
    double u_b = unset<double>, u_v = unset<double>, u_tau = unset<double>, u_1 = unset<double>, u_2 = unset<double>,
           u_pv = unset<double>, x_E = unset<double>;
    LugLoad eye, cheek;
  };
  static constexpr Fields results{
      Field{&Result::F_d, "F_d", N, "force that counts: with the service factor"}.holding("K_A"),
      Field{&Result::M_b, "M_b", N_m, "largest bending moment of the pin"}.holding("K_A"),
      Field{&Result::sigma_b, "sigma_b", MPa, "bending stress"}.holding("K_A"),
      Field{&Result::tau_m, "tau_m", MPa, "mean shear stress"}.holding("K_A"),
      Field{&Result::tau, "tau", MPa, "shear stress in the neutral axis, which is checked"}.holding("K_A"),
      Field{&Result::sigma_v, "sigma_v", MPa, "largest equivalent stress: of the extreme fibre or of the neutral axis"}
          .holding("K_A"),
      Field{&Result::p_1, "p_1", MPa, "pressure in the eye"}.holding("K_A"),
      Field{&Result::p_2, "p_2", MPa, "pressure in the fork; in a wall the largest"}.holding("K_A"),
      Field{&Result::v, "v", m_per_s, "speed of sliding"},
      Field{&Result::pv, "pv", MPa_m_per_s, "pressure times speed in the seat that slides"},
      Field{&Result::u_b, "u_b", ratio, "bending over the allowable stress"}.check("sigma_adm, R_m"),
      Field{&Result::u_v, "u_v", ratio, "equivalent stress over the allowable bending stress"}.check("sigma_adm, R_m"),
      Field{&Result::u_tau, "u_tau", ratio, "shear over the allowable stress"}.check("tau_adm, R_m"),
      Field{&Result::u_1, "u_1", ratio, "pressure in the eye over the allowable one"}.check("p_adm_1"),
      Field{&Result::u_2, "u_2", ratio, "pressure in fork or wall over the allowable one"}.check("p_adm_2"),
      Field{&Result::u_pv, "u_pv", ratio, "pressure times speed over the allowable one"}
          .check("pv_adm")
          .where_it_applies(),
      modulus_over_steel<Result>(&Result::x_E),
      Group{&Result::eye, "eye", "what the eye carries, for pin.lug: load"}.handed_over(),
      Group{&Result::cheek, "cheek", "what one cheek of the fork carries, for pin.lug: load"}.handed_over()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.held != Held::unsaid; }, "held",
                  "say how the pin is held, which its moment follows from: loose, in_fork, in_eye or one_side"},
      Rule<Input>{[](const Input& in) { return !is_set(in.d_i) || !is_set(in.d) || in.d_i < in.d; }, "d_i, d",
                  "the bore must be smaller than the pin"},
      Rule<Input>{[](const Input& in) { return in.spread == Spread::even || in.held == Held::loose; }, "spread, held",
                  "the force falls over the cheeks of a loose pin alone: held = \"loose\""},
      Rule<Input>{[](const Input& in) {
                    const bool typed = is_set(in.sigma_adm) && is_set(in.tau_adm);
                    return !is_set(in.R_m) || typed || in.loading != Loading::unsaid;
                  },
                  "R_m, loading", "the share of R_m that is allowed follows from how the force varies: say loading"},
      Rule<Input>{[](const Input& in) { return is_set(in.pv_adm) <= is_set(in.n); }, "pv_adm, n",
                  "pressure times speed needs the speed of turning n"},
      heat_treated_before_turning<Input>()};

  static constexpr std::array meanings{Meaning{"sigma_adm", allowable_in_normal},
                                       Meaning{"tau_adm", allowable_in_shear}};
  static constexpr std::array modes{
      Mode<Input>{"bending", "pin bent", &loaded}.judged_by("u_b, u_v, x_E"),
      Mode<Input>{"shear", "pin sheared off", &loaded}.judged_by("u_tau, x_E"),
      Mode<Input>{"eye", "pin or bore of the eye crushed", &loaded}.judged_by("u_1"),
      Mode<Input>{"fork", "pin or bore of fork or wall crushed", &loaded}.judged_by("u_2"),
      Mode<Input>{"fatigue", "fatigue of the pin, by what the loading allows", &varies}.judged_by("u_b, u_tau"),
      Mode<Input>{"variation", "fatigue of a pin whose loading is not said to vary", &may_vary}.in_service().wanting(
          "loading = pulsating"),
      Mode<Input>{"wear", "wear and heat of the seat that slides", &turns_in_seat}
          .judged_by("u_pv")
          .wanting("n, pv_adm")
          .special()
          .in_service(),
      Mode<Input>{"eye_wall", "eye torn or sheared out", &loaded}.left_to("pin.lug", "eye.net, eye.shear_out"),
      Mode<Input>{"fork_wall", "cheek of the fork torn or sheared out", &forked}.left_to("pin.lug",
                                                                                         "cheek.net, cheek.shear_out"),
      Mode<Input>{"wall", "wall that holds the pin on one side broken", &in_wall},
      Mode<Input>{"oval", "a bored pin that turns oval", &bored},
      Mode<Input>{"other_loads", "what comes along with the force, and is not taken", &unseen<Input>}.by_companions(),
      Mode<Input>{"locking", "a pin that creeps out of its seat", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Joint::Held) {
  using Held = Joint::Held;
  return std::array{ChoiceName<Held>{Held::unsaid, "", "not said"},
                    ChoiceName<Held>{Held::loose, "loose", "loose in fork and eye"},
                    ChoiceName<Held>{Held::in_fork, "in_fork", "fixed in the fork, loose in the eye"},
                    ChoiceName<Held>{Held::in_eye, "in_eye", "fixed in the eye, loose in the fork"},
                    ChoiceName<Held>{Held::one_side, "one_side", "fixed in one wall, the eye on its free end"}};
}
constexpr auto choices_of(Joint::Spread) {
  using Spread = Joint::Spread;
  return std::array{ChoiceName<Spread>{Spread::even, "even", "evenly over cheeks and eye"},
                    ChoiceName<Spread>{Spread::falling, "falling",
                                       "evenly over the eye, falling to zero at the outside of the cheeks"}};
}

}  // namespace loadpath::pin
