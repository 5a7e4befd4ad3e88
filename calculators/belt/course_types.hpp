// Input and result of belt.course.
#pragma once

#include "calculators/belt/loop.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::belt {

struct CourseTypes {
  enum class Side { inside, outside };
  enum class Turns { ccw, cw };

  struct Pulley {
    Name name;
    Length x = unset<Length>, y = unset<Length>, d = unset<Length>;
    Side side = Side::inside;
    Power P = unset<Power>;
    double along = unset<double>, mu = unset<double>;
    static constexpr Fields fields{
        NameField{&Pulley::name, "name", "name of the pulley"}.may_be_missing(),
        Field{&Pulley::x, "x", mm, "position of its axis"},
        Field{&Pulley::y, "y", mm, "position of its axis"},
        Field{&Pulley::d, "d", mm, "diameter at the belt centre line, or at the datum line"}.positive().usually(10,
                                                                                                                3000),
        Choice{&Pulley::side, "side", "side of the belt: inside or outside"}.may_be_missing(),
        Field{&Pulley::P, "P", kW, "power taken from the belt; negative: driving"}.load().may_be_missing(),
        Field{&Pulley::mu, "mu", ratio,
              "coefficient of friction on this pulley (flat pulley of a V-belt, belt back); omitted: the "
              "common value"}
            .within(0.01, 10)
            .usually(0.1, 2)
            .may_be_missing(),
        Field{&Pulley::along, "along", deg, "adjustment direction of this pulley for the belt length L"}
            .may_be_missing()};
  };

  struct Input {
    List<Pulley, most_pulleys> pulleys;
    Turns turns = Turns::ccw;
    Length L = unset<Length>;
    AngularSpeed n_1 = unset<AngularSpeed>;
    double mu = unset<double>;
    LineDensity q = 0.0 * kg_per_m;
    Force S_0 = unset<Force>, S_adm = unset<Force>;
  };

  struct PulleyResult {
    Name name;
    Length x = unset<Length>, y = unset<Length>;
    double alpha = unset<double>;
    Length l_s = unset<Length>;
    AngularSpeed n = unset<AngularSpeed>;
    Moment T = unset<Moment>;
    Force S = unset<Force>, R_x = unset<Force>, R_y = unset<Force>, R = unset<Force>;
    double mu_req = unset<double>;
    static constexpr Fields fields{
        NameField{&PulleyResult::name, "name", "pulley"},
        Field{&PulleyResult::x, "x", mm, "position of its axis"},
        Field{&PulleyResult::y, "y", mm, "position of its axis"},
        Field{&PulleyResult::alpha, "alpha", deg, "wrap"},
        Field{&PulleyResult::l_s, "l_s", mm, "free span length after the pulley"},
        Field{&PulleyResult::n, "n", rpm, "speed, counter-clockwise positive"},
        Field{&PulleyResult::T, "T", N_m, "torque of the belt on the pulley, counter-clockwise positive"}.load().with(
            "R|R_x|R_y"),
        Field{&PulleyResult::S, "S", N, "tension of the span after the pulley"},
        Field{&PulleyResult::R_x, "R_x", N, "shaft load, along x"}.load().with("T, R_y"),
        Field{&PulleyResult::R_y, "R_y", N, "shaft load, along y"}.load().with("T, R_x"),
        Field{&PulleyResult::R, "R", N, "shaft load"}.load().with("T"),
        Field{&PulleyResult::mu_req, "mu_req", ratio, "utilised coefficient of friction"}};
  };
  struct Result {
    Length L = unset<Length>, s = unset<Length>;
    Speed v = unset<Speed>;
    AngularSpeed f_B = unset<AngularSpeed>;
    Power P_1 = unset<Power>;
    Force F_c = unset<Force>, S_0_min = unset<Force>, S_0 = unset<Force>, S_max = unset<Force>, N_min = unset<Force>;
    double u_S = unset<double>, u_T = unset<double>;
    List<PulleyResult, most_pulleys> pulleys;
  };
};

constexpr auto choices_of(CourseTypes::Side) {
  using Side = CourseTypes::Side;
  return std::array{ChoiceName<Side>{Side::inside, "inside", "inside of the belt"},
                    ChoiceName<Side>{Side::outside, "outside", "outside: runs on the belt's back, opposite rotation"}};
}
constexpr auto choices_of(CourseTypes::Turns) {
  using Turns = CourseTypes::Turns;
  return std::array{ChoiceName<Turns>{Turns::ccw, "ccw", "counter-clockwise"},
                    ChoiceName<Turns>{Turns::cw, "cw", "clockwise"}};
}

}  // namespace loadpath::belt
