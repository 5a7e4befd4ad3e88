// Impulse of a force that changes with time, and the change of velocity that it brings to a mass.
//
// The force is a law of the time along each axis; known or constant forces are laws too. Sign: along the axes.
// Source: [B33], theorem of momentum of a point.
#pragma once

#include "calculators/motion/laws.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::dynamics {

struct Impulse {
  static constexpr auto id = "dynamics.impulse";
  static constexpr auto title = "Impulse of a force";
  static constexpr auto scope =
      "Impulse and mean value of a force F(t) that is smooth over the range, and the resulting velocity of a "
      "mass by the impulse-momentum theorem.";
  static constexpr auto source = "[B33]";
  static constexpr auto headline = "I = {I}|v_2 = {v_2}";
  static constexpr auto synonyms =
      "impulse, momentum, mean force, impulse-momentum theorem, Kraftstoß, Impulssatz, импульс силы, "
      "теорема об изменении количества движения";
  static constexpr auto example = R"toml([project]
title = "A blow"

[hammer]
calculator = "dynamics.impulse"
m = "3 kg"
F_x = "500 N*sin(pi*t/(20 ms))"
t_2 = "20 ms"
v_1x = "-1 m/s"
)toml";

  struct Input {
    Mass mass = unset<Mass>;
    motion::ForceLaw F_x, F_y, F_z;
    Time t_1 = 0.0 * sec, t_2 = unset<Time>;
    Speed v_1x = 0.0 * m_per_s, v_1y = 0.0 * m_per_s, v_1z = 0.0 * m_per_s;
  };
  static constexpr Fields inputs{
      Field{&Input::mass, called("m"), kg, "mass"}.positive().usually(1e-6, 1e6),
      FormulaField{&Input::F_x, "F_x", "force along x as a formula of the time t: \"500 N*sin(pi*t/(20 ms))\""}.load(),
      FormulaField{&Input::F_y, "F_y", "force along y as a formula of the time t; omitted: none"}
          .load()
          .may_be_missing(),
      FormulaField{&Input::F_z, "F_z", "force along z as a formula of the time t; omitted: none"}
          .load()
          .may_be_missing(),
      Field{&Input::t_1, "t_1", sec, "time at which the force starts"},
      Field{&Input::t_2, "t_2", sec, "end time of the force, after t_1"},
      Field{&Input::v_1x, "v_1x", m_per_s, "velocity along x before"},
      Field{&Input::v_1y, "v_1y", m_per_s, "velocity along y before"},
      Field{&Input::v_1z, "v_1z", m_per_s, "velocity along z before"}};

  struct Result {
    Momentum I_x = unset<Momentum>, I_y = unset<Momentum>, I_z = unset<Momentum>, I = unset<Momentum>;
    Force F_mx = unset<Force>, F_my = unset<Force>, F_mz = unset<Force>, F_m = unset<Force>;
    Momentum q_1x = unset<Momentum>, q_1y = unset<Momentum>, q_1z = unset<Momentum>;
    Momentum q_2x = unset<Momentum>, q_2y = unset<Momentum>, q_2z = unset<Momentum>;
    Speed v_2x = unset<Speed>, v_2y = unset<Speed>, v_2z = unset<Speed>, v_2 = unset<Speed>;
    Moment A = unset<Moment>;
  };
  static constexpr Fields results{Field{&Result::I_x, "I_x", N_s, "impulse along x"},
                                  Field{&Result::I_y, "I_y", N_s, "impulse along y"},
                                  Field{&Result::I_z, "I_z", N_s, "impulse along z"},
                                  Field{&Result::I, "I", N_s, "impulse"},
                                  Field{&Result::F_mx, "F_mx", N, "mean force along x"}.load().with("F_my, F_mz"),
                                  Field{&Result::F_my, "F_my", N, "mean force along y"}.load().with("F_mx, F_mz"),
                                  Field{&Result::F_mz, "F_mz", N, "mean force along z"}.load().with("F_mx, F_my"),
                                  Field{&Result::F_m, "F_m", N, "mean force"}.load(),
                                  Field{&Result::q_1x, "q_1x", kg_m_per_s, "momentum along x before"},
                                  Field{&Result::q_1y, "q_1y", kg_m_per_s, "momentum along y before"},
                                  Field{&Result::q_1z, "q_1z", kg_m_per_s, "momentum along z before"},
                                  Field{&Result::q_2x, "q_2x", kg_m_per_s, "momentum along x after"},
                                  Field{&Result::q_2y, "q_2y", kg_m_per_s, "momentum along y after"},
                                  Field{&Result::q_2z, "q_2z", kg_m_per_s, "momentum along z after"},
                                  Field{&Result::v_2x, "v_2x", m_per_s, "velocity along x after"},
                                  Field{&Result::v_2y, "v_2y", m_per_s, "velocity along y after"},
                                  Field{&Result::v_2z, "v_2z", m_per_s, "velocity along z after"},
                                  Field{&Result::v_2, "v_2", m_per_s, "speed after"},
                                  Field{&Result::A, "A", J, "work of the force: the change of the kinetic energy"}};

  static bool laws_read(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool laws_are_smooth(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr bool turns = true;
  static constexpr std::array rules{
      Rule<Input>{&laws_read, "F_x, F_y, F_z", "F_x, F_y and F_z must be forces as formulas of t", &law_fault},
      Rule<Input>{[](const Input& in) { return !(in.t_1 >= in.t_2); }, "t_2, t_1",
                  "the force must end after its start"},
      Rule<Input>{&laws_are_smooth, "F_x, F_y, F_z, t_1, t_2", "the laws must have values at these times", &gap}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::dynamics
