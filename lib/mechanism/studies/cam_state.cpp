#include "lib/mechanism/studies/cam_state.hpp"

#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/model/pair.hpp"

#include <cmath>

namespace loadpath::mechanism {
namespace {

/// The direction of the follower's point if only its guide moves it.
Vec path_at(const Model& model, std::size_t guide, int follower, Vec point, const Position& at) {
  const Joint& joint = model.joints[guide];
  if (joint.kind == JointKind::prismatic) {
    return (placed_at(at, joint.j).turned * turn(joint.direction))({1.0, 0.0});
  }
  const Vec pivot = placed_at(at, follower).point(joint.i == follower ? joint.point_i : joint.point_j);
  return normal(point - pivot);
}

}  // namespace

std::optional<std::size_t> guide_of(const Model& model, std::size_t cam) {
  const int follower = model.joints[cam].i;
  std::optional<std::size_t> guide;
  if (follower == ground) return guide;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const Joint& joint = model.joints[k];
    if (joint.kind != JointKind::prismatic && joint.kind != JointKind::revolute) continue;
    if (joint.i != follower && joint.j != follower) continue;
    if ((joint.i == follower ? joint.j : joint.i) == ground) return k;
    if (!guide) guide = k;
  }
  return guide;
}

CamState cam_state(const Model& model, std::size_t k, const Position& at) {
  const Joint& joint = model.joints[k];
  const Placed i = placed_at(at, joint.i), j = placed_at(at, joint.j);
  PairPlace place;
  place.touch.parameter = at.reactions[k].touch;  // a profile may come near its follower twice
  mechanism::place(shape_of(joint), i, j, place);
  const Vec out = place.rows[0].e;
  CamState state;
  state.pressing = dot(at.reactions[k].force, out);
  const Vec apart = velocity_at(place.at, i, speeds_at(at, joint.i)) - velocity_at(place.at, j, speeds_at(at, joint.j));
  if (joint.contact == CamContact::flat || joint.radius_i == 0.0) state.sliding = dot(place.along, apart);
  if (const auto guide = guide_of(model, k)) {
    const Vec point = joint.contact == CamContact::flat ? place.at : i.point(joint.point_i);
    const Vec path = path_at(model, *guide, joint.i, point, at);
    constexpr double rounding = 1e-14;  // rounding error of the sine
    const double across = std::abs(cross(path, out));
    state.pressure_angle = across <= rounding * length(path) ? 0.0 : std::atan2(across, std::abs(dot(path, out)));
  }
  return state;
}

}  // namespace loadpath::mechanism
