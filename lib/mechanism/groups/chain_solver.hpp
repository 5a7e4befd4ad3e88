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
  /// Where something is and how it moves.
  struct Course {
    VecLanes<Count> at, velocity, acceleration;
  };

  void move(const ChainStep& step, std::size_t s) {
    switch (step.kind) {
      case ChainStep::Kind::turned:
        return turn_by_drive(step.first, s);
      case ChainStep::Kind::slid:
        return slide_by_drive(step.first, s);
      case ChainStep::Kind::fixed:
        return fix(step.first);
      case ChainStep::Kind::two_arms:
        return close_two_arms(step, s);
      case ChainStep::Kind::arm_and_line:
        return close_arm_and_line(step, s);
      case ChainStep::Kind::slot:
      case ChainStep::Kind::guide:
        return close_on_line(step, s);
    }
  }

  void supply(const ChainStep& step, std::size_t s) {
    switch (step.kind) {
      case ChainStep::Kind::turned:
      case ChainStep::Kind::slid:
      case ChainStep::Kind::fixed:
        return supply_driven(step, s);
      case ChainStep::Kind::two_arms:
        return supply_two_arms(step, s);
      case ChainStep::Kind::arm_and_line:
        return supply_arm_and_line(step, s);
      case ChainStep::Kind::slot:
      case ChainStep::Kind::guide:
        return supply_on_line(step, s);
    }
  }

  // ---- motion

  /// Of a point of what the hinge hangs on.
  void follow(const Hinge& hinge, Vec point, Course& out) const {
    if (hinge.grounded) {
      return each_lane<Count>([&](std::size_t n) {
        out.at.set(n, point);
        out.velocity.set(n, {});
        out.acceleration.set(n, {});
      });
    }
    const Motion& on = now_.links[hinge.on];
    each_lane<Count>([&](std::size_t n) {
      const Vec arm = on.turned[n](point);
      const double omega = on.omega[n];
      out.at.set(n, on.origin[n] + arm);
      out.velocity.set(n, on.velocity[n] + omega * normal(arm));
      out.acceleration.set(n, on.acceleration[n] + on.epsilon[n] * normal(arm) - omega * omega * arm);
    });
  }

  void turn_by_drive(const Hinge& hinge, std::size_t s) {
    Course pin;
    follow(hinge, hinge.seat, pin);
    const DriveLanes<Count>& drive = now_.drives[s];
    Motion& link = now_.links[hinge.link];
    const Motion& on = now_.links[hinge.on];
    each_lane<Count>([&](std::size_t n) {
      link.origin.set(n, pin.at[n]);
      link.velocity.set(n, pin.velocity[n]);
      link.acceleration.set(n, pin.acceleration[n]);
      link.turned.set(n, on.turned[n] * drive.turned[n]);
      link.omega[n] = on.omega[n] + drive.speed[n];
      link.epsilon[n] = on.epsilon[n] + drive.acceleration[n];
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
    each_lane<Count>([&](std::size_t n) {
      const Vec way = on.turned[n](hinge.along);
      const Vec lever = on.turned[n](hinge.seat) + value[n] * way;
      const double omega = on.omega[n], epsilon = on.epsilon[n];
      along.set(n, way);
      link.origin.set(n, on.origin[n] + lever);
      link.turned.set(n, on.turned[n]);
      link.omega[n] = omega;
      link.epsilon[n] = epsilon;
      link.velocity.set(n, on.velocity[n] + omega * normal(lever) + speed[n] * way);
      link.acceleration.set(n, on.acceleration[n] + epsilon * normal(lever) - omega * omega * lever +
                                   2.0 * omega * speed[n] * normal(way) + acceleration[n] * way);
    });
  }

  void close_two_arms(const ChainStep& step, std::size_t s) {
    Course a, b;
    follow(step.first, step.first.seat, a);
    follow(step.second, step.second.seat, b);
    Motion &i = now_.links[step.first.link], &j = now_.links[step.second.link];
    StepMotion<Count>& keep = now_.steps[s];
    const double to_i = 1.0 / step.first.length, to_j = 1.0 / step.second.length;
    const double ii = step.first.length * step.first.length, jj = step.second.length * step.second.length;
    const double difference = ii - jj, sine_of = 1.0 / (step.first.length * step.second.length), side = now_.sides[s];
    each_lane<Count>([&](std::size_t n) {
      const Vec across = b.at[n] - a.at[n];
      const double square = dot(across, across), inverse_square = 1.0 / square;
      const double along = 0.5 + 0.5 * (difference * inverse_square);
      const double aside = std::sqrt(ii * inverse_square - along * along);
      now_.clear[n] = aside * square * sine_of > now_.least_sine[n] ? now_.clear[n] : 0.0;
      const Vec u = along * across + (side * aside) * normal(across), w = u - across;
      i.turned.set(n, {to_i * u.x, to_i * u.y});
      j.turned.set(n, {to_j * w.x, to_j * w.y});
      const double inverse = 1.0 / cross(u, w);
      keep.inverse[n] = inverse;
      const Vec parting = b.velocity[n] - a.velocity[n];
      const double omega_i = dot(parting, w) * inverse, omega_j = dot(parting, u) * inverse;
      const Vec gaining = b.acceleration[n] - a.acceleration[n] + omega_i * omega_i * u - omega_j * omega_j * w;
      i.omega[n] = omega_i;
      j.omega[n] = omega_j;
      i.epsilon[n] = dot(gaining, w) * inverse;
      j.epsilon[n] = dot(gaining, u) * inverse;
    });
    take(a, i);
    take(b, j);
  }

  static void take(const Course& pin, Motion& link) {
    link.origin = pin.at;
    link.velocity = pin.velocity;
    link.acceleration = pin.acceleration;
  }

  void close_arm_and_line(const ChainStep& step, std::size_t s) {
    Course a;
    follow(step.first, step.first.seat, a);
    Motion& arm = now_.links[step.first.link];
    const Motion& on = now_.links[step.second.on];
    StepMotion<Count>& keep = now_.steps[s];
    Course slider;
    const Hinge& line = step.second;
    const double length = step.first.length, to_arm = 1.0 / length, side = now_.sides[s];
    each_lane<Count>([&](std::size_t n) {
      const Vec along = on.turned[n](line.along), aside = normal(along);
      const Vec start = on.origin[n] + on.turned[n](line.seat);
      const double distance = dot(start - a.at[n], aside);
      const double half = std::sqrt(length * length - distance * distance), ahead = side * half;
      now_.clear[n] = half * to_arm > now_.least_sine[n] ? now_.clear[n] : 0.0;
      const Vec u = ahead * along + distance * aside;
      arm.turned.set(n, {to_arm * u.x, to_arm * u.y});
      const Vec at = a.at[n] + u;
      const double inverse = 1.0 / ahead, carried = on.omega[n];
      keep.along.set(n, along);
      keep.inverse[n] = inverse;
      keep.distance[n] = distance;
      // Of the line's point that the slider is at.
      const Vec lever = at - on.origin[n];
      const Vec velocity = on.velocity[n] + carried * normal(lever);
      const Vec acceleration = on.acceleration[n] + on.epsilon[n] * normal(lever) - carried * carried * lever;
      const Vec parting = velocity - a.velocity[n];
      const double omega = dot(parting, aside) * inverse, speed = -dot(parting, u) * inverse;
      const Vec gaining = acceleration - a.acceleration[n] + (2.0 * carried * speed) * aside + omega * omega * u;
      const double epsilon = dot(gaining, aside) * inverse;
      arm.omega[n] = omega;
      arm.epsilon[n] = epsilon;
      slider.at.set(n, at);
      slider.velocity.set(n, a.velocity[n] + omega * normal(u));
      slider.acceleration.set(n, a.acceleration[n] + epsilon * normal(u) - omega * omega * u);
    });
    take(a, arm);
    if (line.tree == none) return;
    Motion& link = now_.links[line.link];
    take(slider, link);
    link.turned = on.turned;
    link.omega = on.omega;
    link.epsilon = on.epsilon;
  }

  /// From the pivot of the second link to what its line passes at `aside`: the pin in its slot, or the other pivot.
  void close_on_line(const ChainStep& step, std::size_t s) {
    const bool guide = step.kind == ChainStep::Kind::guide;
    Course to, from;
    follow(step.first, guide ? step.first.seat : step.pin, to);
    follow(step.second, step.second.seat, from);
    Motion& link = now_.links[step.second.link];
    StepMotion<Count>& keep = now_.steps[s];
    const double aside = step.aside, side = now_.sides[s];
    each_lane<Count>([&](std::size_t n) {
      const Vec way = to.at[n] - from.at[n];
      const double square = dot(way, way), half = std::sqrt(square - aside * aside), ahead = side * half;
      now_.clear[n] = half > now_.least_sine[n] * std::sqrt(square) ? now_.clear[n] : 0.0;
      const double inverse_square = 1.0 / square, inverse = 1.0 / ahead;
      const Vec along = inverse_square * (ahead * way - aside * normal(way)), across = normal(along);
      const Vec parting = to.velocity[n] - from.velocity[n];
      const double omega = dot(parting, across) * inverse, speed = dot(parting, along) + omega * aside;
      const Vec gaining = to.acceleration[n] - from.acceleration[n];
      link.turned.set(n, {along.x, along.y});
      link.omega[n] = omega;
      link.epsilon[n] = (dot(gaining, across) - 2.0 * speed * omega + omega * omega * aside) * inverse;
      keep.along.set(n, along);
      keep.inverse[n] = inverse;
    });
    take(from, link);
    if (!guide) return;
    Motion& first = now_.links[step.first.link];
    take(to, first);
    first.turned = link.turned;
    first.omega = link.omega;
    first.epsilon = link.epsilon;
  }

  // ---- forces

  void need(const ChainLink& link, Motion& m, bool statics) const {
    const Vec gravity = chain_.gravity;
    if (link.mass == 0.0 && link.inertia == 0.0) {
      m.force = {};
      m.moment = {};
      return;
    }
    if (statics) {
      const Vec weight = -link.mass * gravity;
      return each_lane<Count>([&](std::size_t n) {
        m.force.set(n, weight);
        m.moment[n] = cross(m.turned[n](link.centre), weight);
      });
    }
    each_lane<Count>([&](std::size_t n) {
      const double omega = m.omega[n], epsilon = m.epsilon[n];
      const Vec arm = m.turned[n](link.centre);
      const Vec centre = m.acceleration[n] + epsilon * normal(arm) - omega * omega * arm;
      const Vec force = link.mass * (centre - gravity);
      m.force.set(n, force);
      m.moment[n] = link.inertia * epsilon + cross(arm, force);
    });
  }

  void load(const ChainLoad& load, const LoadLanes<Count>& given) {
    Motion& m = now_.links[load.link];
    const Turn own = chain_.links[load.link].own;
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
        m.moment[n] -= given.moment[n] + cross(m.turned[n](load.point), force);
      });
    }
    each_lane<Count>([&](std::size_t n) {
      const Vec force = m.turned[n](own(given.force[n]));
      m.force.set(n, m.force[n] - force);
      m.moment[n] -= given.moment[n] + cross(m.turned[n](load.point), force);
    });
  }

  /// What a link pinned at its origin still needs comes through the pin.
  void pass_pin(const Hinge& hinge) {
    Motion& link = now_.links[hinge.link];
    const double sense = hinge.link_is_i ? 1.0 : -1.0;
    ReactionLanes<Count>& out = now_.reactions[hinge.joint];
    each_lane<Count>([&](std::size_t n) {
      out.force.set(n, sense * link.force[n]);
      out.couple[n] = 0.0;
    });
    if (hinge.grounded) return;
    Motion& on = now_.links[hinge.on];
    each_lane<Count>([&](std::size_t n) {
      const Vec force = link.force[n];
      on.force.set(n, on.force[n] + force);
      on.moment[n] += cross(link.origin[n] - on.origin[n], force);
    });
  }

  /// What a slider still needs, its guide gives: what it needs along the guide is with its drive, or nothing.
  void pass_guide(const Hinge& hinge, const VecLanes<Count>& along, bool whole) {
    Motion& link = now_.links[hinge.link];
    Motion& on = now_.links[hinge.on];
    const double sense = hinge.link_is_i ? 1.0 : -1.0;
    ReactionLanes<Count>& out = now_.reactions[hinge.joint];
    each_lane<Count>([&](std::size_t n) {
      const Vec aside = normal(along[n]), force = link.force[n];
      const Vec across = whole ? force : dot(force, aside) * aside;
      out.force.set(n, sense * across);
      out.couple[n] = sense * link.moment[n];
    });
    if (!hinge.centred) {
      const Motion& frame = hinge.link_is_i ? link : on;
      each_lane<Count>([&](std::size_t n) {
        const Vec mount = frame.origin[n] + frame.turned[n](hinge.mount);
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

  void supply_driven(const ChainStep& step, std::size_t s) {
    const Hinge& hinge = step.first;
    Motion& link = now_.links[hinge.link];
    const double sense = step.sense;
    if (step.kind != ChainStep::Kind::turned) {
      const VecLanes<Count>& along = now_.steps[s].along;
      pass_guide(hinge, along, step.kind == ChainStep::Kind::fixed);
      if (step.driver == none) return;
      Lanes<Count>& effort = now_.effort[step.driver];
      return each_lane<Count>([&](std::size_t n) { effort[n] = sense * dot(link.force[n], along[n]); });
    }
    Lanes<Count>& effort = now_.effort[step.driver];
    each_lane<Count>([&](std::size_t n) { effort[n] = sense * link.moment[n]; });
    pass_pin(hinge);
    if (hinge.grounded) return;
    Motion& on = now_.links[hinge.on];
    each_lane<Count>([&](std::size_t n) { on.moment[n] += link.moment[n]; });
  }

  void supply_two_arms(const ChainStep& step, std::size_t s) {
    Motion &i = now_.links[step.first.link], &j = now_.links[step.second.link];
    const StepMotion<Count>& kept = now_.steps[s];
    ReactionLanes<Count>& out = now_.reactions[step.joint];
    const double length_i = step.first.length, length_j = step.second.length;
    each_lane<Count>([&](std::size_t n) {
      const double of_i = length_j * i.moment[n] * kept.inverse[n], of_j = length_i * j.moment[n] * kept.inverse[n];
      const Turn u = i.turned[n], w = j.turned[n];
      const Vec force{of_i * w.cosine + of_j * u.cosine, of_i * w.sine + of_j * u.sine};
      out.force.set(n, force);
      out.couple[n] = 0.0;
      i.force.set(n, i.force[n] - force);
      j.force.set(n, j.force[n] + force);
    });
    pass_pin(step.first);
    pass_pin(step.second);
  }

  void supply_arm_and_line(const ChainStep& step, std::size_t s) {
    Motion& arm = now_.links[step.first.link];
    const StepMotion<Count>& kept = now_.steps[s];
    ReactionLanes<Count>& out = now_.reactions[step.joint];
    const Hinge& line = step.second;
    const double sense = step.sense;
    if (line.tree != none) {
      Motion& slider = now_.links[line.link];
      each_lane<Count>([&](std::size_t n) {
        const Vec along = kept.along[n];
        const double pushed = -dot(slider.force[n], along);
        const double pressed = (arm.moment[n] + pushed * kept.distance[n]) * kept.inverse[n];
        const Vec force = pushed * along + pressed * normal(along);
        out.force.set(n, sense * force);
        out.couple[n] = 0.0;
        arm.force.set(n, arm.force[n] - force);
        slider.force.set(n, slider.force[n] + force);
      });
      pass_guide(line, kept.along, false);
      return pass_pin(step.first);
    }
    each_lane<Count>([&](std::size_t n) {
      const Vec force = (arm.moment[n] * kept.inverse[n]) * normal(kept.along[n]);
      out.force.set(n, sense * force);
      out.couple[n] = 0.0;
      arm.force.set(n, arm.force[n] - force);
    });
    if (!line.grounded) {
      Motion& on = now_.links[line.on];
      const double length = step.first.length;
      each_lane<Count>([&](std::size_t n) {
        const Vec force = sense * out.force[n];
        const Turn u = arm.turned[n];
        const Vec at = arm.origin[n] + Vec{length * u.cosine, length * u.sine};
        on.force.set(n, on.force[n] + force);
        on.moment[n] += cross(at - on.origin[n], force);
      });
    }
    pass_pin(step.first);
  }

  void supply_on_line(const ChainStep& step, std::size_t s) {
    Motion& link = now_.links[step.second.link];
    const StepMotion<Count>& kept = now_.steps[s];
    ReactionLanes<Count>& out = now_.reactions[step.joint];
    if (step.kind == ChainStep::Kind::guide) {
      Motion& first = now_.links[step.first.link];
      const double reach = step.pin.x;
      each_lane<Count>([&](std::size_t n) {
        const double pressed = -(first.moment[n] + link.moment[n]) * kept.inverse[n];
        const Vec force = pressed * normal(kept.along[n]);
        out.force.set(n, force);
        out.couple[n] = first.moment[n] - pressed * reach;
        first.force.set(n, first.force[n] - force);
        link.force.set(n, link.force[n] + force);
      });
      pass_pin(step.first);
      return pass_pin(step.second);
    }
    each_lane<Count>([&](std::size_t n) {
      const Vec force = (-link.moment[n] * kept.inverse[n]) * normal(kept.along[n]);
      out.force.set(n, force);
      out.couple[n] = 0.0;
      link.force.set(n, link.force[n] + force);
    });
    if (!step.first.grounded) {
      Motion& held = now_.links[step.first.on];
      each_lane<Count>([&](std::size_t n) {
        const Vec force = out.force[n];
        held.force.set(n, held.force[n] - force);
        held.moment[n] -= cross(held.turned[n](step.pin), force);
      });
    }
    pass_pin(step.second);
  }

  const Chain& chain_;
  ChainState<Count>& now_;
};

}  // namespace loadpath::mechanism
