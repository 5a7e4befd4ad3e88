// Closed forms of three linkages, written for these only: the floor for the general solver. Positions, velocities,
// accelerations, all joint forces and the driving moment at constant crank speed; the numbers are known to the
// compiler, and results not requested are not kept.
#pragma once

#include "lib/mechanism/model/vec.hpp"

#include <array>
#include <cmath>

namespace loadpath::mechanism::hand_written {

inline constexpr double g = 9.81;

/// A slender bar from a pin; the required force is m (a - g) of its middle, and the moment about its start.
struct Bar {
  double length, mass;
  [[nodiscard]] constexpr double inertia() const { return mass * length * length / 12.0; }
  [[nodiscard]] Vec force(Vec a_start, Vec a_end) const {
    return {0.5 * mass * (a_start.x + a_end.x), mass * (0.5 * (a_start.y + a_end.y) + g)};
  }
};

inline constexpr Bar crank{0.1, 1.0}, coupler{0.35, 1.5}, rocker{0.3, 1.2};
inline constexpr Vec foot{0.4, 0.0};

struct Crank {
  Vec pin, velocity, acceleration;
  Crank(double phi, double omega)
      : pin{crank.length * std::cos(phi), crank.length * std::sin(phi)},
        velocity{-omega * pin.y, omega * pin.x},
        acceleration{-omega * omega * pin.x, -omega * omega * pin.y} {}
  /// Torque of the drive, with this force on the crank's pin.
  double forces(Vec at_pin, Vec& at_ground) const {
    const Vec own = crank.force({}, acceleration);
    at_ground = own + at_pin;
    return 0.5 * cross(pin, own) + cross(pin, at_pin);
  }
};

/// Rod and piston on the line y = `line`, from a pin that moves; `push`: on the piston, along x.
struct SlidingDyad {
  Vec pin_force, piston_force;  // on the rod at the moving pin, on the piston from the rod
  double guide_force;

  void solve(Bar rod, double piston, double line, double push, Vec pin, Vec v, Vec a) {
    const double sine = (line - pin.y) / rod.length, cosine = std::sqrt(1.0 - sine * sine);
    const double across = rod.length * sine, along = rod.length * cosine;
    const double omega = -v.y / along, epsilon = (across * omega * omega - a.y) / along;
    const double a_piston = a.x - across * epsilon - along * omega * omega;
    const Vec needed = rod.force(a, {a_piston, 0.0});
    piston_force.x = piston * a_piston - push;
    piston_force.y =
        -(rod.inertia() * epsilon + 0.5 * (along * needed.y - across * needed.x) - across * piston_force.x) / along;
    guide_force = piston * g - piston_force.y;
    pin_force = needed + piston_force;
  }
};

/// Coupler and rocker.
struct PinnedDyad {
  Vec u, w;          // from the crank's pin and from the foot to their joint
  Vec v_tip, a_tip;  // motion of the joint
  double epsilon_u, epsilon_w, inverse;
  Vec at_crank, at_joint, at_foot;  // on coupler, rocker, rocker

  void move(const Crank& driven) {
    const Vec e = foot - driven.pin, v = driven.velocity, a = driven.acceleration;
    constexpr double uu = coupler.length * coupler.length, ww = rocker.length * rocker.length;
    const double d2 = dot(e, e), t = (uu - ww + d2) / (2.0 * d2), h = std::sqrt(uu / d2 - t * t);
    u = {t * e.x - h * e.y, t * e.y + h * e.x};
    w = u - e;
    inverse = 1.0 / cross(u, w);
    const double omega_u = -dot(v, w) * inverse, omega_w = -dot(v, u) * inverse;
    const Vec known = omega_u * omega_u * u - omega_w * omega_w * w - a;
    epsilon_u = dot(known, w) * inverse;
    epsilon_w = dot(known, u) * inverse;
    v_tip = omega_w * normal(w);
    a_tip = epsilon_w * normal(w) - omega_w * omega_w * w;
  }

  /// `tip`: additional force on the rocker at the joint; `couple`: on the rocker.
  void find_forces(Vec a_pin, Vec tip, double couple) {
    const Vec needed_u = coupler.force(a_pin, a_tip), needed_w = rocker.force({}, a_tip);
    const double of_u = 0.5 * cross(u, needed_u) + coupler.inertia() * epsilon_u;
    const double of_w = 0.5 * cross(w, needed_w) + rocker.inertia() * epsilon_w - couple + cross(w, tip);
    at_joint = -inverse * (of_u * w + of_w * u);
    at_crank = needed_u + at_joint;
    at_foot = needed_w - at_joint + tip;
  }
};

/// Forces in the order of the joints of the models, on link i of the joint.
struct SliderCrank {
  std::array<Vec, 4> forces;
  double solve(double phi, double omega) {
    const Crank driven(phi, omega);
    SlidingDyad dyad;
    dyad.solve({0.3, 1.5}, 2.0, 0.0, -1000.0, driven.pin, driven.velocity, driven.acceleration);
    forces[1] = dyad.pin_force;
    forces[2] = dyad.piston_force;
    forces[3] = {0.0, dyad.guide_force};
    return driven.forces(dyad.pin_force, forces[0]);
  }
};

struct FourBar {
  std::array<Vec, 4> forces;
  double solve(double phi, double omega) {
    const Crank driven(phi, omega);
    PinnedDyad dyad;
    dyad.move(driven);
    dyad.find_forces(driven.acceleration, {}, -20.0);
    forces[1] = dyad.at_crank;
    forces[2] = dyad.at_joint;
    forces[3] = dyad.at_foot;
    return driven.forces(dyad.at_crank, forces[0]);
  }
};

struct SixBar {
  std::array<Vec, 7> forces;
  double solve(double phi, double omega) {
    const Crank driven(phi, omega);
    PinnedDyad first;
    first.move(driven);
    SlidingDyad second;
    second.solve({0.5, 1.0}, 2.0, 0.25, -1000.0, foot + first.w, first.v_tip, first.a_tip);
    first.find_forces(driven.acceleration, second.pin_force, 0.0);
    forces[1] = first.at_crank;
    forces[2] = first.at_joint;
    forces[3] = first.at_foot;
    forces[4] = second.pin_force;
    forces[5] = second.piston_force;
    forces[6] = {0.0, second.guide_force};
    return driven.forces(first.at_crank, forces[0]);
  }
};

}  // namespace loadpath::mechanism::hand_written
