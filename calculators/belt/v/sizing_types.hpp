// Input and result of belt.v_sizing.
#pragma once

#include "calculators/belt/v/v.hpp"
#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::belt {

struct VSizingTypes {
  enum class Rank { pulleys, shaft_load, width };
  enum class Merit { none, best, pulleys, shaft_load, width, speed, centre };

  struct Input {
    Basis basis = Basis::optibelt;
    Name section;
    V::BeltClass belt_class = V::BeltClass::unstated;
    Power P = unset<Power>;
    double K_A = unset<double>;
    V::Duty duty = V::Duty::unstated;
    V::Motor motor = V::Motor::unstated;
    Time h_day = unset<Time>;
    AngularSpeed n_1 = unset<AngularSpeed>, n_2_set = unset<AngularSpeed>;
    double i_set = unset<double>;
    double tol_n = 0.03;
    Length a_set = unset<Length>;
    double tol_a = 0.15;
    double epsilon = 0.01;
    Length d_1_min = unset<Length>, d_max = unset<Length>;
    Whole z_max = 8;
    double mu = unset<double>;
    Speed v_rim_adm = from_si<Speed>(35.0);
    Rank rank = Rank::pulleys;
  };

  struct Candidate {
    SectionWord section = SectionWord::none;
    Length d_1 = unset<Length>, d_2 = unset<Length>, L = unset<Length>;
    Whole z = 0;
    Length a = unset<Length>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Length B = unset<Length>;
    SectionModulus V = unset<SectionModulus>;
    Force R_new = unset<Force>;
    double u_P = unset<double>, excess = unset<double>;
    Merit merit = Merit::none;
    static constexpr Fields fields{
        Choice{&Candidate::section, "section", "belt section"},
        Field{&Candidate::d_1, "d_1", mm, "driving pulley"},
        Field{&Candidate::d_2, "d_2", mm, "driven pulley"},
        Field{&Candidate::L, "L", mm, "length of the belts"},
        Count{&Candidate::z, "z", 0, 100, "number of belts"},
        Field{&Candidate::a, "a", mm, "centre distance"},
        Field{&Candidate::n_2, "n_2", rpm, "speed of the driven pulley"},
        Field{&Candidate::B, "B", mm, "pulley face width"},
        Field{&Candidate::V, "V", dm3, "volume of the two pulleys as full discs"},
        Field{&Candidate::R_new, "R_new", N, "shaft load at standstill, new belts"}.load(),
        Field{&Candidate::u_P, "u_P", ratio, "utilisation of the belts"},
        Field{&Candidate::excess, "excess", ratio, "relative excess over the first candidate in the ranking criterion"},
        Choice{&Candidate::merit, "merit", "advantage over the first candidate"}};
  };
  using Candidates = List<Candidate, 20>;

  /// Input that belt.v takes from a drive.
  struct Drive : V::Input {
    static constexpr const auto& fields = V::inputs;
  };

  struct Result {
    double drives = 0.0, tried = 0.0, too_weak = 0.0, outside = 0.0;
    Basis rating = Basis::optibelt;
    SectionWord section = SectionWord::none;
    Length d_1 = unset<Length>, d_2 = unset<Length>, L = unset<Length>, a = unset<Length>;
    Whole z = 0;
    double i = unset<double>, i_w = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>, n_k = unset<AngularSpeed>;
    Time L_h = unset<Time>;
    double dev_n = unset<double>, dev_a = unset<double>;
    Force F_0 = unset<Force>, R_0 = unset<Force>, R_new = unset<Force>, R = unset<Force>;
    Length B = unset<Length>;
    double u_P = unset<double>, u_grip = unset<double>, u_rim = unset<double>, u_B = unset<double>;
    Drive best;
    Candidates candidates;
  };
};

constexpr auto choices_of(VSizingTypes::Rank) {
  using Rank = VSizingTypes::Rank;
  return std::array{ChoiceName<Rank>{Rank::pulleys, "pulleys", "small pulleys: the volume of the two as full discs"},
                    ChoiceName<Rank>{Rank::shaft_load, "shaft_load", "small shaft load at standstill, new belts"},
                    ChoiceName<Rank>{Rank::width, "width", "narrow pulleys"}};
}
constexpr auto choices_of(VSizingTypes::Merit) {
  using Merit = VSizingTypes::Merit;
  return std::array{ChoiceName<Merit>{Merit::none, "none", "nothing: worse or equal in all"},
                    ChoiceName<Merit>{Merit::best, "best", "it is the first"},
                    ChoiceName<Merit>{Merit::pulleys, "pulleys", "smaller pulleys"},
                    ChoiceName<Merit>{Merit::shaft_load, "shaft_load", "smaller shaft load"},
                    ChoiceName<Merit>{Merit::width, "width", "narrower pulleys"},
                    ChoiceName<Merit>{Merit::speed, "speed", "nearer to the speed"},
                    ChoiceName<Merit>{Merit::centre, "centre", "nearer to the centre distance"}};
}

}  // namespace loadpath::belt
