// Whether wheels stay on what they roll on, and followers on their cams.
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/model/pair.hpp"
#include "lib/mechanism/studies/cam_state.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::planar {

namespace {

/// Whether a joint only pushes: a wheel on its track, or a follower on its cam, can lift off.
bool only_pushes(const planar::Joint& joint) {
  using Type = planar::Type;
  if (is_cam(joint.type)) return joint.holding == planar::Holding::one_side;
  return joint.type == Type::rolling || joint.type == Type::rolling_inside || joint.type == Type::rolling_on_line;
}

/// The force that presses a rolling wheel against what it rolls on, or a follower against its cam, N.
double pressing(const mechanism::Model& model, const mechanism::Position& at, std::size_t k) {
  const mechanism::Joint& joint = model.joints[k];
  if (joint.kind == mechanism::JointKind::cam) return mechanism::cam_state(model, k, at).pressing;
  mechanism::PairPlace place;
  mechanism::place(mechanism::shape_of(joint), mechanism::placed_at(at, joint.i), mechanism::placed_at(at, joint.j),
                   place);
  const bool line = joint.kind == mechanism::JointKind::rolling_on_line;
  const double side = line ? std::copysign(1.0, joint.radius_i) : -1.0;
  return side * mechanism::dot(at.reactions[k].force, place.rows[1].e);
}

void judge_contact(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  const mechanism::Model& model = solved.given;
  const Cycle& cycle = solved.proved;
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    const mechanism::Joint& joint = model.joints[n];
    if (!only_pushes(solved.in.joints[n])) continue;
    const bool cam = joint.kind == mechanism::JointKind::cam;
    std::vector<bool> lost(cycle.positions.size());
    for (std::size_t k = 0; k < lost.size(); ++k)
      lost[k] = cycle.has_forces(k) && pressing(model, cycle.positions[k], n) < -rounding_at(cycle.positions[k]).force;
    const auto count = static_cast<std::size_t>(std::count(lost.begin(), lost.end(), true));
    account::Verdict& v = verdicts.emplace_back(
        account::Verdict{.step = solved.step,
                         .symbol = "contact_" + joint.name,
                         .meaning = cam ? say("the follower of joint '{1}' stays on its cam", joint.name)
                                        : say("the wheel of joint '{1}' stays on what it rolls on", joint.name),
                         .value = say("not unique"),
                         .bound = say("every position"),
                         .state = account::State::not_covered});
    if (!cycle.unique.empty() && !cycle.unique[n].force) continue;
    v.value = say("{1} of {2}", std::to_string(lost.size() - count), std::to_string(lost.size()));
    v.state = account::pass_if(count == 0);
    if (count > 0 && solved.axis != nullptr) v.note = say("lifts off {1}", range_of(lost, true, *solved.axis));
  }
}

}  // namespace

constinit const Aspect aspects::contact{.judge = &judge_contact};

}  // namespace loadpath::planar
