// V-belt drives that can be bought: from power, speeds and a rough centre distance to sections, pulleys, belts and
// their number, ranked, with the winner checked by belt.v itself.
//
// Every section of the basis, every pair of standard pulleys that meets the speed, and the standard belt nearest to the
// centre distance are tried; what fails a check or a limit of belt.v is left out and counted.
// Not covered: price and stock of a dealer; what belt.v does not cover.
#pragma once

#include "calculators/belt/v/sizing_types.hpp"
#include "calculators/belt/v/v.hpp"

namespace loadpath::belt {

struct VSizing : VSizingTypes {
  static constexpr auto id = "belt.v_sizing";
  static constexpr auto title = "V-belt drive selection";
  static constexpr auto scope =
      "Ranked selection of V-belt drives from standard sections, pulleys and lengths for a power, two speeds "
      "and an approximate centre distance, with the complete belt.v calculation of the best one or of the "
      "nearest candidate where none passes.";
  static constexpr auto source = V::source;
  static constexpr auto headline = "{best.section}, z = {z}";
  static constexpr auto details =
      "d_1 = {d_1}, d_2 = {d_2}, L = {L}, a = {a}, initial tension F_0 = {F_0} per belt, shaft load R = {R}";
  static constexpr auto synonyms =
      "V-belt selection, V-belt sizing, belt selection, standard pulley, standard belt length, catalogue selection, "
      "Keilriemenauswahl, Riemenauslegung, подбор клинового ремня, подбор ремня";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Fan drive"

[fan]
calculator = "belt.v_sizing"
basis = "optibelt"
P = "11 kW"
K_A = 1.2
n_1 = "1460 rpm"
n_2_set = "730 rpm"
a_set = "600 mm"
)";

  static constexpr auto inputs = join(
      Fields{Choice{&Input::basis, "basis", "rating method: ISO 5292 or Optibelt"}.may_be_missing(),
             NameField{&Input::section, "section", "belt section, restricts the selection"}.may_be_missing(),
             Choice{&Input::belt_class, "belt_class", "belt class, with the basis iso"}.may_be_missing(),
             Field{&Input::P, "P", kW, "power, mean over the cycle"}
                 .load()
                 .at_least_that_of_source("shafts[#].P")
                 .positive()
                 .usually(0.05, 3000),
             Field{&Input::K_A, "K_A", ratio, "service factor of the basis (C_P, c_2; 1 if the power includes it)"}
                 .at_least(1)
                 .usually(1, 2)
                 .may_be_missing()
                 .factor(),
             Choice{&Input::duty, "duty", "load type"}.may_be_missing(),
             Choice{&Input::motor, "motor", "starting torque of the driver: normal or high"}.may_be_missing(),
             Field{&Input::h_day, "h_day", hour, "daily operating time"}.positive().within(0.01, 24).may_be_missing(),
             Field{&Input::n_1, "n_1", rpm, "speed of the driving pulley"}
                 .positive()
                 .near_that_of_source("shafts[#].n")
                 .usually(20, 9000)},
      driven_inputs<Input>(),
      Fields{Field{&Input::tol_n, "tol_n", ratio, "tolerance, relative"}.positive().below(0.5).usually(0.005, 0.1),
             Field{&Input::a_set, "a_set", mm, "target centre distance"}.also("a").positive().usually(50, 2e4),
             Field{&Input::tol_a, "tol_a", ratio, "tolerance, relative"}.positive().below(0.9).usually(0.01, 0.5),
             Field{&Input::epsilon, "epsilon", ratio, "slip"}.within(0, 0.1).usually(0, 0.03),
             Field{&Input::d_1_min, "d_1_min", mm, "minimum driving pulley, required by the motor"}
                 .positive()
                 .may_be_missing(),
             Field{&Input::d_max, "d_max", mm, "maximum pulley diameter"}.positive().may_be_missing(),
             Count{&Input::z_max, "z_max", 1, 100, "maximum number of belts"}.may_be_missing(),
             Field{&Input::mu, "mu", ratio, "coefficient of friction, for traction in the grooves"}
                 .positive()
                 .usually(0.1, 0.6)
                 .may_be_missing(),
             Field{&Input::v_rim_adm, "v_rim_adm", m_per_s, "maximum rim speed; cast iron 35 m/s"}
                 .positive()
                 .usually(10, 100)
                 .customarily_at_most(60),
             Choice{&Input::rank, "rank", "ranking criterion"}.may_be_missing()});

  static constexpr Fields results{
      Choice{&Result::rating, "rating", "governing rating method"},
      Field{&Result::tried, "tried", ratio, "number of drives that meet speed and centre distance"},
      Field{&Result::too_weak, "too_weak", ratio, "number of these drives with too many belts"},
      Field{&Result::outside, "outside", ratio, "number of these drives that fail another check or limit"},
      Choice{&Result::section, "section", "belt section"}.chosen(),
      Field{&Result::d_1, "d_1", mm, "datum diameter of the driving pulley"}.chosen(),
      Field{&Result::d_2, "d_2", mm, "datum diameter of the driven pulley"}.chosen(),
      Field{&Result::L, "L", mm, "datum length of the belts"}.chosen(),
      Count{&Result::z, "z", 0, 100, "number of belts"}.chosen(),
      Field{&Result::a, "a", mm, "centre distance"},
      Field{&Result::n_2, "n_2", rpm, "speed of the driven pulley"},
      Field{&Result::i, "i", ratio, "speed ratio n_1/n_2 with slip"},
      Field{&Result::i_w, "i_w", ratio, "required speed ratio"},
      Field{&Result::dev_n, "dev_n", ratio, "deviation of the speed, relative"},
      Field{&Result::dev_a, "dev_a", ratio, "deviation of the centre distance, relative"},
      Field{&Result::n_k, "n_k", rpm, "speed of the smaller pulley, without slip"},
      Field{&Result::L_h, "L_h", hour, "mean life stated by the basis"},
      Field{&Result::F_0, "F_0", N, "initial tension of one belt span, run-in"},
      Field{&Result::R_0, "R_0", N, "shaft load at standstill"}.load().with("P").holding("K_A"),
      Field{&Result::R_new, "R_new", N, "shaft load at standstill, new belts"}.load().with("P").holding("K_A"),
      Field{&Result::R, "R", N, "shaft load in operation"}.load().with("P").holding("K_A"),
      Field{&Result::B, "B", mm, "pulley face width"},
      Field{&Result::u_P, "u_P", ratio, "power: design power / power rating of the belts"}.check(),
      Field{&Result::u_grip, "u_grip", ratio, "traction: required / actual belt tension"}.check("mu"),
      Field{&Result::u_rim, "u_rim", ratio, "rim: larger rim speed / allowable rim speed"}.check(),
      Field{&Result::u_B, "u_B", ratio, "flex rate / maximum flex rate"}.check(),
      Field{&Result::drives, "drives", ratio, "number of standard drives that pass every check"}
          .limit(1, 1e6)
          .criterion(),
      Group{&Result::best, "best", "best drive, for belt.v: drive = \"=pick.best\""}.handed_over(),
      ListField{&Result::candidates, "candidates", "the drives, best first"}};

  static bool section_is_known(const Input& in);
  static bool class_fits(const Input& in);
  static bool service_is_given(const Input& in);
  static FieldFault unknown_section(const Input& in);
  static FieldFault wrong_class(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.n_2_set) != is_set(in.i_set); }, "n_2_set, i_set",
                  "give either the speed n_2 of the driven pulley or the ratio i"},
      Rule<Input>{[](const Input& in) { return in.basis != Basis::unstated; }, "basis",
                  "give the basis, iso or optibelt: their ratings and factors must not be mixed"},
      Rule<Input>{&section_is_known, "section, basis", "the basis does not rate this section", &unknown_section},
      Rule<Input>{&class_fits, "belt_class, basis", "the belt class requires the basis iso", &wrong_class},
      Rule<Input>{
          &service_is_given, "K_A, duty, motor, h_day",
          "give either K_A or, with the basis optibelt, duty = \"medium\", motor = \"normal\" and h_day = \"16 h\""},
      Rule<Input>{[](const Input& in) { return !(is_set(in.d_1_min) && is_set(in.d_max)) || in.d_1_min <= in.d_max; },
                  "d_1_min, d_max", "the smallest driving pulley must not be larger than the largest pulley"}};

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"P", "mean"}};

  static constexpr std::array modes{
      Mode<Input>{"drives", "availability of a standard drive", &always<Input>}
          .judged_by("drives")
          .advising(
              "divide a power beyond all belts over several drives; else try another centre distance or two stages")
          .of_shape(),
      Mode<Input>{"power", "power rating of the belts", &always<Input>}.judged_by("u_P"),
      Mode<Input>{"grip", "belt slip (Euler-Eytelwein)", [](const Input& in) { return shown_by(is_set(in.mu)); }}
          .judged_by("u_grip"),
      Mode<Input>{"rim", "bursting of pulley rims", &always<Input>}.judged_by("u_rim"),
      Mode<Input>{"bending", "flex rate", &always<Input>}.judged_by("u_B"),
      Mode<Input>{"radial_load", "radial load on the motor shaft", &unseen<Input>}.special(),
      Mode<Input>{"heat", "heat, oil and dust", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::belt
