// Compound motion of a point at one instant: it moves in a frame that moves itself, in one plane.
//
// Relative, transport and Coriolis parts of velocity and acceleration, in the axes xi, eta of the moving frame and in
// the fixed axes x, y. Sign: angles and omega counter-clockwise; zeta is the axis of omega. Source: [B31].
// A point that runs on a circle against the rotation has a Coriolis acceleration against the normal transport one.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>
#include <vector>

namespace loadpath::motion {

struct Compound {
  static constexpr auto id = "motion.compound";
  static constexpr auto title = "Relative (compound) motion of a point";
  static constexpr auto scope =
      "Absolute velocity and acceleration of a point in a moving and rotating frame at one instant, by "
      "relative, transport and Coriolis components; the frame rotates about an axis of fixed direction.";
  static constexpr auto source = "[B31]";
  static constexpr auto headline = "v = {v}, a = {a}";
  static constexpr auto synonyms =
      "relative motion, compound motion, Coriolis acceleration, rotating frame, transport velocity, "
      "Relativbewegung, Coriolisbeschleunigung, Führungsgeschwindigkeit, сложное движение точки, "
      "ускорение Кориолиса, переносное движение";
  static constexpr auto example = R"toml([project]
title = "A collar on a turning rod"

[collar]
calculator = "motion.compound"
xi = "0.2 m"
v_xi = "2 m/s"
a_xi = "3 m/s^2"
omega = "3 rad/s"
epsilon = "2 rad/s^2"
phi = "60 deg"
)toml";

  enum class Sense { none, along, against, across, oblique };

  struct Input {
    Length xi = unset<Length>, eta = 0.0 * m;
    Speed v_xi = 0.0 * m_per_s, v_eta = 0.0 * m_per_s, v_zeta = 0.0 * m_per_s;
    Acceleration a_xi = 0.0 * m_per_s2, a_eta = 0.0 * m_per_s2, a_zeta = 0.0 * m_per_s2;
    AngularSpeed omega = unset<AngularSpeed>;
    AngularAcceleration epsilon = 0.0 * rad_per_s2;
    double phi = 0.0;
    Speed v_Ax = 0.0 * m_per_s, v_Ay = 0.0 * m_per_s;
    Acceleration a_Ax = 0.0 * m_per_s2, a_Ay = 0.0 * m_per_s2;
  };
  static constexpr Fields inputs{
      Field{&Input::xi, "xi", m, "position of the point in the frame, along xi from its origin A"},
      Field{&Input::eta, "eta", m, "position of the point in the frame, along eta"},
      Field{&Input::v_xi, "v_xi", m_per_s, "relative velocity along xi"},
      Field{&Input::v_eta, "v_eta", m_per_s, "relative velocity along eta"},
      Field{&Input::v_zeta, "v_zeta", m_per_s, "relative velocity along the axis of rotation"},
      Field{&Input::a_xi, "a_xi", m_per_s2, "relative acceleration along xi"},
      Field{&Input::a_eta, "a_eta", m_per_s2, "relative acceleration along eta"},
      Field{&Input::a_zeta, "a_zeta", m_per_s2, "relative acceleration along the axis of rotation"},
      Field{&Input::omega, "omega", rad_per_s, "angular velocity of the frame, counter-clockwise positive"},
      Field{&Input::epsilon, "epsilon", rad_per_s2, "angular acceleration of the frame, counter-clockwise positive"},
      Field{&Input::phi, "phi", deg, "angle from x to xi"},
      Field{&Input::v_Ax, "v_Ax", m_per_s, "velocity of the origin of the frame along x"},
      Field{&Input::v_Ay, "v_Ay", m_per_s, "velocity of the origin of the frame along y"},
      Field{&Input::a_Ax, "a_Ax", m_per_s2, "acceleration of the origin of the frame along x"},
      Field{&Input::a_Ay, "a_Ay", m_per_s2, "acceleration of the origin of the frame along y"}};

  struct Result {
    Speed v_r = unset<Speed>, v_e = unset<Speed>, v = unset<Speed>;
    Acceleration a_r = unset<Acceleration>, a_e = unset<Acceleration>, a_c = unset<Acceleration>,
                 a = unset<Acceleration>;
    Sense sense = Sense::none;
    Speed v_exi = unset<Speed>, v_eeta = unset<Speed>, v_axi = unset<Speed>, v_aeta = unset<Speed>;
    Acceleration a_exi = unset<Acceleration>, a_eeta = unset<Acceleration>;
    Acceleration a_cxi = unset<Acceleration>, a_ceta = unset<Acceleration>;
    Acceleration a_axi = unset<Acceleration>, a_aeta = unset<Acceleration>;
    Speed v_x = unset<Speed>, v_y = unset<Speed>;
    Acceleration a_x = unset<Acceleration>, a_y = unset<Acceleration>;
  };
  static constexpr Fields results{
      Field{&Result::v_r, "v_r", m_per_s, "relative speed"},
      Field{&Result::v_e, "v_e", m_per_s, "transport speed: of the point of the frame under the moving one"},
      Field{&Result::v, "v", m_per_s, "absolute speed"},
      Field{&Result::a_r, "a_r", m_per_s2, "relative acceleration"},
      Field{&Result::a_e, "a_e", m_per_s2, "transport acceleration"},
      Field{&Result::a_c, "a_c", m_per_s2, "Coriolis acceleration"},
      Field{&Result::a, "a", m_per_s2, "absolute acceleration"},
      Choice{&Result::sense, "sense", "Coriolis acceleration next to the normal transport acceleration"},
      Field{&Result::v_exi, "v_exi", m_per_s, "transport velocity along xi"},
      Field{&Result::v_eeta, "v_eeta", m_per_s, "transport velocity along eta"},
      Field{&Result::v_axi, "v_axi", m_per_s, "absolute velocity along xi"},
      Field{&Result::v_aeta, "v_aeta", m_per_s, "absolute velocity along eta"},
      Field{&Result::a_exi, "a_exi", m_per_s2, "transport acceleration along xi"},
      Field{&Result::a_eeta, "a_eeta", m_per_s2, "transport acceleration along eta"},
      Field{&Result::a_cxi, "a_cxi", m_per_s2, "Coriolis acceleration along xi"},
      Field{&Result::a_ceta, "a_ceta", m_per_s2, "Coriolis acceleration along eta"},
      Field{&Result::a_axi, "a_axi", m_per_s2, "absolute acceleration along xi"},
      Field{&Result::a_aeta, "a_aeta", m_per_s2, "absolute acceleration along eta"},
      Field{&Result::v_x, "v_x", m_per_s, "absolute velocity along x"},
      Field{&Result::v_y, "v_y", m_per_s, "absolute velocity along y"},
      Field{&Result::a_x, "a_x", m_per_s2, "absolute acceleration along x"},
      Field{&Result::a_y, "a_y", m_per_s2, "absolute acceleration along y"}};

  static constexpr std::array<Rule<Input>, 0> rules{};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Compound::Sense) {
  using S = Compound::Sense;
  return std::array{ChoiceName<S>{S::none, "none", "one of the two is zero"},
                    ChoiceName<S>{S::along, "along", "towards the axis as well"},
                    ChoiceName<S>{S::against, "against", "on the same line, away from the axis"},
                    ChoiceName<S>{S::across, "across", "perpendicular to it"},
                    ChoiceName<S>{S::oblique, "oblique", "at an angle to it"}};
}

}  // namespace loadpath::motion
