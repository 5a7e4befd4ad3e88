// A shaft on its bearings: reactions, moments, deflection, slope, twist, strength, fatigue and critical speeds.
//
// Reactions and bending in two planes by beams with shear; yielding of each section by von Mises; fatigue of each notch
// by four criteria of [Shigley7] with the limit by Marin, and by [DIN743], [FKM], Serensen; slopes, deflection and
// critical speeds in bending and torsion. Axes: z along the shaft from its left end, X and Y across it, Y a quarter
// turn from X about z. Constant forces are fixed in space while the shaft rotates: bending alternates, axial stress
// stays, torsion runs from r_T T to T. Loads over a cycle of a mechanism count in full: each point of the
// circumference, which turns with the shaft by psi, has its own amplitude and mean, and the worst governs; amplitudes
// of bending, axial force and torsion are taken as simultaneous. Tapers up to 10 degrees bend and twist by the
// flexibility of their sections and are assessed at the weakest one, their notches as those of a cylinder of that
// diameter. Critical speeds in bending: forward whirl with gyroscopic moments. Not covered: unequal or damped bearings.
#pragma once

#include "calculators/fatigue/endurance.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/strength_rules.hpp"
#include "calculators/shaft/design/model/input.hpp"
#include "calculators/shaft/design/model/result.hpp"
#include "calculators/shaft/parts/modes.hpp"
#include "calculators/shaft/parts/ring.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/sizing.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/fit_units.hpp"

#include <span>
#include <vector>

namespace loadpath::shaft {

struct Design {
  static constexpr auto id = "shaft.design";
  static constexpr auto title = "Shaft design (strength, fatigue, critical speeds)";
  static constexpr auto scope =
      "Reactions, internal forces, deflection, slope and twist of a stepped or tapered shaft on two or more "
      "bearings, with yielding and fatigue of every section and notch and the lateral and torsional critical "
      "speeds; loads are fixed in space while the shaft turns, or given over one revolution.";
  static constexpr auto source =
      "[Shigley6], [Shigley7], [DIN743], [FKM], [GOST25504], [Peterson], [Cowper], [Mises], [Foeppl], [AGMA927]";
  static constexpr auto headline = "d = {d_max}";
  static constexpr auto synonyms =
      "shaft, stepped shaft, layshaft, countershaft, jackshaft, axle, shaft calculation, bearing reaction, deflection, "
      "slope, critical speed, whirling, "
      "Campbell diagram, torsional vibration, shaft fatigue, stress concentration, notch, shoulder, keyway, "
      "DIN 743, FKM, Welle, Achse, Wellenberechnung, Durchbiegung, biegekritische Drehzahl, Kerbwirkung, "
      "bending and torsion, Absatzwelle, вал, расчёт вала, прогиб, критическая частота вращения, "
      "концентрация напряжений, выносливость";
  static constexpr auto example = R"([project]
title = "Shaft of a gear between its bearings"

[shaft]
calculator = "shaft.design"
material = "C45E"
group = "carbon-steel"
n = "1450 rpm"
pieces = [{ l = "60 mm", d = "30 mm" }, { l = "80 mm", d = "40 mm" }, { l = "60 mm", d = "30 mm" }]
supports = [{ name = "left", x = "15 mm", holds = "both" }, { name = "right", x = "185 mm" }]
seats = [
  { name = "coupling", x = "0 mm", way = "balances", mass = "2 kg", J = "0.002 kg*m^2", I_p = "0.002 kg*m^2", I_d = "0.00126666667 kg*m^2" },
  { name = "gear", x = "100 mm", T = "50 N*m", F_x = "-600 N", F_y = "1429 N", F_z = "300 N", x_w = "35 mm", mass = "1 kg", J = "0.0006 kg*m^2", I_p = "0.0006 kg*m^2", b = "30 mm" },
]
g_angle = "-90 deg"
notches = [
  { name = "left_shoulder", x = "60 mm", kind = "shoulder", r = "2 mm" },
  { name = "right_shoulder", x = "140 mm", kind = "shoulder", r = "2 mm" },
]
S_F = 1.5
S_D = 1.5
r_T = 0
)";

  using Input = DesignInput;
  static constexpr Fields inputs{
      ListField{&Input::pieces, "pieces", "shaft segments (cylinders and tapers) from left to right"},
      ListField{&Input::supports, "supports", "bearings"},
      ListField{&Input::seats, "seats", "mounted components with their loads"}.may_be_missing(),
      ListField{&Input::notches, "notches", "notches (stress raisers)"}.may_be_missing(),
      ListField{&Input::orders, "orders", "excitation orders other than one per revolution"}.may_be_missing(),
      Field{&Input::n, "n", rpm, "speed; omitted: speed of a mounted component, else at rest"}.may_be_missing(),
      Field{&Input::K_A, "K_A", ratio,
            "application factor K_A on all torques and forces, not on weight (1 if they include it)"}
          .at_least(1)
          .usually(1, 4)
          .factor(),
      Field{&Input::k_max, "k_max", ratio, "peak load factor (start, jam), for yielding"}
          .at_least(1)
          .usually(1, 5)
          .factor(),
      Field{&Input::g_angle, "g_angle", deg, "direction of gravity, angle from X to Y; omitted: self-weight neglected"}
          .may_be_missing(),
      Field{&Input::E, "E", GPa, "modulus of elasticity"}.positive().usually(least_E, most_E).from("material", "E"),
      Field{&Input::G, "G", GPa, "shear modulus"}.positive().usually(least_G, most_G).from("material", "G"),
      Field{&Input::rho, "rho", kg_per_m3, "density"}.positive().usually(500, 20000).from("material", "rho"),
      diameter_at_heat_treatment(&Input::d_h),
      Field{&Input::R_e, "R_e", MPa, "yield strength"}
          .positive()
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "d_s"),
      Field{&Input::R_m, "R_m", MPa, "tensile strength"}
          .positive()
          .usually(80, 2500)
          .customarily_at_most(most_tensile_strength)
          .from("material", "R_m", "d_s"),
      Field{&Input::S_F, "S_F", ratio, "required safety factor against yielding"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.2)
          .may_be_missing()
          .factor(),
      Field{&Input::S_D, "S_D", ratio, "required fatigue safety factor, infinite life"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.2)
          .may_be_missing()
          .factor(),
      Field{&Input::r_T, "r_T", ratio,
            "torque ratio T_min/T_max: 1 steady, 0 pulsating (starts and stops), -1 reversing; in "
            "addition to torques over a revolution"}
          .within(-1, 1)
          .may_be_missing(),
      Choice{&Input::method, "method", "governing fatigue method"}.may_be_missing(),
      Choice{&Input::group, "group", "group of materials, for the fatigue limit"},
      Choice{&Input::finish, "finish", "surface finish"}.may_be_missing(),
      Field{&Input::sigma_W, "sigma_W", MPa, "measured fatigue limit of smooth specimens in bending, r = −1"}
          .positive()
          .usually(10, 1500)
          .may_be_missing(),
      Field{&Input::R_z, "R_z", um, "roughness, for DIN 743, FKM and Serensen"}
          .positive()
          .usually(0.1, 400)
          .customarily_at_least(0.1)
          .may_be_missing(),
      Field{&Input::v_adm, "v_adm", mm, "allowable deflection"}.positive().customarily_at_most(5).may_be_missing(),
      Field{&Input::theta_adm, "theta_adm", deg_per_m, "allowable angle of twist per unit length"}
          .positive()
          .usually(0.02, 10)
          .customarily_at_most(15)
          .may_be_missing(),
      Field{&Input::k_n, "k_n", ratio,
            "required ratio of critical speed to speed (1.25 is customary); in torsion: required "
            "separation from every critical speed"}
          .at_least(1)
          .usually(1.1, 2)
          .customarily_at_least(1.1)
          .factor(),
      Count{&Input::whirl_modes, "whirl_modes", 1, most_whirls, "number of whirl modes listed"}.may_be_missing()};

  using Result = DesignResult;
  static constexpr Fields results{
      Field{&Result::l, "l", mm, "length"},
      Field{&Result::d_max, "d_max", mm, "maximum diameter"},
      Field{&Result::s_max, "s_max", ratio, "maximum slope of a taper to the axis"}
          .limit(0, steepest_cone)
          .where_it_applies(),
      Field{&Result::d_s, "d_s", mm, "diameter for the material strength: heat treatment diameter, else the maximum"},
      Field{&Result::mass, "mass", kg, "mass of the shaft itself"},
      Field{&Result::M_max, "M_max", N_m, "maximum bending moment"}.holding("K_A"),
      Field{&Result::T_max, "T_max", N_m, "maximum torque"}.holding("K_A"),
      Field{&Result::v_max, "v_max", mm, "maximum deflection"},
      Field{&Result::theta_max, "theta_max", deg_per_m, "maximum angle of twist per unit length"},
      Field{&Result::phi, "phi", deg, "maximum angle of twist between any two sections"},
      Field{&Result::psi, "psi", deg, "shaft angle of maximum bending (loads over a revolution)"},
      Field{&Result::n, "n", rpm, "speed"},
      Field{&Result::n_c, "n_c", rpm, "first lateral critical speed, without gyroscopic effect"},
      Field{&Result::n_R, "n_R", rpm, "first lateral critical speed by Rayleigh (upper bound)"},
      Field{&Result::n_D, "n_D", rpm, "first lateral critical speed by Dunkerley (lower bound)"},
      Field{&Result::n_F, "n_F", rpm,
            "first lateral critical speed with gyroscopic effect: forward whirl, if a component has I_p"},
      Field{&Result::n_T, "n_T", rpm, "first torsional critical speed of the shaft with its mounted components only"},
      Field{&Result::u_y, "u_y", ratio, "deflection / allowable deflection"}.check("v_adm"),
      Field{&Result::u_theta, "u_theta", ratio, "angle of twist per unit length / allowable value"}.check("theta_adm"),
      Field{&Result::u_n, "u_n", ratio, "lateral critical speed: k_n x speed / critical speed"}
          .check()
          .where_it_applies(),
      modulus_over_steel<Result>(&Result::x_E),
      ListField{&Result::bearings, "bearings", "bearing loads"},
      ListField{&Result::seats, "seats", "deflection and slope at the mounted components"},
      ListField{&Result::harmonics, "harmonics",
                "torsional excitations: shaft speed, excitation orders, and torques over a revolution"},
      ListField{&Result::whirls, "whirls", "whirl modes with gyroscopic effect, slowest first"},
      ListField{&Result::sections, "sections", "sections at changes of geometry or load, left to right"},
      ListField{&Result::safeties, "safeties", "fatigue safety factors of the same sections"}};

  static bool within_ends(const Input& in);
  static bool on_shaft(const Input& in);
  static FieldFault off_shaft(const Input& in);
  static bool held(const Input& in);
  static bool stiff_enough(const Input& in);
  static bool turn_is_known(const Input& in);
  static FieldFault open_turn(const Input& in);
  static bool torques_close(const Input& in);
  static FieldFault open_sum(const Input& in);
  static bool speeds_agree(const Input& in);
  static bool thrust_is_held(const Input& in);
  static FieldFault loose_thrust(const Input& in);
  static bool bores_fit(const Input& in);
  static bool bearings_sit(const Input& in);
  static FieldFault slips(const Input& in);
  static bool notches_fit(const Input& in);
  static FieldFault misfit(const Input& in);
  static bool connections_match(const Input& in);
  static FieldFault other_diameter(const Input& in);
  static bool notches_apart(const Input& in);
  static FieldFault crowd(const Input& in);
  static bool keyways_in_hubs(const Input& in);
  static FieldFault keyway_beyond_hub(const Input& in);
  static bool steps_are_notched(const Input& in);
  static FieldFault bare_step(const Input& in);
  static bool slopes_of_all(const Input& in);
  static FieldFault slope_missing(const Input& in);
  static bool forces_make_torques(const Input& in);
  static FieldFault other_torque(const Input& in);
  static bool turn_alike(const Input& in);
  static bool discs_are_bodies(const Input& in);
  static FieldFault no_body(const Input& in);
  static bool forces_turn_alike(const Input& in);
  static Applies weighed(const Input& in);
  static Applies thin_wall(const Input& in);
  static Applies abuts(const Input& in);
  static bool treated_thick(const Input& in);
  static bool torque_runs(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&held, "supports", "a shaft needs at least two bearings, at different positions"},
      Rule<Input>{&within_ends, "supports, seats, notches", "components must lie between the shaft ends", &off_shaft},
      Rule<Input>{&on_shaft, "supports, pieces", "pressure centres must lie between the shaft ends", &off_shaft},
      Rule<Input>{&bores_fit, "pieces", "a bore must be smaller than the diameters of its segment and the neighbours"},
      Rule<Input>{&bearings_sit, "supports, pieces", "bearings must be on cylindrical segments", &slips},
      Rule<Input>{&turn_is_known, "seats", "loads over a revolution must be given at all of its positions", &open_turn},
      Rule<Input>{&torques_close, "seats", "driving and driven torques must balance", &open_sum},
      Rule<Input>{&thrust_is_held, "seats, supports", "exactly one bearing must take axial forces: holds = \"both\"",
                  &loose_thrust},
      Rule<Input>{&speeds_agree, "n, seats", "all components of a shaft must have the same speed, not zero"},
      Rule<Input>{&notches_fit, "notches, pieces, r_T, group", "the notches must match the shaft", &misfit},
      Rule<Input>{&connections_match, "seats, pieces, R_m", "connections must match the diameter of the shaft",
                  &other_diameter},
      Rule<Input>{&notches_apart, "notches, pieces, seats", "notches must be far enough apart", &crowd, true},
      Rule<Input>{&keyways_in_hubs, "notches, seats", "a keyway must lie within its hub", &keyway_beyond_hub, true},
      Rule<Input>{&steps_are_notched, "notches, pieces, S_D", "each change of diameter needs a notch", &bare_step},
      Rule<Input>{&slopes_of_all, "supports, seats",
                  "give beta_adm of every bearing or of none, and likewise of the seats", &slope_missing},
      Rule<Input>{&forces_make_torques, "seats", "F_y x_w must equal the torque T", &other_torque},
      Rule<Input>{&forces_turn_alike, "seats",
                  "driving and driven components give opposite torques: F_y x_w of a mounted component has the wrong "
                  "sign; give the direction of rotation of gears, turns = \"cw\""},
      Rule<Input>{&turn_alike, "seats",
                  "mounted components rotate in opposite directions in two steps: turns = \"cw\" of the gears reverses "
                  "their forces",
                  nullptr, true},
      yields_before_it_breaks<Input>(),
      lasts_below_tensile<&Input::sigma_W, Input>("sigma_W, R_m"),
      Rule<Input>{&discs_are_bodies, "seats", "a disc must be a body of revolution", &no_body},
      Rule<Input>{[](const Input& in) { return !(in.E < 2.0 * in.G || in.E > 3.0 * in.G); }, "E, G",
                  "E must be between 2 G and 3 G: moduli of the same material"},
      Rule<Input>{&treated_thick, "d_h, pieces",
                  "the heat treatment diameter must not be below that of the finished part"},
      Rule<Input>{[](const Input& in) { return asks_fatigue(in) || !is_set(in.r_T); }, "S_D, r_T",
                  "r_T applies to fatigue, which needs the safety factor S_D"},
      Rule<Input>{[](const Input& in) { return !asks_fatigue(in) || is_set(in.r_T) || torque_runs(in); },
                  "S_D, r_T, seats", "fatigue needs the torque ratio r_T, or torques over a revolution"},
      Rule<Input>{[](const Input& in) { return !asks_fatigue(in) || is_set(in.R_m); }, "R_m, S_D",
                  "fatigue needs the tensile strength R_m, or a material"},
      Rule<Input>{[](const Input& in) { return !asks_fatigue(in) || is_set(in.R_e); }, "R_e, S_D",
                  "fatigue needs the yield strength R_e, or a material"},
      Rule<Input>{[](const Input& in) {
                    return !asks_fatigue(in) || is_set(in.sigma_W) || in.group <= fatigue::Endurance::Group::cast_steel;
                  },
                  "sigma_W, group", "the estimate of the fatigue limit applies to steels: give sigma_W"},
      Rule<Input>{[](const Input& in) {
                    const bool steel = in.group <= fatigue::Endurance::Group::cast_steel;
                    return in.method < School::din743 || (is_set(in.R_z) && steel);
                  },
                  "method, R_z, group", "DIN 743, FKM and Serensen apply to steels and need the roughness R_z"},
      safety_has_its_yield<Input>(),
      Rule<Input>{[](const Input& in) { return is_set(in.E) && is_set(in.G); }, "E, G",
                  "bending needs the moduli E and G, or a material"},
      Rule<Input>{&stiff_enough, "supports, pieces, E, G", "the bearings are too compliant to support the shaft"},
      Rule<Input>{[](const Input& in) { return !is_set(in.g_angle) || is_set(in.rho); }, "g_angle, rho",
                  "its weight needs the density rho, or a material"}};

  static Applies loaded(const Input& in) { return where(!in.seats.empty() || is_set(in.g_angle)); }
  static Applies running(const Input& in);
  static Applies passes_resonance(const Input& in);
  static Applies bears_discs(const Input& in);
  /// Bearings of a shaft that turns have a life, whatever its loads come from.
  static Applies bears_bearings(const Input& in) { return std::max(Applies::unseen, running(in)); }
  static Applies lacks_connection(const Input& in);
  static Applies has_connection(const Input& in);
  static Applies bears_rims(const Input& in);
  static Applies pushes_hubs(const Input& in);
  static Applies lacks_notch(const Input& in);
  static Applies has_mild_notch(const Input& in);
  static Applies has_long_hub(const Input& in);
  static Applies has_turned_pulley(const Input& in);
  static Applies has_fast_fit(const Input& in);
  static Applies cannot_be_assembled(const Input& in);
  static Applies tired(const Input& in);
  static Applies endless(const Input& in) {
    const bool has_no_limit = in.group >= fatigue::Endurance::Group::wrought_aluminium || lacks_fatigue_limit(in);
    return has_no_limit ? tired(in) : Applies::no;
  }
  static Applies crowds(const Input& in) { return where(asks_fatigue(in) && !notches_apart(in)); }
  static Applies brittle(const Input& in) { return shown_by(in.group == fatigue::Endurance::Group::grey_iron); }
  static constexpr std::array senses{SenseClaim{"seats.T", "r_T"}};
  static double most_toward_mate(const Input& in, std::size_t seat) {
    return in.seats[seat].kind == Mounted::gear ? 0.0 : unset<double>;
  }
  static constexpr std::array bounds{
      Bound<Input>{"seats.F_x", "gears, which their tooth force pushes apart", &most_toward_mate}.sparing_results()};

  static constexpr std::array meanings{
      Meaning{"sigma_W", fatigue::specimen_in_bending},
      Meaning{"sections.sigma_b, sections.M, sections.M_x, sections.M_y, M_max", reverses_in_turns}};
  static constexpr std::array modes{
      Mode<Input>{"yield", "yielding of shaft sections", &loaded}.judged_by("sections.u_v, s_max"),
      Mode<Input>{"fatigue", "fatigue of sections and notches", &tired}
          .judged_by("safeties.u_D, safeties.x_b, safeties.x_t, safeties.x_d, safeties.x_n, safeties.x_r, "
                     "safeties.x_DIN, x_E, s_max")
          .wanting("S_D, r_T")
          .in_service(),
      Mode<Input>{"cycles", "fatigue without a fatigue limit (fatigue.life of each section)", &endless}
          .assessed_additionally_in("fatigue.life"),
      Mode<Input>{"neighbours", "fatigue at interacting notches", &crowds},
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"deflection", "deflection", &loaded}.judged_by("u_y, s_max").of_service(),
      Mode<Input>{"slope_bearings", "shaft slope at bearings", &loaded}
          .judged_by("bearings.u_beta, s_max")
          .wanting("supports[].beta_adm")
          .of_service(),
      Mode<Input>{"slope_seats", "shaft slope at mounted components", &loaded}
          .judged_by("seats.u_beta, s_max")
          .wanting("seats[].beta_adm")
          .of_service(),
      Mode<Input>{"twist", "angle of twist per unit length", &loaded}.judged_by("u_theta, s_max").of_service(),
      Mode<Input>{"critical_bending", "lateral critical speed (whirling)", &running}
          .judged_by("u_n, s_max")
          .wanting("rho, seats[].mass")
          .in_service(),
      Mode<Input>{"discs", "gyroscopic effect of attached discs", &bears_discs}
          .wanting("seats[].I_p, seats[].I_d")
          .special(),
      Mode<Input>{"whirl_orders", "whirl excitation by higher orders", &unseen<Input>}.special(),
      Mode<Input>{"critical_torsion", "torsional critical speed", &running}
          .judged_by("harmonics.u_h, s_max")
          .wanting("rho, seats[].J")
          .in_service(),
      Mode<Input>{"resonance", "passage through torsional resonance", &passes_resonance}.special(),
      Mode<Input>{"train", "torsional vibration of the drive train", &unseen<Input>}.special(),
      Mode<Input>{"bearings", "bearing life and static safety factor", &bears_bearings}
          .left_to("bearing.rolling",
                   "bearings.fatigue, bearings.static, bearings.axial, bearings.radial, bearings.ribs, bearings.mate, "
                   "bearings.pressure_centre, bearings.skidding, bearings.speed")
          .in_service(),
      Mode<Input>{"weight", "bending due to self-weight", &weighed}.wanting("g_angle").special(),
      Mode<Input>{"wall", "local buckling of thin walls", &thin_wall},
      Mode<Input>{"abutment", "shoulder (abutment) height", &abuts}.judged_by("sections.u_h").of_shape(),
      Mode<Input>{"hub", "keys, splines and press fits", &lacks_connection}
          .wanting("seats[].connection")
          .assessed_additionally_in("shaft.key, shaft.spline, shaft.press_fit, shaft.set_screw, pin.cross"),
      Mode<Input>{"connection", "torque capacity of shaft-hub connections", &has_connection}
          .judged_by("seats.x_c, seats.x_peak")
          .advising("x_peak: give T_max in the step of the key or spline; x_c: give T there"),
      Mode<Input>{"pushed", "axial load on shaft-hub connections", &pushes_hubs}.wanting("seats[].F_c"),
      Mode<Input>{"seat_fatigue", "shaft fatigue under hubs, notch of the connection missing", &lacks_notch}.wanting(
          "notches[].part"),
      Mode<Input>{"notch_factors", "notch factors of the connection", &has_mild_notch}.advising(
          "use the notch of the connection, part = \"=key.notch\", or accept.notch_factors = \"source\""),
      Mode<Input>{"rim", "gear rim thickness over the keyway", &bears_rims}
          .judged_by("seats.m_R, seats.x_R")
          .of_shape(),
      Mode<Input>{"hub_length", "connection length within the hub", &has_long_hub}.advising(
          "give the hub width b of the seat, or confirm a longer hub: accept.hub_length = \"...\""),
      Mode<Input>{"one_piece", "pulley or sprocket integral with the shaft", &has_turned_pulley}.advising(
          "give the seat a connection, or confirm the integral design: accept.one_piece = \"...\""),
      Mode<Input>{"assembly", "axial clearance and assembly of components", &cannot_be_assembled}.advising(
          "correct positions, widths and diameters, or confirm the design (split, dished): accept.assembly = \"...\""),
      Mode<Input>{"fit_speed", "interference of press fits at speed", &has_fast_fit}.judged_by("seats.x_n"),
      Mode<Input>{"turning_loads", "rotating loads (unbalance, crank)", &unseen<Input>}.special(),
      Mode<Input>{"brittle", "brittle fracture", &brittle}.special(),
      Mode<Input>{"corrosion", "corrosion and fretting", &unseen<Input>}.special()};

  /// Diameters that are searched for together; calculators/shaft/design/sizing.cpp says how.
  static constexpr auto sized = "pieces";
  static bool arrange(const Input& in, std::span<OpenSize> sought, std::size_t way);
  static bool raise(const Input& in, std::span<OpenSize> sought);
  static double cost(const Input& in);
  static const void* place(const Input& in, std::string_view list, const void* element);
  static Message unsound(const Input& in, std::span<const OpenSize> sought, std::size_t which);

  static constexpr bool takes_series = false;
  static constexpr bool turns = true;
  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::shaft
