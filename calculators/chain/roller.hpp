// A drive with a roller or bush chain: geometry, chain tension, pressure in the joints, safety against breaking, shaft
// loads.
//
// Decides the even number of links and the centre distance that belongs to it, exactly in both directions for a chain
// that lies on circles of z p/(2 pi); speeds, chordal action, tension with centrifugal force and sag, and the
// capacity of the chain. Wear and fatigue of plates and rollers govern a chain, not its breaking load: that safety
// factor is not a sufficient criterion. The rated power of the chain manufacturer goes in as P_R, on the basis of ISO
// 10823 (19 teeth, 15 000 h, 120 links). K_A acts once: on the tension from the power. Not covered: idlers, more than
// two sprockets, the sag of vertical drives. A bush chain differs by its joint area and breaking load only. The
// position of the drive (theta, loaded) decides whether a slack strand above sags onto the tight one, and whether it
// needs a tensioner.
#pragma once

#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::chain {

struct Roller {
  static constexpr auto id = "chain.roller";
  static constexpr auto title = "Roller chain drive";
  static constexpr auto scope =
      "Chain length and centre distance of a two-sprocket roller or bush chain drive, speed limits by lubrication, "
      "chordal action, chain pull, sag, pin bearing pressure, static safety factor against breakage and shaft loads; "
      "service life is not covered.";
  static constexpr auto source = "[ASME-B29], [B40], [ISO10823]";
  static constexpr auto headline = "z {z_1}/{z_2}, p {p}";
  static constexpr auto details = "{X} links, a = {a}, chain speed v = {v}, shaft load F_W = {F_W}";
  static constexpr auto synonyms =
      "roller chain, bush chain, chain drive, sprocket, ISO 606, ISO 10823, chain pull, chordal action, polygon "
      "effect, Rollenkette, Buchsenkette, Hülsenkette, Kettentrieb, Kettenrad, Polygoneffekt, chain, Kette, цепная "
      "передача, роликовая цепь, втулочная цепь, звёздочка";
  static constexpr auto example = R"([project]
title = "Chain from a gear motor to a conveyor"

[conveyor]
calculator = "chain.roller"
chain = "16B"
edition = "maker"
z_1 = 21
z_2 = 57
n_1 = "96 rpm"
P = "3 kW"
K_A = 1.3
a = "1000 mm"
p_adm = "35 MPa"
S_min = 7.6
P_R = "5.5 kW"
)";

  enum class Edition { maker, iso606_1994 };
  enum class Lubrication { grease, bath };
  enum class Loaded { upper, lower };

  struct Input {
    Length p = unset<Length>, p_t = unset<Length>;
    Area A = unset<Area>;
    Edition edition = Edition::maker;
    Force F_uM = unset<Force>, F_u94 = unset<Force>;
    LineDensity q = unset<LineDensity>;
    Whole strands = 1;
    Whole z_1 = 0, z_2 = 0;
    Length a = unset<Length>;
    Whole X = 0;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Power P = unset<Power>;
    Moment T_1 = unset<Moment>;
    double K_A = 1.0;
    double K_f = 6.0;
    Lubrication lubrication = Lubrication::grease;
    double theta = unset<double>;
    Loaded loaded = Loaded::upper;
    Stress p_adm = unset<Stress>;
    double S_min = unset<double>;
    Power P_R = unset<Power>;
  };
  static Applies inclined(const Input& in) { return where(is_set(in.theta)); }
  static Applies sags_down(const Input& in) { return where(is_set(in.theta) && in.loaded == Loaded::lower); }
  static bool sprockets_apart(const Input& in);
  static FieldFault sprockets_touch(const Input& in);
  static bool links_reach(const Input& in);
  static FieldFault too_few_links(const Input& in);
  static Applies loaded(const Input& in) { return where(is_set(in.P) || is_set(in.T_1)); }
  /// Wear and fatigue by running only.
  static Applies runs_loaded(const Input& in) {
    return loaded(in) == Applies::yes ? shown_by(is_set(in.n_1)) : Applies::no;
  }
  static constexpr Fields inputs{
      Field{&Input::p, "p", mm, "pitch of the chain"}
          .positive()
          .usually(4, 120)
          .from("chain", "p")
          .same_as_that_of_source("stages[#].p"),
      Field{&Input::p_t, "p_t", mm, "transverse pitch (distance of two strands)"}.positive().from("chain", "p_t"),
      Field{&Input::A, "A", mm2, "joint bearing area: pin diameter x inner link width, one strand"}
          .positive()
          .usually(5, 5000)
          .from("chain", "A"),
      Choice{&Input::edition, "edition", "source of the breaking loads: manufacturer or ISO 606:1994"}.may_be_missing(),
      Field{&Input::F_uM, "F_uM", kN, "breaking load of one strand, manufacturer's value"}
          .positive()
          .usually(1, 1500)
          .from("chain", "F_uM")
          .where_it_has(),
      Field{&Input::F_u94, "F_u94", kN, "breaking load of one strand, ISO 606 of 1994"}
          .positive()
          .usually(1, 1500)
          .from("chain", "F_u94"),
      Field{&Input::q, "q", kg_per_m, "mass per length of one strand"}
          .positive()
          .usually(0.05, 100)
          .from("chain", "q")
          .where_it_has(),
      Count{&Input::strands, "strands", 1, 6, "number of strands"}.may_be_missing(),
      Count{&Input::z_1, "z_1", 7, 150, "number of teeth, driving sprocket"}.same_as_that_of_source("stages[#].z_1"),
      Count{&Input::z_2, "z_2", 7, 150, "number of teeth, driven sprocket"}.same_as_that_of_source("stages[#].z_2"),
      Field{&Input::a, "a", mm, "required centre distance, adjusted to the number of links"}
          .positive()
          .may_be_missing(),
      Count{&Input::X, "X", 0, 2000, "number of links, replaces a; 0: the even number nearest to a"}.may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the driving sprocket"}
          .positive()
          .near_that_of_source("shafts[#].n")
          .may_be_missing(),
      Field{&Input::P, "P", kW, "nominal power, with n_1"}
          .load()
          .at_least(0)
          .at_least_that_of_source("shafts[#].P")
          .may_be_missing(),
      Field{&Input::T_1, "T_1", N_m, "nominal torque of the driving sprocket, replaces P"}
          .load()
          .at_least_that_of_source("shafts[#].T")
          .at_least(0)
          .may_be_missing(),
      Field{&Input::K_A, "K_A", ratio,
            "service factor for the driver and the driven machine (1 if the load includes it)"}
          .at_least(1)
          .usually(1, 2)
          .factor(),
      Field{&Input::K_f, "K_f", ratio, "sag factor: 6 for a horizontal drive, 3 at 40°, 1 for a vertical drive"}
          .within(0, 10)
          .usually(1, 6),
      Choice{&Input::lubrication, "lubrication", "lubrication type"}.may_be_missing(),
      Field{&Input::theta, "theta", deg,
            "inclination of the line of centres to the horizontal; positive: driving sprocket below the driven one"}
          .within(-90, 90)
          .may_be_missing(),
      Choice{&Input::loaded, "loaded", "loaded strand, with theta"}.may_be_missing(),
      Field{&Input::p_adm, "p_adm", MPa, "allowable joint bearing pressure"}.positive().usually(5, 60).may_be_missing(),
      Field{&Input::S_min, "S_min", ratio, "required safety factor against breakage"}
          .at_least(1)
          .usually(5, 20)
          .customarily_at_least(5)
          .may_be_missing(),
      Field{&Input::P_R, "P_R", kW,
            "rated power of this chain for 19 teeth at the speed of the smaller sprocket, all strands"}
          .positive()
          .from("chain", "P_R")
          .where_it_has()};

  struct Result {
    double i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Length d_1 = unset<Length>, d_2 = unset<Length>;
    double X_0 = unset<double>, X = unset<double>;
    Length a = unset<Length>, L = unset<Length>;
    double alpha_1 = unset<double>, alpha_2 = unset<double>;
    double a_p = unset<double>, z_min = unset<double>;
    double odd = unset<double>;
    Speed v = unset<Speed>;
    double v_share = unset<double>;
    double delta_1 = unset<double>, delta_2 = unset<double>;
    Moment T_1 = unset<Moment>, T_2 = unset<Moment>;
    Force F_t = unset<Force>, F_c = unset<Force>, F_f = unset<Force>, F = unset<Force>, F_W = unset<Force>;
    ShaftLoad shaft_1, shaft_2;
    Stress p_r = unset<Stress>;
    Force F_u = unset<Force>;
    double S_stat = unset<double>, S_dyn = unset<double>, u_F = unset<double>;
    double f_2 = unset<double>;
    Power P_c = unset<Power>;
    Length f_s = unset<Length>, g_s = unset<Length>;
    double theta_c = unset<double>;
    double u_p = unset<double>, u_S = unset<double>, u_P = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "speed ratio n_1/n_2 (up to 7, at most 10)"}.limit(0.1, 10),
      Field{&Result::n_2, "n_2", rpm, "mean speed of the driven sprocket"},
      Field{&Result::d_1, "d_1", mm, "pitch diameter, driving sprocket"}
          .at_least_that_of_source("d")
          .same_as_that_of_source("drive.d_1"),
      Field{&Result::d_2, "d_2", mm, "pitch diameter, driven sprocket"}.same_as_that_of_source("drive.d_2"),
      Field{&Result::z_min, "z_min", ratio, "number of teeth of the smaller sprocket (below 17: rough running)"},
      Field{&Result::X_0, "X_0", ratio, "number of links for the required centre distance, not rounded"},
      Field{&Result::X, "X", ratio, "number of links"},
      Field{&Result::odd, "odd", ratio, "odd number of links (weaker cranked link required); 0: even"},
      Field{&Result::a, "a", mm, "centre distance of the taut chain"},
      Field{&Result::a_p, "a_p", ratio, "centre distance in pitches; 30 to 50 is usual"},
      Field{&Result::L, "L", mm, "chain length"},
      Field{&Result::alpha_1, "alpha_1", deg, "wrap angle, driving sprocket (at least 120°)"}.limit(120, 360),
      Field{&Result::alpha_2, "alpha_2", deg, "wrap angle, driven sprocket (at least 120°)"}.limit(120, 360),
      Field{&Result::v, "v", m_per_s, "mean chain speed"},
      Field{&Result::v_share, "v_share", ratio, "chain speed / maximum speed for the lubrication type"}.limit(0, 1,
                                                                                                              "n_1"),
      Field{&Result::delta_1, "delta_1", ratio,
            "speed variation due to chordal action, driving sprocket: (v_max - v_min)/v_max"},
      Field{&Result::delta_2, "delta_2", ratio, "speed variation due to chordal action, driven sprocket"},
      Field{&Result::T_1, "T_1", N_m, "torque of the driving sprocket, nominal"}.load().with("F_W"),
      Field{&Result::T_2, "T_2", N_m, "torque of the driven sprocket, nominal, without losses"}.load().with("F_W"),
      Field{&Result::F_t, "F_t", N, "chain pull, nominal"}.load(),
      Field{&Result::F_c, "F_c", N, "centrifugal force"},
      Field{&Result::F_f, "F_f", N, "chain pull due to sag"},
      Field{&Result::f_s, "f_s", mm, "sag of the slack strand in its middle, new chain"},
      Field{&Result::g_s, "g_s", mm, "clearance between the strands (slack strand above the tight one)"}
          .limit(0, 1e6)
          .criterion()
          .where_it_applies(),
      Field{&Result::theta_c, "theta_c", deg, "inclination to the horizontal (above 60° a tensioner is required)"}
          .limit(0, 60, "theta"),
      Field{&Result::F, "F", N, "maximum chain pull: with service factor, centrifugal force and sag"}.holding("K_A"),
      Field{&Result::F_W, "F_W", N, "force on each shaft, along the line of centres"}.load().with("T_1|T_2").holding(
          "K_A"),
      Group{&Result::shaft_1, "shaft_1", "shaft load on the driving shaft, for load"}.handed_over(),
      Group{&Result::shaft_2, "shaft_2", "shaft load on the driven shaft, for load"}.handed_over(),
      Field{&Result::p_r, "p_r", MPa, "joint bearing pressure"},
      Field{&Result::F_u, "F_u", kN, "breaking load of all strands"},
      Field{&Result::S_stat, "S_stat", ratio, "static safety factor against breakage, without service factor"},
      Field{&Result::S_dyn, "S_dyn", ratio, "dynamic safety factor against breakage, with service factor"},
      Field{&Result::f_2, "f_2", ratio, "tooth factor"},
      Field{&Result::P_c, "P_c", kW, "corrected power, for the rating for 19 teeth"},
      Field{&Result::u_p, "u_p", ratio, "joints: bearing pressure / allowable pressure"}.check("p_adm"),
      Field{&Result::u_F, "u_F", ratio, "breakage: maximum pull / breaking load (of a chain, or F_uM, F_u94)"}.check(
          "P, T_1"),
      Field{&Result::u_S, "u_S", ratio,
            "breakage: required / dynamic safety factor (not sufficient as the only design criterion)"}
          .check("S_min"),
      Field{&Result::u_P, "u_P", ratio, "rating: corrected / rated power"}.check("P_R")};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.p); }, "p", "give the pitch p, or a chain: chain = \"16B\""},
      Rule<Input>{[](const Input& in) { return is_set(in.a) != (in.X > 0); }, "a, X",
                  "give either the centre distance a or the number of links X"},
      Rule<Input>{&sprockets_apart, "a, p, z_1, z_2", "the sprockets touch at this centre distance", &sprockets_touch},
      Rule<Input>{&links_reach, "X, z_1, z_2", "the chain is too short to go around the sprockets", &too_few_links},
      Rule<Input>{[](const Input& in) { return !(is_set(in.P) && is_set(in.T_1)); }, "P, T_1",
                  "give the load as P or as T_1, not both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P) || is_set(in.n_1); }, "P, n_1",
                  "a power needs the speed n_1"},
      Rule<Input>{
          [](const Input& in) { return !is_set(in.p_adm) || (is_set(in.A) && (is_set(in.P) || is_set(in.T_1))); },
          "p_adm, A, P, T_1", "the pressure needs the bearing area A (or a chain) and a load"},
      Rule<Input>{[](const Input& in) {
                    const Force F_u = in.edition == Edition::maker ? in.F_uM : in.F_u94;
                    return !is_set(in.S_min) || (is_set(F_u) && (is_set(in.P) || is_set(in.T_1)));
                  },
                  "S_min, edition, F_uM, F_u94, P, T_1",
                  "the safety factor needs the breaking load of the edition (or a chain that has it) and a load"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P_R) || is_set(in.P); }, "P_R, P",
                  "the rating is compared with the power P"},
      Rule<Input>{[](const Input& in) { return !is_set(in.theta) || in.K_f > 0.0; }, "theta, K_f",
                  "the sag needs a sag factor K_f above 0"},
      Rule<Input>{[](const Input& in) { return is_set(in.theta) || in.loaded == Loaded::upper; }, "loaded, theta",
                  "the loaded strand needs the inclination theta; 0°: horizontal"},
      Rule<Input>{[](const Input& in) { return in.X % 2 == 0; }, "X",
                  "an odd number of links needs a cranked link, which is weaker", nullptr, true},
      Rule<Input>{[](const Input& in) { return in.z_1 >= 17 && in.z_2 >= 17; }, "z_1, z_2",
                  "fewer than 17 teeth: rough running and rapid wear", nullptr, true}};

  static double most_rating(const Input& in);
  /// That of the inclination; where this is not given and K_f impossible, that of a horizontal drive, the largest.
  static double least_sag(const Input& in);
  static double most_centre(const Input& in);
  static double most_links(const Input& in);
  static constexpr std::array bounds{Bound<Input>{"P_R", "twice the ASME B29.1 rating for this pitch", &most_rating},
                                     Bound<Input>{"K_f", "this inclination (0°: 6, vertical: 1)", &least_sag}.least(),
                                     Bound<Input>{"a", "80 pitches (slack strand above: 60)", &most_centre},
                                     Bound<Input>{"X", "80 pitches (slack strand above: 60)", &most_links}};

  static constexpr bool turns = true;
  static constexpr std::array modes{
      Mode<Input>{"joints", "pin-bush joint wear (bearing pressure)", &loaded}.judged_by("u_p"),
      Mode<Input>{"breaking", "static breaking strength of the chain", &loaded}.judged_by("u_S, u_F"),
      Mode<Input>{"plates", "link plate fatigue", &runs_loaded}.judged_by("u_P").in_service(),
      Mode<Input>{"cranked_link", "strength of the cranked link", [](const Input& in) { return where(in.X % 2 != 0); }},
      Mode<Input>{"rollers", "roller and bush impact fatigue", &runs_loaded}.judged_by("u_P").in_service(),
      Mode<Input>{"speed", "chain speed for the lubrication type",
                  [](const Input& in) { return where(is_set(in.n_1)); }}
          .judged_by("v_share"),
      Mode<Input>{"wrap_1", "wrap angle, driving sprocket", &always<Input>}.judged_by("alpha_1").of_shape(),
      Mode<Input>{"wrap_2", "wrap angle, driven sprocket", &always<Input>}.judged_by("alpha_2").of_shape(),
      Mode<Input>{"ratio", "speed ratio per stage", &always<Input>}.judged_by("i").of_shape(),
      Mode<Input>{"strands", "contact of the strands, slack strand above", &sags_down}.judged_by("g_s").of_shape(),
      Mode<Input>{"position", "inclination of the line of centres", &inclined}.judged_by("theta_c").of_shape(),
      Mode<Input>{"galling", "galling of pins and bushes", &unseen<Input>}.judged_by("u_P").special(),
      Mode<Input>{"sprockets", "sprocket tooth wear", &unseen<Input>}.special(),
      Mode<Input>{"vibration", "strand vibration due to chordal action", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Roller::Edition) {
  using Edition = Roller::Edition;
  return std::array{ChoiceName<Edition>{Edition::maker, "maker", "current list of a manufacturer (Donghua 2020)"},
                    ChoiceName<Edition>{Edition::iso606_1994, "iso606_1994", "ISO 606:1994"}};
}
constexpr auto choices_of(Roller::Lubrication) {
  using Lubrication = Roller::Lubrication;
  return std::array{ChoiceName<Lubrication>{Lubrication::grease, "grease", "by hand or drops: up to 6 m/s"},
                    ChoiceName<Lubrication>{Lubrication::bath, "bath", "in an oil bath: up to 12 m/s"}};
}

constexpr auto choices_of(Roller::Loaded) {
  using Loaded = Roller::Loaded;
  return std::array{
      ChoiceName<Loaded>{Loaded::upper, "upper", "upper strand: the slack strand hangs free below"},
      ChoiceName<Loaded>{Loaded::lower, "lower",
                         "lower strand: the slack strand sags toward it; stays in the teeth better, [B40]"}};
}

}  // namespace loadpath::chain
