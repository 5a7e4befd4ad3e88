// The characteristics of a stress cycle from any two of them; its kind; which other cycles are similar to it.
//
// Decides sigma_max, sigma_min, mean, amplitude and ratio r, and the kind of the cycle, [B20]; for shear stresses
// alike. Cycles of one ratio are similar; +inf and -inf are one ratio, that of a pulsation below zero. The largest
// stress is compared with a yield strength, the amplitude against the fatigue limit of the part in symmetric cycles,
// each with its safety. Tension is positive, and lowers that limit: such a cycle is not covered; what compression
// adds to it is not counted. Not covered: mean stress and life (fatigue.life takes the full cycle), histories.
#pragma once

#include "calculators/fatigue/cycle_of.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/strength_rules.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/form.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::fatigue {

struct Cycle {
  static constexpr auto id = "fatigue.cycle";
  static constexpr auto title = "Stress cycle";
  static constexpr auto scope =
      "Maximum, minimum and mean stress, amplitude, stress ratio and type of a cycle from any two of them, for "
      "normal or shear stress, with yielding by the maximum stress and, where no tensile mean stress acts, the "
      "amplitude against a fatigue limit at r = −1; mean stress and life: fatigue.life.";
  static constexpr auto source = "[B20]";
  static constexpr auto headline = "sigma_a = {sigma_a}";
  static constexpr auto subject = "the stress cycle";
  static constexpr auto synonyms =
      "stress cycle, amplitude, mean stress, stress ratio, R ratio, alternating stress, pulsating stress, fatigue, "
      "Spannungsamplitude, Mittelspannung, Spannungsverhältnis, Schwellbeanspruchung, Wechselbeanspruchung, "
      "цикл напряжений, амплитуда, коэффициент асимметрии";
  static constexpr auto example = R"([project]
title = "Cycle of a connecting rod"

[rod]
calculator = "fatigue.cycle"
sigma_max = "120 MPa"
sigma_min = "-40 MPa"
others = [{ name = "test", sigma_a = "100 MPa", r = -1 }]
)";

  enum class Similar { yes, no };

  struct Other : Given {
    Name name;
    static constexpr Fields fields = join(
        Fields{NameField<Other>{&Other::name, "name", "name of the cycle"}.may_be_missing()}, given_fields<Other>());
  };
  static constexpr std::size_t most_others = 16;

  struct Input : Given {
    Stresses stress = Stresses::normal;
    Length d_h = unset<Length>;
    Stress R_e = unset<Stress>, E = unset<Stress>, sigma_D = unset<Stress>;
    Density rho = unset<Density>;
    double S_F = unset<double>, S_D = unset<double>, N = unset<double>, N_D = unset<double>;
    List<Other, most_others> others;
  };
  static bool two_given(const Input& in);
  static bool sound(const Input& in);
  static FieldFault miscount(const Input& in);
  static FieldFault objectionable(const Input& in);
  static Applies varies(const Input& in);
  static constexpr Fields inputs = join(
      Fields{RecordField<Input>{"cycle", "maximum stress of a part: cycle = \"=shaft.cycle\""}}, given_fields<Input>(),
      Fields{Choice<Input, Stresses>{&Input::stress, "stress", "stress component: normal or shear"}.may_be_missing(),
             Field<Input, Stress>{&Input::R_e, "R_e", MPa, "yield strength, to check the maximum stress"}
                 .positive()
                 .usually(50, 2500)
                 .customarily_at_most(most_yield_strength)
                 .from("material", "R_e", "d_h"),
             modulus_of_material<Input>(&Input::E), density_of_material<Input>(&Input::rho),
             diameter_at_heat_treatment(&Input::d_h).at_least_that_of_source("d_s, t, d_h"),
             Field<Input, double>{&Input::S_F, "S_F", ratio, "required safety factor against yielding"}
                 .at_least(1)
                 .usually(1, 6)
                 .customarily_at_least(1.2)
                 .may_be_missing()
                 .factor(),
             Field<Input, Stress>{&Input::sigma_D, "sigma_D", MPa,
                                  "fatigue limit of the part, r = −1, as nominal stress, e.g. of fatigue.endurance"}
                 .positive()
                 .usually(5, 1500)
                 .may_be_missing(),
             Field<Input, double>{&Input::S_D, "S_D", ratio, "safety against the fatigue limit"}
                 .at_least(1)
                 .usually(1.2, 6)
                 .customarily_at_least(1.2)
                 .may_be_missing()
                 .factor(),
             ListField<Input, List<Other, most_others>>{&Input::others, "others", "cycles compared with this one"}
                 .may_be_missing()},
      cycles_of_metal<Input>());

  struct Compared : Characteristics {
    Name name;
    Similar similar = Similar::no;
    static constexpr Fields fields =
        join(Fields{NameField<Compared>{&Compared::name, "name", "name of the cycle"}}, cycle_fields<Compared>(),
             Fields{Choice<Compared, Similar>{&Compared::similar, "similar", "of one ratio with the first cycle"}});
  };

  struct Result : Characteristics {
    double u_y = unset<double>, u_F = unset<double>, u_D = unset<double>, x_m = unset<double>;
    double x_N = unset<double>;
    WholeCycle cycle;
    List<Compared, most_others> others;
  };
  static constexpr Fields results = join(
      cycle_fields<Result>(),
      Fields{
          Field<Result, double>{&Result::u_y, "u_y", ratio, "yielding: maximum stress / yield strength"}.check("R_e"),
          Field<Result, double>{&Result::u_F, "u_F", ratio, "yielding: required / calculated safety factor"}.check(
              "S_F"),
          Field<Result, double>{&Result::u_D, "u_D", ratio, "fatigue: amplitude over the limit, with its safety"}.check(
              "sigma_D"),
          Field<Result, double>{&Result::x_m, "x_m", ratio,
                                "mean stress over the amplitude, where it lowers the limit of r = −1"}
              .limit(0, same, "sigma_D")
              .where_it_applies(),
          cycles_over_told<Result>(&Result::x_N),
          Group<Result, WholeCycle>{&Result::cycle, "cycle", "the full cycle, for fatigue.life: cycle"}.handed_over(),
          ListField<Result, List<Compared, most_others>>{&Result::others, "others", "the compared cycles"}});

  static constexpr bool turns = true;
  static constexpr std::array rules{
      Rule<Input>{&two_given, "sigma_max, sigma_min, sigma_m, sigma_a, r",
                  "a cycle needs two of sigma_max, sigma_min, sigma_m, sigma_a and r", &miscount},
      Rule<Input>{&sound, "sigma_max, sigma_min, sigma_m, sigma_a, r", "these two do not define a cycle",
                  &objectionable},
      safety_has_its_yield<Input>(),
      Rule<Input>{[](const Input& in) { return is_set(in.S_D) == is_set(in.sigma_D); }, "sigma_D, S_D",
                  "the fatigue limit sigma_D and its safety factor S_D must be given together"}};

  static constexpr std::array meanings{Meaning{"sigma_D", limit_in_normal, "stress", "normal"},
                                       Meaning{"sigma_D", limit_in_shear, "stress", "shear"},
                                       Meaning{"sigma_max", "max"},
                                       Meaning{"sigma_min", "min"},
                                       Meaning{"sigma_a", "amplitude"},
                                       Meaning{"sigma_m", steady_part}};

  static constexpr std::array modes{
      Mode<Input>{"yield", "first-cycle yielding", &always<Input>}
          .judged_by("u_y, u_F")
          .left_to("fatigue.life", "cycle.yield"),
      Mode<Input>{"fatigue", "infinite-life fatigue", &varies}
          .judged_by("u_D, x_m")
          .left_to("fatigue.life", "cycle.fatigue"),
      fatigue_of_metal<&varies, Input>(),
      Mode<Input>{"life", "finite-life fatigue", &unseen<Input>}.left_to("fatigue.life", "cycle.fatigue"),
      Mode<Input>{"notch", "local yielding at the notch root", &unseen<Input>}};

  static constexpr std::array forms{Form{"sigma_max, sigma_min, R_e"}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Cycle::Similar) {
  using Similar = Cycle::Similar;
  return std::array{ChoiceName<Similar>{Similar::yes, "yes", "the ratios are equal"},
                    ChoiceName<Similar>{Similar::no, "no", "the ratios differ"}};
}

}  // namespace loadpath::fatigue
