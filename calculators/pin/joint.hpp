// A pin in a clevis and an eye, or in one wall: bending, shear, pressure, and pressure times speed where it turns.
//
// Decides as [RM-9] does, by beams whose moment follows from how the pin is held: loose, fixed in the clevis, fixed in
// the eye; with a gap c on either side of the eye. A pin held on one side is a cantilever, supported in its wall by
// force and moment. The load is even over eye and cheeks, or falls towards the outside of the cheeks, [Bhandari-4].
// Shear is that of the neutral axis, of a bore too. Allowable values are typed, or a share of R_m by how the force
// varies, [RM-9]. The equivalent stress is that of the extreme fibre in bending or of the neutral axis in shear: over
// a section it is lower between them. K_A acts once, on F. Not covered: a bored pin that turns oval, forces along it,
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

/// Load of an eye, or of one cheek of a clevis: an input record of pin.lug, load = "=pin.eye".
struct LugLoad {
  Force F = unset<Force>;
  Length d = unset<Length>, t = unset<Length>;

  static constexpr Fields fields{
      Field{&LugLoad::F, "F", N, "force of the pin on the lug, with the application factor"}.load().holding("K_A"),
      Field{&LugLoad::d, "d", mm, "diameter of the pin"}, Field{&LugLoad::t, "t", mm, "thickness"}};
};

struct Joint {
  static constexpr auto id = "pin.joint";
  static constexpr auto title = "Clevis pin or cantilever pin joint";
  static constexpr auto scope =
      "Bending and shear of a solid or hollow pin in a clevis and eye, or cantilevered from a wall, bearing "
      "pressure in eye and clevis, and the pv value if the joint rotates; eye and clevis walls are assessed by "
      "pin.lug; ovalisation of a hollow pin is not covered.";
  static constexpr auto source = "[RM-9], [Bhandari-4], [Mises]";
  static constexpr auto headline = "d = {d}";
  static constexpr auto subject = "pin and eyes";
  static constexpr auto synonyms =
      "clevis pin, pin joint, fork pin, gudgeon pin, wrist pin, crosshead pin, hinge pin, knuckle joint, bearing "
      "pressure, "
      "pv value, Bolzenverbindung, Gabel, Gelenkbolzen, Flächenpressung, clevis, Bolzen, Gelenk, палец, "
      "шарнирный палец, ось шарнира, вилка, проушина";
  static constexpr auto example = R"([project]
title = "Pin of a clevis"

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
      RecordField<Input>{"load", "loads of a mechanism joint: load = \"=press.joints.B\""},
      Field{&Input::F, "F", N, "transverse force on the pin, magnitude"}.load(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A on F (1 if F includes it)"}
          .at_least(1)
          .usually(1, 4)
          .factor(),
      Choice{&Input::held, "held", "pin fixing: loose, fixed in clevis or eye, or cantilevered"}.may_be_missing(),
      Choice{&Input::loading, "loading", "type of loading on the pin: steady, pulsating or alternating"}
          .may_be_missing(),
      Choice{&Input::spread, "spread", "load distribution over the clevis cheeks (loose pin)"}.may_be_missing(),
      Field{&Input::d, "d", mm, "diameter of the pin"}
          .positive()
          .usually(2, 500)
          .findable("R40")
          .same_as_that_of_source("joints.#.d_pin"),
      Field{&Input::d_i, "d_i", mm, "bore of the pin; omitted: solid"}.at_least(0).may_be_missing(),
      Field{&Input::t_1, "t_1", mm, "thickness of the eye"}.positive().usually(1, 1000),
      Field{&Input::t_2, "t_2", mm, "thickness of one clevis cheek (cantilevered pin: of the wall)"}.positive().usually(
          1, 1000),
      Field{&Input::c, "c", mm, "gap between eye and clevis cheek, each side"}.at_least(0).usually(0, 100),
      Field{&Input::R_m, "R_m", MPa, "tensile strength of the pin"}
          .positive()
          .usually(200, 2500)
          .customarily_at_most(most_tensile_strength)
          .from("material", "R_m", "d_h, d")
          .where_it_has(),
      modulus_of_material(&Input::E),
      diameter_at_heat_treatment(&Input::d_h),
      Field{&Input::sigma_adm, "sigma_adm", MPa, "allowable bending stress under this loading, replaces R_m"}
          .positive()
          .usually(10, 1500)
          .customarily_at_most(700)
          .may_be_missing(),
      Field{&Input::tau_adm, "tau_adm", MPa, "allowable shear stress under this loading, replaces R_m"}
          .positive()
          .usually(5, 1000)
          .customarily_at_most(400)
          .may_be_missing(),
      Field{&Input::p_adm_1, "p_adm_1", MPa, "allowable bearing pressure in the eye (sliding value if the joint turns)"}
          .positive()
          .usually(1, 1000)
          .customarily_at_most(400)
          .may_be_missing(),
      Field{&Input::p_adm_2, "p_adm_2", MPa,
            "allowable bearing pressure in clevis or wall (sliding value if the joint turns)"}
          .positive()
          .usually(1, 1000)
          .customarily_at_most(400)
          .may_be_missing(),
      Field{&Input::n, "n", rpm, "speed of relative rotation in the loose fit, either direction"}
          .usually(-3000, 3000)
          .at_least_that_of_source("joints.#.omega")
          .may_be_missing(),
      Field{&Input::pv_adm, "pv_adm", MPa_m_per_s, "allowable pv value"}.positive().usually(0.01, 20).may_be_missing()};

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
      Field{&Result::F_d, "F_d", N, "design force: with the application factor"}.holding("K_A"),
      Field{&Result::M_b, "M_b", N_m, "maximum bending moment of the pin"}.holding("K_A"),
      Field{&Result::sigma_b, "sigma_b", MPa, "bending stress"}.holding("K_A"),
      Field{&Result::tau_m, "tau_m", MPa, "mean shear stress"}.holding("K_A"),
      Field{&Result::tau, "tau", MPa, "shear stress at the neutral axis (checked)"}.holding("K_A"),
      Field{&Result::sigma_v, "sigma_v", MPa, "maximum equivalent stress: at the extreme fibre or at the neutral axis"}
          .holding("K_A"),
      Field{&Result::p_1, "p_1", MPa, "bearing pressure in the eye"}.holding("K_A"),
      Field{&Result::p_2, "p_2", MPa, "bearing pressure in the clevis (wall: maximum)"}.holding("K_A"),
      Field{&Result::v, "v", m_per_s, "sliding speed"},
      Field{&Result::pv, "pv", MPa_m_per_s, "pv value of the sliding fit"},
      Field{&Result::u_b, "u_b", ratio, "bending: bending stress / allowable stress"}.check("sigma_adm, R_m"),
      Field{&Result::u_v, "u_v", ratio, "equivalent stress / allowable bending stress"}.check("sigma_adm, R_m"),
      Field{&Result::u_tau, "u_tau", ratio, "shear: shear stress / allowable stress"}.check("tau_adm, R_m"),
      Field{&Result::u_1, "u_1", ratio, "eye: bearing pressure / allowable pressure"}.check("p_adm_1"),
      Field{&Result::u_2, "u_2", ratio, "clevis or wall: bearing pressure / allowable pressure"}.check("p_adm_2"),
      Field{&Result::u_pv, "u_pv", ratio, "pv value / allowable pv value"}.check("pv_adm").where_it_applies(),
      modulus_over_steel<Result>(&Result::x_E),
      Group{&Result::eye, "eye", "load of the eye, for pin.lug: load"}.handed_over(),
      Group{&Result::cheek, "cheek", "load of one clevis cheek, for pin.lug: load"}.handed_over()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.held != Held::unsaid; }, "held",
                  "pin support missing: give held = loose, in_fork, in_eye or one_side"},
      Rule<Input>{[](const Input& in) { return !is_set(in.d_i) || !is_set(in.d) || in.d_i < in.d; }, "d_i, d",
                  "the bore must be smaller than the pin"},
      Rule<Input>{[](const Input& in) { return in.spread == Spread::even || in.held == Held::loose; }, "spread, held",
                  "a falling force distribution needs a loose pin: held = \"loose\""},
      Rule<Input>{[](const Input& in) {
                    const bool typed = is_set(in.sigma_adm) && is_set(in.tau_adm);
                    return !is_set(in.R_m) || typed || in.loading != Loading::unsaid;
                  },
                  "R_m, loading",
                  "the allowable stress as a fraction of R_m depends on the type of loading: give loading = steady, "
                  "pulsating or alternating"},
      Rule<Input>{[](const Input& in) { return is_set(in.pv_adm) <= is_set(in.n); }, "pv_adm, n",
                  "the pv value needs the speed of rotation n"},
      heat_treated_before_turning<Input>()};

  static constexpr std::array meanings{Meaning{"sigma_adm", allowable_in_normal},
                                       Meaning{"tau_adm", allowable_in_shear}};
  static constexpr std::array senses{SenseClaim{"F", "loading", "steady, pulsating", "alternating"}};
  static constexpr std::array modes{
      Mode<Input>{"bending", "bending of the pin", &loaded}.judged_by("u_b, u_v, x_E"),
      Mode<Input>{"shear", "shear of the pin", &loaded}.judged_by("u_tau, x_E"),
      Mode<Input>{"eye", "bearing pressure, eye", &loaded}.judged_by("u_1"),
      Mode<Input>{"fork", "bearing pressure, clevis or wall", &loaded}.judged_by("u_2"),
      Mode<Input>{"fatigue", "fatigue of the pin by the stated loading type", &varies}.judged_by("u_b, u_tau"),
      Mode<Input>{"variation", "fatigue of the pin, loading type not stated", &may_vary}.in_service().wanting(
          "loading = pulsating"),
      Mode<Input>{"wear", "wear and heating (pv value)", &turns_in_seat}
          .judged_by("u_pv")
          .wanting("n, pv_adm")
          .special()
          .in_service(),
      Mode<Input>{"eye_wall", "net section and shear-out, eye", &loaded}.left_to("pin.lug", "eye.net, eye.shear_out"),
      Mode<Input>{"fork_wall", "net section and shear-out, clevis", &forked}.left_to("pin.lug",
                                                                                     "cheek.net, cheek.shear_out"),
      Mode<Input>{"wall", "strength of the supporting wall", &in_wall},
      Mode<Input>{"oval", "ovalisation of a hollow pin", &bored},
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"locking", "axial retention of the pin", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Joint::Held) {
  using Held = Joint::Held;
  return std::array{
      ChoiceName<Held>{Held::unsaid, "", "not given"},
      ChoiceName<Held>{Held::loose, "loose", "loose in clevis and eye"},
      ChoiceName<Held>{Held::in_fork, "in_fork", "fixed in the clevis, loose in the eye"},
      ChoiceName<Held>{Held::in_eye, "in_eye", "fixed in the eye, loose in the clevis"},
      ChoiceName<Held>{Held::one_side, "one_side", "cantilevered from one wall, the eye on its free end"}};
}
constexpr auto choices_of(Joint::Spread) {
  using Spread = Joint::Spread;
  return std::array{ChoiceName<Spread>{Spread::even, "even", "uniform over cheeks and eye"},
                    ChoiceName<Spread>{Spread::falling, "falling",
                                       "uniform over the eye, falling to zero at the outside of the cheeks"}};
}

}  // namespace loadpath::pin
