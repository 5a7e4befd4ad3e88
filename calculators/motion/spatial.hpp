// Spherical and general motion of a body by laws of time: precession, nutation and spin, and the path of one of its
// points.
//
// The body's axes xi, eta, zeta lie on x, y, z first; it is turned by psi about z (precession), by theta about the line
// of nodes (nutation) and by phi about zeta (spin). Without laws of the pole O' it is the fixed point of a spherical
// motion. Signs: right-handed; components along the fixed axes. Source: [B30]. Not covered: forces; laws with kinks or
// jumps.
#pragma once

#include "calculators/motion/laws.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::motion {

struct Spatial {
  static constexpr auto id = "motion.spatial";
  static constexpr auto title = "Spherical and general motion of a body";
  static constexpr auto scope =
      "Angular velocity and acceleration, instantaneous axis of rotation, and velocity and acceleration of a point, "
      "from "
      "laws of precession, nutation and spin, about a fixed point or with a moving pole; forces are not covered.";
  static constexpr auto source = "[B30]";
  static constexpr auto headline = "omega = {omega}";
  static constexpr auto synonyms =
      "spherical motion, spatial motion, general motion, Euler angles, precession, nutation, spin, gyroscope, "
      "instantaneous axis, screw axis, rigid body kinematics, fixed point, Eulersche Winkel, Kreiselung, Praezession, "
      "räumliche Bewegung, Momentanachse, сферическое движение, углы Эйлера, прецессия, нутация, мгновенная ось";
  static constexpr auto example = R"toml([project]
title = "A boom that is raised while the crane turns"

[boom]
calculator = "motion.spatial"
psi = "0.3*t/(1 s)"
theta = "60 deg - 0.5*t/(1 s)"
t = "0 s"
zeta = "12 m"
)toml";

  struct Input {
    AngleLaw psi, theta, phi;
    LengthLaw x, y, z;
    Time t = unset<Time>;
    Length xi = 0.0 * m, eta = 0.0 * m, zeta = 0.0 * m;
  };
  static constexpr Fields inputs{
      FormulaField{&Input::psi, "psi", "precession about z as a formula of the time t: \"30 deg*t/(1 s)\""}
          .may_be_missing(),
      FormulaField{&Input::theta, "theta", "nutation, angle from z to the axis zeta of the spin, as a formula of t"}
          .may_be_missing(),
      FormulaField{&Input::phi, "phi", "spin about zeta as a formula of t"}.may_be_missing(),
      FormulaField{&Input::x, "x", "coordinate of the pole as a formula of t; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::y, "y", "coordinate of the pole as a formula of t; omitted: 0"}.may_be_missing(),
      FormulaField{&Input::z, "z", "coordinate of the pole as a formula of t; omitted: 0"}.may_be_missing(),
      Field{&Input::t, "t", sec, "time at which the state is calculated"},
      Field{&Input::xi, "xi", m, "coordinate of the point in the axes of the body"}.usually(-1e4, 1e4),
      Field{&Input::eta, "eta", m, "coordinate of the point in the axes of the body"}.usually(-1e4, 1e4),
      Field{&Input::zeta, "zeta", m, "coordinate of the point along the axis of the spin"}.usually(-1e4, 1e4)};

  struct Result {
    double psi_t = unset<double>, theta_t = unset<double>, phi_t = unset<double>;
    AngularSpeed omega_psi = unset<AngularSpeed>, omega_theta = unset<AngularSpeed>, omega_phi = unset<AngularSpeed>;
    AngularSpeed omega_x = unset<AngularSpeed>, omega_y = unset<AngularSpeed>, omega_z = unset<AngularSpeed>;
    AngularSpeed omega = unset<AngularSpeed>;
    double alpha = unset<double>, beta = unset<double>, gamma = unset<double>, delta = unset<double>;
    AngularAcceleration epsilon_x = unset<AngularAcceleration>, epsilon_y = unset<AngularAcceleration>,
                        epsilon_z = unset<AngularAcceleration>, epsilon = unset<AngularAcceleration>;
    Length x_M = unset<Length>, y_M = unset<Length>, z_M = unset<Length>;
    Speed v_x = unset<Speed>, v_y = unset<Speed>, v_z = unset<Speed>, v = unset<Speed>;
    Acceleration a_x = unset<Acceleration>, a_y = unset<Acceleration>, a_z = unset<Acceleration>,
                 a = unset<Acceleration>;
    Speed v_k = unset<Speed>;
    Length h = unset<Length>;
  };
  static constexpr Fields results{
      Field{&Result::psi_t, "psi_t", deg, "angle of precession at the time t"},
      Field{&Result::theta_t, "theta_t", deg, "angle of nutation at the time t"},
      Field{&Result::phi_t, "phi_t", deg, "angle of spin at the time t"},
      Field{&Result::omega_psi, "omega_psi", rad_per_s, "angular velocity of the precession, signed"},
      Field{&Result::omega_theta, "omega_theta", rad_per_s, "angular velocity of the nutation, signed"},
      Field{&Result::omega_phi, "omega_phi", rad_per_s, "angular velocity of the spin, signed"},
      Field{&Result::omega_x, "omega_x", rad_per_s, "angular velocity along x"},
      Field{&Result::omega_y, "omega_y", rad_per_s, "angular velocity along y"},
      Field{&Result::omega_z, "omega_z", rad_per_s, "angular velocity along z"},
      Field{&Result::omega, "omega", rad_per_s, "angular velocity"},
      Field{&Result::alpha, "alpha", deg, "angle of the instantaneous axis with x"},
      Field{&Result::beta, "beta", deg, "angle of the instantaneous axis with y"},
      Field{&Result::gamma, "gamma", deg, "angle of the instantaneous axis with z: half angle of the fixed cone"},
      Field{&Result::delta, "delta", deg, "angle of the instantaneous axis with zeta: half angle of the rolling cone"},
      Field{&Result::epsilon_x, "epsilon_x", rad_per_s2, "angular acceleration along x"},
      Field{&Result::epsilon_y, "epsilon_y", rad_per_s2, "angular acceleration along y"},
      Field{&Result::epsilon_z, "epsilon_z", rad_per_s2, "angular acceleration along z"},
      Field{&Result::epsilon, "epsilon", rad_per_s2, "angular acceleration"},
      Field{&Result::x_M, "x_M", m, "coordinate x of the point"},
      Field{&Result::y_M, "y_M", m, "coordinate y of the point"},
      Field{&Result::z_M, "z_M", m, "coordinate z of the point"},
      Field{&Result::v_x, "v_x", m_per_s, "velocity of the point along x"},
      Field{&Result::v_y, "v_y", m_per_s, "velocity of the point along y"},
      Field{&Result::v_z, "v_z", m_per_s, "velocity of the point along z"},
      Field{&Result::v, "v", m_per_s, "speed of the point"},
      Field{&Result::a_x, "a_x", m_per_s2, "acceleration of the point along x"},
      Field{&Result::a_y, "a_y", m_per_s2, "acceleration of the point along y"},
      Field{&Result::a_z, "a_z", m_per_s2, "acceleration of the point along z"},
      Field{&Result::a, "a", m_per_s2, "acceleration of the point"},
      Field{&Result::v_k, "v_k", m_per_s, "velocity along the instantaneous axis; 0 in a spherical motion"},
      Field{&Result::h, "h", m, "distance of the point from the instantaneous axis"}};

  static bool some_law(const Input& in);
  static bool laws_read(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool laws_are_smooth(const Input& in);
  static FieldFault gap(const Input& in);
  static constexpr bool turns = true;
  static constexpr std::array rules{
      Rule<Input>{&laws_read, "psi, theta, phi, x, y, z", "the laws must be angles and lengths as formulas of t",
                  &law_fault},
      Rule<Input>{&some_law, "psi, theta, phi", "the law of one angle must be given: of psi, theta or phi"},
      Rule<Input>{&laws_are_smooth, "psi, theta, phi, x, y, z, t", "the laws must have values at this time", &gap}};
  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::motion
