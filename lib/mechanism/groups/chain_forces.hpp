// Forces of a chain of dyads with known motion (chain_motion.hpp), back through its steps: a dyad's inner joint takes
// the forces that would rotate its links about their pins or slide them, by the determinant of its motion; the rest
// passes through the joints that carry them.
#pragma once

#include "lib/mechanism/groups/chain_state.hpp"

#include <cstddef>

namespace loadpath::mechanism {

template <std::size_t Count>
class ChainForces {
 public:
  ChainForces(const Chain& chain, ChainState<Count>& now) : chain_(chain), now_(now) {}

  /// `statics`: without inertia.
  void find(bool statics) {
    for (std::size_t k = 0; k < chain_.ground; ++k) need(chain_.links[k], now_.links[k], statics);
    for (std::size_t n = 0; n < chain_.loads.size(); ++n) load(chain_.loads[n], now_.loads[n]);
    for (std::size_t s = chain_.steps.size(); s-- > 0;) supply(chain_.steps[s], s);
  }

 private:
  using Motion = ChainMotion<Count>;

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

  /// The forces on a link pinned at its origin pass through the pin.
  template <bool Grounded>
  static void pass_pin(Vec force, Vec origin, double sense, std::size_t n, Motion& on, ReactionLanes<Count>& out) {
    out.force.set(n, sense * force);
    if constexpr (!Grounded) {
      on.force.set(n, on.force[n] + force);
      on.moment[n] += cross(origin - on.origin[n], force);
    }
  }
  static double sense_of(const Hinge& hinge) { return hinge.link_is_i ? 1.0 : -1.0; }

  /// The guide supplies the remaining force on a slider: the component along the guide is supplied by its drive, or
  /// is zero.
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
