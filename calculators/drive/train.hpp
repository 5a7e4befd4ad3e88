// A train of drives, one behind the other: gears, belts with slip, chains, bevel, crossed helical gears, worms,
// planetary sets.
//
// Decides the ratio, speed, torque and power of every shaft, the total efficiency, whether it reduces or multiplies,
// and the loads of the wheels on each shaft: T_k = T_1 i eta over the stages before. Loads are nominal: the service
// factor belongs to the part that is designed with them. An efficiency that is left out is 1, of a belt 1 - slip: the
// slip lowers the speed, not the ratio of the torques. Given, it contains the slip. Signs: torque and speed of a
// shaft are positive in the direction of the first one; a stage's ratio is negative where its second shaft rotates in
// the opposite direction; that of bevel gears is positive unless stated. Not covered: branches, power that circulates,
// losses of bearings.
#pragma once

#include "calculators/drive/train_types.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::drive {

struct Train : TrainTypes {
  static constexpr auto id = "drive.train";
  static constexpr auto title = "Drive train";
  static constexpr auto scope =
      "Speed ratio, speeds, torques, powers and efficiency along a series of stages: gears, belts with slip, "
      "chains, bevel, worm and crossed helical gears and planetary sets, with the torque of every shaft; branched "
      "trains are not covered.";
  static constexpr auto source = "[B40]";
  static constexpr auto headline = "i = {i}";
  static constexpr auto synonyms =
      "drive train, gear train, gearbox, transmission, speed ratio, efficiency, worm gear, stages, reducer, "
      "Getriebe, Antriebsstrang, Übersetzung, Wirkungsgrad, Schneckengetriebe, power flow, привод, редуктор, "
      "передаточное отношение, КПД";
  static constexpr auto example = R"([project]
title = "Conveyor drive"

[conveyor]
calculator = "drive.train"
P = "5.5 kW"
n_1 = "1450 rpm"
stages = [
  { name = "belt", kind = "belt", d_1 = "125 mm", d_2 = "315 mm", slip = 0.015, eta = 0.95 },
  { name = "gears", kind = "gear", z_1 = 20, z_2 = 80, m_n = "3 mm", eta = 0.97 },
  { name = "chain", kind = "chain", z_1 = 21, z_2 = 57, p = "25.4 mm", eta = 0.96 },
]
)";

  static bool ratios_known(const Input& in);
  static FieldFault open_ratio(const Input& in);
  static bool ratios_single(const Input& in);
  static FieldFault double_ratio(const Input& in);
  static bool slips_fit(const Input& in);
  static FieldFault wrong_slip(const Input& in);
  static bool members_differ(const Input& in);
  static FieldFault same_member(const Input& in);
  static constexpr Fields inputs{
      Field{&Input::P, "P", kW, "input power, with n_1"}.load().positive().may_be_missing(),
      Field{&Input::T_1, "T_1", N_m, "input torque, replaces P"}.load().positive().may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the first shaft"}.positive().may_be_missing(),
      ListField{&Input::stages, "stages", "stages from the motor to the driven machine"}};

  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "overall ratio, negative for opposite direction of rotation"},
      Field{&Result::eta, "eta", ratio, "overall efficiency"},
      Choice{&Result::works, "works", "effect on the speed: reducing or increasing"},
      Field{&Result::T_1, "T_1", N_m, "input torque"}.load(),
      Field{&Result::n_out, "n_out", rpm, "output speed, signed"},
      Field{&Result::T_out, "T_out", N_m, "output torque, signed"}.load(),
      Field{&Result::P_out, "P_out", kW, "output power"},
      Field{&Result::P_loss, "P_loss", kW, "power loss"},
      ListField{&Result::stages, "stages", "stages"},
      ListField{&Result::shafts, "shafts", "shafts, from first to last"}};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.stages.empty(); }, "stages", "give at least one stage"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.P) && is_set(in.T_1)); }, "P, T_1",
                  "give the load as P or as T_1, not both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P) || is_set(in.n_1); }, "P, n_1",
                  "a power needs the speed n_1"},
      Rule<Input>{&ratios_known, "stages", "every stage needs a ratio: i, teeth, or diameters", &open_ratio},
      Rule<Input>{&ratios_single, "stages", "give the ratio of a stage only once", &double_ratio},
      Rule<Input>{&slips_fit, "stages", "slip applies to belts only, and their efficiency includes it", &wrong_slip},
      Rule<Input>{&members_differ, "stages", "input and output of a planetary set must be different members",
                  &same_member}};

  static constexpr bool turns = true;
  static constexpr bool is_one_drive = true;
  static double least_efficiency(const Input& in, std::size_t stage);
  static constexpr std::array bounds{Bound<Input>{"stages.eta", "stages of this kind", &least_efficiency}.least()};
  static bool drives_a_worm(const Input& in);
  static Applies loads_a_worm(const Input& in);
  static constexpr std::array modes{
      Mode<Input>{"self_locking", "self-locking of back-driven worm stages",
                  [](const Input& in) { return where(drives_a_worm(in)); }}
          .of_shape(),
      Mode<Input>{"efficiency", "efficiency of the worm gear", &loads_a_worm}.judged_by("stages.x_eta"),
      Mode<Input>{"strength", "strength of the stages",
                  [](const Input& in) { return is_set(in.P) || is_set(in.T_1) ? Applies::unseen : Applies::no; }}
          .assessed_additionally_in("gear.pair, gear.planetary, gear.bevel, gear.worm, gear.crossed, chain.roller, "
                                    "chain.inverted_tooth, belt.v, belt.flat, belt.grooved, belt.synchronous, "
                                    "drive.friction_wheels")
          .for_each_of("stages", "shafts"),
      Mode<Input>{"heat", "thermal capacity", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::drive
