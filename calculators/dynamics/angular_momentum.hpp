// Angular momentum about a fixed axis: parts that change their inertia, are coupled, driven or braked.
//
// Theorem of the angular momentum over a time: K_2 = K_1 + M t. Parts without an angular velocity after turn together;
// where all are given, the time follows from the moment. Sign: counter-clockwise. Source: [B33], [B36].
// Only external moments are in M: an inertia force is none, and forces through the axis or along it have no moment.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>

namespace loadpath::dynamics {

struct AngularMomentumChange {
  static constexpr auto id = "dynamics.angular_momentum";
  static constexpr auto title = "Angular momentum about an axis";
  static constexpr auto scope =
      "Angular velocity after a change of inertia, a coupling, or driving or braking by a constant moment of "
      "parts on one axis, or the time required, with the energy lost or released.";
  static constexpr auto source = "[B33], [B36]";
  static constexpr auto headline = "omega_2 = {omega_2}";
  static constexpr auto synonyms =
      "angular momentum, moment of momentum, coupling of shafts, clutch engagement, spin-up, Drehimpuls, Drall, "
      "Drallsatz, Kupplungsvorgang, кинетический момент, момент количества движения";
  static constexpr auto example = R"toml([project]
title = "A ball on a thread"

[ball]
calculator = "dynamics.angular_momentum"
parts = [{ name = "ball", m = "0.2 kg", R_1 = "400 mm", R_2 = "200 mm", omega_1 = "120 rpm" }]
)toml";

  struct Part {
    Name name;
    MassMoment J_1 = unset<MassMoment>, J_2 = unset<MassMoment>;
    Mass mass = unset<Mass>;
    Length R_1 = unset<Length>, R_2 = unset<Length>;
    AngularSpeed omega_1 = 0.0 * rad_per_s, omega_2 = unset<AngularSpeed>;
    static constexpr Fields fields{
        NameField{&Part::name, "name", "name of the part"}.may_be_missing(),
        Field{&Part::J_1, "J_1", kg_m2, "moment of inertia before"}.positive().may_be_missing(),
        Field{&Part::J_2, "J_2", kg_m2, "moment of inertia after; omitted: as before"}.positive().may_be_missing(),
        Field{&Part::mass, called("m"), kg, "point mass, replaces J_1"}.positive().may_be_missing(),
        Field{&Part::R_1, "R_1", mm, "its distance from the axis before"}.positive().may_be_missing(),
        Field{&Part::R_2, "R_2", mm, "its distance from the axis after; omitted: as before"}
            .positive()
            .may_be_missing(),
        Field{&Part::omega_1, "omega_1", rad_per_s, "angular velocity before, signed"},
        Field{&Part::omega_2, "omega_2", rad_per_s, "angular velocity after; omitted: to be found"}.may_be_missing()};
  };
  static constexpr std::size_t most_parts = 16;

  struct Input {
    List<Part, most_parts> parts;
    Moment M = 0.0 * N_m;
    Time t = unset<Time>;
  };
  static constexpr Fields inputs{
      ListField{&Input::parts, "parts", "parts on the axis; those without omega_2 turn together afterwards"},
      Field{&Input::M, "M", N_m, "constant external moment about the axis, signed; negative: brakes forward rotation"}
          .load(),
      Field{&Input::t, "t", sec, "time for which the moment acts; computed if every omega_2 is given"}
          .at_least(0)
          .may_be_missing()};

  struct After {
    Name name;
    MassMoment J_1 = unset<MassMoment>, J_2 = unset<MassMoment>;
    AngularSpeed omega_2 = unset<AngularSpeed>, n_2 = unset<AngularSpeed>;
    static constexpr Fields fields{
        NameField{&After::name, "name", "name of the part"},
        Field{&After::J_1, "J_1", kg_m2, "moment of inertia before"},
        Field{&After::J_2, "J_2", kg_m2, "moment of inertia after"},
        Field{&After::omega_2, "omega_2", rad_per_s, "angular velocity after"},
        Field{&After::n_2, "n_2", rpm, "angular velocity afterwards, in revolutions per minute"}};
  };

  struct Result {
    AngularMomentum K_1 = unset<AngularMomentum>, K_2 = unset<AngularMomentum>, K_k = unset<AngularMomentum>;
    MassMoment J_k = unset<MassMoment>;
    AngularSpeed omega_2 = unset<AngularSpeed>, n_2 = unset<AngularSpeed>;
    Time t_M = unset<Time>;
    Moment E_1 = unset<Moment>, E_2 = unset<Moment>, Delta_E = unset<Moment>;
    List<After, most_parts> after;
  };
  static constexpr Fields results{
      Field{&Result::K_1, "K_1", kg_m2_per_s, "angular momentum before"},
      Field{&Result::K_2, "K_2", kg_m2_per_s, "angular momentum after"},
      Field{&Result::K_k, "K_k", kg_m2_per_s, "angular momentum after of the parts whose speed is given"},
      Field{&Result::J_k, "J_k", kg_m2, "moment of inertia after of the parts whose speed is to be found"},
      Field{&Result::omega_2, "omega_2", rad_per_s, "angular velocity after of the parts that turn together"},
      Field{&Result::n_2, "n_2", rpm, "the same in revolutions per minute"},
      Field{&Result::t_M, "t_M", sec, "time for which the moment acts"},
      Field{&Result::E_1, "E_1", J, "kinetic energy before"},
      Field{&Result::E_2, "E_2", J, "kinetic energy after"},
      Field{&Result::Delta_E, "Delta_E", J, "change of the kinetic energy"},
      ListField{&Result::after, "after", "the parts afterwards"}};

  static bool has_unknown(const Input& in);
  static bool inertias_given(const Input& in);
  static bool time_is_ahead(const Input& in);
  static constexpr bool turns = true;
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.parts.empty(); }, "parts", "give at least one part"},
      Rule<Input>{&inertias_given, "parts", "a part has J_1 (and J_2), or m with R_1 (and R_2): give one of the two"},
      Rule<Input>{[](const Input& in) { return !has_unknown(in) || is_set(in.t) || in_si(in.M) == 0.0; }, "M, t, parts",
                  "a moment acts for a time: give t, or every omega_2, from which t follows"},
      Rule<Input>{[](const Input& in) { return has_unknown(in) || !is_set(in.t); }, "t, parts",
                  "if every omega_2 is given, the time follows from the moment: omit t, or one omega_2"},
      Rule<Input>{&time_is_ahead, "M, parts",
                  "this moment does not bring the parts from omega_1 to omega_2: change its sign or give one"}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::dynamics
