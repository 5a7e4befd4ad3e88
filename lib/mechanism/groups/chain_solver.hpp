// Positions, velocities, accelerations and forces of a chain of dyads (chain.hpp), for one position or for several side
// by side: one template, so that a position has the same bits in a sweep and alone.
//
// Forward through the steps for the motion, back for the forces: the two equations by which a dyad closes are solved by
// their determinant, velocities and accelerations are those of links, not of joints. A dyad stays on the side that it
// has; near its change point it is not clear, and what stands in that lane is not to be used.
#pragma once

#include "lib/mechanism/groups/chain.hpp"
#include "lib/mechanism/groups/lanes.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace loadpath::mechanism {

/// How a link's own frame stands and moves, and what its joints have to supply for that, about its origin.
template <std::size_t Count>
struct ChainMotion {
  VecLanes<Count> origin;
  TurnLanes<Count> turned;
  VecLanes<Count> velocity, acceleration;
  Lanes<Count> omega{}, epsilon{};
  VecLanes<Count> force;
  Lanes<Count> moment{};
};

/// What a step's forces take over from its motion.
template <std::size_t Count>
struct StepMotion {
  VecLanes<Count> along;    // of a slider
  Lanes<Count> inverse{};   // of the determinant
  Lanes<Count> distance{};  // arm and line: of the arm's pin from the line
};

/// Of a drive, as the joint counts that it drives.
template <std::size_t Count>
struct DriveLanes {
  Lanes<Count> value{}, speed{}, acceleration{};
  TurnLanes<Count> turned;  // rotary: by the value
};

template <std::size_t Count>
struct ReactionLanes {
  VecLanes<Count> force;
  Lanes<Count> couple{};
};

template <std::size_t Count>
struct LoadLanes {
  VecLanes<Count> force;
  Lanes<Count> moment{};
};

template <std::size_t Count>
struct ChainState {
  explicit ChainState(const Chain& chain)
      : links(chain.links.size()),
        steps(chain.steps.size()),
        drives(chain.steps.size()),
        loads(chain.loads.size()),
        reactions(chain.joints),
        effort(chain.drivers),
        sides(chain.steps.size(), 1.0) {
    links[chain.ground].turned.cosine.fill(1.0);
  }

  std::vector<ChainMotion<Count>> links;
  std::vector<StepMotion<Count>> steps;
  std::vector<DriveLanes<Count>> drives;  // of the steps that are driven
  std::vector<LoadLanes<Count>> loads;
  std::vector<ReactionLanes<Count>> reactions;  // on link i of the joint, about its pin
  std::vector<Lanes<Count>> effort;
  std::vector<double> sides;  // of the steps, +1 or -1
  ChainMotion<Count> spare;   // of a slot, what a slider would be
  Lanes<Count> least_sine{};  // up to which a dyad is not clear
  Lanes<Count> clear{};       // 1, or 0
};

template <std::size_t Count>
class ChainSolver {
 public:
  ChainSolver(const Chain& chain, ChainState<Count>& now) : chain_(chain), now_(now) {}

  void move() {
    now_.clear.fill(1.0);
    for (std::size_t s = 0; s < chain_.steps.size(); ++s) move(chain_.steps[s], s);
  }
  /// After `move`; `statics`: without inertia.
  void find_forces(bool statics) {
    for (std::size_t k = 0; k < chain_.ground; ++k) need(chain_.links[k], now_.links[k], statics);
    for (std::size_t n = 0; n < chain_.loads.size(); ++n) load(chain_.loads[n], now_.loads[n]);
    for (std::size_t s = chain_.steps.size(); s-- > 0;) supply(chain_.steps[s], s);
  }

 private:
  using Motion = ChainMotion<Count>;
  /// Where something is and how it moves, in one lane.
  struct Course {
    Vec at, velocity, acceleration;
  };

  void move(const ChainStep& step, std::size_t s) {
    switch (step.kind) {
      case ChainStep::Kind::turned:
        return on_ground(step.first, [&](auto grounded) { turn_by_drive<grounded>(step.first, s); });
      case ChainStep::Kind::slid:
        return slide_by_drive(step.first, s);
      case ChainStep::Kind::fixed:
        return fix(step.first);
      case ChainStep::Kind::two_arms:
        return on_grounds(step, [&](auto a, auto b) { close_two_arms<a, b>(step, s); });
      case ChainStep::Kind::arm_and_line:
        return on_grounds(step, [&](auto a, auto b) { close_arm_and_line<a, b>(step, s); });
      case ChainStep::Kind::slot:
      case ChainStep::Kind::guide:
        return on_grounds(step, [&](auto a, auto b) { close_on_line<a, b>(step, s); });
    }
  }

  void supply(const ChainStep& step, std::size_t s) {
    switch (step.kind) {
      case ChainStep::Kind::turned:
        return on_ground(step.first, [&](auto grounded) { supply_turned<grounded>(step); });
      case ChainStep::Kind::slid:
      case ChainStep::Kind::fixed:
        return supply_slid(step, s);
      case ChainStep::Kind::two_arms:
        return on_grounds(step, [&](auto a, auto b) { supply_two_arms<a, b>(step, s); });
      case ChainStep::Kind::arm_and_line:
        return on_ground(step.first, [&](auto grounded) { supply_arm_and_line<grounded>(step, s); });
      case ChainStep::Kind::slot:
        return on_ground(step.second, [&](auto grounded) { supply_slot<grounded>(step, s); });
      case ChainStep::Kind::guide:
        return on_grounds(step, [&](auto a, auto b) { supply_guide<a, b>(step, s); });
    }
  }

  /// With what hangs on the ground known when it is compiled: most of its arithmetic is with zeros.
  template <class Do>
  static void on_ground(const Hinge& hinge, Do what) {
    hinge.grounded ? what(std::true_type{}) : what(std::false_type{});
  }
  template <class Do>
  static void on_grounds(const ChainStep& step, Do what) {
    on_ground(step.first, [&](auto first) { on_ground(step.second, [&](auto second) { what(first, second); }); });
  }

  // ---- motion

  /// Of a point of a link.
  template <bool Grounded>
  static Course follow(const Motion& on, Vec point, std::size_t n) {
    if constexpr (Grounded) {
      return {point, {}, {}};
    } else {
      const Vec arm = on.turned[n](point);
      const double omega = on.omega[n];
      return {on.origin[n] + arm, on.velocity[n] + omega * normal(arm),
              on.acceleration[n] + on.epsilon[n] * normal(arm) - omega * omega * arm};
    }
  }
  template <bool Grounded>
  static Turn turned(const Motion& on, std::size_t n) {
    if constexpr (Grounded) {
      return {};
    } else {
      return on.turned[n];
    }
  }

  static void put(const Course& course, std::size_t n, Motion& link) {
    link.origin.set(n, course.at);
    link.velocity.set(n, course.velocity);
    link.acceleration.set(n, course.acceleration);
  }

  template <bool Grounded>
  void turn_by_drive(const Hinge& hinge, std::size_t s) {
    const DriveLanes<Count>& drive = now_.drives[s];
    Motion& link = now_.links[hinge.link];
    const Motion& on = now_.links[hinge.on];
    const Vec seat = hinge.seat;
    each_lane<Count>([&](std::size_t n) {
      put(follow<Grounded>(on, seat, n), n, link);
      if constexpr (Grounded) {
        link.turned.set(n, drive.turned[n]);
        link.omega[n] = drive.speed[n];
        link.epsilon[n] = drive.acceleration[n];
      } else {
        link.turned.set(n, on.turned[n] * drive.turned[n]);
        link.omega[n] = on.omega[n] + drive.speed[n];
        link.epsilon[n] = on.epsilon[n] + drive.acceleration[n];
      }
    });
  }

  void slide_by_drive(const Hinge& hinge, std::size_t s) {
    const DriveLanes<Count>& drive = now_.drives[s];
    slide(hinge, drive.value, drive.speed, drive.acceleration, now_.steps[s].along);
  }

  void fix(const Hinge& hinge) {
    static constexpr Lanes<Count> none_at_all{};
    VecLanes<Count> along;
    slide(hinge, none_at_all, none_at_all, none_at_all, along);
  }

  void slide(const Hinge& hinge, const Lanes<Count>& value, const Lanes<Count>& speed, const Lanes<Count>& acceleration,
             VecLanes<Count>& along) {
    const Motion& on = now_.links[hinge.on];
    Motion& link = now_.links[hinge.link];
    const Vec direction = hinge.along, seat = hinge.seat;
    each_lane<Count>([&](std::size_t n) {
      const Vec way = on.turned[n](direction);
      const Vec lever = on.turned[n](seat) + value[n] * way;
      const double omega = on.omega[n], epsilon = on.epsilon[n];
      along.set(n, way);
      link.turned.set(n, on.turned[n]);
      link.omega[n] = omega;
      link.epsilon[n] = epsilon;
      link.origin.set(n, on.origin[n] + lever);
      link.velocity.set(n, on.velocity[n] + omega * normal(lever) + speed[n] * way);
      link.acceleration.set(n, on.acceleration[n] + epsilon * normal(lever) - omega * omega * lever +
                                   2.0 * omega * speed[n] * normal(way) + acceleration[n] * way);
    });
  }

  template <bool FirstGrounded, bool SecondGrounded>
  void close_two_arms(const ChainStep& step, std::size_t s) {
    const Hinge &first = step.first, &second = step.second;
    const Motion &on_first = now_.links[first.on], &on_second = now_.links[second.on];
    Motion &i = now_.links[first.link], &j = now_.links[second.link];
    StepMotion<Count>& keep = now_.steps[s];
    const double to_i = 1.0 / first.length, to_j = 1.0 / second.length;
    const double ii = first.length * first.length, jj = second.length * second.length;
    const Vec seat_i = first.seat, seat_j = second.seat;
    const double difference = ii - jj, sine_of = to_i * to_j, side = now_.sides[s];
    each_lane<Count>([&](std::size_t n) {
      const Course a = follow<FirstGrounded>(on_first, seat_i, n);
      const Course b = follow<SecondGrounded>(on_second, seat_j, n);
      const Vec across = b.at - a.at;
      const double square = dot(across, across), inverse_square = 1.0 / square;
      const double along = 0.5 + 0.5 * (difference * inverse_square);
      const double aside = std::sqrt(ii * inverse_square - along * along);
      now_.clear[n] = aside * square * sine_of > now_.least_sine[n] ? now_.clear[n] : 0.0;
      const Vec u = along * across + (side * aside) * normal(across), w = u - across;
      const double inverse = 1.0 / cross(u, w);
      keep.inverse[n] = inverse;
      const Vec parting = b.velocity - a.velocity;
      const double omega_i = dot(parting, w) * inverse, omega_j = dot(parting, u) * inverse;
      const Vec gaining = b.acceleration - a.acceleration + omega_i * omega_i * u - omega_j * omega_j * w;
      put(a, n, i);
      put(b, n, j);
      i.turned.set(n, {to_i * u.x, to_i * u.y});
      j.turned.set(n, {to_j * w.x, to_j * w.y});
      i.omega[n] = omega_i;
      j.omega[n] = omega_j;
      i.epsilon[n] = dot(gaining, w) * inverse;
      j.epsilon[n] = dot(gaining, u) * inverse;
    });
  }

  template <bool ArmGrounded, bool LineGrounded>
  void close_arm_and_line(const ChainStep& step, std::size_t s) {
    const Hinge &bar = step.first, &line = step.second;
    const Motion &on_arm = now_.links[bar.on], &on = now_.links[line.on];
    Motion& arm = now_.links[bar.link];
    Motion& slider = line.tree == none ? now_.spare : now_.links[line.link];
    StepMotion<Count>& keep = now_.steps[s];
    const double length = bar.length, to_arm = 1.0 / length, side = now_.sides[s];
    const Vec pin = bar.seat, base = line.seat, direction = line.along;
    each_lane<Count>([&](std::size_t n) {
      const Course a = follow<ArmGrounded>(on_arm, pin, n);
      const Turn frame = turned<LineGrounded>(on, n);
      const Vec along = frame(direction), aside = normal(along);
      const Vec start = LineGrounded ? base : on.origin[n] + frame(base);
      const double distance = dot(start - a.at, aside);
      const double half = std::sqrt(length * length - distance * distance), ahead = side * half;
      now_.clear[n] = half * to_arm > now_.least_sine[n] ? now_.clear[n] : 0.0;
      const Vec u = ahead * along + distance * aside, at = a.at + u;
      const double inverse = 1.0 / ahead;
      // Of the line's point that the slider is at.
      Vec velocity, acceleration;
      double carried = 0.0;
      if constexpr (!LineGrounded) {
        const Vec lever = at - on.origin[n];
        carried = on.omega[n];
        velocity = on.velocity[n] + carried * normal(lever);
        acceleration = on.acceleration[n] + on.epsilon[n] * normal(lever) - carried * carried * lever;
      }
      const Vec parting = velocity - a.velocity;
      const double omega = dot(parting, aside) * inverse;
      Vec gaining = acceleration - a.acceleration + omega * omega * u;
      if constexpr (!LineGrounded) gaining = gaining - (2.0 * carried * dot(parting, u) * inverse) * aside;
      const double epsilon = dot(gaining, aside) * inverse;
      put(a, n, arm);
      arm.turned.set(n, {to_arm * u.x, to_arm * u.y});
      arm.omega[n] = omega;
      arm.epsilon[n] = epsilon;
      put({at, a.velocity + omega * normal(u), a.acceleration + epsilon * normal(u) - omega * omega * u}, n, slider);
      slider.turned.set(n, frame);
      slider.omega[n] = carried;
      slider.epsilon[n] = LineGrounded ? 0.0 : on.epsilon[n];
      keep.along.set(n, along);
      keep.inverse[n] = inverse;
      keep.distance[n] = distance;
    });
  }

  /// From the pivot of the second link to what its line passes at `aside`: the pin in its slot, or the other pivot.
  template <bool FirstGrounded, bool SecondGrounded>
  void close_on_line(const ChainStep& step, std::size_t s) {
    const Hinge &first = step.first, &second = step.second;
    const bool guide = step.kind == ChainStep::Kind::guide;
    const Vec point = guide ? first.seat : step.pin, pivot = second.seat;
    const Motion &on_first = now_.links[first.on], &on_second = now_.links[second.on];
    Motion& link = now_.links[second.link];
    Motion& other = guide ? now_.links[first.link] : now_.spare;
    StepMotion<Count>& keep = now_.steps[s];
    const double aside = step.aside, side = now_.sides[s];
    each_lane<Count>([&](std::size_t n) {
      const Course to = follow<FirstGrounded>(on_first, point, n);
      const Course from = follow<SecondGrounded>(on_second, pivot, n);
      const Vec way = to.at - from.at;
      const double square = dot(way, way), half = std::sqrt(square - aside * aside), ahead = side * half;
      now_.clear[n] = half > now_.least_sine[n] * std::sqrt(square) ? now_.clear[n] : 0.0;
      const double inverse_square = 1.0 / square, inverse = 1.0 / ahead;
      const Vec along = inverse_square * (ahead * way - aside * normal(way)), across = normal(along);
      const Vec parting = to.velocity - from.velocity, gaining = to.acceleration - from.acceleration;
      const double omega = dot(parting, across) * inverse, speed = dot(parting, along) + omega * aside;
      const double epsilon = (dot(gaining, across) - 2.0 * speed * omega + omega * omega * aside) * inverse;
      for (Motion* m : {&link, &other}) {
        m->turned.set(n, {along.x, along.y});
        m->omega[n] = omega;
        m->epsilon[n] = epsilon;
      }
      put(from, n, link);
      put(to, n, other);
      keep.along.set(n, along);
      keep.inverse[n] = inverse;
    });
  }

  // ---- forces

  void need(const ChainLink& link, Motion& m, bool statics) const {
    const Vec gravity = chain_.gravity, to_centre = link.centre;
    const double mass = link.mass, inertia = link.inertia;
    if (mass == 0.0 && inertia == 0.0) {
      m.force = {};
      m.moment = {};
      return;
    }
    if (statics) {
      const Vec weight = -mass * gravity;
      return each_lane<Count>([&](std::size_t n) {
        m.force.set(n, weight);
        m.moment[n] = cross(m.turned[n](to_centre), weight);
      });
    }
    if (to_centre.x == 0.0 && to_centre.y == 0.0) {
      return each_lane<Count>([&](std::size_t n) {
        m.force.set(n, mass * (m.acceleration[n] - gravity));
        m.moment[n] = inertia * m.epsilon[n];
      });
    }
    each_lane<Count>([&](std::size_t n) {
      const double omega = m.omega[n], epsilon = m.epsilon[n];
      const Vec arm = m.turned[n](to_centre);
      const Vec centre = m.acceleration[n] + epsilon * normal(arm) - omega * omega * arm;
      const Vec force = mass * (centre - gravity);
      m.force.set(n, force);
      m.moment[n] = inertia * epsilon + cross(arm, force);
    });
  }

  void load(const ChainLoad& load, const LoadLanes<Count>& given) {
    Motion& m = now_.links[load.link];
    const Turn own = chain_.links[load.link].own;
    const Vec point = load.point;
    if (load.at_start && !load.turns_with_link) {
      return each_lane<Count>([&](std::size_t n) {
        m.force.set(n, m.force[n] - given.force[n]);
        m.moment[n] -= given.moment[n];
      });
    }
    if (!load.turns_with_link) {
      return each_lane<Count>([&](std::size_t n) {
        const Vec force = given.force[n];
        m.force.set(n, m.force[n] - force);
        m.moment[n] -= given.moment[n] + cross(m.turned[n](point), force);
      });
    }
    each_lane<Count>([&](std::size_t n) {
      const Vec force = m.turned[n](own(given.force[n]));
      m.force.set(n, m.force[n] - force);
      m.moment[n] -= given.moment[n] + cross(m.turned[n](point), force);
    });
  }

  /// What a link pinned at its origin needs comes through the pin.
  template <bool Grounded>
  static void pass_pin(Vec force, Vec origin, double sense, std::size_t n, Motion& on, ReactionLanes<Count>& out) {
    out.force.set(n, sense * force);
    if constexpr (!Grounded) {
      on.force.set(n, on.force[n] + force);
      on.moment[n] += cross(origin - on.origin[n], force);
    }
  }
  static double sense_of(const Hinge& hinge) { return hinge.link_is_i ? 1.0 : -1.0; }

  /// What a slider still needs, its guide gives: what it needs along the guide is with its drive, or nothing.
  void pass_guide(const Hinge& hinge, const VecLanes<Count>& along, bool whole) {
    Motion& link = now_.links[hinge.link];
    Motion& on = now_.links[hinge.on];
    const double sense = sense_of(hinge);
    ReactionLanes<Count>& out = now_.reactions[hinge.joint];
    each_lane<Count>([&](std::size_t n) {
      const Vec aside = normal(along[n]), force = link.force[n];
      const Vec across = dot(force, aside) * aside;
      out.force.set(n, sense * across);
      out.couple[n] = sense * link.moment[n];
    });
    if (whole) each_lane<Count>([&](std::size_t n) { out.force.set(n, sense * link.force[n]); });
    if (!hinge.centred) {
      const Motion& frame = hinge.link_is_i ? link : on;
      const Vec own = hinge.mount;
      each_lane<Count>([&](std::size_t n) {
        const Vec mount = frame.origin[n] + frame.turned[n](own);
        out.couple[n] += sense * cross(link.origin[n] - mount, link.force[n]);
      });
    }
    if (hinge.grounded) return;
    each_lane<Count>([&](std::size_t n) {
      const Vec force = link.force[n];
      on.force.set(n, on.force[n] + force);
      on.moment[n] += link.moment[n] + cross(link.origin[n] - on.origin[n], force);
    });
  }

  template <bool Grounded>
  void supply_turned(const ChainStep& step) {
    const Motion& link = now_.links[step.first.link];
    Motion& on = now_.links[step.first.on];
    ReactionLanes<Count>& out = now_.reactions[step.first.joint];
    Lanes<Count>& effort = now_.effort[step.driver];
    const double sense = sense_of(step.first), of_drive = step.sense;
    each_lane<Count>([&](std::size_t n) {
      effort[n] = of_drive * link.moment[n];
      pass_pin<Grounded>(link.force[n], link.origin[n], sense, n, on, out);
      if constexpr (!Grounded) on.moment[n] += link.moment[n];
    });
  }

  void supply_slid(const ChainStep& step, std::size_t s) {
    const VecLanes<Count>& along = now_.steps[s].along;
    pass_guide(step.first, along, step.kind == ChainStep::Kind::fixed);
    if (step.driver == none) return;
    const Motion& link = now_.links[step.first.link];
    Lanes<Count>& effort = now_.effort[step.driver];
    const double sense = step.sense;
    each_lane<Count>([&](std::size_t n) { effort[n] = sense * dot(link.force[n], along[n]); });
  }

  template <bool FirstGrounded, bool SecondGrounded>
  void supply_two_arms(const ChainStep& step, std::size_t s) {
    const Motion &i = now_.links[step.first.link], &j = now_.links[step.second.link];
    Motion &on_i = now_.links[step.first.on], &on_j = now_.links[step.second.on];
    const StepMotion<Count>& kept = now_.steps[s];
    ReactionLanes<Count>&out = now_.reactions[step.joint], &of_i = now_.reactions[step.first.joint],
    &of_j = now_.reactions[step.second.joint];
    const double length_i = step.first.length, length_j = step.second.length;
    const double sense_i = sense_of(step.first), sense_j = sense_of(step.second);
    each_lane<Count>([&](std::size_t n) {
      const double inverse = kept.inverse[n];
      const double along_j = length_j * i.moment[n] * inverse, along_i = length_i * j.moment[n] * inverse;
      const Turn u = i.turned[n], w = j.turned[n];
      const Vec force{along_j * w.cosine + along_i * u.cosine, along_j * w.sine + along_i * u.sine};
      out.force.set(n, force);
      pass_pin<FirstGrounded>(i.force[n] - force, i.origin[n], sense_i, n, on_i, of_i);
      pass_pin<SecondGrounded>(j.force[n] + force, j.origin[n], sense_j, n, on_j, of_j);
    });
  }

  template <bool ArmGrounded>
  void supply_arm_and_line(const ChainStep& step, std::size_t s) {
    const Hinge &bar = step.first, &line = step.second;
    const Motion& arm = now_.links[bar.link];
    const bool slot = line.tree == none;
    Motion &on_arm = now_.links[bar.on], &slider = slot ? now_.spare : now_.links[line.link];
    const StepMotion<Count>& kept = now_.steps[s];
    ReactionLanes<Count>&out = now_.reactions[step.joint], &of_pin = now_.reactions[bar.joint];
    const double sense = step.sense, sense_pin = sense_of(bar);
    if (slot) slider.force = {};
    each_lane<Count>([&](std::size_t n) {
      const Vec along = kept.along[n], needed = slider.force[n];
      const double pushed = -dot(needed, along);
      const double pressed = (arm.moment[n] + pushed * kept.distance[n]) * kept.inverse[n];
      const Vec force = pushed * along + pressed * normal(along);
      out.force.set(n, sense * force);
      slider.force.set(n, needed + force);
      pass_pin<ArmGrounded>(arm.force[n] - force, arm.origin[n], sense_pin, n, on_arm, of_pin);
    });
    if (!slot) return pass_guide(line, kept.along, false);
    if (line.grounded) return;
    Motion& on = now_.links[line.on];
    const double length = bar.length;
    each_lane<Count>([&](std::size_t n) {
      const Turn u = arm.turned[n];
      const Vec at = arm.origin[n] + Vec{length * u.cosine, length * u.sine}, force = slider.force[n];
      on.force.set(n, on.force[n] + force);
      on.moment[n] += cross(at - on.origin[n], force);
    });
  }

  template <bool Grounded>
  void supply_slot(const ChainStep& step, std::size_t s) {
    const Motion& link = now_.links[step.second.link];
    Motion& on = now_.links[step.second.on];
    const StepMotion<Count>& kept = now_.steps[s];
    ReactionLanes<Count>&out = now_.reactions[step.joint], &of_pin = now_.reactions[step.second.joint];
    const double sense = sense_of(step.second);
    each_lane<Count>([&](std::size_t n) {
      const Vec force = (-link.moment[n] * kept.inverse[n]) * normal(kept.along[n]);
      out.force.set(n, force);
      pass_pin<Grounded>(link.force[n] + force, link.origin[n], sense, n, on, of_pin);
    });
    if (step.first.grounded) return;
    Motion& held = now_.links[step.first.on];
    const Vec pin = step.pin;
    each_lane<Count>([&](std::size_t n) {
      const Vec force = out.force[n];
      held.force.set(n, held.force[n] - force);
      held.moment[n] -= cross(held.turned[n](pin), force);
    });
  }

  template <bool FirstGrounded, bool SecondGrounded>
  void supply_guide(const ChainStep& step, std::size_t s) {
    const Motion &first = now_.links[step.first.link], &second = now_.links[step.second.link];
    Motion &on_first = now_.links[step.first.on], &on_second = now_.links[step.second.on];
    const StepMotion<Count>& kept = now_.steps[s];
    ReactionLanes<Count>&out = now_.reactions[step.joint], &of_first = now_.reactions[step.first.joint],
    &of_second = now_.reactions[step.second.joint];
    const double reach = step.pin.x, sense_first = sense_of(step.first), sense_second = sense_of(step.second);
    each_lane<Count>([&](std::size_t n) {
      const double pressed = -(first.moment[n] + second.moment[n]) * kept.inverse[n];
      const Vec force = pressed * normal(kept.along[n]);
      out.force.set(n, force);
      out.couple[n] = first.moment[n] - pressed * reach;
      pass_pin<FirstGrounded>(first.force[n] - force, first.origin[n], sense_first, n, on_first, of_first);
      pass_pin<SecondGrounded>(second.force[n] + force, second.origin[n], sense_second, n, on_second, of_second);
    });
  }

  const Chain& chain_;
  ChainState<Count>& now_;
};

}  // namespace loadpath::mechanism
