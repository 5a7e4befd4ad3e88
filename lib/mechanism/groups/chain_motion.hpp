// Positions, velocities and accelerations of a chain of dyads, forward through its steps, for one position or for
// several in parallel: one template, so that a position has the same bits in a sweep and separately.
//
// The two closing equations of a dyad are solved by their determinant; velocities and accelerations are those of
// links, not of joints. A dyad keeps its assembly mode; near its change point the mode is ambiguous, and the values
// in that lane are not to be used.
#pragma once

#include "lib/mechanism/groups/chain_state.hpp"

#include <cmath>
#include <cstddef>

namespace loadpath::mechanism {

template <std::size_t Count>
class ChainMover {
 public:
  ChainMover(const Chain& chain, ChainState<Count>& now) : chain_(chain), now_(now) {}

  void move() {
    now_.clear.fill(1.0);
    for (std::size_t s = 0; s < chain_.steps.size(); ++s) move(chain_.steps[s], s);
  }

 private:
  using Motion = ChainMotion<Count>;
  /// Position and motion of a point, in one lane.
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

  /// The motion of a point of a link.
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
      // motion of the line's point at the slider
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

  /// From the pivot of the second link to the point at `aside` from its line: the pin in its slot, or the other pivot.
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

  const Chain& chain_;
  ChainState<Count>& now_;
};

}  // namespace loadpath::mechanism
