// The characteristics of a stress cycle from any two of them; its kind; which other cycles are similar to it.
//
// Decides sigma_max, sigma_min, mean, amplitude and ratio r, and the kind of the cycle, [B20]; for shear stresses
// alike. Cycles of one ratio are similar; +inf and -inf are one ratio, that of a pulsation below zero. Where a yield
// strength is given the largest stress is checked against it. Tension is positive. Not covered: life, fatigue limits,
// histories that are no cycle.
#pragma once

#include "calculators/fatigue/cycle_of.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::fatigue {

struct Cycle {
  static constexpr auto id = "fatigue.cycle";
  static constexpr auto title = "Stress cycle";
  static constexpr auto scope =
      "Largest, least and mean stress, amplitude, ratio and kind of a stress cycle from any two of these; similar "
      "cycles; normal and shear stresses alike. Life and fatigue limit are not covered.";
  static constexpr auto source = "[B20]";
  static constexpr auto example = R"([project]
title = "Cycle of a connecting rod"

[rod]
calculator = "fatigue.cycle"
sigma_max = "120 MPa"
sigma_min = "-40 MPa"
others = [{ name = "test", sigma_a = "100 MPa", r = -1 }]
)";

  enum class Stresses { normal, shear };
  enum class Similar { yes, no };

  struct Other : Given {
    Name name;
    static constexpr std::tuple fields =
        std::tuple_cat(std::tuple{NameField<Other>{&Other::name, "name", "name of the cycle"}.may_be_missing()},
                       given_fields<Other>());
  };
  static constexpr std::size_t most_others = 16;

  struct Input : Given {
    Stresses stress = Stresses::normal;
    Stress R_e = unset<Stress>;
    List<Other, most_others> others;
  };
  static bool two_given(const Input& in);
  static bool sound(const Input& in);
  static FieldFault wrong_count(const Input& in);
  static FieldFault unsound(const Input& in);
  static constexpr std::tuple inputs = std::tuple_cat(
      given_fields<Input>(),
      std::tuple{Choice<Input, Stresses>{&Input::stress, "stress", "what varies"}.may_be_missing(),
                 Field<Input, Stress>{&Input::R_e, "R_e", MPa, "yield strength, to check the largest stress"}
                     .positive()
                     .usually(50, 2500)
                     .from("material", "R_e"),
                 ListField<Input, Other, most_others>{&Input::others, "others", "cycles that are compared with it"}
                     .may_be_missing()});

  struct Compared : Characteristics {
    Similar similar = Similar::no;
    static constexpr std::tuple fields = std::tuple_cat(
        cycle_fields<Compared>(),
        std::tuple{Choice<Compared, Similar>{&Compared::similar, "similar", "of one ratio with the first cycle"}});
  };

  struct Result : Characteristics {
    double u_y = unset<double>;
    List<Compared, most_others> others;
  };
  static constexpr std::tuple results = std::tuple_cat(
      cycle_fields<Result>(),
      std::tuple{
          Field<Result, double>{&Result::u_y, "u_y", ratio, "yielding: largest stress over the yield strength"}.check(
              "R_e"),
          ListField<Result, Compared, most_others>{&Result::others, "others", "the compared cycles"}});

  static constexpr std::array rules{
      Rule<Input>{&two_given, "sigma_max, sigma_min, sigma_m, sigma_a, r",
                  "two of sigma_max, sigma_min, sigma_m, sigma_a and r make a cycle", &wrong_count},
      Rule<Input>{&sound, "sigma_max, sigma_min, sigma_m, sigma_a, r", "these two do not make a cycle", &unsound}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<draw::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Cycle::Stresses) {
  using Stresses = Cycle::Stresses;
  return std::array{ChoiceName<Stresses>{Stresses::normal, "normal", "normal stresses, sigma"},
                    ChoiceName<Stresses>{Stresses::shear, "shear", "shear stresses: read tau for sigma"}};
}

constexpr auto choices_of(Cycle::Similar) {
  using Similar = Cycle::Similar;
  return std::array{ChoiceName<Similar>{Similar::yes, "yes", "the ratios are equal"},
                    ChoiceName<Similar>{Similar::no, "no", "the ratios differ"}};
}

}  // namespace loadpath::fatigue
