#include "lib/mechanism/induced.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

double sign(double value) { return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0); }

bool has_teeth(const Joint& joint) {
  return (joint.kind == JointKind::gear || joint.kind == JointKind::rack) && joint.pressure_angle != 0.0;
}

bool rubs(const Joint& joint) { return joint.kind != JointKind::belt && !has_teeth(joint) && joint.friction.any(); }

/// The span of a belt that is not the one of its equation: mirrored at the line of centres.
struct Span {
  Vec at, along;
};
Span other_span(const PairShape& shape, const PairPlace& at) {
  const Vec e = (-1.0 / std::sqrt(dot(at.apart, at.apart))) * at.apart;
  const Vec along = 2.0 * dot(e, at.along) * e - at.along;
  return {at.seat + at.apart - shape.radius_i * normal(along), along};
}

}  // namespace

std::size_t modes_of(const Joint& joint) {
  if (joint.kind == JointKind::belt || has_teeth(joint)) return 1;
  if (!rubs(joint)) return 0;
  switch (joint.kind) {
    case JointKind::prismatic:
    case JointKind::slot:
      return 2;
    case JointKind::revolute:
    case JointKind::rolling:
    case JointKind::rolling_on_line:
      return 1;
    default:
      return 0;
  }
}

InducedForces::InducedForces(const Model& model) : model_(model) {
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const Joint& joint = model.joints[k];
    const std::size_t count = modes_of(joint);
    if (count == 0) continue;
    sources_.push_back({.joint = k, .first = modes_.size(), .shape = shape_of(joint)});
    modes_.resize(modes_.size() + count, {.joint = k, .at = {}, .force = {}});
    if (rubs(joint)) parts_ = 4;
  }
  for (auto* x : {&amounts_, &induced_, &before_}) x->resize(modes_.size());
  newton_ = SmallLu(modes_.size());
}

void InducedForces::start(const Position& at) {
  std::ranges::fill(amounts_, 0.0);
  for (Source& source : sources_) {
    set_up(source, at);
    set_modes(source);
  }
}

void InducedForces::set_up(Source& source, const Position& at) {
  const Joint& joint = model_.joints[source.joint];
  const auto placed = [&](int link) {
    if (link == ground) return Placed{};
    const Pose& pose = at.pose[static_cast<std::size_t>(link)];
    return Placed{turn(pose.phi), {pose.x, pose.y}, pose.phi};
  };
  const auto speed = [&](int link) { return link == ground ? Pose{} : at.velocity[static_cast<std::size_t>(link)]; };
  const Placed i = placed(joint.i), j = placed(joint.j);
  const Pose speed_i = speed(joint.i), speed_j = speed(joint.j);
  place(source.shape, i, j, source.place);
  source.turning = speed_i.phi - speed_j.phi;
  const Vec pin = source.place.at;
  const Vec apart = Vec{speed_i.x, speed_i.y} + speed_i.phi * normal(pin - i.origin) - Vec{speed_j.x, speed_j.y} -
                    speed_j.phi * normal(pin - j.origin);
  source.sliding = dot(source.place.along, apart);
}

void InducedForces::set_modes(const Source& source) {
  const PairPlace& at = source.place;
  InducedMode* const mode = &modes_[source.first];
  mode->at = at.at;
  switch (source.shape.joint) {
    case JointKind::gear:  // towards the axis of wheel i
      mode->force = -at.along;
      break;
    case JointKind::rack:
      mode->force = std::copysign(1.0, source.shape.radius_i) * normal(at.along);
      break;
    case JointKind::belt: {
      const Span other = other_span(source.shape, at);
      mode->force = at.along + other.along;
      mode->couple = cross(other.at - at.at, other.along);
      break;
    }
    case JointKind::prismatic:
    case JointKind::slot:
      mode->force = at.along;
      mode[1].at = at.at;
      mode[1].couple = 1.0;
      break;
    default:
      mode->couple = 1.0;
  }
}

void InducedForces::induce(const Position& at, double share) {
  for (const Source& source : sources_) induce(source, at.reactions[source.joint], share);
}

// What the force of a joint induces; `share`: of the coefficients of friction.
void InducedForces::induce(const Source& source, const Reaction& by, double share) {
  const Joint& joint = model_.joints[source.joint];
  const Friction& friction = joint.friction;
  const double mu = share * friction.coefficient;
  const Vec along = source.place.along;
  double* const amount = &induced_[source.first];
  switch (joint.kind) {
    case JointKind::gear:
      amount[0] = std::tan(joint.pressure_angle) * std::abs(dot(by.force, normal(along)));
      break;
    case JointKind::rack:
      amount[0] = std::tan(joint.pressure_angle) * std::abs(dot(by.force, along));
      break;
    case JointKind::belt:  // the equation's span cannot push: then the other one pulls
      amount[0] = joint.tension + std::max(0.0, -dot(by.force, along));
      break;
    case JointKind::revolute:
      amount[0] = -sign(source.turning) * mu * friction.pin_radius * length(by.force) -
                  share * friction.viscous * source.turning;
      break;
    case JointKind::prismatic: {
      const double pressing = dot(by.force, normal(along));
      const double tilting = joint.guide_length > 0.0 ? 2.0 * by.couple / joint.guide_length : 0.0;
      const double edges = std::max(std::abs(pressing), std::abs(tilting));  // |R/2 + R h/l| + |R/2 - R h/l|
      amount[0] = -sign(source.sliding) * mu * edges - share * friction.viscous * source.sliding;
      amount[1] = -sign(source.sliding) * mu * 0.5 * joint.guide_width * pressing;
      break;
    }
    case JointKind::slot: {  // where the pin touches it may slide, roll or both
      const double pressing = dot(by.force, normal(along));
      const double arm = sign(pressing) * friction.pin_radius;
      const double rubbing = source.sliding + arm * source.turning;
      amount[0] = -sign(rubbing) * mu * std::abs(pressing) - share * friction.viscous * rubbing;
      amount[1] = arm * amount[0];
      break;
    }
    default:
      amount[0] =
          -sign(source.turning) * share * friction.rolling_arm * std::abs(dot(by.force, source.place.rows[1].e)) -
          share * friction.viscous * source.turning;
  }
}

double InducedForces::largest_force(const Position& at) {
  double most = 1e-300;
  for (const Reaction& reaction : at.reactions)
    most = std::max({most, std::abs(reaction.force.x), std::abs(reaction.force.y)});
  return most;
}

bool InducedForces::is_settled(const Position& at) const {
  const double rounding = 1e-15 * largest_force(at);
  for (std::size_t m = 0; m < amounts_.size(); ++m) {
    if (!(std::abs(amounts_[m] - induced_[m]) <= rounding + 1e-13 * std::abs(amounts_[m]))) return false;
  }
  return true;
}

bool InducedForces::step() {
  if (!newton_.factor() || newton_.sign() < 0.0) return false;
  for (std::size_t m = 0; m < amounts_.size(); ++m) before_[m] = amounts_[m] - before_[m];
  newton_.solve(before_);
  for (std::size_t m = 0; m < amounts_.size(); ++m) amounts_[m] -= before_[m];
  return true;
}

void InducedForces::add_to(Position& at) const {
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    Reaction& reaction = at.reactions[modes_[m].joint];
    reaction.force = reaction.force + amounts_[m] * modes_[m].force;
    reaction.couple += amounts_[m] * modes_[m].couple;
  }
}

}  // namespace loadpath::mechanism
