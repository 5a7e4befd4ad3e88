// A body thrown at an angle: flight without resistance of the air, to the height that it lands at.
//
// Sign: heights upwards, h is that of the throw above the landing. Source: [B32]. The angle of greatest range is 45 deg
// where the body lands at the height of the throw, flatter where it lands lower; that of greatest height is 90 deg.
#pragma once

#include "calculators/dynamics/gravity.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>
#include <vector>

namespace loadpath::dynamics {

struct Throw {
  static constexpr auto id = "dynamics.throw";
  static constexpr auto title = "Projectile motion";
  static constexpr auto scope =
      "Height, range, flight times and velocities of a projectile that lands above, at or below launch level, "
      "and the launch angles for a given range; air resistance is not covered.";
  static constexpr auto source = "[B32]";
  static constexpr auto headline = "L = {L}, H = {H}";
  static constexpr auto synonyms =
      "projectile, projectile motion, trajectory, range, launch angle, ballistics, oblique throw, schiefer Wurf, "
      "Wurfparabel, Wurfweite, бросок под углом, движение снаряда, дальность полёта";
  static constexpr auto example = R"toml([project]
title = "A throw"

[ball]
calculator = "dynamics.throw"
V_0 = "20 m/s"
theta = "30 deg"
)toml";

  struct Input {
    Speed V_0 = unset<Speed>;
    double theta = unset<double>;
    Length h = 0.0 * m;
    Length L_req = unset<Length>;
    Acceleration g = unset<Acceleration>;
    double latitude = unset<double>;
    Length altitude = unset<Length>;
  };
  static constexpr auto inputs =
      join(Fields{Field{&Input::V_0, "V_0", m_per_s, "launch speed"}.positive().usually(0.01, 1000),
                  Field{&Input::theta, "theta", deg, "launch angle above the horizontal"}.within(-90, 90),
                  Field{&Input::h, "h", m, "height of the throw above the landing, negative where it lands higher"},
                  Field{&Input::L_req, "L_req", m, "required range at theta, and for the launch angles"}
                      .positive()
                      .may_be_missing()},
           gravity_fields<Input>());

  struct Result {
    Speed V_x = unset<Speed>, V_z = unset<Speed>;
    Time t_H = unset<Time>;
    Length H = unset<Length>;
    Time t_L = unset<Time>;
    Length L = unset<Length>;
    Speed V_L = unset<Speed>;
    double theta_L = unset<double>;
    double theta_H = unset<double>, theta_R = unset<double>;
    Length L_max = unset<Length>;
    double theta_flat = unset<double>, theta_steep = unset<double>;
    double u_h = unset<double>, u_L = unset<double>;
    Acceleration g = unset<Acceleration>;
  };
  static constexpr Fields results{
      Field{&Result::V_x, "V_x", m_per_s, "horizontal speed, all the time"},
      Field{&Result::V_z, "V_z", m_per_s, "vertical launch speed"},
      Field{&Result::t_H, "t_H", sec, "time to the highest point; 0 if launched horizontally or downwards"},
      Field{&Result::H, "H", m, "height of the highest point above the throw"},
      Field{&Result::t_L, "t_L", sec, "time to the landing"},
      Field{&Result::L, "L", m, "horizontal distance to the landing"},
      Field{&Result::V_L, "V_L", m_per_s, "speed at the landing"},
      Field{&Result::theta_L, "theta_L", deg, "angle of the landing below the horizontal"},
      Field{&Result::theta_H, "theta_H", deg, "angle of greatest height"},
      Field{&Result::theta_R, "theta_R", deg, "angle of greatest range"},
      Field{&Result::L_max, "L_max", m, "greatest range, at theta_R"},
      Field{&Result::theta_flat, "theta_flat", deg, "smaller of the launch angles for the range L_req"},
      Field{&Result::theta_steep, "theta_steep", deg, "larger of the launch angles for the range L_req"},
      Field{&Result::u_h, "u_h", ratio, "landing: its height over that of the highest point, above the throw"}.check(),
      Field{&Result::u_L, "u_L", ratio, "range: required / calculated"}.check("L_req"),
      Field{&Result::g, "g", m_per_s2, "weight per mass of the calculation"}};

  static constexpr std::array rules =
      join(std::array{Rule<Input>{[](const Input& in) { return !(in_si(in.h) < 0.0 && in.theta <= 0.0); }, "theta, h",
                                  "with theta <= 0 the body cannot land higher: increase theta, or give h >= 0"}},
           gravity_rules<Input>());

  static constexpr std::array modes{
      Mode<Input>{"landing", "height of the landing point", &always<Input>}.judged_by("u_h"),
      Mode<Input>{"reach", "horizontal range", [](const Input& in) { return where(is_set(in.L_req)); }}.judged_by(
          "u_L")};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::dynamics
