// Closed forms of three linkages, as one would write them for these alone: the floor for the general solver.
// Positions, velocities, accelerations, all joint forces and the driving moment at constant crank speed.
#pragma once

#include "lib/mechanism/model/vec.hpp"

#include <cmath>

namespace loadpath::mechanism::hand_written {

inline constexpr Vec g{0.0, -9.81};

/// A bar from `from` with the unit vector `u`; `inertia_force`: mass * (acceleration - g) of its middle.
struct Bar {
  double length, mass;
  Vec u{}, a_from{};
  double omega = 0.0, epsilon = 0.0;

  [[nodiscard]] Vec reach() const { return length * u; }
  [[nodiscard]] Vec velocity(double share) const { return share * length * omega * normal(u); }
  [[nodiscard]] Vec acceleration(double share) const {
    return a_from + share * length * (epsilon * normal(u) - omega * omega * u);
  }
  [[nodiscard]] Vec inertia_force() const { return mass * (acceleration(0.5) - g); }
  /// About the start of the bar.
  [[nodiscard]] double inertia_moment() const {
    return cross(0.5 * reach(), inertia_force()) + mass * length * length / 12.0 * epsilon;
  }
};

inline Bar crank_at(double phi, double omega) {
  Bar crank{.length = 0.1, .mass = 1.0};
  crank.u = {std::cos(phi), std::sin(phi)};
  crank.omega = omega;
  return crank;
}

/// Rod and piston on the line y = `line`, from a pin that moves; `push`: on the piston, along x.
struct SlidingDyad {
  Bar rod;
  double piston_mass, line, push;
  Vec pin_force{};     // on the rod, at the moving pin
  Vec piston_force{};  // on the piston, from the rod
  double guide_force = 0.0, x = 0.0, v = 0.0, a = 0.0;

  void solve(Vec pin, Vec v_pin, Vec a_pin) {
    const double sine = (line - pin.y) / rod.length;
    rod.u = {std::sqrt(1.0 - sine * sine), sine};
    const double reach = rod.length * rod.u.x;
    rod.omega = -v_pin.y / reach;
    rod.epsilon = (rod.length * sine * rod.omega * rod.omega - a_pin.y) / reach;
    rod.a_from = a_pin;
    x = pin.x + reach;
    v = v_pin.x + rod.velocity(1.0).x;
    a = rod.acceleration(1.0).x;
    piston_force.x = piston_mass * a - push;
    piston_force.y = (rod.u.y * rod.length * piston_force.x - rod.inertia_moment()) / reach;
    pin_force = rod.inertia_force() + piston_force;
    guide_force = -piston_mass * g.y - piston_force.y;
  }
};

struct SliderCrank {
  SlidingDyad dyad{.rod = {.length = 0.3, .mass = 1.5}, .piston_mass = 2.0, .line = 0.0, .push = -1000.0};
  Vec ground_force{};

  double solve(double phi, double omega) {
    const Bar crank = crank_at(phi, omega);
    dyad.solve(crank.reach(), crank.velocity(1.0), crank.acceleration(1.0));
    ground_force = crank.inertia_force() + dyad.pin_force;
    return crank.inertia_moment() + cross(crank.reach(), dyad.pin_force);
  }
};

struct FourBar {
  Bar crank{.length = 0.1, .mass = 1.0}, coupler{.length = 0.35, .mass = 1.5}, rocker{.length = 0.3, .mass = 1.2};
  Vec force_o{}, force_a{}, force_b{}, force_c{};  // on crank, coupler, rocker, rocker
  static constexpr Vec foot{0.4, 0.0};

  void move(double phi, double omega) {
    crank = crank_at(phi, omega);
    const Vec across = foot - crank.reach();
    const double d2 = dot(across, across);
    const double along = (coupler.length * coupler.length - rocker.length * rocker.length + d2) / (2.0 * d2);
    const double aside = std::sqrt(coupler.length * coupler.length / d2 - along * along);
    const Vec coupled = along * across + aside * normal(across);
    coupler.u = (1.0 / coupler.length) * coupled;
    rocker.u = (1.0 / rocker.length) * (coupled - across);
    const double inverse = 1.0 / cross(coupler.u, rocker.u);
    const Vec v = crank.velocity(1.0);
    coupler.omega = -dot(v, rocker.u) * inverse / coupler.length;
    rocker.omega = -dot(v, coupler.u) * inverse / rocker.length;
    coupler.a_from = crank.acceleration(1.0);
    const Vec known = coupler.a_from - coupler.length * coupler.omega * coupler.omega * coupler.u +
                      rocker.length * rocker.omega * rocker.omega * rocker.u;
    coupler.epsilon = -dot(known, rocker.u) * inverse / coupler.length;
    rocker.epsilon = -dot(known, coupler.u) * inverse / rocker.length;
  }

  /// `tip`: force on the rocker's tip; `couple`: on the rocker. Returns the driving moment.
  double forces(Vec tip, double couple) {
    const double coupler_moment = -coupler.inertia_moment() / coupler.length;
    const double rocker_moment = (rocker.inertia_moment() - couple) / rocker.length - cross(rocker.u, tip);
    const double inverse = 1.0 / cross(coupler.u, rocker.u);
    force_b = inverse * (coupler_moment * rocker.u - rocker_moment * coupler.u);
    force_c = rocker.inertia_force() - force_b - tip;
    force_a = coupler.inertia_force() + force_b;
    force_o = crank.inertia_force() + force_a;
    return crank.inertia_moment() + cross(crank.reach(), force_a);
  }

  double solve(double phi, double omega) {
    move(phi, omega);
    return forces({}, -20.0);
  }
};

struct SixBar {
  FourBar four_bar;
  SlidingDyad dyad{.rod = {.length = 0.5, .mass = 1.0}, .piston_mass = 2.0, .line = 0.25, .push = -1000.0};

  double solve(double phi, double omega) {
    four_bar.move(phi, omega);
    const Bar& rocker = four_bar.rocker;
    dyad.solve(FourBar::foot + rocker.reach(), rocker.velocity(1.0), rocker.acceleration(1.0));
    return four_bar.forces(-dyad.pin_force, 0.0);
  }
};

}  // namespace loadpath::mechanism::hand_written
