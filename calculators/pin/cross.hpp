// A pin across shaft and hub that carries a torque: shear, pressure in shaft and hub, the shaft with its hole.
//
// Decides as [RM-9] does: shear in both sections at the surface of the shaft, a pressure in the shaft that grows from
// its axis to its surface, an even one in the wall of the hub at the middle of that wall. The torsion of the shaft
// counts with the section modulus that its cross hole leaves, [DIN743]. Allowable values are typed; in shear also a
// share of R_m by how the torque varies. K_A acts once, on T. Not covered: tapered and grooved pins but by their mean
// diameter and lower allowable values, the notch of the hole in fatigue, the wall of the hub, bending of the shaft.
#pragma once

#include "calculators/load/connection.hpp"
#include "calculators/load/steel.hpp"
#include "calculators/pin/loading.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::pin {

struct Cross {
  static constexpr auto id = "pin.cross";
  static constexpr auto title = "Cross pin (shaft-hub)";
  static constexpr auto scope =
      "Shear of a pin through a solid shaft and its hub that transmits the torque, bearing pressure in shaft "
      "and hub, and torsion of the shaft at the hole; static; the stress concentration of the hole and the hub "
      "are not covered.";
  static constexpr auto source = "[RM-9], [Inggo-31], [DIN743]";
  static constexpr auto headline = "d = {d}";
  static constexpr auto subject = "cross pin";
  static constexpr auto synonyms =
      "cross pin, transverse pin, taper pin, dowel pin, shear pin, shaft-hub connection, Querstift, "
      "Stiftverbindung, Scherstift, Kegelstift, штифт, поперечный штифт, штифтовое соединение";
  static constexpr auto example = R"([project]
title = "Lever on its shaft"

[pin]
calculator = "pin.cross"
T = "32 N*m"
loading = "pulsating"
d = "8 mm"
d_w = "32 mm"
D = "64 mm"
R_m = "400 MPa"
p_adm_1 = "70 MPa"
p_adm_2 = "35 MPa"
tau_adm_1 = "40 MPa"
)";

  struct Input {
    Length d_f = unset<Length>, h_t = unset<Length>, b_r = unset<Length>, bore = unset<Length>;
    Moment T = unset<Moment>;
    double K_A = 1.0;
    Loading loading = Loading::unsaid;
    Length d = unset<Length>, d_w = unset<Length>, D = unset<Length>;
    Stress E = unset<Stress>, R_m = unset<Stress>, tau_adm = unset<Stress>, p_adm_1 = unset<Stress>,
           p_adm_2 = unset<Stress>, tau_adm_1 = unset<Stress>;
  };
  static Applies loaded(const Input& in);
  static Applies varies(const Input& in);
  static Applies may_vary(const Input& in);
  static Applies shaft_varies(const Input& in);
  static constexpr auto inputs = join(
      hub_inputs<Input>(),
      Fields{
          RecordField<Input>{"load", "shaft load of the mounted gear, belt, chain or drive: load = \"=gears.gear_2\""},
          Field{&Input::T, "T", N_m, "torque, magnitude"}.load().one_of_body("torque"),
          Field{&Input::K_A, "K_A", ratio, "application factor K_A on T (1 if T includes it)"}
              .at_least(1)
              .usually(1, 4)
              .factor(),
          Choice{&Input::loading, "loading", "loading: steady, pulsating or alternating"}.may_be_missing(),
          Field{&Input::d, "d", mm, "pin diameter (taper pin: mean diameter)"}.positive().usually(1, 100),
          Field{&Input::d_w, "d_w", mm, "shaft diameter"}.own().positive().usually(4, 500).at_most_that_of_source(
              "d, d_max"),
          Field{&Input::D, "D", mm, "outer diameter of the hub"}.positive().usually(6, 1000),
          Field{&Input::R_m, "R_m", MPa, "tensile strength of the pin"}
              .positive()
              .usually(200, 2500)
              .customarily_at_most(most_tensile_strength)
              .from("material", "R_m", "d")
              .where_it_has(),
          modulus_of_material(&Input::E),
          Field{&Input::tau_adm, "tau_adm", MPa, "allowable shear stress of the pin under this loading, replaces R_m"}
              .positive()
              .usually(5, 1000)
              .customarily_at_most(400)
              .may_be_missing(),
          Field{&Input::p_adm_1, "p_adm_1", MPa, "allowable bearing pressure in the shaft"}
              .positive()
              .usually(5, 1000)
              .customarily_at_most(400)
              .may_be_missing(),
          Field{&Input::p_adm_2, "p_adm_2", MPa, "allowable bearing pressure in the hub"}
              .positive()
              .usually(5, 1000)
              .customarily_at_most(400)
              .may_be_missing(),
          Field{&Input::tau_adm_1, "tau_adm_1", MPa, "allowable torsional stress of the shaft at the hole"}
              .positive()
              .usually(5, 1000)
              .customarily_at_most(400)
              .may_be_missing()});

  struct Result {
    Moment T_d = unset<Moment>;
    Stress tau = unset<Stress>, p_1 = unset<Stress>, p_2 = unset<Stress>, tau_t = unset<Stress>;
    double u_tau = unset<double>, u_1 = unset<double>, u_2 = unset<double>, u_t = unset<double>, x_d = unset<double>;
    double x_E = unset<double>;
    Connection connection;
  };
  static constexpr Fields results{
      Field{&Result::T_d, "T_d", N_m, "design torque: with the application factor"}.holding("K_A"),
      Field{&Result::tau, "tau", MPa, "mean shear stress of the pin"}.holding("K_A"),
      Field{&Result::p_1, "p_1", MPa, "maximum bearing pressure in the shaft, at its surface"}.holding("K_A"),
      Field{&Result::p_2, "p_2", MPa, "bearing pressure in the hub"}.holding("K_A"),
      Field{&Result::tau_t, "tau_t", MPa, "torsional stress of the shaft at the hole"}.holding("K_A"),
      Field{&Result::u_tau, "u_tau", ratio, "shear of the pin: shear stress / allowable stress"}.check("tau_adm, R_m"),
      Field{&Result::u_1, "u_1", ratio, "shaft: bearing pressure / allowable pressure"}.check("p_adm_1"),
      Field{&Result::u_2, "u_2", ratio, "hub: bearing pressure / allowable pressure"}.check("p_adm_2"),
      Field{&Result::u_t, "u_t", ratio, "torsion of the shaft: torsional stress / allowable stress"}.check("tau_adm_1"),
      Field{&Result::x_d, "x_d", ratio, "pin diameter / shaft diameter (validity limit)"}.limit(0, 0.3 + 1e-9),
      modulus_over_steel<Result>(&Result::x_E),
      Group{&Result::connection, "connection", connection_doc}.handed_over()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !is_set(in.d_f) || in.d_w < in.d_f; }, "d_f, d_w",
                  "the shaft diameter must not exceed the root diameter of the mounted component"},
      Rule<Input>{[](const Input& in) { return !(in.D > 1.000001 * in.d_f) || in.d_w >= in.d_f; }, "D, d_f",
                  "the outer diameter of the hub must not exceed the root diameter of the mounted component"},
      Rule<Input>{[](const Input& in) { return bore_fits(in.bore, in.d_w); }, "bore, d_w",
                  "the bore of the mounted component must equal the shaft diameter; for another component give its "
                  "bore, with because.bore = \"...\""},
      Rule<Input>{[](const Input& in) { return in.d < in.d_w; }, "d, d_w",
                  "the pin diameter must be smaller than the shaft diameter"},
      Rule<Input>{[](const Input& in) { return in.d_w < in.D; }, "D, d_w",
                  "the outer diameter of the hub must exceed the shaft diameter"},
      Rule<Input>{
          [](const Input& in) { return !is_set(in.R_m) || is_set(in.tau_adm) || in.loading != Loading::unsaid; },
          "R_m, loading",
          "the allowable stress as a fraction of R_m depends on the type of loading: give loading = steady, pulsating "
          "or alternating"}};

  static constexpr std::array senses{SenseClaim{"T", "loading", "steady, pulsating", "alternating"}};
  static constexpr std::array meanings{Meaning{"tau_adm", allowable_in_shear}};
  static constexpr std::array modes{
      Mode<Input>{"shear", "shear of the pin", &loaded}.judged_by("u_tau, x_E"),
      Mode<Input>{"shaft_bore", "bearing pressure, shaft", &loaded}.judged_by("u_1"),
      Mode<Input>{"hub_bore", "bearing pressure, hub", &loaded}.judged_by("u_2"),
      Mode<Input>{"shaft", "torsion of the shaft at the hole", &loaded}.judged_by("u_t, x_d"),
      Mode<Input>{"fatigue", "fatigue of the pin by the stated loading type", &varies}.judged_by("u_tau"),
      Mode<Input>{"variation", "fatigue of the pin, loading type not stated", &may_vary}.in_service().wanting(
          "loading = pulsating"),
      Mode<Input>{"shaft_fatigue", "shaft fatigue at the cross hole", &shaft_varies}
          .in_service()
          .assessed_additionally_in("shaft.design"),
      Mode<Input>{"wall", "hub wall strength at the pin", &unseen<Input>},
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"fretting", "loosening of hub and pin", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::pin
