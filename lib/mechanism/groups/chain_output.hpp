// The input of a chain of dyads from the drives of its model, and its output on links and joints in the model's
// terms.
#pragma once

#include "lib/mechanism/groups/chain_state.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/mechanism/model/whole_turn.hpp"

#include <cmath>
#include <cstddef>
#include <span>

namespace loadpath::mechanism {

/// In the counting direction of the step's joint.
inline double value_of(const ChainStep& step, const Drive& drive) {
  return step.sense * (drive.coordinate - step.offset);
}

template <std::size_t Count>
void set_drive(const ChainStep& step, const Drive& drive, std::size_t lane, DriveLanes<Count>& out) {
  out.value[lane] = value_of(step, drive);
  out.speed[lane] = step.sense * drive.speed;
  out.acceleration[lane] = step.sense * drive.acceleration;
  if (step.kind == ChainStep::Kind::turned) out.turned.set(lane, turn(out.value[lane]));
}

template <std::size_t Count>
Vec place_of(const Chain& chain, const ChainState<Count>& now, std::size_t link, std::size_t lane) {
  const ChainMotion<Count>& m = now.links[link];
  return chain.links[link].shifted ? m.origin[lane] + m.turned[lane](chain.links[link].start) : m.origin[lane];
}

/// Velocity and acceleration of the model's frame of a link.
template <std::size_t Count>
Pose velocity_of(const Chain& chain, const ChainState<Count>& now, std::size_t link, std::size_t lane) {
  const ChainMotion<Count>& m = now.links[link];
  Vec v = m.velocity[lane];
  if (chain.links[link].shifted) v = v + m.omega[lane] * normal(m.turned[lane](chain.links[link].start));
  return {v.x, v.y, m.omega[lane]};
}
template <std::size_t Count>
Pose acceleration_of(const Chain& chain, const ChainState<Count>& now, std::size_t link, std::size_t lane) {
  const ChainMotion<Count>& m = now.links[link];
  Vec a = m.acceleration[lane];
  if (chain.links[link].shifted) {
    const Vec arm = m.turned[lane](chain.links[link].start);
    a = a + m.epsilon[lane] * normal(arm) - m.omega[lane] * m.omega[lane] * arm;
  }
  return {a.x, a.y, m.epsilon[lane]};
}

/// Continues from the previous poses: among angles that differ by full revolutions it takes the nearest.
template <std::size_t Count>
void follow_poses(const Chain& chain, const ChainState<Count>& now, std::size_t lane, std::span<Pose> poses) {
  const auto set_place = [&](std::size_t link) {
    const Vec at = place_of(chain, now, link, lane);
    poses[link].x = at.x;
    poses[link].y = at.y;
  };
  const auto go_with = [&](const Hinge& hinge, double angle) {
    poses[hinge.link].phi = (hinge.grounded ? 0.0 : poses[hinge.on].phi) + angle;
    set_place(hinge.link);
  };
  const auto turn_to = [&](std::size_t link) {
    const double angle = angle_of(now.links[link].turned[lane] * chain.links[link].own);
    poses[link].phi = angle + whole_turn * std::round((poses[link].phi - angle) / whole_turn);
    set_place(link);
  };
  for (std::size_t s = 0; s < chain.steps.size(); ++s) {
    const ChainStep& step = chain.steps[s];
    switch (step.kind) {
      case ChainStep::Kind::turned:
        go_with(step.first, now.drives[s].value[lane]);
        break;
      case ChainStep::Kind::slid:
      case ChainStep::Kind::fixed:
        go_with(step.first, step.first.angle);
        break;
      case ChainStep::Kind::two_arms:
        turn_to(step.first.link);
        turn_to(step.second.link);
        break;
      case ChainStep::Kind::arm_and_line:
        turn_to(step.first.link);
        if (step.second.tree != none) go_with(step.second, step.second.angle);
        break;
      case ChainStep::Kind::slot:
        turn_to(step.second.link);
        break;
      case ChainStep::Kind::guide:
        turn_to(step.second.link);
        poses[step.first.link].phi = poses[step.second.link].phi + step.angle;
        set_place(step.first.link);
        break;
    }
  }
}

/// The points of action of the reactions: of the step's hinges and of its inner joint.
template <std::size_t Count>
void take_pins(const Chain& chain, const ChainState<Count>& now, std::size_t lane, std::span<Reaction> reactions) {
  const auto point = [&](std::size_t link, Vec own) {
    return now.links[link].origin[lane] + now.links[link].turned[lane](own);
  };
  const auto take_hinge = [&](const Hinge& hinge, bool slides) {
    if (hinge.joint == none) return;
    const std::size_t link = hinge.link_is_i || !slides ? hinge.link : hinge.on;
    reactions[hinge.joint].at = slides ? point(link, hinge.mount) : now.links[link].origin[lane];
  };
  for (const ChainStep& step : chain.steps) {
    using Kind = ChainStep::Kind;
    take_hinge(step.first, step.kind == Kind::slid || step.kind == Kind::fixed);
    take_hinge(step.second, step.kind == Kind::arm_and_line);
    if (step.joint == none) continue;
    Vec& at = reactions[step.joint].at;
    if (step.kind == Kind::slot) {
      at = point(step.first.on, step.pin);
    } else {
      at = point(step.first.link, step.kind == Kind::guide ? step.pin : Vec{step.first.length, 0.0});
    }
  }
}

}  // namespace loadpath::mechanism
